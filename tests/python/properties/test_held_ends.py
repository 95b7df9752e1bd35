"""A wall that holds a part of a side at rest loses heat at its ends, and says how much."""

from __future__ import annotations

from pathlib import Path

import pytest
from numpy import ceil

import lapilli as lp

# Held at 1 between .31 and .69 of the bottom, at 0 along the top, Fourier number .3: heat that the
# plate gave, by finite volumes of 1/96 and 1/192 extrapolated, over rho c side^2 of 1 K.
EXACT = 0.470


def plate(points: int, ends: tuple[float, float], degrees: float, **heat: object) -> lp.Scene:
    cell, wide = 1.0 / points, 0.5

    def placed(lower: tuple[float, float], upper: tuple[float, float]) -> lp.Shape:
        turned = lp.Rotated(shape=lp.Box(lower=lower, upper=upper), degrees=degrees)
        return lp.Translated(shape=turned, by=(0.13, 0.27))

    walls = [
        lp.FluidWall(
            name="plate",
            shape=placed((ends[0], -wide), (ends[1], 0.0)),
            heat="temperature",
            temperature=1.0,
        ),
        lp.FluidWall(
            name="top", shape=placed((-wide, 1.0), (1.0 + wide, 1.0 + wide)), heat="temperature"
        ),
    ]
    return lp.Scene(
        grid=lp.Grid(lower=(-3, -3), upper=(-3 + cell * ceil(6 / cell),) * 2, cell=cell),
        bodies=[
            lp.Body(
                shape=placed((0.0, 0.0), (1.0, 1.0)),
                points_per_cell=1,
                material=lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0),
            )
        ],
        peridynamics=lp.Peridynamics(heat=lp.PeridynamicHeat(**heat), walls=walls),
        time=lp.Time(end=0.3),
    )


def said(scene: lp.Scene, path: Path) -> tuple[float, list[str]]:
    run = lp.run(scene, path / "plate.vtkhdf", progress=False)
    return run.simulation.balance()[0].entries["wall plate"], list(run.warnings)


@pytest.mark.parametrize("degrees", [0.0, 20.0, 45.0])
def test_ends_within_a_side_are_named_with_what_they_lose(tmp_path: Path, degrees: float) -> None:
    """5 to 7 % at 10 points, in silence before; at 20 the size halves."""
    shares = []
    for points in (10, 20):
        heat, warnings = said(plate(points, (0.31, 0.69), degrees), tmp_path)
        text = next(one for one in warnings if "ends within a side" in one)
        shares.append(float(text.split("about ")[1].split(" %")[0]) / 100)
        assert -1.5 * shares[-1] < heat / EXACT - 1.0 < 0.01
    assert shares == pytest.approx([0.4 / 10 / 0.38, 0.4 / 20 / 0.38], rel=0.01)


def test_ends_at_corners_lose_nothing(tmp_path: Path) -> None:
    assert said(plate(12, (0.0, 1.0), 30.0), tmp_path)[1] == []
    assert said(plate(12, (-0.3, 1.3), 0.0), tmp_path)[1] == []


@pytest.mark.parametrize("laplacian", ["compact", "zero-energy", "literal"])
def test_a_laplacian_for_comparison_is_named(tmp_path: Path, laplacian: str) -> None:
    """By what its bonds miss, or as what it is."""
    warnings = said(plate(12, (0.0, 1.0), 0.0, laplacian=laplacian), tmp_path)[1]
    assert any("for comparison" in one or "the bonds of a point miss" in one for one in warnings)
