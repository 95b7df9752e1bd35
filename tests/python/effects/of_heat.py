"""Keys of heat, its boundaries, and bodies that move as they are told."""

from __future__ import annotations

import scenes
import variants as v
from effect import (
    Effect,
    centre,
    number,
    size,
    supplied,
)

import lapilli as lp

TEMPERATURE = size("temperature")
D = scenes.disk

EFFECTS: dict[str, Effect] = {
    "Heat.method": Effect(D, "heat.method", "virtual", "paper", supplied("heat"), "!="),
    "Heat.transfer": Effect(
        scenes.turning_disk, "heat.transfer", "affine", "pic", TEMPERATURE, "!="
    ),
    "Heat.time_integration": Effect(
        D, "heat.time_integration", "explicit", "implicit", TEMPERATURE, "!="
    ),
    "Heat.theta": Effect(v.theta_disk, "heat.theta", 0.5, 1.0, TEMPERATURE, "!="),
    "Heat.tolerance": Effect(
        v.slow_disk, "heat.tolerance", 1e-2, 1e-4, number("heat/staged_steps"), "!="
    ),
    "Heat.blend": Effect(scenes.turning_disk, "heat.blend", 4.0, 40.0, TEMPERATURE, "!="),
    "Heat.normal_smoothing": Effect(D, "heat.normal_smoothing", 2, 0, supplied("heat"), "!="),
    "Heat.surface_fraction": Effect(
        v.paper_disk, "heat.surface_fraction", 0.55, 0.9, supplied("heat"), "!="
    ),
    "Heat.implicit_robin": Effect(D, "heat.implicit_robin", True, False, TEMPERATURE, "!="),
    "Heat.corner_fit": Effect(v.box_plate, "heat.corner_fit", True, False, supplied("heat"), "!="),
    "Heat.subcycling": Effect(
        scenes.soil_block,
        "heat.subcycling",
        False,
        True,
        lambda s: s.diagnostics().get("heat/steps_per_heat_step", 1.0),
        ">",
    ),
    "Flux.value": Effect(
        v.flux_disk, "heat.boundaries[0].value", 1.0, 2.5, supplied("heat"), "x", 2.5
    ),
    "Flux.region": Effect(
        v.flux_disk,
        "heat.boundaries[0].region",
        None,
        lp.HalfSpace(point=(0, 0), normal=(1, 0)),
        supplied("heat"),
        "x",
        0.5,
        1e-2,
    ),
    "Convection.coefficient": Effect(
        D, "heat.boundaries[0].coefficient", 1.0, 2.0, supplied("heat"), ">"
    ),
    "Convection.ambient": Effect(
        D, "heat.boundaries[0].ambient", 1.0, 3.0, supplied("heat"), "x", 3.0
    ),
    "Radiation.emissivity": Effect(
        scenes.glowing_disk, "heat.boundaries[0].emissivity", 1.0, 0.5, supplied("heat"), "<"
    ),
    "Radiation.ambient": Effect(
        scenes.glowing_disk, "heat.boundaries[0].ambient", 1.0, 1.2, supplied("heat"), ">"
    ),
    "Radiation.stefan_boltzmann": Effect(
        scenes.glowing_disk, "heat.boundaries[0].stefan_boltzmann", 0.5, 1.0, supplied("heat"), ">"
    ),
    "Heat.temperature_unit": Effect(
        scenes.glowing_disk, "heat.temperature_unit", "kelvin", "celsius", supplied("heat"), "!="
    ),
    "PrescribedTemperature.value": Effect(
        v.held_disk, "heat.boundaries[0].value", 1.0, 2.0, supplied("heat"), "x", 2.0
    ),
    "Rotation.revolutions_per_second": Effect(
        scenes.turning_disk,
        "bodies[0].motion.revolutions_per_second",
        1.0,
        2.0,
        size("position"),
        "!=",
    ),
    "Rotation.center": Effect(
        scenes.turning_disk, "bodies[0].motion.center", (0, 0), (0.2, 0), centre(1), "!="
    ),
    "Swirl.revolutions_per_second": Effect(
        v.swirling_disk,
        "bodies[0].motion.revolutions_per_second",
        1.0,
        2.0,
        size("position"),
        "!=",
    ),
    "Swirl.shear": Effect(
        v.swirling_disk, "bodies[0].motion.shear", 0.5, 0.0, size("position"), "!="
    ),
    "Swirl.radius": Effect(
        v.swirling_disk, "bodies[0].motion.radius", 1.3, 2.6, size("position"), "!="
    ),
    "Swirl.center": Effect(
        v.swirling_disk, "bodies[0].motion.center", (0, 0), (0.1, 0), size("position"), "!="
    ),
    "Convection.region": Effect(
        D,
        "heat.boundaries[0].region",
        None,
        lp.HalfSpace(point=(0, 0), normal=(1, 0)),
        supplied("heat"),
        "x",
        0.5,
        1e-2,
    ),
    "Radiation.region": Effect(
        scenes.glowing_disk,
        "heat.boundaries[0].region",
        None,
        lp.HalfSpace(point=(0, 0), normal=(1, 0)),
        supplied("heat"),
        "x",
        0.5,
        1e-2,
    ),
    "PrescribedTemperature.region": Effect(
        v.held_disk,
        "heat.boundaries[0].region",
        None,
        lp.HalfSpace(point=(0, 0), normal=(1, 0)),
        supplied("heat"),
        "<",
    ),
    "Translation.velocity": Effect(
        scenes.sliding_disk, "bodies[0].motion.velocity", (1, 0), (2, 0), centre(0), ">"
    ),
    "HeatContact.conductance": Effect(
        v.hot_and_cold,
        "heat.contacts[0].conductance",
        0.5,
        5.0,
        number("heat/heat_from_hot_to_cold"),
        ">",
    ),
}
