"""What every described key changes: for each a scene, two values and the number that must differ.

An effect that has a closed form says by how much. A key that cannot be shown so is in `elsewhere`,
with the test that shows it or the reason why nothing can.
"""

from __future__ import annotations

import scenes
import variants as v
from effect import (
    Effect,
    centre,
    largest,
    mean,
    number,
    points,
    radius_of_gyration,
    size,
    step_size,
    steps,
    supplied,
    volume,
)

import lapilli as lp

TEMPERATURE, VELOCITY = size("temperature"), size("velocity")
STRESS, DISPLACEMENT = size("stress"), size("displacement")
passed_on = number("heat/heat_from_hot_to_cold")
D, F, P, W = scenes.disk, scenes.falling_block, scenes.pressed_block, scenes.warm_fluid

EFFECTS: dict[str, Effect] = {
    "Grid.lower": Effect(F, "grid.lower", (0, 0), (0, -1), VELOCITY, "!="),
    "Grid.cell": Effect(D, "grid.cell", 0.25, 0.125, points, "x", 4.0, 0.1, steps=False),
    "Grid.shape_function": Effect(F, "grid.shape_function", "gimp", "linear", VELOCITY, "!="),
    "Time.end": Effect(D, "time.end", 0.05, 0.1, mean("temperature"), ">"),
    "Time.step": Effect(D, "time.step", 0.005, 0.0025, steps, "x", 2.0),
    "Time.steps": Effect(P, "time.steps", 2, 4, steps, "x", 2.0),
    # bodies
    "Body.shape": Effect(D, "bodies[0].shape.radius", 1.3, 1.0, volume, "<", steps=False),
    "Body.points_per_cell": Effect(
        D, "bodies[0].points_per_cell", 4, 9, points, "x", 2.25, 0.1, steps=False
    ),
    "Body.fill": Effect(
        v.box_plate, "bodies[0].fill", "lattice", "exact", volume, "!=", steps=False
    ),
    "Body.jitter": Effect(D, "bodies[0].jitter", 0.0, 0.3, size("position"), "!=", steps=False),
    "Body.random": Effect(D, "bodies[0].random", False, True, size("position"), "!=", steps=False),
    "Body.seed": Effect(v.shaken_disk, "bodies[0].seed", 1, 2, size("position"), "!=", steps=False),
    "Body.rotation": Effect(
        v.box_plate, "bodies[0].rotation", 0.0, 20.0, size("position"), "!=", steps=False
    ),
    "Body.rotation_center": Effect(
        v.rotated_box, "bodies[0].rotation_center", (0, 0), (0.1, 0.3), centre(0), ">", steps=False
    ),
    "Body.translation": Effect(
        v.box_plate, "bodies[0].translation", (0, 0), (0.3, 0), centre(0), ">", steps=False
    ),
    "Body.temperature": Effect(D, "bodies[0].temperature", 0.0, 2.0, supplied("heat"), "<"),
    "Body.source": Effect(D, "bodies[0].source", 0.0, 3.0, mean("temperature"), ">"),
    "Body.velocity": Effect(F, "bodies[0].velocity", (0.5, -1), (-0.5, -1), centre(0), "<"),
    "Body.spin": Effect(F, "bodies[0].spin", 1.0, 2.0, VELOCITY, "!="),
    "Body.spin_center": Effect(
        v.spinning_block, "bodies[0].spin_center", (1.5, 0.5), (0, 0), centre(1), ">"
    ),
    # materials
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
    "HeatContact.conductance": Effect(
        v.hot_and_cold, "heat.contacts[0].conductance", 0.5, 5.0, passed_on, ">"
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
    # heat
    "Heat.method": Effect(D, "heat.method", "virtual", "paper", supplied("heat"), "!="),
    "Heat.transfer": Effect(
        scenes.turning_disk, "heat.transfer", "affine", "pic", TEMPERATURE, "!="
    ),
    "Heat.time_integration": Effect(
        D, "heat.time_integration", "explicit", "implicit", TEMPERATURE, "!="
    ),
    "Heat.theta": Effect(v.theta_disk, "heat.theta", 0.5, 1.0, TEMPERATURE, "!="),
    "Heat.tolerance": Effect(
        v.slow_disk, "heat.tolerance", 1e-2, 1e-4, number("heat/implicit_steps"), "!="
    ),
    "Heat.blend": Effect(scenes.turning_disk, "heat.blend", 4.0, 40.0, TEMPERATURE, "!="),
    "Heat.normal_smoothing": Effect(D, "heat.normal_smoothing", 2, 0, supplied("heat"), "!="),
    "Heat.surface_fraction": Effect(
        v.paper_disk, "heat.surface_fraction", 0.55, 0.9, supplied("heat"), "!="
    ),
    "Heat.implicit_robin": Effect(D, "heat.implicit_robin", True, False, TEMPERATURE, "!="),
    "Heat.corner_fit": Effect(v.box_plate, "heat.corner_fit", True, False, supplied("heat"), "!="),
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
    # motion
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
    # momentum
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
    # quasi-static
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
    # peridynamics
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
        W, "peridynamics.flow.buoyancy", "reduced", "full", number("flow/sound_speed"), ">"
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
    "MohrCoulomb.youngs_modulus": Effect(
        scenes.soil_block, "bodies[0].material[0].youngs_modulus", 1e5, 2e5, STRESS, "!="
    ),
    "MohrCoulomb.poissons_ratio": Effect(
        scenes.soil_block, "bodies[0].material[0].poissons_ratio", 0.3, 0.2, STRESS, "!="
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
    "Translation.velocity": Effect(
        scenes.sliding_disk, "bodies[0].motion.velocity", (1, 0), (2, 0), centre(0), ">"
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
