"""References for a closed box of fluid between a hot and a cold wall, set up from its scene."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

import lapilli._core as lp
from lapilli._core import Scene

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class Enclosure:
    """The box of a peridynamic scene: where it lies, what it holds and what drives it."""

    lower: Array  # m
    size: Array  # m
    axis: int  # from the hot wall to the cold one
    hot: float  # K
    cold: float  # K
    diffusivity: float  # m^2/s
    viscosity: float  # m^2/s; 0 without flow
    buoyancy: float  # m/s^2 for each K, upwards

    @property
    def length(self) -> float:
        """From the hot to the cold wall, m."""
        return float(self.size[self.axis])

    @property
    def rayleigh(self) -> float:
        """Rayleigh number of that length."""
        drive = self.buoyancy * (self.hot - self.cold) * self.length**3
        return drive / (self.viscosity * self.diffusivity)


@dataclass(frozen=True)
class PlatesReference:
    """Conduction alone from a uniform start (Crank 1975)."""

    box: Enclosure
    initial: float  # K

    def __call__(self, position: Array, time: float) -> Array:
        from lapilli.references.slab import prescribed_slab

        along = np.clip((position[:, self.box.axis] - self.box.lower[self.box.axis])
                        / self.box.length, 0, 1)  # fmt: skip
        scaled = time * self.box.diffusivity / self.box.length**2
        values: Array = prescribed_slab(
            along, scaled, left=self.box.hot, right=self.box.cold, initial=self.initial
        )
        return values


@dataclass(frozen=True)
class SteadyFlowReference:
    """The steady buoyant flow by finite differences; the run must have become steady."""

    box: Enclosure
    velocity: bool
    cells: int = 80

    @cached_property
    def flow(self) -> Any:
        from lapilli.references.cavity import Box, solve

        prandtl = self.box.viscosity / self.box.diffusivity
        width, height = self.box.size / self.box.length
        heated, aspect = ("left", height) if self.box.axis == 0 else ("bottom", width)
        return solve(
            Box(
                rayleigh=self.box.rayleigh,
                prandtl=prandtl,
                heated=heated,
                aspect=float(aspect),
                rolls=max(1, round(float(aspect))) if heated == "bottom" else 1,
            ),
            self.cells,
        )

    def __call__(self, position: Array, time: float) -> Array:
        del time
        places = (position[:, :2] - self.box.lower) / self.box.length
        found = self.flow.at(np.clip(places, 0, self.box.size / self.box.length))
        values: Array
        if self.velocity:
            values = found[:, :2] * self.box.diffusivity / self.box.length
        else:
            values = self.box.cold + (self.box.hot - self.box.cold) * found[:, 2]
        return values


def plates(scene: Scene) -> PlatesReference:
    """Conduction between two held walls."""
    box = enclosure(scene, "plates")
    start = scene.bodies[0].temperature
    if flow_of(scene) is not None or not isinstance(start, float | int):
        raise ValueError("reference plates: heat alone, from one temperature")
    return PlatesReference(box, float(start))


def cavity(scene: Scene) -> SteadyFlowReference:
    """Temperature of the steady buoyant flow."""
    return SteadyFlowReference(flowing(scene, "cavity"), velocity=False)


def cavity_velocity(scene: Scene) -> SteadyFlowReference:
    """Velocity of the steady buoyant flow."""
    return SteadyFlowReference(flowing(scene, "cavity-velocity"), velocity=True)


def flowing(scene: Scene, name: str) -> Enclosure:
    """The enclosure of a scene in two dimensions with a flow."""
    box = enclosure(scene, name)
    if flow_of(scene) is None or len(box.size) != 2 or box.viscosity == 0:
        raise ValueError(f"reference {name}: a viscous flow in two dimensions is needed")
    return box


def enclosure(scene: Scene, name: str) -> Enclosure:
    """The box of a peridynamic scene; a ValueError says why there is none."""
    if scene.peridynamics is None or len(scene.bodies) != 1:
        raise ValueError(f"reference {name}: [peridynamics] with one body is needed")
    body = scene.bodies[0]
    if not isinstance(body.shape, lp.Box) or body.rotation or body.translation:
        raise ValueError(f"reference {name}: the body must be a Box along the axes")
    lower, upper = np.asarray(body.shape.lower), np.asarray(body.shape.upper)
    held = [wall for wall in scene.peridynamics.walls if wall.heat == "temperature"]
    boxes = [wall.shape for wall in held if isinstance(wall.shape, lp.Box)]
    open_walls = {wall.heat for wall in scene.peridynamics.walls} - {"temperature", "adiabatic"}
    if len(held) != 2 or open_walls or len(boxes) != 2:
        raise ValueError(f"reference {name}: two walls with a temperature, the others adiabatic")
    for axis in range(len(lower)):
        before = [
            wall for wall, box in zip(held, boxes, strict=True) if box.upper[axis] <= lower[axis]
        ]
        behind = [
            wall for wall, box in zip(held, boxes, strict=True) if box.lower[axis] >= upper[axis]
        ]
        if len(before) == len(behind) == 1:
            thermal, fluid, buoyancy = coefficients(scene)
            return Enclosure(
                lower, upper - lower, axis, number(before[0].temperature),
                number(behind[0].temperature), thermal, fluid, buoyancy,
            )  # fmt: skip
    raise ValueError(f"reference {name}: the two walls must face each other")


def flow_of(scene: Scene) -> lp.PeridynamicFlow | None:
    """The flow of a peridynamic scene, if it has any."""
    return scene.peridynamics.flow if scene.peridynamics is not None else None


def coefficients(scene: Scene) -> tuple[float, float, float]:
    """Thermal diffusivity, kinematic viscosity, upward acceleration for each K."""
    given = scene.bodies[0].material
    materials = given if isinstance(given, list) else [given]
    thermal = next(one for one in materials if isinstance(one, lp.Thermal))
    diffusivity = number(thermal.conductivity) / (thermal.density * number(thermal.specific_heat))
    fluids = [one for one in materials if isinstance(one, lp.Newtonian)]
    flow = flow_of(scene)
    if not fluids or flow is None:
        return diffusivity, 0.0, 0.0
    gravity = flow.gravity
    return (
        diffusivity,
        fluids[0].viscosity / fluids[0].density,
        fluids[0].thermal_expansion * -gravity[-1] if gravity else 0.0,
    )


def number(value: Any) -> float:
    """A constant."""
    if not isinstance(value, float | int):
        raise ValueError(f"references of enclosures need constant numbers, got {value}")
    return float(value)
