"""Slabs in contact that conduct up to a thousand times unlike, anywhere on the grid: heat stays
bounded, and what passes its range is told before the run."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

Pose = tuple[float, int, float, tuple[float, float]]

# Conductivity of the upper block over that of the lower, cells across, degrees, cells off the grid.
JUST_BEFORE_A_NODE: list[Pose] = [
    (100.0, 16, 0.0, (0.208, 0.112)),
    (395.761, 16, 0.0, (0.124, 0.107)),
    (439.342, 8, 0.0, (0.278, 0.137)),
    (0.005, 10, 0.0, (-0.206, -0.129)),
]


def drawn(number: int) -> Pose:
    random = np.random.default_rng(900 + number)
    contrast = 10.0 ** random.uniform(0.3, 3.0)
    degrees = float(random.choice([0.0, 0.0, random.uniform(0.0, 90.0)]))
    off = (random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5))
    upper = contrast if random.random() < 0.5 else 1.0 / contrast
    return upper, int(random.choice([8, 10, 16, 20])), degrees, off


def two_blocks(pose: Pose) -> lp.Scene:
    """Blocks of 1 on each other, 0 below 1."""
    upper, cells, degrees, off = pose
    by = tuple(np.array(off) / cells)

    def body(bottom: float, conductivity: float, temperature: float) -> lp.Body:
        box = lp.Box(lower=(-0.5, bottom), upper=(0.5, bottom + 1.0))
        return lp.Body(
            shape=lp.Translated(shape=lp.Rotated(shape=box, degrees=degrees), by=by),
            material=[
                lp.Elastic(density=1.0, youngs_modulus=100.0, poissons_ratio=0.2),
                lp.Thermal(density=1.0, specific_heat=1.0, conductivity=conductivity),
            ],
            temperature=temperature,
        )

    return lp.Scene(
        grid=lp.Grid(lower=(-2.0, -2.0), upper=(2.0, 2.0), cell=1.0 / cells),
        bodies=[body(-1.0, 1.0, 0.0), body(0.0, upper, 1.0)],
        heat=lp.Heat(),
        dynamics=lp.Dynamics(contacts=[lp.BodyContact(contact="frictional", friction=0.5)]),
        time=lp.Time(end=1.0),
    )


@pytest.mark.parametrize("pose", [*JUST_BEFORE_A_NODE, *map(drawn, range(24))])
def test_heat_stays_in_its_range_or_says_so(pose: Pose) -> None:
    """Of 120 draws found .04 past the range below a contrast of 50, .24 above. Faces that lie just
    before a node of the poorer body took it to 5 times the range in the first step."""
    contrast = max(pose[0], 1.0 / pose[0])
    simulation = lp.Simulation(two_blocks(pose))
    told = any(one.code == "heat.unlike-contact" for one in simulation.warnings())
    assert told == (contrast >= 50.0)
    for _ in range(60):
        simulation.step()
    stray = np.abs(simulation["temperature"] - 0.5).max() - 0.5
    assert stray < (0.35 if told else 0.06)


def passed(off: tuple[float, float], degrees: float) -> float:
    """Heat that the upper of two alike blocks of eight cells has lost, over what it should have."""
    simulation = lp.Simulation(two_blocks((1.0, 8, degrees, off)))
    simulation.run_until(1.0 / 16.0)
    upper = simulation["body"] == 1
    carried, volume = simulation["temperature_carried"][upper], simulation["volume"][upper]
    return float((1.0 - np.average(carried, weights=volume)) / np.sqrt(simulation.time / np.pi))


@pytest.mark.parametrize("across", [0.3, 0.91])
@pytest.mark.parametrize("along", [0.1, 0.24, 0.251, 0.26, 0.28, 0.31, 0.49, 0.74, 0.749])
def test_blocks_touch_wherever_their_face_cuts_the_cells(along: float, across: float) -> None:
    """Found 1.3 % at most; .25 to .29 cells past a node 43 to 72 % of the heat were lost: the gap
    there was measured .06 cells wide."""
    assert passed((across, along), 0.0) == pytest.approx(1.0, abs=0.02)
