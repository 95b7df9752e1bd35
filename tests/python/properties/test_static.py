"""Quasi-static scenes that nobody tuned, on plain defaults: drawn shapes, poses, materials, loads
against closed forms and fitted finite elements."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pytest

import lapilli as lp
from lapilli.references.elastic import Elastic
from lapilli.references.plane_patch import solve_patch

Array = npt.NDArray[np.float64]
PROMISE = 0.03  # error of the displacements (root mean square) over their own


@dataclass
class Drawn:
    """One scene and the exact or fine displacement at places of the undeformed body."""

    what: str
    scene: lp.Scene
    exact: Callable[[Array], Array]


@dataclass
class Pose:
    """Where a body stands on the grid."""

    turn: Array
    by: Array

    def of(self, places: npt.ArrayLike) -> Array:
        return np.asarray(places, dtype=float) @ self.turn.T + self.by

    def back(self, places: Array) -> Array:
        return (places - self.by) @ self.turn


def draw_pose(rng: np.random.Generator, size: float) -> Pose:
    angle = rng.uniform(0, 2 * np.pi)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return Pose(turn, rng.uniform(-1, 1, 2) * size)


def draw_material(rng: np.random.Generator) -> tuple[lp.Elastic, Elastic]:
    young = float(10 ** rng.uniform(3, 11))
    poisson = float(rng.choice([rng.uniform(0.0, 0.45), 0.49, 0.499, 0.4999]))
    return (
        lp.Elastic(density=1000.0, youngs_modulus=young, poissons_ratio=poisson),
        Elastic(young=young, poisson=poisson),
    )


def rows(places: npt.ArrayLike) -> list[list[float]]:
    return [[float(x) for x in place] for place in np.asarray(places)]


def scene_of(
    rng: np.random.Generator,
    outline: Array,
    shape: lp.Shape,
    material: lp.Elastic,
    settings: lp.QuasiStatic,
    across: float,
) -> lp.Scene:
    """A grid of 8 to 14 cells across the body, anywhere."""
    cell = across / rng.uniform(8, 14)
    lower = outline.min(axis=0) - rng.uniform(1, 2, 2) * cell
    upper = lower + cell * np.ceil((outline.max(axis=0) + 1.5 * cell - lower) / cell)
    return lp.Scene(
        grid=lp.Grid(
            lower=lower,
            upper=upper,
            cell=cell,
            shape_function=str(rng.choice(["linear", "gimp"])),
        ),
        bodies=[lp.Body(shape=shape, material=[material])],
        quasi_static=settings,
        time=lp.Time(end=1.0, steps=int(rng.integers(1, 4))),
    )


def draw_quadrilateral(rng: np.random.Generator) -> Drawn:
    """A convex quadrilateral, held at one side, under tractions, pressures or its weight."""
    scale = float(10 ** rng.uniform(-3, 3))
    ratio = rng.uniform(1.0, 3.0)
    square = np.array([[0, 0], [ratio, 0], [ratio, 1], [0, 1]]) + rng.uniform(-0.15, 0.15, (4, 2))
    pose = draw_pose(rng, 3 * scale)
    corners = pose.of(scale * square)
    material, elastic = draw_material(rng)
    load = 1e-5 * elastic.shear
    side = {
        "bottom": corners[[0, 1]],
        "right": corners[[1, 2]],
        "top": corners[[2, 3]],
        "left": corners[[3, 0]],
    }
    held = str(rng.choice(["left", "bottom"]))
    free = {"left": "right", "bottom": "top"}[held]
    kind = str(rng.choice(["traction", "pressure", "weight"]))
    direction = rng.normal(size=2)
    direction *= load / np.linalg.norm(direction)
    settings = lp.QuasiStatic(
        supports=[lp.Support(name="held", kind="fixed", line=rows(side[held]))]
    )
    given: dict[str, object] = {}
    if kind == "traction":
        settings.tractions = [
            lp.SurfaceTraction(
                name="pull", line=rows(side[free]), traction=[float(x) for x in direction]
            )
        ]
        given = {"tractions": {free: direction}}
    elif kind == "pressure":
        settings.tractions = [lp.SurfaceTraction(name="push", line=rows(side[free]), pressure=load)]
        given = {"pressures": {free: load}}
    else:
        settings.body_force = [float(x) for x in direction / scale]
        given = {"body_force": direction / scale}

    def place(s: Array, t: Array) -> Array:
        s, t = s[..., None], t[..., None]
        a, b, c, d = corners
        return (1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d

    fine = solve_patch(place, material=elastic, elements=(24, 24), fixed=(held,), **given)
    shape = lp.Polygon(vertices=rows(corners))
    what = f"quadrilateral, {kind}, held at {held}, Poisson {elastic.poisson:.4f}"
    across = scale * min(1.0, ratio)
    return Drawn(what, scene_of(rng, corners, shape, material, settings, across), fine.at)


def draw_bar(rng: np.random.Generator) -> Drawn:
    """A bar on two rollers, pulled at its end: an even stress."""
    scale = float(10 ** rng.uniform(-3, 3))
    length, height = scale * rng.uniform(1.0, 3.0), scale
    pose = draw_pose(rng, 3 * scale)
    corners = pose.of([[0, 0], [length, 0], [length, height], [0, height]])
    material, elastic = draw_material(rng)
    load = 1e-5 * elastic.young
    pull = pose.turn @ np.array([load, 0.0])
    settings = lp.QuasiStatic(
        supports=[
            lp.Support(name="left", kind="roller", line=rows(corners[[3, 0]])),
            lp.Support(name="base", kind="roller", line=rows(corners[[0, 1]])),
        ],
        tractions=[
            lp.SurfaceTraction(
                name="pull", line=rows(corners[[1, 2]]), traction=[float(x) for x in pull]
            )
        ],
    )
    along = load * (1 - elastic.poisson**2) / elastic.young
    across = -load * elastic.poisson * (1 + elastic.poisson) / elastic.young

    def exact(places: Array) -> Array:
        return pose.back(places) * [along, across] @ pose.turn.T

    shape = lp.Polygon(vertices=rows(corners))
    what = f"bar, Poisson {elastic.poisson:.4f}"
    return Drawn(what, scene_of(rng, corners, shape, material, settings, height), exact)


def draw_ring(rng: np.random.Generator) -> Drawn:
    """A quarter of a ring on rollers at its flat sides, under pressure from inside (Lame)."""
    scale = float(10 ** rng.uniform(-3, 3))
    inner, outer = scale, scale * rng.uniform(1.8, 3.0)
    pose = draw_pose(rng, 3 * scale)
    material, elastic = draw_material(rng)
    load = 1e-5 * elastic.shear
    centre = pose.of([[0, 0]])[0]
    corner = pose.of([[0, 0], [3 * outer, 0], [3 * outer, 3 * outer], [0, 3 * outer]])
    ring = lp.Annulus(center=centre, inner=inner, outer=outer)
    shape = lp.Intersection(shapes=[ring, lp.Polygon(vertices=rows(corner))])
    tips = pose.of([[inner, 0], [outer, 0], [0, inner], [0, outer]])
    settings = lp.QuasiStatic(
        supports=[
            lp.Support(name="one", kind="roller", line=rows(tips[[0, 1]])),
            lp.Support(name="other", kind="roller", line=rows(tips[[3, 2]])),
        ],
        tractions=[
            lp.SurfaceTraction(
                name="inside", shape=lp.Disk(center=centre, radius=inner), pressure=load
            )
        ],
    )
    nu = elastic.poisson
    factor = load * (1 + nu) / elastic.young * inner**2 / (outer**2 - inner**2)

    def exact(places: Array) -> Array:
        arm = places - centre
        r = np.linalg.norm(arm, axis=1, keepdims=True)
        return factor * ((1 - 2 * nu) + outer**2 / r**2) * arm

    angle = np.linspace(0, np.pi / 2, 20)
    arc = pose.of(outer * np.stack([np.cos(angle), np.sin(angle)], -1))
    outline = np.concatenate([tips, arc])
    what = f"ring, Poisson {nu:.4f}"
    return Drawn(what, scene_of(rng, outline, shape, material, settings, outer - inner), exact)


def draw_column(rng: np.random.Generator) -> Drawn:
    """A column under its own weight between rollers."""
    scale = float(10 ** rng.uniform(-3, 3))
    width, height = scale, scale * rng.uniform(1.0, 2.5)
    pose = draw_pose(rng, 3 * scale)
    corners = pose.of([[0, 0], [width, 0], [width, height], [0, height]])
    material, elastic = draw_material(rng)
    weight = 1e-5 * elastic.confined / height
    down = pose.turn @ np.array([0.0, -weight])
    settings = lp.QuasiStatic(
        supports=[
            lp.Support(name="left", kind="roller", line=rows(corners[[3, 0]])),
            lp.Support(name="base", kind="roller", line=rows(corners[[0, 1]])),
            lp.Support(name="right", kind="roller", line=rows(corners[[1, 2]])),
        ],
        body_force=[float(x) for x in down],
    )

    def exact(places: Array) -> Array:
        y = pose.back(places)[:, 1]
        u = -weight / elastic.confined * (height * y - y**2 / 2)
        return np.stack([0 * y, u], -1) @ pose.turn.T

    shape = lp.Polygon(vertices=rows(corners))
    what = f"column, Poisson {elastic.poisson:.4f}"
    return Drawn(what, scene_of(rng, corners, shape, material, settings, width), exact)


KINDS = (draw_quadrilateral, draw_bar, draw_ring, draw_column)


def error_of(drawn: Drawn) -> float:
    simulation = lp.Simulation(drawn.scene)
    simulation.run_until(simulation.end)
    moved = np.asarray(simulation.by_id("displacement"))
    start = np.asarray(simulation.by_id("position")) - moved
    there = drawn.exact(start)
    weight = np.asarray(simulation.by_id("volume"))
    difference = np.sqrt(weight @ np.sum((moved - there) ** 2, axis=1))
    return float(difference / np.sqrt(weight @ np.sum(there**2, axis=1)))


def draw(seed: int) -> Drawn:
    rng = np.random.default_rng(seed)
    return KINDS[seed % len(KINDS)](rng)


def outside(seeds: range) -> list[str]:
    """The scenes that miss the promise."""
    missed = []
    for seed in seeds:
        drawn = draw(seed)
        error = error_of(drawn)
        if error > PROMISE:
            missed.append(f"{seed}: {drawn.what}: {error:.3f}")
    return missed


def test_drawn_scenes_are_right_by_default() -> None:
    missed = outside(range(16))
    assert len(missed) <= 1, missed


@pytest.mark.slow
def test_many_drawn_scenes_are_right_by_default() -> None:
    seeds = range(100, 300)
    missed = outside(seeds)
    assert len(missed) <= 0.05 * len(seeds), missed
