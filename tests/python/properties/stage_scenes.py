"""Scenes in stages that tests share."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import lapilli as lp

G = 9.81
STEP = 2.0**-9  # s: times of a run and of its parts are then the same to the last bit


def soil(cohesion: float = 20e3, **changes: float) -> lp.MohrCoulomb:
    values = {"density": 2000, "youngs_modulus": 2e7, "poissons_ratio": 0.3, "friction_angle": 20}
    return lp.MohrCoulomb(cohesion=cohesion, dilatancy_angle=0, **{**values, **changes})


def cut(dimension: int = 2, heat: bool = False, **dynamics: object) -> lp.Scene:
    """A slope of 45 degrees, prismatic in space, with a box of ballast on its crest."""
    flat = slice(dimension)
    profile = [(0, 0), (8, 0), (8, 1), (5, 1), (3, 3), (0, 3)]
    shape: lp.Polygon | lp.Difference = lp.Polygon(vertices=profile)
    if dimension == 3:
        shape = lp.Difference(
            shape=lp.Box(lower=(0, 0, 0), upper=(8, 3, 1)),
            minus=lp.Box(lower=(4, 1, 0), upper=(8, 3, 1)),
        )
    thermal = [lp.Thermal(density=2000, specific_heat=800, conductivity=2)] if heat else []
    faces = ["y_lower", "x_lower", "x_upper", "z_lower", "z_upper"][: 3 if dimension == 2 else 5]
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0, 0)[flat], upper=(8, 5, 1)[flat], cell=0.5),
        bodies=[
            lp.Body(
                name="slope",
                shape=shape,
                material=[soil(), *thermal],
                geostatic=lp.Geostatic(k0=0.5),
                temperature=290,
            ),
            lp.Body(
                name="ballast",
                shape=lp.Box(lower=(0, 3, 0)[flat], upper=(2, 4, 1)[flat]),
                material=[soil(1e5), *thermal],
                temperature=350,
            ),
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -G, 0)[flat],
            grid_boundaries=[
                lp.NoSlipBoundary(face=faces[0]),
                *(lp.RollerBoundary(face=face) for face in faces[1:]),
            ],
            **{"local_damping": 0.5, **dynamics},
        ),
        heat=lp.Heat(boundaries=[lp.Convection(coefficient=20, ambient=250)]) if heat else None,
        time=lp.Time(end=64 * STEP, step=STEP),
        output=lp.Output(every=32 * STEP),
    )


WEAKER = {"bodies.slope.material.mohr_coulomb.cohesion": 500.0, "dynamics.local_damping": 0.0}


def weakened(scene: lp.Scene, **changes: object) -> lp.Scene:
    scene.stages = [lp.Stage(name="weak", end=160 * STEP, set=WEAKER, **changes)]
    return scene


def everything(heat: bool = False) -> lp.Scene:
    """Three stages after the first: weaker, without ballast and with a dam, at rest with a load."""
    scene = cut(heat=heat, obstacles=[boulder(), plate()])
    scene.bodies[0].name = "slope"
    thermal = [lp.Thermal(density=2400, specific_heat=800, conductivity=2)] if heat else []
    dam = lp.Body(
        name="dam",
        shape=lp.Box(lower=(6, 1), upper=(7, 2)),
        material=[lp.Elastic(density=2400, youngs_modulus=3e7, poissons_ratio=0.2), *thermal],
        temperature=280,
    )
    scene.stages = [
        lp.Stage(name="weak", end=100 * STEP, set=WEAKER),
        lp.Stage(name="dam", end=140 * STEP, remove=["ballast", "plate"], add_bodies=[dam]),
        lp.Stage(
            name="load",
            end=170 * STEP,
            reset_velocity=True,
            add_boundaries=[
                lp.Pressure(name="fill", value=1e4, region=lp.Box(lower=(0, 2.5), upper=(2, 3.5)))
            ],
        ),
    ]
    return scene


def boulder() -> lp.Obstacle:
    return lp.Obstacle(
        name="boulder", shape=lp.Disk(center=(6.5, 4), radius=0.4), mass=500, velocity=(-1, 0)
    )


def plate() -> lp.Obstacle:
    return lp.Obstacle(name="plate", shape=lp.Box(lower=(7.5, 3), upper=(8, 3.5)), velocity=(0, 1))


def fields_of(result: lp.Result | lp.Simulation, heat: bool = False) -> dict[str, np.ndarray]:
    names = ["position", "velocity", "stress", "density", *(["temperature_carried"] * heat)]
    return {name: result.by_id(name) for name in names}


def files_of(path: Path) -> dict[str, bytes]:
    names = [".vtkhdf.data", ".checkpoint", ".csv"]
    return {name: path.with_suffix(name).read_bytes() for name in names}
