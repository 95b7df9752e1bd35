"""Scenes of a few cells in which every setting can show what it does."""

import lapilli as lp

Corner = tuple[float, float]
UNIT = lp.Thermal(density=1, specific_heat=1, conductivity=1)


def disk(**heat: object) -> lp.Scene:
    """A disk that exchanges heat with warm surroundings."""
    exchange = lp.Convection(coefficient=1, ambient=1)
    return lp.Scene(
        grid=lp.Grid(lower=(-2, -2), upper=(2, 2), cell=0.25),
        bodies=[lp.Body(name="disk", shape=lp.Disk(radius=1.3), material=UNIT)],
        heat=lp.Heat(**{"boundaries": [exchange], **heat}),
        time=lp.Time(end=0.05, step=0.005),
    )


def glowing_disk() -> lp.Scene:
    """A disk that radiates."""
    return disk(boundaries=[lp.Radiation(ambient=1, stefan_boltzmann=0.5)])


def turning_disk(transfer: str = "affine") -> lp.Scene:
    """A disk that turns, half of it hot."""
    scene = disk(transfer=transfer)
    scene.bodies[0].temperature = lambda x, s, t: (x[:, 0] > 0).astype(float)
    scene.bodies[0].motion = lp.Rotation(revolutions_per_second=1.0)
    return scene


def sliding_disk() -> lp.Scene:
    """A disk that is moved along x."""
    scene = turning_disk()
    scene.bodies[0].motion = lp.Translation(velocity=(1, 0))
    return scene


def sliding_block(**contact: object) -> lp.Scene:
    """An elastic block that slides on another."""
    solid = lp.Elastic(density=1000, youngs_modulus=1e5, poissons_ratio=0.3)
    low, high = lp.Box(lower=(0.5, 0), upper=(3.5, 0.5)), lp.Box(lower=(1, 0.5), upper=(2, 1))
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 2), cell=0.25),
        bodies=[
            lp.Body(name="base", shape=low, material=solid),
            lp.Body(name="block", shape=high, material=solid, velocity=(0.5, -0.1)),
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -10),
            grid_boundaries=[lp.NoSlipBoundary(face="y_lower")],
            contacts=[lp.BodyContact(**contact)],
        ),
        time=lp.Time(end=0.1),
    )


def falling_block(**momentum: object) -> lp.Scene:
    """An elastic block that hits a wall."""
    settings = {
        "gravity": (1.0, -10.0),
        "grid_boundaries": [lp.FrictionalBoundary(face="y_lower", coefficient=0.2)],
        **momentum,
    }
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 2), cell=0.25),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(1, 0), upper=(2, 1)),
                material=lp.Elastic(density=1000, youngs_modulus=1e5, poissons_ratio=0.3),
                velocity=(0.5, -1.0),
            )
        ],
        dynamics=lp.Dynamics(**settings),
        time=lp.Time(end=0.1),
    )


def soil_block() -> lp.Scene:
    """A block of sand that yields under its weight and heats up."""
    scene = falling_block(gravity=(0.0, -10.0), grid_boundaries=[lp.NoSlipBoundary(face="y_lower")])
    sand = lp.MohrCoulomb(
        density=1000,
        youngs_modulus=1e5,
        poissons_ratio=0.3,
        friction_angle=20.0,
        dilatancy_angle=0.0,
        cohesion=50.0,
    )
    scene.bodies[0].material = [sand, lp.Thermal(density=1000, specific_heat=1, conductivity=1)]
    scene.heat = lp.Heat()
    return scene


def pressed_block(**settings: object) -> lp.Scene:
    """A block between a support that does not fit the grid and one that comes down."""
    supports = [
        lp.Support(name="base", kind="fixed", line=[(0.03, 0.13), (1.13, 0.13)]),
        lp.Support(
            name="top",
            kind="roller",
            line=[(1.13, 1.17), (0.03, 1.17)],
            displacement=(0, ((0, 1), (0, -0.02))),
        ),
    ]
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1.25, 1.25), cell=0.125),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0.1, 0.13), upper=(1.1, 1.17)),
                material=lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3),
            )
        ],
        quasi_static=lp.QuasiStatic(**{"supports": supports, **settings}),
        time=lp.Time(end=1.0, steps=2),
    )


def warm_fluid(**flow: object) -> lp.Scene:
    """A box of fluid between a hot and a cold wall."""

    def wall(
        name: str, lower: tuple[float, float], upper: tuple[float, float], **rest: object
    ) -> lp.FluidWall:
        return lp.FluidWall(name=name, shape=lp.Box(lower=lower, upper=upper), **rest)

    walls = [
        wall("hot", (-0.4, -0.4), (0.0, 1.4), heat="temperature", temperature=1.0),
        wall("cold", (1.0, -0.4), (1.4, 1.4), heat="temperature", temperature=0.0),
        wall("floor", (-0.4, -0.4), (1.4, 0.0)),
        wall("lid", (-0.4, 1.0), (1.4, 1.4)),
    ]
    water = lp.Newtonian(density=1, viscosity=0.7, thermal_expansion=0.1, reference_temperature=0.5)
    return lp.Scene(
        grid=lp.Grid(lower=(-0.4, -0.4), upper=(1.4, 1.4), cell=0.1),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0, 0), upper=(1, 1)),
                points_per_cell=1,
                material=[UNIT, water],
                temperature=lambda x, s, t: 1 - x[:, 0] ** 2,
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            flow=lp.PeridynamicFlow(**{"gravity": (0.0, -1000.0), **flow}),
            walls=walls,
        ),
        time=lp.Time(end=0.002),
    )
