"""Section 4.6: a column of soil that collapses while convection heats it.

The paper shows pictures only, and reports that its own method gives wrong temperatures with 4 and
9 points a cell. So the rows compare runs with few points a cell with one of 25 of the same recipe,
on the nodes that both fill, and show the paper's operator beside. Heat that starts at 1.5 s, when
the column has already spread, is the harder test.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation, Table
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.rows import rows_of
from lapilli.reproduce.states import Array, changed, rms

NAME = "vhfm/column"
row = rows_of(NAME)
TIME = 2.0  # s
CELLS = (0.1, 0.05, 0.025)  # m
LATE = 1.5  # s, when heating begins in the harder test
RANGE = 1e-3  # K, of the span of 1 K
FILLED = 0.3  # share of a node's cell that both runs must fill

# Bars on RMS over the span and on the heat taken up, in per cent, by points per cell.
BARS = {9: (0.5, 0.5), 4: (1.5, 1.5)}
LATE_BARS = {9: (1.0, 1.0), 4: (2.0, 2.0)}
PAPER_FAILS = {9: 5.0, 4: 50.0}


@dataclass(frozen=True, kw_only=True)
class Setting:
    """What is changed of the example."""

    points: int = 25
    cell: float = 0.1
    friction: float = 30.0
    coefficient: float = 1.0
    late: bool = False
    paper: bool = False

    def scene(self) -> Scene:
        """The example with these settings; the operator of the paper needs its shape functions."""
        scene = changed(
            example(NAME),
            f"grid.cell={self.cell!r}",
            f"bodies.0.points_per_cell={self.points}",
            f"bodies.0.material.0.friction={self.friction!r}",
            f"heat.boundaries.0.coefficient={self.coefficient!r}",
        )
        if self.friction < 25:
            scene = changed(scene, "grid.lower=[-5.0, 0.0]", "grid.upper=[5.0, 2.4]")
        if self.paper:
            scene = changed(
                scene,
                'grid.shape_function="linear"',
                'heat.method="paper"',
                'heat.transfer="flip"',
                "heat.implicit_exchange=false",
            )
        if self.late:
            start = Table(times=[LATE, LATE + 1e-9], values=[0.0, self.coefficient])
            assert scene.heat is not None
            scene.heat.boundaries[0].coefficient = start
        return scene


@dataclass(frozen=True, kw_only=True)
class Heated:
    """The points at one time, and what has been seen on the way."""

    position: Array  # (points, 2), m
    temperature: Array  # (points,), K, interpolated from the nodes
    carried: Array  # (points,), K
    volume: Array  # (points,), m2
    heat: float  # J, taken up
    residual: float  # of the balance of heat
    low: float  # K, the least and the largest temperature so far
    high: float


def heated(simulation: Simulation, times: Sequence[float]) -> Heated:
    """Run to the last of the times, looking at every one."""
    low, high = np.inf, -np.inf
    for time in times:
        simulation.run_until(time)
        both = np.concatenate([simulation["temperature"], simulation["temperature_carried"]])
        low, high = min(low, float(both.min())), max(high, float(both.max()))
    ledger = next(account for account in simulation.ledger() if account.quantity == "heat")
    return Heated(
        position=simulation["position"].copy(),
        temperature=simulation["temperature"].copy(),
        carried=simulation["temperature_carried"].copy(),
        volume=simulation["volume"].copy(),
        heat=ledger.stored - ledger.initial,
        residual=abs(ledger.residual),
        low=low,
        high=high,
    )


@cache
def final(setting: Setting) -> Heated:
    """The column at 2 s."""
    return heated(Simulation(setting.scene()), np.linspace(0.1, TIME, 20).tolist())


def on_nodes(state: Heated, cell: float) -> tuple[Array, Array]:
    """Share of its cell that each node fills, and its temperature (linear, weighted by volume),
    over the nodes of a grid wide enough for every run."""
    corner = np.array([-6.0, -1.0])
    count = np.array([round(12.0 / cell) + 2, round(5.0 / cell) + 2])
    at = (state.position - corner) / cell
    base = np.floor(at).astype(int)
    along = at - base
    filled, heat = np.zeros(count), np.zeros(count)
    for i in (0, 1):
        for j in (0, 1):
            share = np.abs(1 - i - along[:, 0]) * np.abs(1 - j - along[:, 1])
            place = (base[:, 0] + i, base[:, 1] + j)
            np.add.at(filled, place, share * state.volume)
            np.add.at(heat, place, share * state.volume * state.carried)
    return filled / cell**2, np.divide(heat, filled, out=np.zeros(count), where=filled > 0)


def difference(one: Heated, other: Heated, cell: float) -> tuple[float, float]:
    """RMS of the temperature over the common nodes in per cent of the span of 1 K, and the
    difference of the heat taken up in per cent."""
    (filled, found), (filled_too, wanted) = on_nodes(one, cell), on_nodes(other, cell)
    common = (filled > FILLED) & (filled_too > FILLED)
    return 100 * rms((found - wanted)[common]), 100 * (one.heat / other.heat - 1)


def run(quick: bool) -> list[Row]:
    """The example and its harder test; without `quick` also other friction, a finer grid, strong
    convection and monitored points."""
    rows = compared("default, h = 0.1 m", Setting(), BARS)
    rows += compared("default, heated from 1.5 s on, h = 0.1 m", Setting(late=True), LATE_BARS)
    rows += paper_rows()
    if not quick:
        rows += compared("default, friction 20°, h = 0.1 m", Setting(friction=20.0), BARS)
        rows += compared("default, h = 0.05 m", Setting(cell=0.05), BARS)
        rows += range_rows("default, coefficient 100", Setting(coefficient=100.0))
        rows += grid_rows()
    return rows


def with_points(setting: Setting, points: int) -> Setting:
    """The same with another number of points a cell."""
    return Setting(**{**setting.__dict__, "points": points})


def compared(text: str, setting: Setting, bars: dict[int, tuple[float, float]]) -> list[Row]:
    """Few points a cell beside 25 of the same recipe."""
    reference = final(setting)
    rows = []
    for points, (rms_bar, heat_bar) in bars.items():
        found, heat = difference(final(with_points(setting, points)), reference, setting.cell)
        words = f"{text}, {points} points a cell"
        rows += [
            row(words, f"RMS against 25 at {TIME:g} s", found, within(found, rms_bar),
                unit="% of span"),
            row(words, "heat taken up against 25", heat, within(heat, heat_bar), unit="%"),
        ]  # fmt: skip
    return rows + range_rows(text, setting)


def range_rows(text: str, setting: Setting) -> list[Row]:
    """Temperatures stay between those of the start and the surroundings; heat is kept."""
    states = [final(with_points(setting, points)) for points in (25, 9, 4)]
    beyond = max(max(-state.low, state.high - 1) for state in states)
    residual = max(state.residual for state in states)
    return [
        row(f"{text}, 25, 9 and 4 points a cell", "temperature beyond [0, 1]",
            max(beyond, 0.0), (f"<= {RANGE:g}", beyond <= RANGE), unit="K"),
        row(f"{text}, 25, 9 and 4 points a cell", "heat stored - taken in, relative",
            residual, within(residual, 1e-10)),
    ]  # fmt: skip


def paper_rows() -> list[Row]:
    """The operator of the paper, which it reports to fail, heated from 1.5 s on."""
    reference = final(Setting(late=True))
    rows = []
    for points, least in PAPER_FAILS.items():
        found, _ = difference(final(Setting(points=points, paper=True, late=True)), reference, 0.1)
        rows.append(
            row(f"method paper, linear, FLIP, heated from 1.5 s on, {points} points a cell",
                f"RMS against 25 at {TIME:g} s", found,
                (f"> {least:g}, fails", not found <= least), unit="% of span")
        )  # fmt: skip
    return rows


def grid_rows() -> list[Row]:
    """The monitored points on two grids."""
    coarse, fine = (histories(cell)[1] for cell in CELLS[:2])
    return [
        row(f"default, h = {CELLS[0]:g} beside {CELLS[1]:g} m, 25 points a cell",
            f"largest difference of the temperature at {name} to {TIME:g} s", gap,
            within(gap, 0.03), unit="K")
        for name, gap in zip(("P1", "P2"), np.abs(coarse - fine).max(axis=0), strict=True)
    ]  # fmt: skip


@cache
def histories(cell: float) -> tuple[Array, Array]:
    """Times (s) and the temperatures (times, monitors) of the monitored points (K): at each, the
    mean over the points that lay within half a cell of it at the start."""
    scene = Setting(cell=cell).scene()
    simulation = Simulation(scene)
    start = simulation.by_id("position")
    near = [
        np.abs(start - np.array(monitor.position)).max(axis=1) < 0.05 for monitor in scene.monitors
    ]
    times = np.linspace(0.0, TIME, 41)
    values = []
    for time in times:
        simulation.run_until(time)
        temperature = simulation.by_id("temperature")
        values.append([float(temperature[rows].mean()) for rows in near])
    return times, np.array(values)


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 27 to 29."""
    from lapilli.reproduce.vhfm.column_figures import draw

    return draw(folder, quick)


CASE = Case(name=NAME, title="soil column that collapses while it is heated", run=run, plot=plot)
