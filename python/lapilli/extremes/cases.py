"""Scenes that try the stability of heat: scattered points, stiff surfaces, contrasts, motion;
peridynamic cavities and soil."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import lapilli as lp
from lapilli.extremes.fluid import fluid_scenes
from lapilli.extremes.soil import soil_scenes

CELL = 1.0  # m; conductivity and capacity are 1, so that h^2/alpha is 1 s
HALF = 6.0  # half the side of the square, m
FLUID = "peridynamics"  # stands for a transfer in scenes that have none
SOIL = "dynamics"  # the same
TRANSFERS = ("nodal", "flip", "pic", "tpic", "affine", FLUID, SOIL)


@dataclass(frozen=True)
class Case:
    """A scene between temperatures 0 and 1 whose step is to be tried."""

    name: str
    transfer: str
    scene: lp.Scene
    lattice: bool  # points on a lattice along the grid: the automatic step must not be timid
    length: int = 30  # automatic steps of a run
    fine: float = 0.05  # steps of what a run is compared with, over the automatic one


def all_cases(transfers: tuple[str, ...] = TRANSFERS) -> Iterator[Case]:
    """Every case with every transfer that it allows."""
    if FLUID in transfers:
        for name, scene in fluid_scenes():
            # Sound needs time to grow: it crosses the box some ten times.
            moving = scene.peridynamics is not None and scene.peridynamics.flow is not None
            length, fine = (600, 0.5) if moving else (30, 0.05)
            yield Case(name, FLUID, scene, False, length, fine)
    if SOIL in transfers:
        for name, scene in soil_scenes():
            yield Case(name, SOIL, scene, False)
    for transfer in (one for one in transfers if one not in (FLUID, SOIL)):
        for biot in (1e-6, 1.0, 1e6):
            yield Case(f"lattice, Biot {biot:g}", transfer, square(transfer, biot), True)
        for name, layout in LAYOUTS.items():
            for biot in (1.0, 1e6):
                scene = square(transfer, biot, **layout)
                yield Case(f"{name}, Biot {biot:g}", transfer, scene, False)
        for conductivity, capacity in ((1e6, 1.0), (1e-6, 1.0), (1.0, 1e6), (1.0, 1e-6)):
            name = f"halves, conductivity {conductivity:g}, capacity {capacity:g}"
            yield Case(name, transfer, halves(transfer, conductivity, capacity), False)
        if transfer != "nodal":
            yield Case("swirl, Biot 1", transfer, swirl(transfer), False)


LAYOUTS: dict[str, dict[str, Any]] = {
    "turned by 20 degrees": {"rotation": 20.0},
    "jittered by 0.25": {"jitter": 0.25},
    "random": {"random": True},
    "1e-9 from a node": {"translation": [0.25 + 1e-9, 0.25 + 1e-9]},
}


def square(transfer: str, biot: float, **layout: Any) -> lp.Scene:
    """A cold square in surroundings at 1."""
    shape = lp.Box(lower=[-HALF, -HALF], upper=[HALF, HALF])
    return _scene([_body(shape, **layout)], transfer, biot)


def halves(transfer: str, conductivity: float, capacity: float) -> lp.Scene:
    """A square of two materials that meet in the middle of a cell."""
    left = lp.Box(lower=[-HALF, -HALF], upper=[0.5, HALF])
    right = lp.Box(lower=[0.5, -HALF], upper=[HALF, HALF])
    other = _body(right, conductivity=conductivity, capacity=capacity)
    return _scene([_body(left), other], transfer, 1.0)


def swirl(transfer: str) -> lp.Scene:
    """A disc that a swirl shears."""
    motion = lp.Swirl(revolutions_per_second=0.04, radius=HALF)
    return _scene([_body(lp.Disk(radius=HALF), motion=motion)], transfer, 1.0)


def _body(
    shape: lp.Shape, conductivity: float = 1.0, capacity: float = 1.0, **layout: Any
) -> lp.Body:
    material = lp.Thermal(density=1.0, specific_heat=capacity, conductivity=conductivity)
    return lp.Body(shape=shape, material=[material], temperature=0.0, points_per_cell=4, **layout)


def _scene(bodies: list[lp.Body], transfer: str, biot: float) -> lp.Scene:
    grid = lp.Grid(lower=[-11.0, -11.0], upper=[11.0, 11.0], cell=CELL)
    heat = lp.Heat(boundaries=[lp.Convection(coefficient=biot / CELL, ambient=1.0)])
    scene = lp.Scene(grid=grid, bodies=bodies, heat=heat, time=lp.Time(end=1.0))
    return scene.set(f"heat.transfer={transfer}")
