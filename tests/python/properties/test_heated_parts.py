"""A wall of a peridynamic flow gives its heat through all of the area it shares with the fluid,
whichever part of which side it is, whatever is beside it and to whom corners are drawn."""

import math

import numpy as np
import pytest

import lapilli as lp

WIDE = 0.5  # m, how thick walls are drawn


def box(*ends: float) -> lp.Box:
    middle = len(ends) // 2
    return lp.Box(lower=ends[:middle], upper=ends[middle:])


def closed_box(points: int, plate: lp.FluidWall, turn: float = 0.0, flows: bool = True):
    """A unit box of a still fluid of conductivity, density and specific heat 1; what of its walls
    is not the plate is adiabatic."""
    cell = 1.0 / points
    dimension = len(plate.shape.lower)

    def turned(shape: lp.Shape) -> lp.Shape:
        center = [0.5] * dimension
        return lp.Rotated(shape=shape, degrees=turn, center=center) if turn else shape

    def cube(low: float, high: float) -> lp.Box:
        return lp.Box(lower=[low] * dimension, upper=[high] * dimension)

    material = [lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0)]
    if flows:
        material.append(lp.Newtonian(density=1.0, viscosity=0.71, thermal_expansion=1.0))
    plate.shape = turned(plate.shape)
    inside, outside = cube(0.0, 1.0), cube(-WIDE, 1.0 + WIDE)
    rest = turned(lp.Difference(shape=outside, minus=inside))
    ends = [-1.0], [-1.0 + cell * math.ceil(3.0 / cell)]
    return lp.Scene(
        grid=lp.Grid(lower=ends[0] * dimension, upper=ends[1] * dimension, cell=cell),
        bodies=[
            lp.Body(name="air", shape=turned(inside), points_per_cell=1, material=material)
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            flow=lp.PeridynamicFlow(sound_speed=20.0) if flows else None,
            walls=[plate, lp.FluidWall(name="rest", shape=rest)],
        ),
        time=lp.Time(end=1.0),
    )  # fmt: skip


def heat_flow(scene: lp.Scene, end: float, wall: str = "plate") -> float:
    simulation = lp.Simulation(scene)
    simulation.run_until(end)
    return simulation.diagnostics()[f"heat/heat_flow_from_wall_{wall}"]


def sides(begin: float, end: float) -> list[lp.Box]:
    """The part from `begin` to `end` of each side of the unit square."""
    return [
        box(begin, -WIDE, end, 0.0),
        box(begin, 1.0, end, 1.0 + WIDE),
        box(-WIDE, begin, 0.0, end),
        box(1.0, begin, 1.0 + WIDE, end),
    ]


@pytest.mark.parametrize("seed", range(8))
def test_a_part_of_a_side_gives_its_flux_through_all_of_its_area(seed: int):
    """To what halving finds of its ends, 1/128 of a spacing each."""
    generator = np.random.default_rng(seed)
    points = int(generator.integers(9, 16))
    length = generator.uniform(2.0 / points, 0.8)
    begin = generator.uniform(0.0, 1.0 - length)
    shape = sides(begin, begin + length)[seed % 4]
    heat = {"heat": "flux", "flux": 2.0}
    if seed % 3 == 0:
        # Surroundings so far off that what they give is a flux.
        heat = {"heat": "convection", "coefficient": 2e-6, "temperature": 1e6}
    plate = lp.FluidWall(name="plate", shape=shape, **heat)
    turn = 0.0 if seed < 4 else generator.uniform(5.0, 85.0)
    found = heat_flow(closed_box(points, plate, turn), 0.001)
    assert found == pytest.approx(2.0 * length, abs=0.04 / points)


def test_a_part_of_a_side_gives_its_flux_in_space():
    plate = lp.FluidWall(
        name="plate", shape=box(0.2, 0.2, -WIDE, 0.8, 0.8, 0.0), heat="flux", flux=1.0
    )
    assert heat_flow(closed_box(5, plate), 2e-3) == pytest.approx(0.36, rel=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_a_flux_through_a_circle_is_that_of_its_length(seed: int):
    generator = np.random.default_rng(seed)
    cell, radius = 0.1, generator.uniform(0.5, 1.0)
    center = generator.uniform(-0.05, 0.05, 2)
    material = [
        lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0),
        lp.Newtonian(density=1.0, viscosity=0.71, thermal_expansion=1.0),
    ]
    rim = lp.Annulus(center=tuple(center), inner=radius, outer=radius + WIDE)
    scene = lp.Scene(
        grid=lp.Grid(lower=[-1.8, -1.8], upper=[1.8, 1.8], cell=cell),
        bodies=[
            lp.Body(
                shape=lp.Disk(center=tuple(center), radius=radius),
                points_per_cell=1,
                material=material,
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            flow=lp.PeridynamicFlow(sound_speed=20.0),
            walls=[lp.FluidWall(name="plate", shape=rim, heat="flux", flux=1.0)],
        ),
        time=lp.Time(end=1.0),
    )
    # Areas of circles are within 2e-4 at this many points.
    assert heat_flow(scene, 0.001) == pytest.approx(2.0 * math.pi * radius, rel=5e-4)


@pytest.mark.parametrize("kind", ["flux", "temperature", "convection"])
@pytest.mark.parametrize("side", range(4))
def test_corners_count_to_no_wall(side: int, kind: str):
    """They are those of the mirror across, whichever wall they are drawn to."""
    heat = {
        "flux": {"flux": 1.0},
        "temperature": {"temperature": 1.0},
        "convection": {"coefficient": 10.0, "temperature": 1.0},
    }[kind]
    found = [
        heat_flow(
            closed_box(8, lp.FluidWall(name="plate", shape=sides(*ends)[side], heat=kind, **heat)),
            0.01,
        )
        for ends in ((0.0, 1.0), (-WIDE, 1.0 + WIDE))
    ]
    assert found[0] == pytest.approx(found[1], rel=1e-12)


def test_a_held_part_of_a_side_gives_what_points_at_rest_say():
    """3.6 % above it at 10 points, 0.8 % at 20: the edge of the plate is singular."""
    flows = []
    for flow in (True, False):
        plate = lp.FluidWall(
            name="plate", shape=box(0.3, -WIDE, 0.7, 0.0), heat="temperature", temperature=1.0
        )
        flows.append(heat_flow(closed_box(10, plate, flows=flow), 0.02))
    assert flows[0] == pytest.approx(flows[1], rel=0.05)
