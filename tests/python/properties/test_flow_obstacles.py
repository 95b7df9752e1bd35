"""Boxes and plates within a flowing fluid: wherever they stand, and how thick they must be."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

AIR = [
    lp.Thermal(density=1, specific_heat=1, conductivity=1),
    lp.Newtonian(density=1, viscosity=0.71, thermal_expansion=1),
]


def cavity(inner: lp.Box, points: int, rayleigh: float = 1e-2) -> lp.Scene:
    """A cold box of one metre with a hot one within."""
    cell = 1 / points
    edge = 4 * cell
    outer = {
        "left": ((-edge, -edge), (0, 1 + edge)),
        "right": ((1, -edge), (1 + edge, 1 + edge)),
        "floor": ((0, -edge), (1, 0)),
        "lid": ((0, 1), (1, 1 + edge)),
    }
    walls = [lp.FluidWall(name="hot", shape=inner, heat="temperature", temperature=1)]
    walls += [
        lp.FluidWall(
            name=name, shape=lp.Box(lower=low, upper=high), heat="temperature", temperature=0
        )
        for name, (low, high) in outer.items()
    ]
    room = lp.Difference(shape=lp.Box(lower=(0, 0), upper=(1, 1)), minus=inner)
    return lp.Scene(
        grid=lp.Grid(lower=(-edge, -edge), upper=(1 + edge, 1 + edge), cell=cell),
        bodies=[lp.Body(name="air", shape=room, points_per_cell=1, temperature=0.5, material=AIR)],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            flow=lp.PeridynamicFlow(gravity=(0, -0.71 * rayleigh)),
            walls=walls,
        ),
        time=lp.Time(end=0.15),
    )


@pytest.mark.parametrize("seed", range(4))
def test_a_box_may_stand_anywhere_in_a_fluid(seed: int) -> None:
    """Of drawn size and place: built, and at a small Rayleigh number it gives the heat that
    conduction between the same walls gives."""
    generator = np.random.default_rng(seed)
    points = 20
    size = generator.integers(5, 10, 2)
    lower = [generator.integers(5, points - 4 - one) for one in size]
    inner = lp.Box(lower=np.array(lower) / points, upper=(lower + size) / points)
    moving = cavity(inner, points)
    resting = cavity(inner, 4 * points)
    resting.peridynamics.flow = None
    given = {
        name: lp.run(scene, progress=False).history["heat/heat_flow_from_wall_hot"][-1]
        for name, scene in (("moving", moving), ("resting", resting))
    }
    assert given["moving"] == pytest.approx(given["resting"], rel=0.04)


@pytest.mark.parametrize(("layers", "fits"), [(3, False), (4, False), (5, True), (7, True)])
def test_a_plate_between_fluid_and_fluid_is_told_how_thick_it_must_be(
    layers: int, fits: bool
) -> None:
    inner = lp.Box(lower=(0.2, 0.3), upper=(0.6, 0.3 + layers / 20))
    scene = cavity(inner, 20)
    if fits:
        lp.Simulation(scene)
        return
    with pytest.raises(ValueError, match=r"wall 'hot' .* fluid on both sides.* 5 layers") as told:
        lp.Simulation(scene)
    assert f"about {layers / 20:g} m thick" in str(told.value)
    assert ", 0)" not in str(told.value)  # a place in the plane has two numbers
