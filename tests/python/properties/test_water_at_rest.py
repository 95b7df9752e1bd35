"""Water in a closed box bears its weight and rests."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

G = 9.81
DENSITY = 1000.0
WARM = 300.0  # K


def box(across: int, degrees: float = 0.0, shift: float = 0.0, heat: bool = True) -> lp.Scene:
    """A metre of water, gravity turned, all of it at one temperature."""
    cell = 1 / across
    lower, upper = shift * np.ones(2), 1 + shift * np.ones(2)
    angle = np.radians(degrees)
    water = lp.Box(lower=tuple(lower), upper=tuple(upper))
    around = lp.Difference(
        shape=lp.Box(lower=tuple(lower - 5 * cell), upper=tuple(upper + 5 * cell)), minus=water
    )
    newtonian = lp.Newtonian(density=DENSITY, viscosity=1.0)
    thermal = lp.Thermal(density=DENSITY, specific_heat=4186, conductivity=0.6)
    if heat:
        newtonian = lp.Newtonian(
            density=DENSITY,
            viscosity=1.0,
            thermal_expansion=2e-4,
            reference_temperature=WARM,
        )
    wall = {"heat": "temperature", "temperature": WARM} if heat else {}
    return lp.Scene(
        grid=lp.Grid(lower=(-6 * cell, -6 * cell), upper=(1 + 8 * cell, 1 + 8 * cell), cell=cell),
        bodies=[
            lp.Body(
                name="water",
                shape=water,
                points_per_cell=1,
                temperature=WARM,
                material=[thermal, newtonian] if heat else [newtonian],
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat() if heat else None,
            flow=lp.PeridynamicFlow(
                gravity=(G * np.sin(angle), -G * np.cos(angle)), buoyancy="full"
            ),
            walls=[lp.FluidWall(name="box", shape=around, **wall)],
        ),
        time=lp.Time(end=1.0),
    )


@pytest.mark.parametrize(
    ("across", "degrees", "shift", "heat"),
    [(12, 0, 0, True), (13, 0, 0.037, True), (12, 30, 0, True), (24, 0, 0, False)],
)
def test_water_rests_under_the_pressure_of_its_weight(
    across: int, degrees: float, shift: float, heat: bool
) -> None:
    """It moved by 0.11 to 0.22 of sqrt(g l): sums over bonds leave some of a pressure of 5 kPa."""
    simulation = lp.Simulation(box(across, degrees, shift, heat))
    simulation.run_until(1.0)
    assert np.abs(simulation["velocity"]).max() < 1e-9 * np.sqrt(G)
    angle = np.radians(degrees)
    water = simulation.by_id("body") == 0
    place = simulation.by_id("position").reshape(-1, 2)[water]
    pull = DENSITY * G * np.array([np.sin(angle), -np.cos(angle)])
    exact = (place - 0.5 - shift) @ pull
    assert np.abs(simulation.by_id("pressure")[water] - exact).max() < 1e-6 * DENSITY * G
