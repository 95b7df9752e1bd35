"""Section 5.1: conduction between two walls, and what the thermal horizon does to it."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation
from lapilli.references.slab import prescribed_slab
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.pd.fluid_state import FluidState, fluid_state
from lapilli.reproduce.rows import NO_BAR, rows_of
from lapilli.reproduce.states import Array, changed

NAME = "pd/conduction"
row = rows_of(NAME)
TIMES = (0.08, 0.16, 0.32)  # s
EARLY = 0.05  # s, where the two horizons differ most
LATTICE_BAR, JITTER_BAR, LITERAL_BAR = 0.002, 0.02, 0.015  # relative L2, 80 x 80
QUICK_BARS = {"lattice": 0.002, "jitter": 0.02}  # the same, at 20 x 20 points


def scene(rows: int, *settings: str) -> Scene:
    """The example with this many rows of points and other settings."""
    return changed(example("pd/conduction"), f"grid.cell={1 / rows!r}", *settings)


@cache
def at(rows: int, time: float, *settings: str) -> FluidState:
    """The block at one time."""
    simulation = Simulation(scene(rows, *settings))
    simulation.run_until(time)
    return fluid_state(simulation)


def exact(state: FluidState) -> Array:
    """Eq. 41."""
    return prescribed_slab(state.position[:, 0], state.time, thickness=1.0, left=1.0, right=0.0)


def error(state: FluidState) -> float:
    """Relative L2 error over the points."""
    right = exact(state)
    return float(np.linalg.norm(state.temperature - right) / np.linalg.norm(right))


def run(quick: bool) -> list[Row]:
    """80 x 80 points; 20 x 20 if `quick`."""
    rows = 20 if quick else 80
    found = []
    for time in TIMES:
        found.append(error_row(rows, f"lattice, t = {time:g} s", LATTICE_BAR, at(rows, time)))
    for time in TIMES:
        state = at(rows, time, "bodies.0.jitter=0.1")
        found.append(error_row(rows, f"10 % jitter, t = {time:g} s", JITTER_BAR, state))
    return found + horizon_rows(20 if quick else 40)


def error_row(rows: int, setting: str, bar: float, state: FluidState) -> Row:
    """One error beside its bar."""
    found = error(state)
    return row(f"{rows} x {rows} points, {setting}", "relative L2 error", found, within(found, bar))


def horizon_rows(rows: int) -> list[Row]:
    """The paper's two fields on its thermal horizon and on the fluid's: the claim of the paper."""
    literal = 'peridynamics.heat.laplacian="literal"'
    narrow = error(at(rows, EARLY, literal))
    wide = error(at(rows, EARLY, literal, "peridynamics.heat.horizon=3.015"))
    setting = f"two fields as in the paper, {rows} x {rows} points, t = {EARLY:g} s"
    return [
        row(setting, "relative L2 error, horizon 1.5 dx", narrow, NO_BAR),
        row(setting, "relative L2 error, horizon 3 dx", wide,
            ("> 2 x that of 1.5 dx", wide > 2 * narrow)),
    ]  # fmt: skip


def plot(folder: Path, quick: bool) -> list[Path]:
    """Fig. 6 (a), and the two horizons."""
    from lapilli.reproduce.pd.figures import draw_conduction

    return [draw_conduction(folder, 20 if quick else 40)]


CASE = Case(name=NAME, title="conduction between two walls", run=run, plot=plot)
