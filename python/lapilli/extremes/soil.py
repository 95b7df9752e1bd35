"""Heated soil that falls and spreads: shape functions, transfers, stiffness, strength, points."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import lapilli as lp

# Cell, density, conductivity and heat capacity are 1: with a modulus of 1 a wave crosses a cell
# in about 1 s, and h^2/alpha is 1 s.
SIDE = 6.0  # m


def soil_scenes() -> Iterator[tuple[str, lp.Scene]]:
    """Name and scene."""
    for shape in ("linear", "gimp", "bspline"):
        for update in ("usl", "musl"):
            yield f"{shape}, {update}", heap({"stress_update": update}, shape=shape)
    yield "gimp, apic", heap({"transfer": "apic"})
    yield "gimp, tpic", heap({"transfer": "tpic"})
    for modulus in (1e-2, 1e6):
        yield f"modulus {modulus:g}", heap(youngs_modulus=modulus)
    for friction in (0.0, 60.0):
        yield f"friction {friction:g}", heap(friction=friction)
    for points in (1, 36):
        yield f"{points} points per cell", heap(points=points)
    yield "10 m/s", heap(speed=10.0)


def heap(
    settings: dict[str, Any] | None = None,
    *,
    shape: str = "gimp",
    points: int = 4,
    speed: float = 0.2,
    youngs_modulus: float = 1.0,
    friction: float = 30.0,
) -> lp.Scene:
    """A block that is thrown to one side on a rough floor, in surroundings at 1."""
    soil = lp.MohrCoulomb(
        density=1.0, youngs_modulus=youngs_modulus, poissons_ratio=0.3, friction_angle=friction
    )
    block = lp.Body(
        shape=lp.Box(lower=(2.0, 0.0), upper=(2.0 + SIDE, SIDE)),
        points_per_cell=points,
        velocity=(speed, 0.0),
        temperature=0.0,
        material=[soil, lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0)],
    )
    walls: list[lp.NoSlipBoundary | lp.RollerBoundary | lp.FrictionalBoundary] = [
        lp.FrictionalBoundary(face="y_lower", coefficient=0.3),
        *(lp.RollerBoundary(face=face) for face in ("x_lower", "x_upper", "y_upper")),
    ]
    scene = lp.Scene(
        grid=lp.Grid(lower=(0.0, 0.0), upper=(24.0, 12.0), cell=1.0),
        bodies=[block],
        heat=lp.Heat(boundaries=[lp.Convection(coefficient=1.0, ambient=1.0)]),
        dynamics=lp.Dynamics(gravity=(0.0, -0.002 * youngs_modulus), grid_boundaries=walls),
        time=lp.Time(end=1.0),
    )
    scene = scene.set(f"grid.shape_function={shape}")
    if shape == "linear":
        scene = scene.set("heat.transfer=flip")
    for name, value in (settings or {}).items():
        scene = scene.set(f"dynamics.{name}={value}")
    return scene
