"""Figures 19, 21 and 22: the turned and the rotating square."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from lapilli.reproduce.figures import map_of, new_figure, save
from lapilli.reproduce.states import Array, State, changed, rms, states
from lapilli.reproduce.vhfm.square import (
    ANGLES,
    HALF,
    SPEEDS,
    TIME,
    exact_temperature,
    lattice_scene,
    rotating,
    turned_scene,
)

LEVELS = (0.3, 0.5, 0.7, 0.9)  # K
PROFILE_TIMES = (1.0, 5.0, 10.0, 50.0)  # s


def draw(folder: Path, quick: bool) -> list[Path]:
    """All of them."""
    return [draw_turned(folder), draw_rotating(folder, quick)]


def draw_turned(folder: Path) -> Path:
    """Figs. 19 and 21: temperature, middle line and relative error for each angle, and for
    configuration B with and without clipped points."""
    scenes = [(f"turned by {angle}°", float(angle), turned_scene(angle)) for angle in ANGLES]
    scenes.append(("configuration B", 45.0, lattice_scene()))
    scenes.append(
        ("configuration B, clipped", 45.0, changed(lattice_scene(), "bodies.0.fill=exact"))
    )
    figure, axes = new_figure(len(scenes), 3, width=3.8, height=3.2)
    for row, (title, angle, scene) in enumerate(scenes):
        for state in states(scene, PROFILE_TIMES):
            draw_middle_line(axes[row, 1], state, angle)
            if state.time == TIME:
                draw_fields(figure, axes[row, 0], axes[row, 2], state, state.temperature, angle)
        axes[row, 0].set_title(title)
    axes[0, 1].set_title("middle line; lines: exact")
    return save(figure, folder / "square_turned.png")


def draw_fields(
    figure: Any, left: Any, right: Any, state: State, values: Array, angle: float
) -> None:
    """Temperature with its isotherms and the exact ones, and the relative error."""
    exact = exact_temperature(state.position, state.time, angle)
    drawn = map_of(left, state.position, values, 0.1, levels=LEVELS, span=(0, 1))
    figure.colorbar(drawn, ax=left, shrink=0.8, label="K")
    side = np.linspace(-HALF, HALF, 120)
    x, y = np.meshgrid(side, side)
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    place = np.stack([cosine * x - sine * y, sine * x + cosine * y], axis=-1)
    field = exact_temperature(place.reshape(-1, 2), state.time, angle).reshape(x.shape)
    left.contour(
        place[..., 0], place[..., 1], field, LEVELS, colors="w", linewidths=0.7, linestyles="dashed"
    )
    error = (values - exact) / exact
    reach = float(np.abs(error).max())
    drawn = map_of(right, state.position, error, 0.1, span=(-reach, reach), colors="coolwarm")
    figure.colorbar(drawn, ax=right, shrink=0.8)
    right.set_title(f"relative error, RMS {rms(error):.1e}")


def draw_middle_line(axes: Any, state: State, angle: float) -> None:
    """Temperature along the middle of the square."""
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    along = state.position[:, 0] * cosine + state.position[:, 1] * sine
    across = -state.position[:, 0] * sine + state.position[:, 1] * cosine
    near = np.abs(across) <= 0.06
    axes.plot(along[near], state.temperature[near], ".", ms=3, label=f"{state.time:g} s")
    x = np.linspace(-HALF, HALF, 200)
    exact = exact_temperature(np.stack([x, 0 * x], axis=1), state.time, 0.0)
    axes.plot(x, exact, "k", lw=0.8)
    axes.set(xlabel="along the middle (m)", ylabel="temperature (K)", ylim=(-0.02, 1.04))
    axes.legend(fontsize=7)


def draw_rotating(folder: Path, quick: bool) -> Path:
    """Fig. 22: what the points carry, and its relative error, at each speed."""
    names = ["1"] if quick else list(SPEEDS)
    figure, axes = new_figure(2, len(names), width=3.8, height=3.2)
    for column, name in enumerate(names):
        state = rotating(SPEEDS[name])
        angle = 360 * SPEEDS[name] * TIME
        draw_fields(figure, axes[0, column], axes[1, column], state, state.carried, angle)
        axes[0, column].set_title(f"{name} revolutions per second, 5 s")
    return save(figure, folder / "square_rotating.png")
