"""Keys of materials."""

from __future__ import annotations

import scenes
import variants as v
from effect import (
    Effect,
    largest,
    mean,
    size,
    step_size,
)

VELOCITY = size("velocity")
STRESS = size("stress")
F = scenes.falling_block
P = scenes.pressed_block
W = scenes.warm_fluid

EFFECTS: dict[str, Effect] = {
    "Thermal.density": Effect(
        v.flux_disk, "bodies[0].material.density", 1, 2, mean("temperature"), "<"
    ),
    "Thermal.specific_heat": Effect(
        v.flux_disk, "bodies[0].material.specific_heat", 1, 2, mean("temperature"), "<"
    ),
    "Thermal.latent_heat": Effect(
        v.melting_disk, "bodies[0].material.latent_heat", 0.5, 1.0, mean("temperature"), "<"
    ),
    "Thermal.solidus": Effect(
        v.melting_disk, "bodies[0].material.solidus", 0.2, 0.3, mean("liquid_fraction"), "<"
    ),
    "Thermal.liquidus": Effect(
        v.melting_disk, "bodies[0].material.liquidus", 0.5, 0.9, mean("liquid_fraction"), "<"
    ),
    "Thermal.conductivity": Effect(
        # exchange with the surroundings is in the fastest rate as well
        v.auto_disk,
        "bodies[0].material.conductivity",
        1,
        2,
        step_size,
        "x",
        0.5,
        0.06,
        steps=False,
    ),
    "Elastic.density": Effect(F, "bodies[0].material.density", 1000, 2000, VELOCITY, "!="),
    "Elastic.youngs_modulus": Effect(
        P, "bodies[0].material.youngs_modulus", 1e6, 2e6, STRESS, "x", 2.0, 1e-6
    ),
    "Elastic.poissons_ratio": Effect(
        P, "bodies[0].material.poissons_ratio", 0.3, 0.1, STRESS, "!="
    ),
    "MohrCoulomb.friction_angle": Effect(
        scenes.soil_block, "bodies[0].material[0].friction_angle", 20.0, 40.0, STRESS, "!="
    ),
    "MohrCoulomb.dilatancy_angle": Effect(
        scenes.soil_block, "bodies[0].material[0].dilatancy_angle", 0.0, 15.0, STRESS, "!="
    ),
    "MohrCoulomb.cohesion": Effect(
        scenes.soil_block, "bodies[0].material[0].cohesion", 50.0, 2000.0, STRESS, "!="
    ),
    "MohrCoulomb.tension_cutoff": Effect(
        scenes.soil_block, "bodies[0].material[0].tension_cutoff", 0.0, 50.0, STRESS, "!="
    ),
    "DruckerPrager.density": Effect(
        v.cone_block, "bodies[0].material.density", 1000, 1500, STRESS, "!="
    ),
    "DruckerPrager.youngs_modulus": Effect(
        v.cone_block, "bodies[0].material.youngs_modulus", 1e5, 2e5, STRESS, "!="
    ),
    "DruckerPrager.poissons_ratio": Effect(
        v.cone_block, "bodies[0].material.poissons_ratio", 0.3, 0.2, STRESS, "!="
    ),
    "VonMises.density": Effect(
        v.metal_block, "bodies[0].material.density", 1000, 1500, STRESS, "!="
    ),
    "VonMises.youngs_modulus": Effect(
        v.metal_block, "bodies[0].material.youngs_modulus", 1e5, 2e5, STRESS, "!="
    ),
    "VonMises.poissons_ratio": Effect(
        v.metal_block, "bodies[0].material.poissons_ratio", 0.3, 0.2, STRESS, "!="
    ),
    "TabulatedMohrCoulomb.density": Effect(
        v.tabulated_block, "bodies[0].material.density", 1000, 1500, STRESS, "!="
    ),
    "TabulatedMohrCoulomb.youngs_modulus": Effect(
        v.tabulated_block, "bodies[0].material.youngs_modulus", 1e5, 2e5, STRESS, "!="
    ),
    "TabulatedMohrCoulomb.poissons_ratio": Effect(
        v.tabulated_block, "bodies[0].material.poissons_ratio", 0.3, 0.2, STRESS, "!="
    ),
    "ModifiedCamClay.density": Effect(
        v.clay_block, "bodies[0].material.density", 1000, 1500, STRESS, "!="
    ),
    "ModifiedCamClay.youngs_modulus": Effect(
        v.clay_block, "bodies[0].material.youngs_modulus", 1e5, 2e5, STRESS, "!="
    ),
    "ModifiedCamClay.poissons_ratio": Effect(
        v.clay_block, "bodies[0].material.poissons_ratio", 0.3, 0.2, STRESS, "!="
    ),
    "ModifiedCamClay.critical_state_slope": Effect(
        v.clay_block, "bodies[0].material.critical_state_slope", 1.2, 0.8, STRESS, "!="
    ),
    "ModifiedCamClay.plastic_compressibility": Effect(
        v.clay_block, "bodies[0].material.plastic_compressibility", 0.02, 0.04, STRESS, "!="
    ),
    "ModifiedCamClay.preconsolidation_pressure": Effect(
        v.clay_block, "bodies[0].material.preconsolidation_pressure", 1e3, 2e3, STRESS, "!="
    ),
    "FunctionSolid.density": Effect(
        v.function_block, "bodies[0].material.density", 1000, 1500, STRESS, "!="
    ),
    "FunctionSolid.youngs_modulus": Effect(
        v.function_block, "bodies[0].material.youngs_modulus", 1e5, 2e5, step_size, "<"
    ),
    "FunctionSolid.poissons_ratio": Effect(
        v.function_block, "bodies[0].material.poissons_ratio", 0.1, 0.3, step_size, "<"
    ),
    "FunctionSolid.function": Effect(
        v.function_block, "bodies[0].material.function", v.soft, v.softer, STRESS, "!="
    ),
    "DruckerPrager.friction_angle": Effect(
        v.cone_block, "bodies[0].material.friction_angle", 20.0, 40.0, STRESS, "!="
    ),
    "DruckerPrager.dilatancy_angle": Effect(
        v.cone_block, "bodies[0].material.dilatancy_angle", 0.0, 15.0, STRESS, "!="
    ),
    "DruckerPrager.cohesion": Effect(
        v.cone_block, "bodies[0].material.cohesion", 50.0, 2000.0, STRESS, "!="
    ),
    "DruckerPrager.fit": Effect(
        v.cone_block, "bodies[0].material.fit", "plane_strain", "compression", STRESS, "!="
    ),
    "VonMises.yield_stress": Effect(
        v.metal_block,
        "bodies[0].material.yield_stress",
        (500.0, 800.0),
        (600.0, 800.0),
        STRESS,
        "!=",
    ),
    "VonMises.plastic_strain": Effect(
        v.metal_block, "bodies[0].material.plastic_strain", (0.0, 0.01), (0.0, 0.1), STRESS, "!="
    ),
    "TabulatedMohrCoulomb.plastic_strain": Effect(
        v.tabulated_block,
        "bodies[0].material.plastic_strain",
        (0.0, 0.01),
        (0.0, 0.001),
        STRESS,
        "!=",
    ),
    "TabulatedMohrCoulomb.friction_angle": Effect(
        v.tabulated_block,
        "bodies[0].material.friction_angle",
        (30.0, 20.0),
        (30.0, 25.0),
        STRESS,
        "!=",
    ),
    "TabulatedMohrCoulomb.dilatancy_angle": Effect(
        v.tabulated_block,
        "bodies[0].material.dilatancy_angle",
        (5.0, 0.0),
        (15.0, 0.0),
        STRESS,
        "!=",
    ),
    "TabulatedMohrCoulomb.cohesion": Effect(
        v.tabulated_block, "bodies[0].material.cohesion", (50.0, 0.0), (500.0, 0.0), STRESS, "!="
    ),
    "TabulatedMohrCoulomb.tension_cutoff": Effect(
        v.tabulated_block, "bodies[0].material.tension_cutoff", 50.0, 0.0, STRESS, "!="
    ),
    "Newtonian.viscosity": Effect(
        W, "bodies[0].material[1].viscosity", 0.7, 2.0, largest("velocity"), "<"
    ),
    "Newtonian.thermal_expansion": Effect(
        W, "bodies[0].material[1].thermal_expansion", 0.1, 0.2, largest("velocity"), ">"
    ),
    "Newtonian.reference_temperature": Effect(
        W, "bodies[0].material[1].reference_temperature", 0.5, 0.2, VELOCITY, "!="
    ),
    "MohrCoulomb.youngs_modulus": Effect(
        scenes.soil_block, "bodies[0].material[0].youngs_modulus", 1e5, 2e5, STRESS, "!="
    ),
    "MohrCoulomb.poissons_ratio": Effect(
        scenes.soil_block, "bodies[0].material[0].poissons_ratio", 0.3, 0.2, STRESS, "!="
    ),
}
