"""Rings, domes and plates with a hole, with their exact displacements."""

from __future__ import annotations

import numpy as np
from static_board import Array, Drawn, Frame, Sides, numbers, rows, scene_of

import lapilli as lp
from lapilli.references.elastic import Annulus


def draw_sector(frame: Frame) -> Drawn:
    """A sector of a ring, held at one end."""
    rng = frame.rng
    inner, outer, opening = 1.0, rng.uniform(1.6, 3.0), rng.uniform(0.5, 2.6)

    def board(s: Array, t: Array) -> Array:
        r, angle = inner + (outer - inner) * s, opening * t
        return np.stack([r * np.cos(angle), r * np.sin(angle)], axis=-1)

    def place(s: Array, t: Array) -> Array:
        return frame.at(board(s, t))

    centre = numbers(frame.at([0, 0]))
    edge = np.linspace(0, 1, 2)
    far = 4 * outer
    middle = opening / 2
    wedge = [
        [0.0, 0.0],
        [far, 0.0],
        [far * np.cos(middle), far * np.sin(middle)],
        [far * np.cos(opening), far * np.sin(opening)],
    ]
    surface: dict[str, dict[str, object]] = {
        "bottom": {"line": rows(place(edge, 0 * edge))},
        "top": {"line": rows(place(edge[::-1], 0 * edge + 1))},
        "left": {"shape": lp.Disk(center=centre, radius=inner * frame.size)},
        "right": {"shape": lp.Disk(center=centre, radius=outer * frame.size), "inside": True},
    }
    sides = Sides(frame, place, surface)
    held = str(rng.choice(["end", "inside", "rollers"]))
    pushed: dict[str, float] = {}
    if held == "end":
        sides.hold("bottom")
        load = sides.draw_load("top")
    elif held == "inside":
        sides.hold("left")
        load = sides.draw_load("right")
    else:
        sides.hold("bottom", "roller")
        sides.hold("top", "roller")
        side = str(rng.choice(["left", "right"]))
        load = sides.draw_load(side, ("press",))
        key = {"left": "inner_pressure", "right": "outer_pressure"}[side]
        pushed = {key: sides.given["pressures"][side]}  # type: ignore[index]
    ring = Annulus.under_pressure(
        inner * frame.size, outer * frame.size, material=frame.elastic, **pushed
    )

    def lame(places: Array) -> Array:
        arm = places - centre
        r = np.linalg.norm(arm, axis=1)
        return np.asarray((ring.at(r).displacement / r)[:, None] * arm)

    shape = lp.Intersection(
        shapes=[
            lp.Annulus(center=centre, inner=inner * frame.size, outer=outer * frame.size),
            lp.Polygon(vertices=rows(frame.at(wedge))),
        ]
    )
    s = np.linspace(0, 1, 20)
    outline = np.concatenate([place(0 * s, s), place(0 * s + 1, s)])
    across = (outer - inner) * frame.size
    return Drawn(
        f"sector, {load}, held at {held}",
        scene_of(frame, outline, shape, sides.settings, across),
        lame if pushed else sides.solve((24, 32)),
        sides.load,
    )


def draw_dome(frame: Frame) -> Drawn:
    """An ellipse or a disk with a flat foot on which it is held, loaded at its upper quarter."""
    rng = frame.rng
    half = np.array([0.5, 0.5 * rng.choice([1.0, rng.uniform(0.4, 1.0)])])
    foot = rng.uniform(0.15, 0.35) * np.pi  # of the corners below the equator
    shoulder = rng.uniform(0.2, 0.3) * np.pi

    def arc(angle: Array) -> Array:
        return np.asarray(half * np.stack([np.cos(angle), np.sin(angle)], axis=-1))

    def board(s: Array, t: Array) -> Array:
        """Coons' patch."""
        right = arc(-foot + t * (foot + shoulder))
        left = right * [-1, 1]
        top = arc(np.pi - shoulder - s * (np.pi - 2 * shoulder))
        a, b = arc(np.array(-foot)) * [-1, 1], arc(np.array(-foot))
        d, c = arc(np.array(shoulder)) * [-1, 1], arc(np.array(shoulder))
        s, t = s[..., None], t[..., None]
        bottom = a + s * (b - a)
        corners = (1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d
        return (1 - s) * left + s * right + (1 - t) * bottom + t * top - corners

    def place(s: Array, t: Array) -> Array:
        return frame.at(board(s, t))

    centre = numbers(frame.at([0, 0]))
    if half[0] == half[1]:
        oval: lp.Shape = lp.Disk(center=centre, radius=0.5 * frame.size)
    else:
        angle = float(np.degrees(np.arctan2(frame.turn[1, 0], frame.turn[0, 0])))
        ellipse = lp.Ellipse(center=centre, semi_axes=numbers(half * frame.size))
        oval = lp.Rotated(shape=ellipse, degrees=angle, center=centre)
    low = arc(np.array(-foot))
    keep = frame.at([[-2, low[1]], [2, low[1]], [2, 2], [-2, 2]])
    upper = frame.at([[0, 0], 4 * arc(np.array(shoulder)), 4 * arc(np.array(shoulder)) * [-1, 1]])
    sides = Sides(
        frame,
        place,
        {
            "bottom": {"line": rows(frame.at([low * [-1, 1], low]))},
            "top": {"shape": oval, "inside": True, "within": lp.Polygon(vertices=rows(upper))},
        },
    )
    sides.hold("bottom")
    load = sides.draw_load("top")
    shape = lp.Intersection(shapes=[oval, lp.Polygon(vertices=rows(keep))])
    s = np.linspace(0, 1, 20)
    outline = np.concatenate(
        [place(0 * s, s), place(0 * s + 1, s), place(s, 0 * s), place(s, 0 * s + 1)]
    )
    across = (half[1] - low[1]) * frame.size
    return Drawn(
        f"dome {half[1] / half[0]:.2f}, {load}",
        scene_of(frame, outline, shape, sides.settings, across),
        sides.solve((32, 32)),
        sides.load,
    )


def draw_plate_with_hole(frame: Frame) -> Drawn:
    """A quarter of a plate with a hole, on rollers at its two planes of symmetry."""
    rng = frame.rng
    hole, ratio = rng.uniform(0.2, 0.6), rng.uniform(0.8, 1.6)

    def place(s: Array, t: Array) -> Array:
        angle = t * np.pi / 2
        # the corner at t = 1/2, where an edge of elements ends
        edge = np.stack([np.minimum(1.0, 2 * (1 - t)), ratio * np.minimum(1.0, 2 * t)], axis=-1)
        arc = hole * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        return frame.at(arc + s[..., None] * (edge - arc))

    corners = frame.at([[0, 0], [1, 0], [1, ratio], [0, ratio]])
    disk = lp.Disk(center=numbers(frame.at([0, 0])), radius=hole * frame.size)
    ends = frame.at([[hole, 0], [1, 0], [0, ratio], [0, hole]])
    sides = Sides(
        frame,
        place,
        {
            "bottom": {"line": rows(ends[:2])},
            "top": {"line": rows(ends[2:])},
            "left": {"shape": disk},
            "right": {"line": rows(corners[1:])},
        },
    )
    sides.hold("bottom", "roller")
    sides.hold("top", "roller")
    load = sides.draw_load(str(rng.choice(["left", "right"])))
    shape = lp.Difference(shape=lp.Polygon(vertices=rows(corners)), minus=disk)
    across = (min(1.0, ratio) - hole) * frame.size
    return Drawn(
        f"plate with a hole {hole:.2f}, {load}",
        scene_of(frame, corners, shape, sides.settings, across),
        sides.solve((24, 32)),
        sides.load,
    )
