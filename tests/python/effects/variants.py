"""Scenes of `scenes` with one thing changed, for keys that need it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import scenes

import lapilli as lp


def automatic(scene: lp.Scene) -> lp.Scene:
    """The same without a given step."""
    scene.time.step = "auto"
    return scene


def theta_disk() -> lp.Scene:
    return scenes.disk(time_integration="implicit")


def auto_disk() -> lp.Scene:
    return automatic(scenes.disk())


def theta_of_both() -> lp.Scene:
    scene = scenes.disk(time_integration="implicit")
    scene.bodies[0].source = 1.0
    return scene


def flux_disk() -> lp.Scene:
    return scenes.disk(boundaries=[lp.Flux(value=1.0)])


def paper_disk() -> lp.Scene:
    return scenes.disk(method="paper")


def held_disk() -> lp.Scene:
    return scenes.disk(boundaries=[lp.PrescribedTemperature(value=1.0)])


def melting_disk() -> lp.Scene:
    """A disk that melts between two temperatures."""
    scene = scenes.disk(boundaries=[lp.Flux(value=20.0)])
    scene.bodies[0].material = lp.Thermal(
        density=1, specific_heat=1, conductivity=1, latent_heat=0.5, solidus=0.2, liquidus=0.5
    )
    return scene


def hot_and_cold() -> lp.Scene:
    """Two blocks that touch with a thermal resistance."""
    unit = lp.Thermal(density=1, specific_heat=1, conductivity=1)
    hot = lp.Body(name="hot", shape=lp.Box(lower=(-1, -1), upper=(0, 1)), material=unit)
    cold = lp.Body(name="cold", shape=lp.Box(lower=(0, -1), upper=(1, 1)), material=unit)
    hot.temperature = 1.0
    return lp.Scene(
        grid=lp.Grid(lower=(-2, -2), upper=(2, 2), cell=0.25),
        bodies=[hot, cold],
        heat=lp.Heat(contacts=[lp.HeatContact(conductance=0.5)]),
        time=lp.Time(end=0.05, step=0.005),
    )


def block_below_a_plate() -> lp.Scene:
    """A warm block that an obstacle holds and cools."""
    scene = scenes.falling_block(
        gravity=(0.0, -10.0),
        grid_boundaries=[],
        outside="remove",
        obstacles=[
            lp.Obstacle(
                name="plate",
                shape=lp.Box(lower=(0, 1), upper=(4, 1.5)),
                separation=False,
                temperature=0.0,
                conductance=1e3,
                heat_capacity=1e4,
            )
        ],
    )
    body = scene.bodies[0]
    body.velocity = ()
    body.temperature = 1.0
    body.material = [
        lp.Elastic(density=1000, youngs_modulus=1e5, poissons_ratio=0.3),
        lp.Thermal(density=1000, specific_heat=1, conductivity=1e3),
    ]
    scene.heat = lp.Heat()
    return scene


def box_plate() -> lp.Scene:
    scene = scenes.disk(boundaries=[lp.Flux(value=1.0)])
    scene.bodies[0].shape = lp.Box(lower=(-1.1, -0.9), upper=(1.05, 1.15))
    return scene


def shaken_disk() -> lp.Scene:
    scene = scenes.disk()
    scene.bodies[0].jitter = 0.3
    return scene


def rotated_box() -> lp.Scene:
    scene = box_plate()
    scene.bodies[0].rotation = 20.0
    return scene


def loaded_block(load: object) -> Callable[[], lp.Scene]:
    return lambda: scenes.falling_block(gravity=(), boundaries=[load])


def sliding_block() -> lp.Scene:
    return scenes.falling_block()


def cool_fluid() -> lp.Scene:
    return scenes.warm_fluid()


def heated_fluid() -> lp.Scene:
    scene = scenes.warm_fluid()
    scene.peridynamics.walls[0].heat = "flux"
    scene.peridynamics.walls[0].temperature = 0.0
    scene.peridynamics.walls[0].flux = 1.0
    return scene


def convecting_fluid() -> lp.Scene:
    scene = scenes.warm_fluid()
    scene.peridynamics.walls[0].heat = "convection"
    scene.peridynamics.walls[0].coefficient = 1.0
    return scene


def driven_fluid() -> lp.Scene:
    scene = scenes.warm_fluid()
    scene.peridynamics.walls[3].velocity = (1.0, 0.0)
    return scene


def zero_energy_fluid() -> lp.Scene:
    scene = scenes.warm_fluid()
    scene.peridynamics.heat.laplacian = "zero-energy"
    scene.peridynamics.flow.laplacian = "zero-energy"
    return scene


def flip_block() -> lp.Scene:
    """A block whose velocity is transferred by FLIP."""
    return scenes.falling_block(transfer="flip")


def damped_block() -> lp.Scene:
    """A block that hits a wall while local damping acts."""
    return scenes.falling_block(local_damping=0.1)


def spinning_block() -> lp.Scene:
    """A block that spins in the air."""
    scene = scenes.falling_block(grid_boundaries=[])
    scene.bodies[0].shape = lp.Box(lower=(1, 0.5), upper=(2, 1.5))
    scene.bodies[0].spin = 1.0
    return scene


def resting_block() -> lp.Scene:
    """A block at rest below an even surface, with the stress of its weight."""
    scene = scenes.falling_block(
        gravity=(0.0, -10.0), grid_boundaries=[lp.NoSlipBoundary(face="y_lower")]
    )
    scene.bodies[0].velocity = ()
    scene.bodies[0].geostatic = lp.Geostatic(surface=(0, 1), normal=(0, 1), k0=0.5)
    return scene


def expanding_block() -> lp.Scene:
    """A warm block that is free to expand."""
    scene = scenes.falling_block(gravity=(), grid_boundaries=[])
    block = scene.bodies[0]
    block.shape = lp.Box(lower=(1, 0.5), upper=(2, 1.5))
    block.velocity = ()
    thermal = lp.Thermal(density=1000, specific_heat=1, conductivity=1)
    block.material = [block.material, thermal, lp.ThermalExpansion(coefficient=1e-3)]
    block.source = 1e6
    scene.heat = lp.Heat()
    return scene


def heating_soil() -> lp.Scene:
    """Sand whose plastic work becomes heat."""
    scene = scenes.soil_block()
    scene.bodies[0].material = [*scene.bodies[0].material, lp.PlasticHeating(share=0.5)]
    return scene


def rubbing_fluid() -> lp.Scene:
    """A viscous fluid under a fast lid."""
    scene = driven_fluid()
    scene.peridynamics.walls[3].velocity = (100.0, 0.0)
    return scene


def swirling_disk() -> lp.Scene:
    """Circles that turn at their own speeds."""
    scene = scenes.turning_disk()
    scene.bodies[0].motion = lp.Swirl(revolutions_per_second=1.0, shear=0.5, radius=1.3)
    return scene


def floating_block(wall: type) -> Callable[[], lp.Scene]:
    """A block without weight in the corner of two faces, moving towards both."""

    def scene() -> lp.Scene:
        made = scenes.falling_block(gravity=(), grid_boundaries=[wall(face="y_lower")])
        made.bodies[0].shape = lp.Box(lower=(0.25, 0.25), upper=(1, 1))
        made.bodies[0].velocity = (-0.5, -1.0)
        return made

    return scene


def pulled_block() -> lp.Scene:
    """A supported block with a traction on its upper face."""
    scene = scenes.pressed_block()
    base = scene.quasi_static.supports[0]
    pull = lp.SurfaceTraction(line=[(1.13, 1.17), (0.03, 1.17)], traction=(0, 100.0))
    scene.quasi_static = lp.QuasiStatic(supports=[base], tractions=[pull])
    return scene


def slow_disk() -> lp.Scene:
    """Long enough for implicit steps."""
    scene = automatic(scenes.disk(tolerance=1e-2))
    scene.time.end = 40.0
    return scene


def block_of(material: object) -> lp.Scene:
    """The block of sand of `soil_block`, of another solid and without heat."""
    scene = scenes.falling_block(
        gravity=(0.0, -10.0), grid_boundaries=[lp.NoSlipBoundary(face="y_lower")]
    )
    scene.bodies[0].material = material
    return scene


ELASTIC = {"density": 1000, "youngs_modulus": 1e5, "poissons_ratio": 0.3}


def cone_block() -> lp.Scene:
    return block_of(lp.DruckerPrager(**ELASTIC, friction_angle=20.0, cohesion=50.0))


def metal_block() -> lp.Scene:
    return block_of(lp.VonMises(**ELASTIC, yield_stress=(500.0, 800.0), plastic_strain=(0.0, 0.01)))


def clay_block() -> lp.Scene:
    return block_of(
        lp.ModifiedCamClay(
            **ELASTIC,
            critical_state_slope=1.2,
            plastic_compressibility=0.02,
            preconsolidation_pressure=1e3,
        )
    )


def tabulated_block() -> lp.Scene:
    return block_of(
        lp.TabulatedMohrCoulomb(
            **ELASTIC,
            plastic_strain=(0.0, 0.01),
            friction_angle=(30.0, 20.0),
            dilatancy_angle=(5.0, 0.0),
            cohesion=(50.0, 0.0),
        )
    )


def soft(strain: np.ndarray, stress: np.ndarray, state: np.ndarray, step: float) -> np.ndarray:
    return stress + 5e4 * strain


def softer(strain: np.ndarray, stress: np.ndarray, state: np.ndarray, step: float) -> np.ndarray:
    return stress + 2e4 * strain


def function_block() -> lp.Scene:
    return block_of(lp.FunctionSolid(**ELASTIC, function=soft))
