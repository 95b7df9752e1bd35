"""Cells that fit their grid: what does not is rounded, and reported."""

from __future__ import annotations

import copy
import math
from collections.abc import Sequence

from lapilli._core import Scene
from lapilli.note import Note, note
from lapilli.study.settings import Setting

FARTHEST = 0.25  # of a cell, that rounding may change it; beyond, the grid grows


def fitted(settings: Sequence[Setting], scene: Scene) -> tuple[list[Setting], list[Note]]:
    """The settings with cells that divide their grid, each once, and what was changed."""
    kept: dict[Setting, None] = {}
    notes: dict[Note, None] = {}
    for setting in settings:
        changes = dict(setting.changes)
        changed = Setting(setting.changes).applied(scene) if "grid.cell" in changes else None
        cell = None if changed is None else fitting_cell(changed)
        if cell is not None:
            words = f"grid.cell={changes['grid.cell']} does not fit the grid: {cell!r} instead"
            notes[note("study.cell-fitted", words)] = None
            changes["grid.cell"] = repr(cell)
        elif changed is not None and not fits(changed):
            upper = grown(changed)
            if upper is not None:
                words = f"grid.cell={changes['grid.cell']}: the grid grows to {upper} m"
                notes[note("study.grid-grown", words)] = None
                changes["grid.upper"] = str(upper)
        kept[Setting(tuple(changes.items()))] = None
    return list(kept), list(notes)


def lengths_of(scene: Scene) -> list[float]:
    """The sides of the grid, m."""
    return [high - low for low, high in zip(scene.grid.lower, scene.grid.upper, strict=True)]


def fits(scene: Scene) -> bool:
    """Whether the cell divides the grid along every axis."""
    return all(is_whole(length / scene.grid.cell) for length in lengths_of(scene))


def fitting_cell(scene: Scene) -> float | None:
    """The cell nearest to that of a scene that divides its grid along every axis, within a quarter;
    None where its own does, or where there is none."""
    cell, lengths = scene.grid.cell, lengths_of(scene)
    if fits(scene):
        return None
    most = round(lengths[0] / cell * (1 + 2 * FARTHEST)) + 1
    fitting = [
        lengths[0] / count
        for count in range(1, most)
        if all(is_whole(length * count / lengths[0]) for length in lengths)
    ]
    nearest = min(fitting, key=lambda one: abs(one / cell - 1), default=None)
    return None if nearest is None or abs(nearest / cell - 1) > FARTHEST else nearest


def grown(scene: Scene) -> list[float] | None:
    """An upper corner that cells divide; None where faces of the grid are boundaries."""
    if scene.dynamics is not None and scene.dynamics.grid_boundaries:
        return None
    cell = scene.grid.cell
    return [
        low + cell * math.ceil(length / cell - 1e-6)
        for low, length in zip(scene.grid.lower, lengths_of(scene), strict=True)
    ]


def is_whole(number: float) -> bool:
    """Whether a number of cells is whole, but for rounding."""
    return abs(number - round(number)) <= 1e-6 * max(1.0, number)


def with_cell(scene: Scene, cell: float) -> Scene:
    """The scene with the cell nearest to this one that fits."""
    changed = copy.copy(scene).set(f"grid.cell={cell!r}")
    near = fitting_cell(changed)
    if near is not None:
        return changed.set(f"grid.cell={near!r}")
    if not fits(changed):
        upper = grown(changed)
        return changed if upper is None else changed.set(f"grid.upper={upper}")
    return changed
