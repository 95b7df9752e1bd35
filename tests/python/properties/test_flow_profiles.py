"""Velocities between walls beside closed forms and finite differences, wherever the walls lie: what
sticks to a wall keeps the curvature of its profile up to it."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest

import lapilli as lp
from lapilli.references.cavity import Box, solve

Array = npt.NDArray[np.float64]
PRANDTL = 0.71


def slot(points: int, height: float, rayleigh: float, turn: float, shift: Array) -> lp.Scene:
    """A fluid of width 1 between a hot and a cold wall, `points` across, turned with gravity."""
    cell = 1.0 / points
    wide, far = 4.2 * cell, 5.0 * cell * math.ceil((height + 1.0) / (5.0 * cell))

    def placed(lower: tuple[float, float], upper: tuple[float, float]) -> lp.Shape:
        turned = lp.Rotated(shape=lp.Box(lower=lower, upper=upper), degrees=turn)
        return lp.Translated(shape=turned, by=tuple(shift * cell))

    ends = {
        "hot": ((-wide, -wide), (0.0, height + wide)),
        "cold": ((1.0, -wide), (1.0 + wide, height + wide)),
        "floor": ((0.0, -wide), (1.0, 0.0)),
        "ceiling": ((0.0, height), (1.0, height + wide)),
    }
    walls = [lp.FluidWall(name=name, shape=placed(*two)) for name, two in ends.items()]
    for wall, temperature in zip(walls[:2], (1.0, 0.0), strict=True):
        wall.heat, wall.temperature = "temperature", temperature
    angle, pull = math.radians(turn), PRANDTL * rayleigh
    return lp.Scene(
        grid=lp.Grid(lower=(-far, -far), upper=(far, far), cell=cell),
        bodies=[
            lp.Body(
                shape=placed((0.0, 0.0), (1.0, height)),
                points_per_cell=1,
                temperature=0.5,
                material=[
                    lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0),
                    lp.Newtonian(density=1.0, viscosity=PRANDTL, thermal_expansion=1.0),
                ],
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            flow=lp.PeridynamicFlow(gravity=(pull * math.sin(angle), -pull * math.cos(angle))),
            walls=walls,
        ),
        time=lp.Time(end=1.0),
    )


def velocity_in(scene: lp.Scene, end: float, turn: float, shift: Array) -> tuple[Array, Array]:
    """Places and velocities of the fluid at the end, in the axes of the slot."""
    simulation = lp.Simulation(scene)
    simulation.run_until(end)
    inside = simulation["body"] == 0
    angle = math.radians(turn)
    axes = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    place = simulation.position[inside] - shift * scene.grid.cell
    return place @ axes, simulation["velocity"][inside] @ axes


@pytest.mark.parametrize("seed", range(3))
def test_a_slot_flows_as_fast_as_it_should(seed: int) -> None:
    """Batchelor (1954): v = Ra (s^3 - s/4)/6 with s from the middle, far from the ends. Found 4.4,
    2.1 and 1.5 % too fast at 8, 12 and 16 points, whatever place and angle; it was 17, 9 and 5 %,
    for what a line behind the wall leaves out acted as slip."""
    generator = np.random.default_rng(seed)
    points, most = ((8, 0.06), (12, 0.03), (10, 0.04))[seed]
    turn, shift = float(generator.uniform(-60.0, 60.0)), generator.uniform(0.0, 1.0, 2)
    rayleigh = float(10.0 ** generator.uniform(0.0, 2.0))
    place, velocity = velocity_in(slot(points, 4.0, rayleigh, turn, shift), 0.5, turn, shift)
    far = np.abs(place[:, 1] - 2.0) < 0.6
    s = place[far, 0] - 0.5
    exact = rayleigh / 6.0 * (s**3 - s / 4.0)
    found = velocity[far, 1]
    assert found @ exact / (exact @ exact) == pytest.approx(1.0, abs=most)
    assert np.sqrt(np.mean((found - exact) ** 2)) < most * np.abs(exact).max()


@pytest.mark.parametrize(("rayleigh", "most"), [(10.0, 0.1), (1e3, 0.04)])
def test_a_cavity_turns_over_as_fast_as_it_should(rayleigh: float, most: float) -> None:
    """All velocities on 12 points beside finite differences: 7.7 and 2.7 % off, with corners; it
    was 15.8 and 12.3 %."""
    shift = np.zeros(2)
    place, velocity = velocity_in(slot(12, 1.0, rayleigh, 0.0, shift), 0.3, 0.0, shift)
    exact = solve(Box(rayleigh=rayleigh, prandtl=PRANDTL, heated="left"), 40).at(place)[:, :2]
    assert np.linalg.norm(velocity - exact) < most * np.linalg.norm(exact)


@pytest.mark.parametrize(
    ("laplacian", "said"), [("zero-energy", True), ("literal", True), ("corrected", False)]
)
def test_the_two_fields_of_a_flow_say_that_they_are_for_comparison(
    laplacian: str, said: bool
) -> None:
    """Found 1.43 times too fast in the slot above, in silence."""
    scene = slot(8, 1.0, 10.0, 0.0, np.zeros(2))
    assert scene.peridynamics is not None
    assert scene.peridynamics.flow is not None
    scene.peridynamics.flow.laplacian = laplacian
    simulation = lp.Simulation(scene)
    simulation.run_until(0.01)
    codes = [one.code for one in simulation.warnings()]
    assert ("peridynamics.comparison-laplacian" in codes) == said
