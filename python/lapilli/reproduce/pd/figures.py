"""Figures 6 to 10, 12 to 15, 17 and 18."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from lapilli.references.cavity import DE_VAHL_DAVIS, Box, solve
from lapilli.references.slab import prescribed_slab
from lapilli.reproduce.figures import map_of, new_figure, save
from lapilli.reproduce.pd import benard, cavity, conduction, thermals
from lapilli.reproduce.pd.fluid_state import FluidState, sample

LEVELS = tuple(np.arange(0.1, 0.95, 0.1))


def draw_conduction(folder: Path, rows: int) -> Path:
    """Temperature along the middle at three times; the two fields on both horizons."""
    figure, axes = new_figure(1, 2)
    x = np.linspace(0, 1, 201)
    literal = 'peridynamics.heat.laplacian="literal"'
    for time in conduction.TIMES:
        draw_middle(axes[0, 0], conduction.at(rows, time), f"{time:g} s", rows)
        axes[0, 0].plot(x, prescribed_slab(x, time), "k-", lw=0.7)
    for title, settings in {
        "corrected": (),
        "two fields, 1.5 dx": (literal,),
        "two fields, 3 dx": (literal, "peridynamics.heat.horizon=3.015"),
    }.items():
        state = conduction.at(rows, conduction.EARLY, *settings)
        draw_middle(axes[0, 1], state, title, rows)
    axes[0, 1].plot(x, prescribed_slab(x, conduction.EARLY), "k-", lw=0.7)
    axes[0, 1].set_title(f"{conduction.EARLY:g} s; line: exact")
    for one in axes[0]:
        one.set_xlabel("x (m)")
        one.legend()
    axes[0, 0].set_ylabel("temperature (K)")
    return save(figure, folder / "pd_conduction.png")


def draw_middle(axes: Any, state: FluidState, label: str, rows: int) -> None:
    """The row of points next to the middle."""
    near = np.abs(state.position[:, 1] - 0.5) < 0.75 / rows
    order = np.argsort(state.position[near, 0])
    axes.plot(
        state.position[near, 0][order], state.temperature[near][order], ".-", ms=3, label=label
    )


def draw_cavity(folder: Path, plans: Mapping[float, cavity.Plan]) -> Path:
    """Temperature, speed, mid-lines and wall Nusselt number beside finite differences (lines) and
    the peaks of de Vahl Davis (crosses, dashed)."""
    figure, axes = new_figure(len(plans), 6, width=3.4, height=3.2)
    for line, (rayleigh, plan) in zip(axes, plans.items(), strict=True):
        seen = cavity.measured(rayleigh, plan.rows, plan.end)
        state, spacing = seen.state, 1 / plan.rows
        speed = np.linalg.norm(state.velocity, axis=1)
        map_of(line[0], state.position, state.temperature, spacing, levels=LEVELS, span=(0, 1))
        map_of(line[1], state.position, speed, spacing, colors="viridis")
        line[0].set_title(f"Ra {rayleigh:.0e}: temperature")
        line[1].set_title("speed")
        for one in line[:2]:
            one.set(xlim=(0, 1), ylim=(0, 1))
        draw_profiles(line[2:], rayleigh, seen)
    axes[0, 2].legend()
    return save(figure, folder / "pd_cavity.png")


def draw_profiles(axes: Any, rayleigh: float, seen: cavity.Measured) -> None:
    """T, v and u along the mid-lines and Nu along the hot wall."""
    right = solve(Box(rayleigh=rayleigh, prandtl=cavity.PRANDTL), 80)
    peaks = DE_VAHL_DAVIS[rayleigh]
    s, middle = cavity.LINE, np.full_like(cavity.LINE, 0.5)
    across = right.at(np.column_stack([s, middle]))
    up = right.at(np.column_stack([middle, s]))
    for one, values, line, title in (
        (axes[0], seen.temperature, across[:, 2], "T on the horizontal mid-line"),
        (axes[1], seen.vertical, across[:, 1], "v on the horizontal mid-line"),
        (axes[2], seen.horizontal, up[:, 0], "u on the vertical mid-line"),
    ):
        one.plot(s, line, "k-", lw=0.8, label="finite differences")
        one.plot(s[::6], values[::6], ".", label="points")
        one.set_title(title)
        one.set_xlabel("y / l" if one is axes[2] else "x / l")
    axes[1].plot(peaks.vertical_peak_at, peaks.vertical_peak, "rx", ms=8)
    axes[2].plot(peaks.horizontal_peak_at, peaks.horizontal_peak, "rx", ms=8)
    axes[0].plot([], [], "rx", ms=8, label="de Vahl Davis")
    axes[3].plot(right.y, right.local_nusselt(), "k-", lw=0.8)
    axes[3].plot(cavity.WALL, seen.local, ".")
    axes[3].axhline(cavity.LARGEST_LOCAL[rayleigh], color="r", lw=0.6, ls="--")
    axes[3].set_title("Nu on the hot wall")
    axes[3].set_xlabel("y / l")


def draw_layers(folder: Path, layers: Mapping[str, benard.Layer]) -> Path:
    """Temperature with streamlines."""
    figure, axes = new_figure(len(layers), 1, width=6.0, height=3.2)
    for (one,), (name, layer) in zip(axes, layers.items(), strict=True):
        found = benard.grown(layer)
        map_of(one, found.state.position, found.state.temperature, 1 / layer.rows, span=(0, 1))
        draw_streamlines(one, found.state, layer)
        one.set_title(f"{name}: {layer.title}; Nu {found.nusselt[-1]:.3f}, rolls: {found.rolls}")
    return save(figure, folder / "pd_benard.png")


def draw_streamlines(axes: Any, state: FluidState, layer: benard.Layer) -> None:
    """Streamlines of the velocity, on a grid."""
    x = np.linspace(0.02, layer.aspect - 0.02, int(30 * layer.aspect) + 2)
    y = np.linspace(0.02, 0.98, 30)
    places = np.stack(np.meshgrid(x, y), axis=-1)
    values = sample(state.position, state.velocity, places.reshape(-1, 2), 2.5 / layer.rows)
    u, v = np.moveaxis(values.reshape(*places.shape), -1, 0)
    axes.streamplot(x, y, u, v, color="w", linewidth=0.6, arrowsize=0.6, density=0.8)


def draw_thermals(folder: Path, spacing: float, end: float) -> Path:
    """The tank at the end, and the monitors in time."""
    found = thermals.record(spacing, end)
    figure, axes = new_figure(1, 3)
    span = (thermals.COLD, thermals.COLD + 6.0)
    map_of(axes[0, 0], found.state.position, found.state.temperature, spacing, span=span)
    axes[0, 0].set_title(f"t = {end:g} s")
    axes[0, 1].plot(found.time, thermals.monitor(found))
    axes[0, 1].set_xlabel("t (s)")
    axes[0, 1].set_title("0.8 cm above the plate (degree C)")
    axes[0, 2].pcolormesh(100 * found.place, found.time, found.temperature, cmap="inferno")
    axes[0, 2].set_xlabel("x (cm)")
    axes[0, 2].set_ylabel("t (s)")
    axes[0, 2].set_title("the same along the plate")
    return save(figure, folder / "pd_thermals.png")
