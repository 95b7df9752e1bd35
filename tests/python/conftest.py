"""Objects that several tests need."""

from pathlib import Path

import pytest

import lapilli as lp


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every test runs in a folder of its own: what it writes lies beside nothing else."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def steel() -> lp.Thermal:
    """Round numbers near those of a carbon steel."""
    return lp.Thermal(density=7800, specific_heat=460, conductivity=50)


@pytest.fixture
def ring() -> lp.Scene:
    """The ring of the heat paper on a coarse grid: a fraction of a second."""
    return lp.Scene(
        grid=lp.Grid(lower=(-6, -6), upper=(6, 6), cell=0.5),
        bodies=[
            lp.Body(
                shape=lp.Annulus(inner=1, outer=5),
                points_per_cell=4,
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
            )
        ],
        heat=lp.Heat(boundaries=[lp.Convection(coefficient=1, ambient=1)]),
        time=lp.Time(end=1),
    )
