"""Bodies of drawn quasi-static scenes, each with its exact or fine displacement."""

from __future__ import annotations

import numpy as np
from static_board import Array, Drawn, Frame, Sides, numbers, rows, scene_of
from static_curved import draw_dome, draw_plate_with_hole, draw_sector

import lapilli as lp
from lapilli.references.plane_patch import quadrilateral

SIDE_AFTER = {"left": "right", "bottom": "top"}


def draw_quadrilateral(frame: Frame) -> Drawn:
    """Any convex quadrilateral, held at one side."""
    rng = frame.rng
    ratio = rng.uniform(1.0, 3.0)
    square = np.array([[0, 0], [ratio, 0], [ratio, 1], [0, 1]]) + rng.uniform(-0.2, 0.2, (4, 2))
    corners = frame.at(square)
    a, b, c, d = rows(corners)
    surface = {
        k: {"line": v}
        for k, v in zip(
            ("bottom", "right", "top", "left"), ([a, b], [b, c], [c, d], [d, a]), strict=True
        )
    }
    sides = Sides(frame, quadrilateral(corners), surface)  # type: ignore[arg-type]
    held = str(rng.choice(["left", "bottom"]))
    sides.hold(held)
    what = f"quadrilateral, {sides.draw_load(SIDE_AFTER[held])}, held at {held}"
    shape = lp.Polygon(vertices=rows(corners))
    scene = scene_of(frame, corners, shape, sides.settings, frame.size)
    return Drawn(what, scene, sides.solve(), sides.load)


def draw_wavy_beam(frame: Frame) -> Drawn:
    """A beam with a wavy top, held at one end."""
    rng = frame.rng
    length, wave = rng.uniform(1.0, 3.0), rng.uniform(0.05, 0.3)
    turns = rng.uniform(0.5, 1.5)

    def board(s: Array, t: Array) -> Array:
        top = 1 + wave * np.cos(2 * np.pi * turns * s)
        return np.stack([length * s, t * top], axis=-1)

    def place(s: Array, t: Array) -> Array:
        return frame.at(board(s, t))

    s = np.linspace(0, 1, 201)
    top = place(s[::-1], 0 * s + 1)
    corners = np.concatenate([place(np.array([0.0, 1.0]), np.zeros(2)), top])
    sides = Sides(
        frame,
        place,
        {
            "left": {"line": rows([top[-1], corners[0]])},
            "right": {"line": rows([corners[1], top[0]])},
            "top": {"line": rows(top)},
        },
    )
    sides.pieces = 200  # those of the polygon
    sides.hold("left")
    load = sides.draw_load(str(rng.choice(["right", "top"])))
    shape = lp.Polygon(vertices=rows(corners))
    return Drawn(
        f"wavy beam, {load}",
        scene_of(frame, corners, shape, sides.settings, frame.size),
        sides.solve((36, 20)),
        sides.load,
    )


def draw_moved_end(frame: Frame) -> Drawn:
    """A quadrilateral whose one end is moved against the other."""
    rng = frame.rng
    ratio = rng.uniform(0.8, 2.0)
    square = np.array([[0, 0], [ratio, 0], [ratio, 1], [0, 1]]) + rng.uniform(-0.15, 0.15, (4, 2))
    corners = frame.at(square)
    a, b, c, d = rows(corners)
    sides = Sides(
        frame, quadrilateral(corners), {"left": {"line": [d, a]}, "right": {"line": [b, c]}}
    )
    sides.hold("left")
    move = 1e-4 * frame.size * frame.any_direction()
    sides.settings.supports = [
        *sides.settings.supports,
        lp.Support(
            name="right",
            kind="fixed",
            line=[b, c],
            displacement=[lp.Table([0.0, 1.0], [0.0, float(x)]) for x in move],
        ),
    ]
    sides.given["displaced"] = {"right": move}
    shape = lp.Polygon(vertices=rows(corners))
    return Drawn(
        "moved end",
        scene_of(frame, corners, shape, sides.settings, frame.size),
        sides.solve(),
        sides.load,
    )


def draw_column(frame: Frame) -> Drawn:
    """A column under its own weight between rollers."""
    height = frame.rng.uniform(1.0, 2.5)
    corners = frame.at([[0, 0], [1, 0], [1, height], [0, height]])
    weight = 1e-5 * frame.elastic.shear / frame.size
    settings = lp.QuasiStatic(
        supports=[
            lp.Support(name=name, kind="roller", line=rows(corners[[i, j]]))
            for name, i, j in (("left", 3, 0), ("base", 0, 1), ("right", 1, 2))
        ],
        body_force=numbers(frame.vector([0.0, -weight])),
    )

    def exact(places: Array) -> Array:
        y = frame.back(places)[:, 1] * frame.size
        u = -weight / frame.elastic.confined * (height * frame.size * y - y**2 / 2)
        return np.stack([0 * y, u], -1) @ frame.turn.T

    shape = lp.Polygon(vertices=rows(corners))
    return Drawn(
        "column", scene_of(frame, corners, shape, settings, frame.size), exact, np.zeros(2)
    )


KINDS = (
    draw_quadrilateral,
    draw_sector,
    draw_dome,
    draw_plate_with_hole,
    draw_wavy_beam,
    draw_moved_end,
    draw_column,
)


def draw(seed: int) -> Drawn:
    frame = Frame(np.random.default_rng([20, seed]))
    drawn = KINDS[seed % len(KINDS)](frame)
    drawn.what += f", Poisson {frame.elastic.poisson:.4f}"
    return drawn
