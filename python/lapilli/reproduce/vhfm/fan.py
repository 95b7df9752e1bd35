"""Section 4.5: a rotating fan cooled by convection, from a picture.

The paper's picture is not published and it states no exact solution: the fan is our own, and its
rows compare three grids with each other and the turning fan with one at rest, whose temperatures
are the same.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.rows import rows_of
from lapilli.reproduce.states import Array, State, changed, rms, states

NAME = "vhfm/fan"
row = rows_of(NAME)
CELLS = (0.2, 0.1, 0.05)  # m; the paper's steps are h^2/2, which FLIP allows and ours need not
TIME = 0.5  # s, of Fig. 25
REST_BAR = 0.5  # K of 100: the grid cuts the turning outline anew in each step
MEAN_BARS = {0.2: 1.0, 0.1: 0.75}  # K, of the mean temperature against the finest grid


def fan_scene(cell: float, turning: bool = True) -> Scene:
    """The example on a grid of this cell, also at rest."""
    scene = changed(example("vhfm/fan"), f"grid.cell={cell!r}")
    return scene if turning else changed(scene, "bodies.0.motion.revolutions_per_second=0.0")


@cache
def cooled(cell: float, turning: bool = True) -> State:
    """The fan at 0.5 s."""
    return next(states(fan_scene(cell, turning), [TIME]))


def centre_history(cell: float, times: Array) -> Array:
    """Temperature at the centre: the mean over the points within one cell of it, K."""
    simulation = Simulation(fan_scene(cell))
    values = []
    for time in times:
        simulation.run_until(time)
        near = np.linalg.norm(simulation["position"], axis=1) < cell
        values.append(float(simulation["temperature"][near].mean()))
    return np.array(values)


def run(quick: bool) -> list[Row]:
    """The three grids against each other, and turning against resting."""
    finest = CELLS[1] if quick else CELLS[2]
    rows = [rest_row()]
    reference = float(cooled(finest).carried.mean())
    for cell in CELLS:
        if cell > finest:
            found = float(cooled(cell).carried.mean())
            rows.append(
                row(
                    f"default, h = {cell:g} m beside {finest:g} m",
                    f"mean temperature at {TIME:g} s",
                    found,
                    (
                        f"within {MEAN_BARS[cell]:g} K",
                        abs(found - reference) <= MEAN_BARS[cell],
                    ),
                    unit="K",
                    reference=reference,
                )
            )
    return rows


def rest_row() -> Row:
    """A fan that turns is as warm as one that rests."""
    error = cooled(0.1).carried - cooled(0.1, turning=False).carried
    return row(
        "default, h = 0.1 m, turning - at rest",
        f"RMS difference of the points at {TIME:g} s",
        rms(error),
        within(rms(error), REST_BAR),
        unit="K",
        reference=0.0,
    )


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 24 and 25."""
    from lapilli.reproduce.figures import map_of, new_figure, save

    figure, axes = new_figure(1, 4, width=3.2)
    simulation = Simulation(fan_scene(0.1))
    for panel, time in zip(axes[0], (0.05, 0.2, 0.5, 1.0), strict=True):
        simulation.run_until(time)
        drawn = map_of(
            panel,
            simulation["position"].copy(),
            simulation["temperature"].copy(),
            0.05,
            span=(0, 100),
        )
        nodes = simulation.surface()["position"]
        panel.plot(nodes[:, 0], nodes[:, 1], "c.", ms=1)
        panel.set_title(f"h = 0.1 m, {time:g} s")
    figure.colorbar(drawn, ax=list(axes[0]), shrink=0.8, label="temperature (°C)")
    pictures = [save(figure, folder / "fan_cooling.png")]

    cells = CELLS[:2] if quick else CELLS
    figure, axes = new_figure(1, len(cells) + 1, width=3.6)
    times = np.linspace(0.05, 1.0, 20)
    for column, cell in enumerate(cells):
        state = cooled(cell)
        drawn = map_of(axes[0, column], state.position, state.carried, 0.5 * cell, span=(0, 100))
        axes[0, column].set_title(f"h = {cell:g} m, {TIME:g} s")
        axes[0, -1].plot(times, centre_history(cell, times), label=f"h = {cell:g} m")
    figure.colorbar(drawn, ax=axes[0, -2], shrink=0.8)
    axes[0, -1].set(xlabel="t (s)", ylabel="temperature at the centre (°C)")
    axes[0, -1].legend(fontsize=8)
    return [*pictures, save(figure, folder / "fan_grids.png")]


CASE = Case(name=NAME, title="rotating fan cooled by convection", run=run, plot=plot)
