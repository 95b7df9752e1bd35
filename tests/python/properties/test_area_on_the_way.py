"""Areas of bodies that move: what was missing of them at the start is not carried elsewhere."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

CELL = 0.1
WARM = lp.Thermal(density=1, specific_heat=1, conductivity=0.01)
SOLID = lp.Elastic(density=1, youngs_modulus=1000, poissons_ratio=0.3)


def rate_at_the_end(scene: lp.Scene, share: float = 0.2) -> float:
    """The heat that arrives per second in the last part of a run."""
    simulation = lp.Simulation(scene)
    simulation.run_until((1 - share) * scene.time.end)
    before = simulation.balance()[0].supplied
    simulation.run_until(scene.time.end)
    return float(simulation.balance()[0].supplied - before) / (share * scene.time.end)


@pytest.mark.parametrize("inside", [0.02, 0.06, 0.2, 1.0])  # cells at the start
@pytest.mark.parametrize("deforms", [False, True])
def test_a_body_that_enters_a_region(inside: float, deforms: bool) -> None:
    edge = 0.5 - inside * CELL
    zone = lp.HalfSpace(point=(edge, 0), normal=(-1, 0))
    if deforms:
        moved = {"velocity": (1.0, 0.0), "material": [WARM, SOLID]}
    else:
        moved = {"motion": lp.Translation(velocity=(1.0, 0.0)), "material": WARM}
    scene = lp.Scene(
        grid=lp.Grid(lower=(-1, -1), upper=(2.5, 1), cell=CELL),
        bodies=[lp.Body(name="ball", shape=lp.Disk(radius=0.5), **moved)],
        heat=lp.Heat(boundaries=[lp.Flux(name="zone", value=1.0, region=zone)]),
        time=lp.Time(end=1.5, step=None if deforms else 0.02),
        **({"dynamics": lp.Dynamics()} if deforms else {}),
    )
    # The ratio of the first moment would take 9 (1 cell inside) to 70 % (.02) for good.
    assert rate_at_the_end(scene) == pytest.approx(np.pi, rel=0.02)


@pytest.mark.parametrize("gap", [0.1, 0.5, 1.0])  # cells
def test_bodies_that_part(gap: float) -> None:
    def square(name: str, left: float, speed: float) -> lp.Body:
        shape = lp.Box(lower=(left, -0.5), upper=(left + 1, 0.5))
        return lp.Body(name=name, shape=shape, material=[WARM, SOLID], velocity=(speed, 0))

    scene = lp.Scene(
        grid=lp.Grid(lower=(-3, -1), upper=(3, 1), cell=CELL),
        bodies=[square("left", -1 - gap * CELL, -1.0), square("right", 0.0, 1.0)],
        heat=lp.Heat(boundaries=[lp.Flux(value=1.0)]),
        dynamics=lp.Dynamics(),
        time=lp.Time(end=0.5),
    )
    # The faces of the gap are found when it has opened; they were counted twice then.
    assert rate_at_the_end(scene) == pytest.approx(8.0, rel=0.02)


def test_a_plate_beside_a_block() -> None:
    plate = lp.Box(lower=(-1, 1), upper=(1, 1.15))
    block = lp.Box(lower=(-1, -1.5), upper=(1, 0.5))
    scene = lp.Scene(
        grid=lp.Grid(lower=(-2, -2), upper=(2, 2), cell=CELL),
        bodies=[
            lp.Body(name="plate", shape=plate, material=[WARM, SOLID]),
            lp.Body(name="block", shape=block, material=[WARM, SOLID]),
        ],
        heat=lp.Heat(boundaries=[lp.Flux(value=1.0)]),
        dynamics=lp.Dynamics(),
        time=lp.Time(end=0.1),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(0.1)
    heat = simulation["volume"] * simulation["temperature"]
    # One ratio for both took 3.5 % from the plate and gave the block 1.9 % too much.
    for number, perimeter in enumerate([4.3, 8.0]):
        arrived = heat[simulation["body"] == number].sum()
        # Found .9 % short: corners look five cells around, where the other body is.
        assert arrived == pytest.approx(0.1 * perimeter, rel=0.012)
