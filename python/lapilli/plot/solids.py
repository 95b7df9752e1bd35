"""What no points stand for: obstacles, and the walls of a fluid where they are drawn."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from lapilli import _core
from lapilli._core import Obstacle, Scene, Shape, Table
from lapilli.frames import Frames

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = npt.NDArray[Any]
ACROSS = 300  # places along the longer side at which shapes are asked for their distance


@functools.lru_cache(maxsize=8)
def scene_of(frames: Frames) -> Scene | None:
    """The scene of a run in the plane from its record; None where there is none, where it cannot be
    read again, or where stages change it on the way."""
    record = frames.record
    if record is None or frames.dimension != 2:
        return None
    try:
        scene = Scene.parse(record["scene"])
    except (ValueError, OSError, RuntimeError):  # of arrays and functions, of files that are gone
        return None
    return None if scene.stages else scene


def solids_move(frames: Frames) -> bool:
    """Whether what is painted is somewhere else in another frame."""
    scene = scene_of(frames)
    obstacles = [] if scene is None or scene.dynamics is None else scene.dynamics.obstacles
    return any(
        one.mass is not None or any(one.velocity) or one.revolutions_per_second for one in obstacles
    )


def draw_solids(axes: Axes, frames: Frames, time: float) -> bool:
    """Paint obstacles and the walls of a fluid within the limits of the axes; returns whether walls
    were painted."""
    scene = scene_of(frames)
    if scene is None:
        return False
    has_walls = False
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    step = max(right - left, high - low) / ACROSS
    x, y = np.arange(left, right + step, step), np.arange(low, high + step, step)
    places = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    for found, order in distances(scene, frames, places, time):
        solid = found.reshape(len(y), len(x))
        if solid.min() < 0 < solid.max():
            ends = [float(solid.min()), 0.0]
            axes.contourf(x, y, solid, levels=ends, colors="0.8", zorder=order)
            axes.contour(x, y, solid, levels=[0], colors="0.4", linewidths=0.7, zorder=order)
            has_walls = has_walls or order > 1
    return has_walls


def distances(
    scene: Scene, frames: Frames, places: Array, time: float
) -> list[tuple[Array, float]]:
    """Signed distances of what is solid, each with its order: obstacles lie behind the points, the
    walls of a fluid before them, so that no box of a point reaches into them."""
    found: list[tuple[Array, float]] = []
    if scene.dynamics is not None:
        shapes = [placed(one, frames, time) for one in scene.dynamics.obstacles]
        found += [(one.distance(places), 0.8) for one in shapes if one is not None]
    if scene.peridynamics is not None and (walls := scene.peridynamics.walls):
        shapes = [None if one.rotation or one.translation else one.shape for one in scene.bodies]
        known = [one for one in shapes if one is not None]
        if len(known) == len(shapes) and not any(one.moves for one in walls):
            fluid = np.min([one.distance(places) for one in known], axis=0)
            wall = np.min([one.shape.distance(places) for one in walls], axis=0)
            found.append((np.maximum(wall, -fluid), 1.3))
    return found


def placed(obstacle: Obstacle, frames: Frames, time: float) -> Shape | None:
    """The shape of an obstacle where it is at a time; None where the record does not tell."""
    center = list(obstacle.center) or [0.0, 0.0]
    if obstacle.mass is None:
        factor: Any = obstacle.factor  # as read from a file: a number or a table
        share = time * (factor.mean(0.0, time) if isinstance(factor, Table) else factor)
        way = [share * one for one in obstacle.velocity] or [0.0, 0.0]
        angle = 360.0 * share * obstacle.revolutions_per_second * math.copysign(1, obstacle.axis[2])
    else:
        history = (frames.record or {})["history"]
        names = [
            f"dynamics/{obstacle.name}_{what}" for what in ("position_x", "position_y", "angle")
        ]
        if any(name not in history for name in names):
            return None
        x, y, turn = (np.asarray(history[name], float) for name in names)
        moments = np.asarray(history["time"], float)
        center = [float(x[0]), float(y[0])]
        way = [float(np.interp(time, moments, one) - one[0]) for one in (x, y)]
        angle = math.degrees(float(np.interp(time, moments, turn)))
    turned = _core.Rotated(shape=obstacle.shape, degrees=angle, center=center)
    return _core.Translated(shape=turned, by=way)
