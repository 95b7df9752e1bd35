"""Figures 9 to 14: normals, temperatures, history, flux and convergence of the ring."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from lapilli.reproduce.figures import convergence, map_of, new_figure, save, slope
from lapilli.reproduce.states import rms, states
from lapilli.reproduce.vhfm.ring import (
    INNER,
    LAWS,
    OUTER,
    default_error,
    default_scene,
    exact_solution,
    history,
    literal_error,
    normal_errors,
    radius_of,
    ring_scene,
)

CELLS = (0.4, 0.2, 0.1)


def draw(folder: Path, quick: bool) -> list[Path]:
    """All of them."""
    cells = CELLS if quick else (*CELLS, 0.05)
    return [
        draw_normals(folder, cells),
        draw_maps(folder),
        draw_profiles(folder),
        draw_history(folder),
        draw_flux(folder),
        draw_convergence(folder, cells),
    ]


def draw_normals(folder: Path, cells: tuple[float, ...]) -> Path:
    """Fig. 9: the angle between computed and radial normals around both rims."""
    figure, axes = new_figure(1, len(cells), width=3.4)
    for column, cell in enumerate(cells):
        for smoothing, marker in ((0, "."), (2, "."), (4, ".")):
            angle, error = normal_errors(cell, smoothing)
            axes[0, column].plot(
                angle, error, marker, ms=3, label=f"smoothed {smoothing}x, RMSE {rms(error):.2f}"
            )
        axes[0, column].axhspan(-10, 10, color="0.93", zorder=0)
        axes[0, column].set(title=f"h = {cell:g} m", xlabel="place (degree)", ylim=(-25, 25))
        axes[0, column].legend(fontsize=7)
    axes[0, 0].set_ylabel("error of the normal (degree)")
    return save(figure, folder / "ring_normals.png")


def draw_maps(folder: Path) -> Path:
    """Fig. 10: temperature with isotherms."""
    figure, axes = new_figure(2, 3, width=3.4)
    for row, law in enumerate(LAWS):
        for column, state in enumerate(states(ring_scene(law, 0.1), (1.0, 2.5, 10.0))):
            panel = axes[row, column]
            drawn = map_of(panel, state.position, state.temperature, 0.05, levels=8)
            panel.set_title(f"{law}, {state.time:g} s")
            figure.colorbar(drawn, ax=panel, shrink=0.8)
    return save(figure, folder / "ring_maps.png")


def draw_profiles(folder: Path) -> Path:
    """Fig. 11: temperature over the radius at 1 s."""
    figure, axes = new_figure(1, 2)
    r = np.linspace(INNER, OUTER, 300)
    for column, law in enumerate(LAWS):
        panel = axes[0, column]
        for cell, color in zip((0.2, 0.1), ("tab:orange", "tab:blue"), strict=True):
            state = next(states(ring_scene(law, cell), [1.0]))
            panel.plot(
                radius_of(state),
                state.temperature,
                ".",
                ms=2,
                color=color,
                label=f"h = {cell:g} m, all points",
            )
        panel.plot(r, exact_solution(law).temperature(r, 1.0), "k", lw=1, label="exact")
        panel.set(title=f"{law}, 1 s", xlabel="r (m)", ylabel="temperature (K)")
        panel.legend(fontsize=8)
    return save(figure, folder / "ring_profiles.png")


def draw_history(folder: Path) -> Path:
    """Fig. 12: temperature half way between the rims."""
    figure, axes = new_figure(1, 2)
    times = np.linspace(0.5, 10, 20)
    for column, law in enumerate(LAWS):
        panel = axes[0, column]
        for cell, marker in ((0.4, "^"), (0.2, "x"), (0.1, "o")):
            panel.plot(
                times, history(law, cell, times), marker, ms=4, mfc="none", label=f"h = {cell:g} m"
            )
        panel.plot(times, exact_solution(law).temperature(3.0, times), "k", lw=1, label="exact")
        panel.set(title=law, xlabel="t (s)", ylabel="temperature at r = 3 m (K)")
        panel.legend(fontsize=8)
    return save(figure, folder / "ring_history.png")


def draw_flux(folder: Path) -> Path:
    """Fig. 13: radial heat flux under a constant flux."""
    figure, axes = new_figure(1, 3)
    found = list(states(ring_scene("flux", 0.1), (0.1, 1.0, 10.0)))
    r = np.linspace(INNER, OUTER, 300)
    for column, state in enumerate(found[:2]):
        panel: Any = axes[0, column + 1]
        radius = radius_of(state)
        radial = np.sum(state.flux * state.position, axis=1) / radius
        panel.plot(radius, radial, ".", ms=2, label="h = 0.1 m, all points")
        panel.plot(r, exact_solution("flux").flux(r, state.time), "k", lw=1, label="exact")
        panel.set(title=f"{state.time:g} s", xlabel="r (m)", ylabel="radial heat flux (W/m²)")
        panel.legend(fontsize=8)
    late = found[-1]
    radial = np.sum(late.flux * late.position, axis=1) / radius_of(late)
    drawn = map_of(axes[0, 0], late.position, radial, 0.05, span=(-1, 1), colors="coolwarm")
    axes[0, 0].set_title("radial heat flux at 10 s")
    figure.colorbar(drawn, ax=axes[0, 0], shrink=0.8)
    return save(figure, folder / "ring_flux.png")


def draw_convergence(folder: Path, cells: tuple[float, ...]) -> Path:
    """Fig. 14, against the exact field instead of the finest grid."""
    figure, axes = new_figure(1, 2)
    for column, law in enumerate(LAWS):
        panel = axes[0, column]
        default = [default_error(law, cell) for cell in cells]
        convergence(panel, cells, default, "default", "s-")
        paper = [literal_error(law, cell) for cell in cells]
        convergence(panel, cells, paper, "the paper's algorithm")
        slope(panel, cells, 1.5 * default[0], 2)
        slope(panel, cells, 1.5 * paper[0], 1)
        panel.set_title(f"{law}, 1 s, h = {default_scene(law, cells[-1]).grid.cell:g} to 0.4 m")
        panel.legend(fontsize=8)
    return save(figure, folder / "ring_convergence.png")
