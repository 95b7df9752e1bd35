"""A run with frames that all tests here look at."""

from __future__ import annotations

from pathlib import Path

import pytest

import lapilli as lp


def plate(folder: Path) -> lp.Scene:
    """A plate at rest with a linear temperature, heated on its left side."""
    return lp.Scene(
        title="plate",
        grid=lp.Grid(lower=(0, 0), upper=(4, 4), cell=0.25),
        bodies=[
            lp.Body(
                name="steel",
                shape=lp.Box(lower=(0.5, 0.5), upper=(3.5, 3.0)),
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
                temperature=lambda x, s, t: 3 * x[:, 0] - x[:, 1],
            )
        ],
        heat=lp.Heat(),
        probes=[lp.Probe(name="middle", position=(2.03, 1.71))],
        time=lp.Time(end=0.02, step=0.001),
        output=lp.Output(path=str(folder / "plate.vtkhdf"), every=0.005),
    )


def block(folder: Path) -> lp.Scene:
    """Two blocks that fall, one faster: velocities and stresses."""
    soil = lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3)
    return lp.Scene(
        title="two blocks",
        grid=lp.Grid(lower=(0, 0), upper=(2, 1), cell=0.1),
        bodies=[
            lp.Body(
                name=name,
                shape=lp.Box(lower=(x, 0.4), upper=(x + 0.5, 0.8)),
                material=soil,
                velocity=(0.0, speed),
            )
            for name, x, speed in (("left", 0.2, -1.0), ("right", 1.2, -2.0))
        ],
        dynamics=lp.Dynamics(gravity=(0, -10)),
        time=lp.Time(end=0.05),
        output=lp.Output(path=str(folder / "block.vtkhdf"), every=0.01),
    )


@pytest.fixture(scope="session")
def heated(tmp_path_factory: pytest.TempPathFactory) -> lp.Result:
    """The plate after its run."""
    return lp.run(plate(tmp_path_factory.mktemp("plate")), progress=False)


@pytest.fixture(scope="session")
def falling(tmp_path_factory: pytest.TempPathFactory) -> lp.Result:
    """The blocks after their run."""
    return lp.run(block(tmp_path_factory.mktemp("block")), progress=False)
