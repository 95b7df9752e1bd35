"""Peridynamic fluid: at rest where it is stratified, and bodies that conduct, anywhere."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

import lapilli as lp
from lapilli.extremes.trials.trial import Mark, Trial
from lapilli.references.arrays import Array

ROWS = 12
WIDE = 0.5
CENTER = (0.53, 0.47)
REST_BAR = 0.01  # of the speed of free fall by the difference of densities
POWER_BAR = 0.03  # found .021 at twelve points across, turned


def fluid_trials() -> Iterator[Trial]:
    """A square heated from above, level or turned with its gravity."""
    for degrees in (0.0, 17.0):
        for rayleigh in (1e2, 1e4, 1e6):
            for prandtl in (0.01, 1.0, 100.0):
                yield stratified(degrees, rayleigh, prandtl)


def stratified(degrees: float, rayleigh: float, prandtl: float) -> Trial:
    """Hot above, cold below: conduction alone, and no motion."""
    angle = np.radians(degrees)
    gravity = rayleigh * prandtl * np.array((np.sin(angle), -np.cos(angle)))
    boxes = {
        "bottom": ((-WIDE, -WIDE), (1 + WIDE, 0.0)),
        "top": ((-WIDE, 1.0), (1 + WIDE, 1 + WIDE)),
        "left": ((-WIDE, 0.0), (0.0, 1.0)),
        "right": ((1.0, 0.0), (1 + WIDE, 1.0)),
    }

    def turned(lower: tuple[float, float], upper: tuple[float, float]) -> lp.Shape:
        return lp.Rotated(shape=lp.Box(lower=lower, upper=upper), degrees=degrees, center=CENTER)

    walls = [lp.FluidWall(name=name, shape=turned(*box)) for name, box in boxes.items()]
    for wall, held in zip(walls[:2], (0.0, 1.0), strict=True):
        wall.heat, wall.temperature = "temperature", held
    up = np.array((-np.sin(angle), np.cos(angle)))

    def start(x: Array, _s: object, _t: float) -> Array:
        found: Array = 0.5 + (x[:, :2] - np.array(CENTER)) @ up + (CENTER[1] - 0.5)
        return found

    fluid = lp.Newtonian(
        density=1.0, viscosity=prandtl, thermal_expansion=1.0, reference_temperature=0.5
    )
    scene = lp.Scene(
        grid=lp.Grid(lower=(-1.0, -1.0), upper=(2.0, 2.0), cell=1.0 / ROWS),
        bodies=[
            lp.Body(
                name="fluid",
                shape=turned((0.0, 0.0), (1.0, 1.0)),
                points_per_cell=1,
                material=[lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0), fluid],
                temperature=start,
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            flow=lp.PeridynamicFlow(gravity=tuple(gravity)),
            walls=walls,
        ),
        time=lp.Time(end=2.0 / np.sqrt(rayleigh * prandtl)),
    )
    name = f"stratified at {degrees:g} degrees, Ra {rayleigh:g}, Pr {prandtl:g}"
    return Trial("fluid", name, scene, partial(judge_rest, rayleigh * prandtl), ("speed",))


def judge_rest(weight: float, scene: lp.Scene) -> Sequence[Mark]:
    """The speed over that of free fall through the box, and the heat through the top."""
    simulation = lp.Simulation(scene)
    simulation.run_until(scene.time.end)
    speed = float(np.linalg.norm(simulation["velocity"], axis=1).max()) / np.sqrt(weight)
    numbers = simulation.diagnostics()
    power = next(value for name, value in numbers.items() if name.endswith("from_wall_top"))
    return [
        Mark("speed", speed, REST_BAR),
        Mark("error of the heat through the top", abs(power - 1.0), POWER_BAR),
    ]
