"""Keys of peridynamic flow and heat."""

from __future__ import annotations

import scenes
import variants as v
from effect import (
    Effect,
    largest,
    mean,
    number,
    size,
)

TEMPERATURE = size("temperature")
VELOCITY = size("velocity")
W = scenes.warm_fluid

EFFECTS: dict[str, Effect] = {
    "PeridynamicHeat.horizon": Effect(
        W, "peridynamics.heat.horizon", 1.515, 3.015, TEMPERATURE, "!="
    ),
    "PeridynamicHeat.laplacian": Effect(
        W, "peridynamics.heat.laplacian", "corrected", "compact", TEMPERATURE, "!="
    ),
    "PeridynamicHeat.zero_energy": Effect(
        v.zero_energy_fluid, "peridynamics.heat.zero_energy", 0.5, 1.0, TEMPERATURE, "!="
    ),
    "PeridynamicHeat.step_factor": Effect(
        W,
        "peridynamics.heat.step_factor",
        0.25,
        0.05,
        lambda s: s.limits()["heat"][0],
        "x",
        0.2,
        steps=False,
    ),
    "PeridynamicFlow.gravity": Effect(
        W, "peridynamics.flow.gravity", (0, -1000), (0, -500), largest("velocity"), "<"
    ),
    "PeridynamicFlow.buoyancy": Effect(
        W, "peridynamics.flow.buoyancy", "reduced", "full", size("pressure"), "!="
    ),
    "PeridynamicFlow.horizon": Effect(W, "peridynamics.flow.horizon", 3.015, 2.015, VELOCITY, "!="),
    "PeridynamicFlow.laplacian": Effect(
        W, "peridynamics.flow.laplacian", "corrected", "compact", VELOCITY, "!="
    ),
    "PeridynamicFlow.sound_speed": Effect(
        W, "peridynamics.flow.sound_speed", 50.0, 75.0, number("flow/sound_speed"), "x", 1.5
    ),
    "PeridynamicFlow.sound_speed_factor": Effect(
        W, "peridynamics.flow.sound_speed_factor", 5.0, 8.0, number("flow/sound_speed"), "x", 1.6
    ),
    "PeridynamicFlow.length": Effect(
        W, "peridynamics.flow.length", 1.0, 4.0, number("flow/sound_speed"), "x", 2.0
    ),
    "PeridynamicFlow.temperature_range": Effect(
        W, "peridynamics.flow.temperature_range", 1.0, 4.0, number("flow/sound_speed"), "x", 2.0
    ),
    "PeridynamicFlow.stiffness_exponent": Effect(
        W, "peridynamics.flow.stiffness_exponent", 7.0, 1.0, size("pressure"), "!="
    ),
    "PeridynamicFlow.density_diffusion": Effect(
        W, "peridynamics.flow.density_diffusion", 0.1, 0.0, size("density"), "!="
    ),
    "PeridynamicFlow.shifting": Effect(
        W, "peridynamics.flow.shifting", 0.1, 0.0, size("position"), "!="
    ),
    "PeridynamicFlow.courant": Effect(
        W,
        "peridynamics.flow.courant",
        0.5,
        0.1,
        lambda s: s.limits()["flow"][0],
        "<",
        steps=False,
    ),
    "PeridynamicFlow.viscous_step": Effect(
        W,
        "peridynamics.flow.viscous_step",
        0.25,
        0.01,
        lambda s: s.limits()["flow"][0],
        "<",
        steps=False,
    ),
    "FluidWall.slip": Effect(
        v.driven_fluid, "peridynamics.walls[3].slip", "no-slip", "free-slip", VELOCITY, "!="
    ),
    "FluidWall.velocity": Effect(
        v.driven_fluid, "peridynamics.walls[3].velocity", (1, 0), (2, 0), VELOCITY, "!="
    ),
    "FluidWall.temperature": Effect(
        W, "peridynamics.walls[0].temperature", 1.0, 2.0, mean("temperature"), ">"
    ),
    "FluidWall.flux": Effect(
        v.heated_fluid,
        "peridynamics.walls[0].flux",
        1.0,
        3.0,
        number("heat/heat_flow_from_wall_hot"),
        "x",
        3.0,
    ),
    "FluidWall.coefficient": Effect(
        v.convecting_fluid, "peridynamics.walls[0].coefficient", 1.0, 5.0, mean("temperature"), "!="
    ),
    "PeridynamicFlow.influence": Effect(
        W, "peridynamics.flow.influence", "gaussian", "unity", VELOCITY, "!="
    ),
    "PeridynamicHeat.influence": Effect(
        W, "peridynamics.heat.influence", "gaussian", "unity", TEMPERATURE, "!="
    ),
    "PeridynamicFlow.zero_energy": Effect(
        v.zero_energy_fluid, "peridynamics.flow.zero_energy", 1.0, 2.0, VELOCITY, "!="
    ),
    "PeridynamicHeat.viscous_dissipation": Effect(
        v.rubbing_fluid,
        "peridynamics.heat.viscous_dissipation",
        False,
        True,
        mean("temperature"),
        ">",
    ),
}
