"""Figures 27 to 29: temperature, normals of the surface, grids, profiles and monitored points."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from lapilli.reproduce.figures import new_figure, save
from lapilli.reproduce.states import Array
from lapilli.reproduce.vhfm.column import CELLS, GRID_POINTS
from lapilli.reproduce.vhfm.column_runs import (
    CORNER,
    EARLY,
    FILLED,
    LOOKS,
    TIME,
    Heated,
    Run,
    Setting,
    column,
    on_nodes,
)

POINTS = (4, 9, 16, 25)
SPANS = {EARLY: (0.0, 0.8), TIME: (0.75, 1.0)}  # K, of the colours


def draw(folder: Path, quick: bool) -> list[Path]:
    """All of them; `quick` leaves out the finest grid."""
    by_points = {f"{points} points per cell": Setting(points=points) for points in POINTS}
    of_paper = {
        f"{points} points per cell": Setting(points=points, paper=True) for points in POINTS
    }
    by_cell = {
        f"h = {cell:g} m": Setting(cell=cell, points=GRID_POINTS)
        for cell in (CELLS[:2] if quick else CELLS)
    }
    return [
        maps(folder / "column_points.png", by_points),
        maps(folder / "column_points_paper.png", of_paper),
        maps(folder / "column_grids.png", by_cell),
        profiles(folder / "column_profiles.png", by_points, by_cell),
        histories(folder / "column_histories.png", by_points, by_cell),
    ]


def maps(path: Path, settings: Mapping[str, Setting]) -> Path:
    """Temperature and normals of the surface at 0.5 and 2 s, a line of panels a setting."""
    figure, axes = new_figure(len(settings), 2, width=5.6, height=1.85)
    for line, (name, setting) in enumerate(settings.items()):
        run = column(setting)
        spacing = setting.cell / np.sqrt(setting.points)
        for panel, (time, state) in zip(
            axes[line], ((EARLY, run.early), (TIME, run.final)), strict=True
        ):
            drawn = dots(panel, state, spacing, SPANS[time])
            panel.set_title(f"{name}, {time:g} s", fontsize=9)
            if line == len(settings) - 1:
                figure.colorbar(
                    drawn, ax=axes[:, 0 if time == EARLY else 1], location="bottom",
                    shrink=0.6, aspect=40, extend="min", label="temperature (K)",
                )  # fmt: skip
    return save(figure, path)


def dots(panel: Any, state: Heated, spacing: float, span: tuple[float, float]) -> Any:
    """The points coloured by temperature, grey below the span, and the normals."""
    from matplotlib import colormaps

    drawn = panel.scatter(
        *state.position.T, c=state.temperature, s=max(0.7, (62 * spacing) ** 2), lw=0,
        vmin=span[0], vmax=span[1], cmap=colormaps["inferno"].with_extremes(under="0.6"),
    )  # fmt: skip
    some = slice(None, None, max(1, round(len(state.surface) / 150)))
    panel.quiver(*state.surface[some].T, *state.normal[some].T, color="c", width=2e-3, scale=32)
    panel.set(xlim=(-3.5, 3.5), ylim=(0, 2.15), aspect="equal", xticks=[], yticks=[])
    return drawn


def profiles(path: Path, by_points: Mapping[str, Setting], by_cell: Mapping[str, Setting]) -> Path:
    """Temperature at 2 s along the axis and 0.3 m above the floor, by points and by grid."""
    figure, axes = new_figure(2, 2, width=4.6, height=2.9)
    for line, settings in zip(axes, (by_points, by_cell), strict=True):
        for style, (name, setting) in zip(STYLES, settings.items(), strict=False):
            line[0].plot(*profile(setting, 1, 0.0), style, label=name)
            line[1].plot(*profile(setting, 0, 0.3), style, label=name)
        line[0].set(xlabel="y at x = 0 (m)", ylabel=f"temperature at {TIME:g} s (K)")
        line[1].set(xlabel="x at y = 0.3 m (m)")
        line[0].legend(fontsize=7)
    return save(figure, path)


STYLES = ("-", "--", "-.", ":")


def profile(setting: Setting, axis: int, across: float) -> tuple[Array, Array]:
    """Places and temperatures of the nodes along an axis, where they are filled, at 2 s."""
    filled, temperature = on_nodes(column(setting).final, setting.cell)
    row = round((across - CORNER[1 - axis]) / setting.cell)
    take: Callable[[Array], Array] = lambda grid: grid[:, row] if axis == 0 else grid[row]  # noqa: E731
    places = CORNER[axis] + setting.cell * np.arange(filled.shape[axis])
    inside = take(filled) > FILLED
    return places[inside], take(temperature)[inside]


def histories(path: Path, by_points: Mapping[str, Setting], by_cell: Mapping[str, Setting]) -> Path:
    """Temperature at P1 and P2 by points and by grid."""
    figure, axes = new_figure(1, 2, width=4.6, height=3.2)
    for panel, settings in zip(axes[0], (by_points, by_cell), strict=True):
        for style, (name, setting) in zip(STYLES, settings.items(), strict=False):
            monitors(panel, column(setting), name, style)
        panel.set(xlabel="t (s)", ylabel="temperature (K)")
        panel.legend(fontsize=7)
    return save(figure, path)


def monitors(panel: Any, run: Run, name: str, style: str) -> None:
    """One run: P1 dark, P2 light."""
    for place, colour in enumerate(("tab:blue", "tab:orange")):
        panel.plot(LOOKS, run.history[:, place], style, color=colour, label=f"P{place + 1}, {name}")
