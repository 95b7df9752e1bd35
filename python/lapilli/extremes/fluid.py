"""Peridynamic cavities that try the step: horizons, forms of the Laplacian, scattered points."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import lapilli as lp

ROWS = 16
REACH = 6  # layers of wall points drawn; what no fluid can feel is left out
FORMS = ("corrected", "compact", "zero-energy", "literal")


def fluid_scenes() -> Iterator[tuple[str, lp.Scene]]:
    """Name and scene: heat alone with every form, then flow."""
    for form in FORMS:
        yield f"heat, {form}", cavity(0.0, heat={"laplacian": form})
    yield "heat, 25 % jitter", cavity(0.0, jitter=0.25)
    yield "heat, random points", cavity(0.0, random=True)
    yield "heat, horizon 3", cavity(0.0, heat={"horizon": 3.015})
    for rayleigh in (1e3, 1e5, 1e8):
        yield f"flow, Ra {rayleigh:.0e}", cavity(rayleigh)
    for prandtl in (0.01, 100.0):
        yield f"flow, Pr {prandtl:g}", cavity(1e4, prandtl)
    yield "flow, compact", cavity(1e4, flow={"laplacian": "compact"})
    yield "flow, zero-energy", cavity(1e4, flow={"laplacian": "zero-energy"})
    yield "flow, horizon 2", cavity(1e4, flow={"horizon": 2.0})
    yield "flow, horizon 5", cavity(1e4, flow={"horizon": 5.0})
    for horizon in (1.2, 5.0):
        yield f"flow, thermal horizon {horizon:g}", cavity(1e4, heat={"horizon": horizon})
    for factor in (3.0, 20.0):
        yield (
            f"flow, sound speed factor {factor:g}",
            cavity(1e4, flow={"sound_speed_factor": factor}),
        )
    yield "flow, 25 % jitter", cavity(1e4, jitter=0.25)
    yield "flow, random points", cavity(1e4, random=True)


def cavity(
    rayleigh: float,
    prandtl: float = 0.71,
    rows: int = ROWS,
    *,
    heat: dict[str, Any] | None = None,
    flow: dict[str, Any] | None = None,
    **layout: Any,
) -> lp.Scene:
    """A unit square of fluid between a wall at 1 and one at 0, insulated above and below; without
    flow where the Rayleigh number is 0 and no setting of it is given."""
    dx = 1 / rows
    wide = REACH * dx
    sides = {
        "hot": ((-wide, -wide), (0.0, 1 + wide), 1.0),
        "cold": ((1.0, -wide), (1 + wide, 1 + wide), 0.0),
        "bottom": ((0.0, -wide), (1.0, 0.0), None),
        "top": ((0.0, 1.0), (1.0, 1 + wide), None),
    }
    walls = [
        lp.FluidWall(name=name, shape=lp.Box(lower=lower, upper=upper))
        if held is None
        else lp.FluidWall(
            name=name, shape=lp.Box(lower=lower, upper=upper), heat="temperature", temperature=held
        )
        for name, (lower, upper, held) in sides.items()
    ]
    moving = rayleigh > 0 or flow is not None
    material: list[Any] = [lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0)]
    if moving:
        material.append(
            lp.Newtonian(
                density=1.0, viscosity=prandtl, thermal_expansion=1.0, reference_temperature=0.5
            )
        )
    body = lp.Body(
        shape=lp.Box(lower=(0.0, 0.0), upper=(1.0, 1.0)),
        points_per_cell=1,
        material=material,
        temperature=0.5,
        **layout,
    )
    gravity = (0.0, -rayleigh * prandtl)
    physics = lp.Peridynamics(
        heat=lp.PeridynamicHeat(**(heat or {})),
        flow=lp.PeridynamicFlow(gravity=gravity, **(flow or {})) if moving else None,
        walls=walls,
    )
    grid = lp.Grid(lower=(-wide, -wide), upper=(1 + wide, 1 + wide), cell=dx)
    return lp.Scene(grid=grid, bodies=[body], peridynamics=physics, time=lp.Time(end=1.0))
