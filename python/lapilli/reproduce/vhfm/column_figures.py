"""Figures 27 to 29: temperature, normals of the surface, grids and monitored points."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from lapilli._core import Simulation
from lapilli.reproduce.figures import new_figure, save
from lapilli.reproduce.vhfm.column import CELLS, Setting, histories

POINTS = (4, 9, 16, 25)


def draw(folder: Path, quick: bool) -> list[Path]:
    """All of them; `quick` leaves out the finest grid."""
    return [
        points_picture(folder / "column_points.png", paper=False),
        points_picture(folder / "column_points_paper.png", paper=True),
        grids_picture(folder / "column_grids.png", CELLS[:2] if quick else CELLS),
    ]


def points_picture(path: Path, paper: bool) -> Path:
    """Temperature and normals of the surface at 0.5 and 2 s by points a cell."""
    figure, axes = new_figure(len(POINTS), 2, width=4.6, height=2.2)
    for line, points in enumerate(POINTS):
        simulation = Simulation(Setting(points=points, paper=paper).scene())
        for panel, time in zip(axes[line], (0.5, 2.0), strict=True):
            simulation.run_until(time)
            drawn = dots(panel, simulation, 0.1 / np.sqrt(points))
            surface = simulation.surface()
            panel.quiver(
                *surface["position"].T, *surface["normal"].T, color="c", width=2e-3, scale=30
            )
            panel.set_title(f"{points} points a cell, {time:g} s", fontsize=8)
    figure.colorbar(drawn, ax=axes, shrink=0.6, label="temperature (K)")
    return save(figure, path)


def grids_picture(path: Path, cells: tuple[float, ...]) -> Path:
    """Temperature at 2 s and at P1 and P2 on each grid."""
    figure, axes = new_figure(1, len(cells) + 1, width=4.2, height=2.6)
    for panel, cell in zip(axes[0], cells, strict=False):
        simulation = Simulation(Setting(cell=cell).scene())
        simulation.run_until(2.0)
        drawn = dots(panel, simulation, 0.2 * cell)
        panel.set_title(f"h = {cell:g} m, 2 s", fontsize=8)
        times, values = histories(cell)
        for column, name in enumerate(("P1", "P2")):
            axes[0, -1].plot(times, values[:, column], label=f"{name}, h = {cell:g} m")
    figure.colorbar(drawn, ax=axes[0, -2], shrink=0.6)
    axes[0, -1].set(xlabel="t (s)", ylabel="temperature (K)")
    axes[0, -1].legend(fontsize=7)
    return save(figure, path)


def dots(panel, simulation: Simulation, spacing: float):  # type: ignore[no-untyped-def]
    """The points coloured by temperature."""
    x, y = simulation["position"].T
    drawn = panel.scatter(
        x, y, c=simulation["temperature"], s=(60 * spacing) ** 2, vmin=0, vmax=1, lw=0,
        cmap="inferno",
    )  # fmt: skip
    panel.set(xlim=(-3.6, 3.6), ylim=(0, 2.1), aspect="equal", xticks=[], yticks=[])
    return drawn
