"""What of a frame a picture shows: which points, along which axes, with which values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli.components import component_of, label, parted, require_field
from lapilli.frames import Frame, Frames
from lapilli.plot.style import Style

Array = npt.NDArray[Any]
NAMES = ("x (m)", "y (m)", "z (m)")
QUIET = ("id", "body", "volume")  # fields that nobody asks for unless by name


@dataclass
class View:
    """Points in the plane of a picture, m, and what they are coloured by."""

    axes: tuple[int, ...]  # which coordinates are drawn: one, or two
    rows: Array  # the points of bodies that are shown, those behind first
    walls: Array  # points of fluid walls that are shown
    position: Array  # (points, 3)
    spacing: Array  # (points,), m
    values: Array  # (points,)
    label: str
    time: float
    part: str  # which part of a body in space is shown; empty: all

    @property
    def title(self) -> str:
        """When and where."""
        return f"t = {self.time:.5g} s" + (f", {self.part}" if self.part else "")

    @property
    def is_plane(self) -> bool:
        """Whether there is a picture and not a curve."""
        return len(self.axes) == 2

    @property
    def shown(self) -> Array:
        """Positions in the plane of the points of bodies."""
        return self.position[self.rows][:, self.axes]

    @property
    def seen(self) -> Array:
        """All points that are drawn."""
        return np.concatenate([self.rows, self.walls])


def drawn_field(frames: Frames, wanted: str | None) -> str:
    """The field asked for; if none was, temperature where there is one, else the size of
    displacement, velocity or the first field."""
    if not frames.fields:
        raise ValueError(f"{frames.path} holds no fields")
    if wanted is not None:
        require_field(wanted, frames.readable, frames.path)
        return wanted
    rest = [name for name in frames.fields if name not in QUIET]
    usual = [name for name in ("temperature", "displacement", "velocity") if name in rest]
    return (usual + rest + frames.fields)[0]


def view_of(frame: Frame, name: str, style: Style | None = None) -> View:
    """What a picture of `name` ("velocity.x") shows of a frame."""
    style = style or Style()
    frames = frame.frames
    position, volume, body = frame.position, frame["volume"], frame["body"]
    everything = frame[parted(name)[0]]
    spacing = _spacing(volume, body, frames.dimension)
    axes, shown, part = _seen(position, spacing, frames.dimension, style)
    is_wall = body[shown] >= frames.body_count
    rows = shown[~is_wall]
    if not len(rows):
        raise ValueError(f"no point lies in the cut {style.cut!r} at {frame.time:g} s")
    title = label(name, everything, frames.unit(name))
    try:
        values = component_of(everything, name)
    except KeyError as error:
        raise ValueError(error.args[0]) from None
    return View(axes, rows, shown[is_wall], position, spacing, values, title, frame.time, part)


def _spacing(volume: Array, body: Array, dimension: int) -> Array:
    """The side of the box of an ordinary point of each body: cut ones are drawn as large."""
    spacing = np.empty(len(volume))
    for number in np.unique(body):
        own = body == number
        spacing[own] = np.median(volume[own]) ** (1 / dimension)
    return spacing


def _seen(
    position: Array, spacing: Array, dimension: int, style: Style
) -> tuple[tuple[int, ...], Array, str]:
    """The axes drawn, the points shown, from the back to the front, and in words which they are."""
    everything = np.arange(len(position))
    if dimension < 3:
        if style.cut is not None:
            raise ValueError("a cut is for scenes in space")
        return ((0,) if dimension == 1 else (0, 1)), everything, ""
    axis, place = style.plane()
    axes = {0: (1, 2), 1: (0, 2), 2: (0, 1)}[axis]
    depth = position[:, axis] if axis != 1 else -position[:, axis]  # towards the eye
    if style.cut is None:  # the half behind the middle; the cut is painted last
        behind = np.argsort(depth, kind="stable")[: (len(depth) + 1) // 2]
        return axes, behind, f"cut open at y = {position[behind[-1], axis]:.3g} m"
    if place is None:
        place = 0.5 * (position[:, axis].min() + position[:, axis].max())
    away = np.abs(position[:, axis] - place)
    near = np.flatnonzero(away <= 0.75 * spacing)
    return axes, near[np.argsort(-away[near], kind="stable")], f"{'xyz'[axis]} = {place:.3g} m"
