"""Section 4.4: a square heated by convection, turned, cut from a lattice, and rotating."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation
from lapilli.references.slab import convective_box
from lapilli.reproduce.case import Case, Row, example, quotient_within, within
from lapilli.reproduce.rows import rows_of
from lapilli.reproduce.states import Array, State, changed, rms, states

NAME = "vhfm/square"
row = rows_of(NAME)
HALF = 5.0  # m, half of the side
TIME = 5.0  # s
ANGLES = (0, 15, 30, 45)  # degree
SPEEDS = {"1/16": 1 / 16, "1/4": 1 / 4, "1": 1.0, "4": 4.0}  # revolutions per second
PAPER = {0: 2.584e-3, 15: 4.902e-3, 30: 5.523e-3, 45: 6.396e-3}  # Fig. 19, at h = 0.2 m

# Largest RMSE (K) at 5 s by cell and angle; largest error of any point; largest miss of the length.
BARS = {
    0.2: {0: 7e-4, 15: 1.3e-3, 30: 3.3e-3, 45: 2.2e-3},
    0.1: {0: 3e-4, 15: 3.5e-4, 30: 5e-4, 45: 7.5e-4},
}
POINT_BAR = 3.5e-3  # K, h = 0.2 m
LENGTH_SHARE = 0.006
ROTATING_BAR, ROTATING_RELATIVE_BAR = 1.5e-3, 3e-3
CLIPPED_BAR = 1.3e-3  # K
LATTICE_BAR = 4.4e-3  # K: the staircase encloses 0.6 % less than the square


def turned_scene(angle: float, cell: float = 0.2) -> Scene:
    """The example with its points turned by this angle (degree), at the paper's step."""
    return changed(
        example("vhfm/square"),
        f"grid.cell={cell!r}",
        f"bodies.0.rotation={float(angle)!r}",
        f"time.step={cell**2 / 4!r}",
    )


def rotating_scene(speed: float) -> Scene:
    """The example that turns while it heats, at the paper's step."""
    return changed(
        example("vhfm/square_rotating"),
        f"bodies.0.motion.revolutions_per_second={speed!r}",
        "time.step=0.01",
    )


def lattice_scene(cell: float = 0.2) -> Scene:
    """Configuration B: a turned square cut out of the lattice of the grid."""
    return changed(
        example("vhfm/square_configuration_b"),
        f"grid.cell={cell!r}",
        f"time.step={cell**2 / 4!r}",
    )


def exact_temperature(position: Array, time: float, angle: float) -> Array:
    """The product of two slabs in the axes of the square, turned by `angle` degrees."""
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    local = position[:, :2] @ np.array([[cosine, -sine], [sine, cosine]])
    return convective_box(np.clip(local, -HALF, HALF), time, half_widths=HALF)


def errors(state: State, angle: float) -> Array:
    """Error of every point, K."""
    return state.temperature - exact_temperature(state.position, state.time, angle)


def length_share(scene: Scene) -> float:
    """Length of the surface over that of the square."""
    return float(Simulation(scene).diagnostics()["heat/surface_area"] / (8 * HALF))


@cache
def turned(angle: int, cell: float) -> State:
    """The turned square at 5 s."""
    return next(states(turned_scene(angle, cell), [TIME]))


@cache
def rotating(speed: float) -> State:
    """The rotating square at 5 s."""
    return next(states(rotating_scene(speed), [TIME]))


def run(quick: bool) -> list[Row]:
    """All at h = 0.2 m; without `quick` also h = 0.1 m and the four speeds."""
    rows = []
    for angle in ANGLES:
        rows += turned_rows(angle)
    rows += [*lattice_rows(), central_line_row()]
    speeds = ["1"] if quick else list(SPEEDS)
    rows += [row for name in speeds for row in rotating_rows(name)]
    if not quick:
        rows += [fine_row(angle) for angle in ANGLES]
    return rows


def turned_rows(angle: int) -> list[Row]:
    """RMSE, largest error and length of the surface at one angle."""
    setting = f"default, turned by {angle}°, h = 0.2 m"
    error = errors(turned(angle, 0.2), angle)
    length = length_share(turned_scene(angle))
    return [
        row(setting, "RMSE at 5 s", rms(error),
            within(rms(error), BARS[0.2][angle]), unit="K", paper=PAPER[angle]),
        row(setting, "largest error at 5 s", float(np.abs(error).max()),
            within(float(np.abs(error).max()), POINT_BAR), unit="K"),
        row(setting, "length of the surface over the true one", length,
            quotient_within(length, 1.0, LENGTH_SHARE), reference=1.0),
    ]  # fmt: skip


def fine_row(angle: int) -> Row:
    """RMSE on the finer grid."""
    found = rms(errors(turned(angle, 0.1), angle))
    return row(
        f"default, turned by {angle}°, h = 0.1 m",
        "RMSE at 5 s", found, within(found, BARS[0.1][angle]), unit="K",
    )  # fmt: skip


def lattice_rows() -> list[Row]:
    """Configuration B as it is, and with boundary points clipped to the square.

    The square itself is integrated, however its points fill it.
    """
    plain = rms(errors(next(states(lattice_scene(), [TIME])), 45))
    clipped = rms(errors(next(states(changed(lattice_scene(), "bodies.0.fill=exact"), [TIME])), 45))
    return [
        row("default, configuration B, h = 0.2 m", "RMSE at 5 s", plain,
            within(plain, LATTICE_BAR), unit="K"),
        row("configuration B, boundary points clipped, h = 0.2 m", "RMSE at 5 s", clipped,
            within(clipped, CLIPPED_BAR), unit="K"),
    ]  # fmt: skip


def central_line_row() -> Row:
    """The temperature along the middle at 1, 5, 10 and 50 s (Fig. 19, second column)."""
    largest = 0.0
    for state in states(turned_scene(0), (1.0, 5.0, 10.0, 50.0)):
        on_line = np.abs(state.position[:, 1]) < 0.1
        largest = max(largest, float(np.abs(errors(state, 0)[on_line]).max()))
    return row(
        "default, not turned, middle line to 50 s, h = 0.2 m",
        "largest error", largest, within(largest, POINT_BAR), unit="K",
    )  # fmt: skip


def rotating_rows(name: str) -> list[Row]:
    """What the points of the rotating square carry."""
    state = rotating(SPEEDS[name])
    exact = exact_temperature(state.position, TIME, 360 * SPEEDS[name] * TIME)
    error = state.carried - exact
    setting = f"default, {name} rev/s, h = 0.2 m"
    return [
        row(setting, "RMSE of the carried temperature at 5 s", rms(error),
            within(rms(error), ROTATING_BAR), unit="K"),
        row(setting, "relative RMSE of it", rms(error / exact),
            within(rms(error / exact), ROTATING_RELATIVE_BAR)),
    ]  # fmt: skip


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 19, 21 and 22."""
    from lapilli.reproduce.vhfm.square_figures import draw

    return draw(folder, quick)


CASE = Case(name=NAME, title="square heated by convection", run=run, plot=plot)
