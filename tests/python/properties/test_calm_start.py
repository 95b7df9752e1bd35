"""Soil that starts at rest: layers under their own weight, damping that ends, and runs that go on
from the state of another."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import lapilli as lp

G = 9.81


def layered(cell: float = 0.25, degrees: float = 0.0, surcharge: float = 50e3) -> lp.Scene:
    """Gravel over clay between smooth sides, under a load on top; gravity turned in quarters."""
    clay = lp.Elastic(density=2000, youngs_modulus=2e7, poissons_ratio=0.3)
    gravel = lp.Elastic(density=1600, youngs_modulus=1e7, poissons_ratio=0.25)
    at_rest = {
        "clay": lp.Geostatic(k0=0.3 / 0.7, surcharge=surcharge),
        "gravel": lp.Geostatic(k0=0.25 / 0.75, surcharge=surcharge),
    }
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(2, 4), cell=cell),
        bodies=[
            lp.Body(
                name="clay",
                shape=lp.Box(lower=(0, 0), upper=(2, 1)),
                material=[clay],
                geostatic=at_rest["clay"],
            ),
            lp.Body(
                name="gravel",
                shape=lp.Box(lower=(0, 1), upper=(2, 3)),
                material=[gravel],
                geostatic=at_rest["gravel"],
            ),
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -G),
            grid_boundaries=[
                lp.RollerBoundary(face="y_lower"),
                lp.RollerBoundary(face="x_lower"),
                lp.RollerBoundary(face="x_upper"),
            ],
            boundaries=[lp.Pressure(value=surcharge)],
        ),
        time=lp.Time(end=1.0),
    )


def vertical(depths: np.ndarray) -> np.ndarray:
    """The stress by height: gravel from 3 m to 1 m, clay below."""
    in_gravel = np.minimum(3 - depths, 2.0)
    in_clay = np.maximum(0, 1 - depths)
    return np.asarray(-50e3 - G * (1600 * in_gravel + 2000 * in_clay))


def test_two_layers_under_a_load_start_with_their_stress_and_stay() -> None:
    simulation = lp.Simulation(layered())
    height = simulation.position[:, 1]
    stress = simulation["stress"]
    exact = vertical(height)
    np.testing.assert_allclose(stress[:, 1], exact, rtol=1e-10)
    k0 = np.where(height < 1, 0.3 / 0.7, 0.25 / 0.75)
    np.testing.assert_allclose(stress[:, 0], k0 * exact, rtol=1e-10)
    simulation.run_until(1.0)
    # Rounding; the bar is 1e-6 m/s.
    assert np.abs(simulation["velocity"]).max() < 1e-6


def test_soil_below_terrain_carries_what_lies_above() -> None:
    # A heap in the shape of a tent, lying on a slab; weight above by elementary geometry.
    slab = lp.Box(lower=(0, 0), upper=(8, 1))
    tent = lp.Polygon(vertices=[(1, 1), (7, 1), (4, 3)])
    sand = lp.MohrCoulomb(
        density=1500, youngs_modulus=1e7, poissons_ratio=0.3, friction_angle=35, cohesion=1e3
    )
    rock = lp.Elastic(density=2500, youngs_modulus=1e8, poissons_ratio=0.2)
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(8, 4), cell=0.25),
        bodies=[
            lp.Body(name="rock", shape=slab, material=[rock], geostatic=lp.Geostatic(k0=0.25)),
            lp.Body(name="sand", shape=tent, material=[sand], geostatic=lp.Geostatic(k0=0.5)),
        ],
        dynamics=lp.Dynamics(gravity=(0, -G), grid_boundaries=[lp.NoSlipBoundary(face="y_lower")]),
        time=lp.Time(end=0.1),
    )
    simulation = lp.Simulation(scene)
    x, y = simulation.position.T
    roof = np.clip(1 + np.minimum(x - 1, 7 - x) * 2 / 3, 1, None)
    exact = -G * (1500 * (roof - np.maximum(y, 1)) + 2500 * np.maximum(1 - y, 0))
    np.testing.assert_allclose(simulation["stress"][:, 1], exact, rtol=1e-9, atol=1e-6)


def column(**dynamics: object) -> lp.Scene:
    """An elastic column that gravity loads at once."""
    soil = lp.Elastic(density=2000, youngs_modulus=1e7, poissons_ratio=0.2)
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1, 5), cell=0.25),
        bodies=[lp.Body(name="soil", shape=lp.Box(lower=(0, 0), upper=(1, 4)), material=[soil])],
        dynamics=lp.Dynamics(
            gravity=(0, -G),
            grid_boundaries=[
                lp.RollerBoundary(face=face) for face in ("y_lower", "x_lower", "x_upper")
            ],
            **dynamics,
        ),
        time=lp.Time(end=1.5),
    )


@pytest.mark.parametrize("courant", [0.5, 0.1])
def test_local_damping_brings_a_column_to_rest_whatever_the_step(courant: float) -> None:
    scene = column(local_damping=0.7, damping_until=1.2, courant=courant)
    simulation = lp.Simulation(scene)
    simulation.run_until(0.1)
    swing = np.abs(simulation["velocity"]).max()
    simulation.run_until(1.2)
    loss = simulation.diagnostics()["dynamics/damping_loss"]
    assert loss > 0
    rest = np.abs(simulation["velocity"]).max()
    assert rest < 1e-3 * swing
    height = simulation.position[:, 1]
    exact = -2000 * G * (4 - height)
    # Second order of the cell; the top has moved by .04 m.
    assert np.abs(simulation["stress"][:, 1] - exact).max() < 0.02 * 2000 * G * 4
    simulation.run_until(1.5)
    assert simulation.diagnostics()["dynamics/damping_loss"] == loss
    assert np.abs(simulation["velocity"]).max() < 2e-3 * swing
    for balance in simulation.balance()[1:]:
        assert abs(balance.residual) < 1e-8  # rounding of impulses a million times as large


def test_gravity_that_grows_slowly_loads_without_swinging() -> None:
    ramp = lp.Table([0.0, 1.0], [0.0, 1.0])
    peaks = []
    for factor in (1.0, ramp):
        slow = lp.Simulation(column(gravity_factor=factor))
        kinetic = []
        for time in np.linspace(1.0, 1.5, 51):  # two swings
            slow.run_until(time)
            kinetic.append(slow.diagnostics()["dynamics/kinetic_energy"])
        peaks.append(max(kinetic))
        energy, *momenta = slow.balance()
        assert abs(energy.residual) < 1e-2  # of the integration in time; .002 under all at once
        for balance in momenta:
            assert abs(balance.residual) < 1e-8
    assert peaks[1] < 0.01 * peaks[0]
    assert slow["stress"][:, 1].min() == pytest.approx(-2000 * G * 4, rel=0.06)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_body_starts_with_translation_and_spin(dimension: int) -> None:
    shape: lp.Disk | lp.Sphere = (
        lp.Disk(center=(0.3, 0.1), radius=0.7)
        if dimension == 2
        else lp.Sphere(center=(0.3, 0.1, -0.2), radius=0.7)
    )
    spin = np.array([0.0, 0.0, 3.0] if dimension == 2 else [1.0, -2.0, 3.0])
    move = np.array([2.0, -1.0, 0.5])[:dimension]
    scene = lp.Scene(
        grid=lp.Grid(lower=(-2,) * dimension, upper=(2,) * dimension, cell=0.25),
        bodies=[
            lp.Body(
                shape=shape,
                material=[lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3)],
                velocity=move,
                spin=spin[2] if dimension == 2 else spin,
            )
        ],
        dynamics=lp.Dynamics(),
        time=lp.Time(end=0.2),
    )
    simulation = lp.Simulation(scene)
    away = np.zeros((len(simulation), 3))
    away[:, :dimension] = simulation.position
    away -= np.average(away, axis=0, weights=simulation["volume"])
    exact = np.cross(spin, away)[:, :dimension] + move
    np.testing.assert_allclose(simulation["velocity"], exact, atol=1e-12)
    simulation.run_until(0.2)
    moment = np.zeros((len(simulation), 3))
    moment[:, :dimension] = simulation.position
    weights = simulation["volume"] * simulation["density"]
    centre = np.average(moment, axis=0, weights=weights)
    start = np.array([0.3, 0.1, -0.2])[:dimension] + 0.2 * move
    np.testing.assert_allclose(centre[:dimension], start, atol=2e-3)


def strong_and_weak(strength: float, **changes: object) -> lp.Scene:
    """A cut of 45 degrees in cohesive soil."""
    soil = lp.MohrCoulomb(
        density=2000,
        youngs_modulus=2e7,
        poissons_ratio=0.3,
        friction_angle=20,
        dilatancy_angle=0,
        cohesion=strength,
    )
    cut = lp.Polygon(vertices=[(0, 0), (8, 0), (8, 1), (5, 1), (3, 3), (0, 3)])
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(8, 4), cell=0.25),
        bodies=[
            lp.Body(name="cut", shape=cut, material=[soil], geostatic=lp.Geostatic(k0=0.5)),
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -G),
            grid_boundaries=[
                lp.NoSlipBoundary(face="y_lower"),
                lp.RollerBoundary(face="x_lower"),
                lp.RollerBoundary(face="x_upper"),
            ],
            **changes,
        ),
        time=lp.Time(end=1.0),
    )


def test_a_slope_rests_and_is_weakened(tmp_path: Path) -> None:
    rested = lp.run(
        strong_and_weak(20e3, local_damping=0.7), tmp_path / "rest.vtkhdf", progress=False
    )
    before = rested.by_id("position")
    assert np.abs(rested.by_id("velocity")).max() < 1e-3

    def weakened(strength: float) -> lp.Simulation:
        scene = strong_and_weak(strength)
        scene.initial_state = tmp_path / "rest.checkpoint"
        return lp.Simulation(scene)

    # Exactly where the other run stopped, and at rest there.
    sound = weakened(20e3)
    np.testing.assert_array_equal(sound.by_id("position"), before)
    np.testing.assert_array_equal(sound.by_id("stress"), rested.by_id("stress"))
    np.testing.assert_array_equal(sound.by_id("velocity"), rested.by_id("velocity"))
    sound.run_until(1.0)
    assert np.abs(sound.by_id("position") - before).max() < 0.25 / 100
    # Less than what it needs (stability number of the slope: c about .06 rho g H = 3.5 kPa).
    weak = weakened(0.5e3)
    weak.run_until(1.0)
    assert np.abs(weak.by_id("position") - before).max() > 0.25
    for balance in weak.balance()[1:]:
        assert abs(balance.residual) < 1e-9


def test_bodies_are_taken_away_and_added(tmp_path: Path) -> None:
    first = layered()
    first.time.end = 0.05
    before = lp.run(first, tmp_path / "both.vtkhdf", progress=False)
    scene = layered(surcharge=0.0)
    scene.initial_state = tmp_path / "both.checkpoint"
    dam = lp.Body(
        name="dam",
        shape=lp.Box(lower=(0, 1), upper=(1, 2)),
        material=[lp.Elastic(density=2400, youngs_modulus=3e7, poissons_ratio=0.2)],
    )
    scene.bodies = [dam, scene.bodies[0]]
    scene.dynamics.boundaries = []
    simulation = lp.Simulation(scene)
    clay = simulation["body"] == 1
    where = before.frames[-1]["body"] == 0
    assert clay.sum() == where.sum()
    assert np.abs(simulation["stress"][clay, 1]).max() > 50e3
    assert np.abs(simulation["stress"][~clay]).max() == 0
    top = simulation.position[clay, 1].max()
    simulation.run_until(0.05)
    # Relieved of the gravel it rises, but below the dam.
    beside = clay & (simulation.position[:, 0] > 1.5)
    assert simulation.position[beside, 1].max() > top


def test_an_initial_state_that_cannot_be_is_refused_by_name(tmp_path: Path) -> None:
    lp.run(column(), tmp_path / "run.vtkhdf", progress=False)
    scene = layered()
    scene.initial_state = tmp_path / "run.checkpoint"
    with pytest.raises(ValueError, match="holds none of the bodies of this scene, but soil"):
        lp.Simulation(scene)
    scene.initial_state = tmp_path / "run.vtkhdf"
    with pytest.raises(ValueError, match=r"the checkpoint beside them: .*run\.checkpoint"):
        lp.Simulation(scene)
    scene.initial_state = tmp_path / "none.checkpoint"
    with pytest.raises((ValueError, lp.OutputError), match=r"none\.checkpoint"):
        lp.Simulation(scene)
