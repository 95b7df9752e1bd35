"""Keys of explicit dynamics, contacts, obstacles, load steps and supports."""

from __future__ import annotations

import scenes
import variants as v
from effect import (
    Effect,
    centre,
    largest,
    number,
    radius_of_gyration,
    size,
    step_size,
    supplied,
    volume,
)

import lapilli as lp

VELOCITY = size("velocity")
STRESS = size("stress")
DISPLACEMENT = size("displacement")
F = scenes.falling_block
P = scenes.pressed_block

EFFECTS: dict[str, Effect] = {
    "Dynamics.gravity": Effect(F, "dynamics.gravity", (0, -10), (1, -10), centre(0), ">"),
    "Dynamics.gravity_factor": Effect(
        F, "dynamics.gravity_factor", lp.Table([0, 1], [0, 1]), 1.0, centre(0), ">"
    ),
    "Dynamics.local_damping": Effect(
        v.damped_block, "dynamics.local_damping", 0.1, 0.8, number("dynamics/damping_loss"), ">"
    ),
    "Dynamics.damping_until": Effect(
        v.damped_block, "dynamics.damping_until", 0.02, 0.1, number("dynamics/damping_loss"), ">"
    ),
    "Dynamics.transfer": Effect(F, "dynamics.transfer", "flip", "apic", VELOCITY, "!="),
    "Dynamics.blend_rate": Effect(F, "dynamics.blend_rate", 4.0, 40.0, VELOCITY, "!="),
    "Dynamics.pic_fraction": Effect(
        v.flip_block, "dynamics.pic_fraction", 0.05, 0.5, VELOCITY, "!="
    ),
    "Dynamics.stress_update": Effect(F, "dynamics.stress_update", "musl", "usl", VELOCITY, "!="),
    "Dynamics.b_bar": Effect(F, "dynamics.b_bar", False, True, VELOCITY, "!="),
    "Dynamics.courant": Effect(F, "dynamics.courant", 0.5, 0.25, step_size, "x", 0.5, steps=False),
    "BodyContact.contact": Effect(
        scenes.sliding_block,
        "dynamics.contacts[0].contact",
        "frictional",
        "bonded",
        centre(0),
        "<",
    ),
    "BodyContact.friction": Effect(
        scenes.sliding_block, "dynamics.contacts[0].friction", 0.0, 0.5, centre(0), "<"
    ),
    "BodyContact.adhesion": Effect(
        scenes.sliding_block, "dynamics.contacts[0].adhesion", 0.0, 1e3, centre(0), "<"
    ),
    "Obstacle.separation": Effect(
        v.block_below_a_plate, "dynamics.obstacles[0].separation", True, False, centre(1), ">"
    ),
    "Obstacle.temperature": Effect(
        v.block_below_a_plate,
        "dynamics.obstacles[0].temperature",
        0.0,
        0.5,
        supplied("heat"),
        "x",
        0.5,
        1e-9,
    ),
    "Obstacle.conductance": Effect(
        v.block_below_a_plate,
        "dynamics.obstacles[0].conductance",
        1e3,
        1e4,
        supplied("heat"),
        "<",
    ),
    "Obstacle.heat_capacity": Effect(
        v.block_below_a_plate,
        "dynamics.obstacles[0].heat_capacity",
        1e4,
        10.0,
        number("heat/temperature_of_plate"),
        ">",
    ),
    "FrictionalBoundary.coefficient": Effect(
        F,
        "dynamics.grid_boundaries[0].coefficient",
        0.0,
        0.5,
        number("dynamics/wall_friction"),
        ">",
    ),
    "Pressure.value": Effect(
        v.loaded_block(lp.Pressure(value=10.0)),
        "dynamics.boundaries[0].value",
        10.0,
        1000.0,
        STRESS,
        "!=",
    ),
    "Traction.value": Effect(
        v.loaded_block(lp.Traction(value=(10.0, 0.0))),
        "dynamics.boundaries[0].value",
        (10.0, 0.0),
        (1000.0, 0.0),
        centre(0),
        ">",
    ),
    "Traction.factor": Effect(
        v.loaded_block(lp.Traction(value=(500.0, 0.0))),
        "dynamics.boundaries[0].factor",
        1.0,
        2.0,
        centre(0),
        ">",
    ),
    "QuasiStatic.enforcement": Effect(
        P, "quasi_static.enforcement", "mean-gap", "pointwise", DISPLACEMENT, "!="
    ),
    "QuasiStatic.bandwidth": Effect(P, "quasi_static.bandwidth", 1e-3, 1e-1, DISPLACEMENT, "!="),
    "QuasiStatic.gap_bandwidth": Effect(
        P, "quasi_static.gap_bandwidth", 0.05, 0.5, DISPLACEMENT, "!="
    ),
    "QuasiStatic.ghost_penalty": Effect(
        P, "quasi_static.ghost_penalty", 0.01, 0.5, DISPLACEMENT, "!="
    ),
    "QuasiStatic.gravity": Effect(P, "quasi_static.gravity", (0, 0), (0, -10), DISPLACEMENT, "!="),
    "QuasiStatic.body_force": Effect(
        P, "quasi_static.body_force", (0, 0), (0, -1e4), DISPLACEMENT, "!="
    ),
    "QuasiStatic.update_volumes": Effect(
        P, "quasi_static.update_volumes", True, False, volume, "!="
    ),
    "Support.displacement": Effect(
        P,
        "quasi_static.supports[1].displacement",
        (0, ((0, 1), (0, -0.02))),
        (0, ((0, 1), (0, -0.01))),
        largest("displacement"),
        "x",
        0.5,
        0.05,
    ),
    "Geostatic.k0": Effect(
        v.resting_block,
        "bodies[0].geostatic.k0",
        0.5,
        1.0,
        lambda s: float(s["stress"][:, 0].mean()),
        "x",
        2.0,
        steps=False,
    ),
    "Geostatic.surface": Effect(
        v.resting_block, "bodies[0].geostatic.surface", (0, 1), (0, 2), STRESS, "!=", steps=False
    ),
    "Geostatic.normal": Effect(
        v.resting_block, "bodies[0].geostatic.normal", (0, 1), (0.1, 1), STRESS, "!=", steps=False
    ),
    "Geostatic.surcharge": Effect(
        v.resting_block,
        "bodies[0].geostatic.surcharge",
        0.0,
        1e3,
        lambda s: float(s["stress"][:, 1].mean()),
        "<",
        steps=False,
    ),
    "ThermalExpansion.coefficient": Effect(
        v.expanding_block, "bodies[0].material[2].coefficient", 1e-3, 2e-3, radius_of_gyration, ">"
    ),
    "PlasticHeating.share": Effect(
        v.heating_soil, "bodies[0].material[2].share", 0.5, 1.0, supplied("heat"), "x", 2.0
    ),
    "SurfaceTraction.traction": Effect(
        v.pulled_block,
        "quasi_static.tractions[0].traction",
        (0, 100.0),
        (0, 200.0),
        largest("displacement"),
        "x",
        2.0,
        0.01,
    ),
    "Support.kind": Effect(
        P, "quasi_static.supports[1].kind", "roller", "fixed", DISPLACEMENT, "!="
    ),
    "Pressure.region": Effect(
        v.loaded_block(lp.Pressure(value=1000.0)),
        "dynamics.boundaries[0].region",
        None,
        lp.Box(lower=(0, 0), upper=(1.5, 2)),
        centre(0),
        ">",
    ),
    "Traction.region": Effect(
        v.loaded_block(lp.Traction(value=(1000.0, 0.0))),
        "dynamics.boundaries[0].region",
        None,
        lp.Box(lower=(0, 0), upper=(1.5, 2)),
        centre(0),
        "<",
    ),
    "NoSlipBoundary.face": Effect(
        v.floating_block(lp.NoSlipBoundary),
        "dynamics.grid_boundaries[0].face",
        "y_lower",
        "x_lower",
        VELOCITY,
        "!=",
    ),
    "RollerBoundary.face": Effect(
        v.floating_block(lp.RollerBoundary),
        "dynamics.grid_boundaries[0].face",
        "y_lower",
        "x_lower",
        VELOCITY,
        "!=",
    ),
    "FrictionalBoundary.face": Effect(
        v.floating_block(lp.FrictionalBoundary),
        "dynamics.grid_boundaries[0].face",
        "y_lower",
        "x_lower",
        VELOCITY,
        "!=",
    ),
}
