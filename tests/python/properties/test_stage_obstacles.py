"""Rigid obstacles that a stage makes heavier, holds or lets go: their motion goes on."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

STEP = 2.0**-9
SPIN = 2 * np.pi * 2.0
CHANGES = {
    "let go": ({"held": ["x", "y", "rotation"]}, {"held": ["x", "y"]}),
    "held": ({}, {"held": ["rotation"]}),
    "heavier": ({}, {"mass": 400.0}),
    "lighter": ({"held": ["x"]}, {"mass": 20.0}),
    "of another inertia": ({"inertia": [3.0]}, {"inertia": [9.0]}),
    "larger": ({}, {"shape": {"kind": "disk", "center": [2.0, 2.0], "radius": 0.5}}),
}


def wheel(stages: list[lp.Stage], **keys: object) -> lp.Scene:
    obstacle = {
        "name": "wheel",
        "shape": lp.Disk(center=(2, 2), radius=0.3),
        "mass": 100.0,
        "revolutions_per_second": 2.0,
        "velocity": (0.5, 0.0),
        **keys,
    }
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 4), cell=0.2),
        bodies=[
            lp.Body(
                name="far",
                shape=lp.Box(lower=(0, 0), upper=(4, 0.4)),
                material=lp.Elastic(density=2000, youngs_modulus=1e6, poissons_ratio=0.3),
            )
        ],
        dynamics=lp.Dynamics(
            grid_boundaries=[lp.NoSlipBoundary(face="y_lower")],
            obstacles=[lp.Obstacle(**obstacle)],
        ),
        time=lp.Time(end=8 * STEP, step=STEP),
        stages=stages,
    )


@pytest.mark.parametrize("change", CHANGES)
def test_a_wheel_turns_on_into_the_next_stage(change: str) -> None:
    before, after = CHANGES[change]
    settings = {f"dynamics.obstacles.wheel.{key}": value for key, value in after.items()}
    scene = wheel([lp.Stage(name="next", end=16 * STEP, set=settings)], **before)
    simulation = lp.Simulation(scene)
    for time in (4 * STEP, 12 * STEP, 16 * STEP):
        simulation.run_until(time)
        said = simulation.diagnostics()
        assert said["dynamics/wheel_spin_z"] == pytest.approx(SPIN, rel=1e-12)
        assert said["dynamics/wheel_velocity_x"] == pytest.approx(0.5, rel=1e-12)


@pytest.mark.parametrize("held", [["rotation"], ["x", "rotation"], ["x"], []])
def test_the_energy_of_a_wheel_counts_its_spin(held: list[str]) -> None:
    said = lp.Simulation(wheel([], inertia=[4.0], held=held)).diagnostics()
    expected = 0.5 * 100 * 0.5**2 + 0.5 * 4 * SPIN**2
    assert said["dynamics/wheel_kinetic_energy"] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("key", ["velocity", "revolutions_per_second"])
def test_a_stage_does_not_set_the_motion_of_what_moves_by_its_mass(key: str) -> None:
    value = (3.0, 0.0) if key == "velocity" else 5.0
    stage = lp.Stage(name="n", end=16 * STEP, set={f"dynamics.obstacles.wheel.{key}": value})
    with pytest.raises(ValueError, match="sets the motion of wheel, an obstacle with a mass"):
        lp.Simulation(wheel([stage]))
