"""A layer on an obstacle off the lattice rests as drawn, and rebounds when it is relieved."""

from __future__ import annotations

import functools

import numpy as np
import pytest

import lapilli as lp

DENSITY, G, E, NU = 2000.0, 9.81, 2e7, 0.3
MODULUS = E * (1 - NU) / (1 + NU) / (1 - 2 * NU)  # of strain along one axis alone
HEIGHT, SPOIL = 3.0, 1.0


@functools.cache
def relieved(floor: float, side: float = 0.0, cell: float = 0.5) -> tuple[np.ndarray, ...]:
    """Ground of 3 m on a smooth obstacle at `floor`, between smooth obstacles at `side` and 4 m
    from there, and 1 m of spoil that a stage removes. Places at the start, before and after, and
    stresses before and after, of the ground."""

    def layer(name: str, lower: float, upper: float) -> lp.Body:
        return lp.Body(
            name=name,
            shape=lp.Box(lower=(side, lower), upper=(side + 4, upper)),
            material=lp.Elastic(density=DENSITY, youngs_modulus=E, poissons_ratio=NU),
            geostatic=lp.Geostatic(k0=NU / (1 - NU)),
        )

    top = floor + HEIGHT
    ends = {
        "floor": lp.Box(lower=(-20, -20), upper=(20, floor)),
        "left": lp.Box(lower=(-20, -20), upper=(side, 20)),
        "right": lp.Box(lower=(side + 4, -20), upper=(20, 20)),
    }
    scene = lp.Scene(
        grid=lp.Grid(lower=(-1, -1), upper=(6, 6), cell=cell),
        bodies=[layer("ground", floor, top), layer("spoil", top, top + SPOIL)],
        dynamics=lp.Dynamics(
            gravity=(0, -G),
            obstacles=[
                lp.Obstacle(name=name, shape=shape, contact="slip") for name, shape in ends.items()
            ],
            local_damping=0.5,
        ),
        time=lp.Time(end=0.2),
        stages=[lp.Stage(name="dig", end=0.8, remove=["spoil"])],
    )
    simulation = lp.Simulation(scene)
    start = simulation.by_id("position").copy()
    simulation.run_until(0.2)
    before = [simulation.by_id(name).copy() for name in ("position", "stress")]
    simulation.run_until(0.8)
    after = [simulation.by_id(name) for name in ("position", "stress")]
    count = len(after[0])
    return start[:count], *(array[:count] for array in (*before, *after))


@pytest.mark.parametrize("floor", [0.0, 0.13, 0.26, 0.4])
@pytest.mark.parametrize("side", [0.0, 0.17])
def test_rows_on_an_obstacle_bear_one_stress(floor: float, side: float) -> None:
    """Points in a corner reach farther down than to the side, or less: they sank until those beside
    them bore twice the stress."""
    start, _, stress, _, _ = relieved(floor, side)
    rows = np.round(start[:, 1], 6)
    most = DENSITY * G * (HEIGHT + SPOIL)
    for row in np.unique(rows):
        assert np.ptp(stress[rows == row, 1]) < 0.07 * most
    depth = floor + HEIGHT + SPOIL - start[:, 1]
    assert np.abs(stress[:, 1] + DENSITY * G * depth).max() < 0.1 * most


@pytest.mark.parametrize(("cell", "bar"), [(0.5, 0.035), (0.25, 0.016)])
@pytest.mark.parametrize("floor", [0.0, 0.13, 0.26, 0.4])
def test_ground_heaves_on_an_obstacle_as_on_a_face(cell: float, bar: float, floor: float) -> None:
    """Of the lowest half row nothing came back: 4 to 9 % of 6 cells."""
    _, before, _, after, _ = relieved(floor, cell=cell)
    top = before[:, 1] > before[:, 1].max() - 0.01
    heave = (after - before)[top, 1].mean()
    exact = DENSITY * G * SPOIL * (before[top, 1].mean() - floor) / MODULUS
    assert heave == pytest.approx(exact, rel=bar)
