"""Material that an obstacle leaves behind inside it is told, with where and how deep."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp


def pushed(boundary: object, unit: float = 1.0, end: float = -0.2) -> lp.Simulation:
    """A wall that reaches down to `end` is pushed .2 m into sand on a floor; lengths in `unit` of a
    metre."""
    scene = lp.Scene(
        grid=lp.Grid(lower=(-0.4 / unit, 0), upper=(1.5 / unit, 0.8 / unit), cell=0.05 / unit),
        bodies=[
            lp.Body(
                name="sand",
                shape=lp.Box(lower=(0, 0), upper=(1.5 / unit, 0.3 / unit)),
                material=lp.MohrCoulomb(
                    density=1700 * unit**3,
                    youngs_modulus=1e6 * unit,
                    poissons_ratio=0.3,
                    friction_angle=32,
                    cohesion=100 * unit,
                ),
            )
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -9.81 / unit),
            grid_boundaries=[boundary, lp.RollerBoundary(face="x_upper")],
            obstacles=[
                lp.Obstacle(
                    name="wall",
                    shape=lp.Box(lower=(-0.4 / unit, end / unit), upper=(0, 0.7 / unit)),
                    contact="frictional",
                    friction=0.3,
                    velocity=(0.5 / unit, 0),
                )
            ],
        ),
        time=lp.Time(end=0.4),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(0.4)
    return simulation


def inside(simulation: lp.Simulation, unit: float = 1.0) -> np.ndarray:
    """How deep points lie behind the face of the wall, in cells."""
    return (0.2 - np.asarray(simulation.position)[:, 0] * unit) / 0.05


@pytest.mark.parametrize("unit", [1.0, 1e-3])
def test_what_a_face_holds_behind_the_obstacle_is_told(unit: float) -> None:
    simulation = pushed(lp.NoSlipBoundary(face="y_lower"), unit)
    depth = inside(simulation, unit)
    told = [note for note in simulation.warnings() if "inside it" in note]
    assert depth.max() > 0.5
    assert len(told) == 1
    assert f"wall: {(depth > 0.5).sum()} points" in told[0]
    assert f"the deepest {depth.max():.2f}"[:-1] in told[0]


def test_nothing_is_told_of_a_smooth_floor() -> None:
    simulation = pushed(lp.RollerBoundary(face="y_lower"))
    assert inside(simulation).max() < 0.25
    assert not [note for note in simulation.warnings() if "inside it" in note]


@pytest.mark.parametrize(("end", "told"), [(0.0, True), (-0.01, True), (-0.1, False)])
def test_an_end_on_a_face_is_told(end: float, told: bool) -> None:
    """Points beside the lower edge are nearest to the end of the wall, and leave through it."""
    simulation = pushed(lp.NoSlipBoundary(face="y_lower"), end=end)
    assert any("ends on it" in note for note in simulation.warnings()) == told
