"""Section 4.6: a column of soil that collapses while convection heats it.

The paper shows pictures only, and reports that its own method gives wrong temperatures with 4 and
9 points per cell. So the rows compare runs with few points per cell with one of 25 of the same
recipe, on the nodes that both fill, and show the paper's operator beside. Heat that starts at
1.5 s, when the column has already spread, is the harder test. The three grids have 9 points per
cell: with 25, as in the paper, the finest would take three times as long and differ by 0.1 %.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from lapilli.reproduce.case import Case, Row, within
from lapilli.reproduce.rows import rows_of
from lapilli.reproduce.vhfm.column_runs import NAME, TIME, Setting, column, difference, gaps

row = rows_of(NAME)
CELLS = (0.1, 0.05, 0.025)  # m
GRID_POINTS = 9  # a cell, where grids are compared
RANGE = 1e-3  # K, of the span of 1 K

# Bars on RMS over the span and on the heat taken up, in per cent, by points per cell.
BARS = {9: (0.5, 0.5), 4: (1.5, 1.5)}
LATE_BARS = {9: (1.0, 1.0), 4: (2.0, 2.0)}
PAPER_FAILS = {9: 5.0, 4: 50.0}
GRID_BAR = 0.01  # K, from one grid to the next at any time, at P1 and P2; 0.0064 measured


def run(quick: bool) -> list[Row]:
    """The example and its harder test; without `quick` also other friction, finer grids and strong
    convection."""
    rows = compared("default, h = 0.1 m", Setting(), BARS)
    rows += compared("default, heated from 1.5 s on, h = 0.1 m", Setting(late=True), LATE_BARS)
    rows += paper_rows()
    if not quick:
        rows += compared("default, friction 20°, h = 0.1 m", Setting(friction=20.0), BARS)
        rows += compared("default, h = 0.05 m", Setting(cell=0.05), BARS)
        rows += range_rows("default, coefficient 100", Setting(coefficient=100.0))
        rows += grid_rows()
    return rows


def compared(text: str, setting: Setting, bars: dict[int, tuple[float, float]]) -> list[Row]:
    """Few points per cell beside 25 of the same recipe."""
    reference = column(setting)
    rows = []
    for points, (rms_bar, heat_bar) in bars.items():
        few = column(replace(setting, points=points))
        found, heat = difference(few, reference, setting.cell)
        words = f"{text}, {points} points per cell"
        rows += [
            row(words, f"RMS against 25 at {TIME:g} s", found, within(found, rms_bar),
                unit="% of span"),
            row(words, "heat taken up against 25", heat, within(heat, heat_bar), unit="%"),
        ]  # fmt: skip
    return rows + range_rows(text, setting)


def range_rows(text: str, setting: Setting) -> list[Row]:
    """Temperatures stay between those of the start and the surroundings; heat is kept."""
    runs = [column(replace(setting, points=points)) for points in (25, 9, 4)]
    beyond = max(max(-one.low, one.high - 1) for one in runs)
    residual = max(one.residual for one in runs)
    return [
        row(f"{text}, 25, 9 and 4 points per cell", "temperature beyond [0, 1]",
            max(beyond, 0.0), (f"<= {RANGE:g}", beyond <= RANGE), unit="K"),
        row(f"{text}, 25, 9 and 4 points per cell", "heat stored - taken in, relative",
            residual, within(residual, 1e-10)),
    ]  # fmt: skip


def paper_rows() -> list[Row]:
    """The operator of the paper, which it reports to fail, heated from 1.5 s on."""
    reference = column(Setting(late=True))
    rows = []
    for points, least in PAPER_FAILS.items():
        failing = column(Setting(points=points, paper=True, late=True))
        found, _ = difference(failing, reference, 0.1)
        rows.append(
            row(f"method paper, linear, FLIP, heated from 1.5 s on, {points} points per cell",
                f"RMS against 25 at {TIME:g} s", found,
                (f"> {least:g}, fails", not found <= least), unit="% of span")
        )  # fmt: skip
    return rows


def grid_rows() -> list[Row]:
    """The monitored points on three grids: near each other, and nearer as cells shrink."""
    found = gaps([column(Setting(cell=cell, points=GRID_POINTS)) for cell in CELLS])
    rows = []
    for place, name in enumerate(("P1", "P2")):
        for step, gap in enumerate(found[:, place]):
            rows.append(
                row(f"default, h = {CELLS[step]:g} beside {CELLS[step + 1]:g} m, "
                    f"{GRID_POINTS} points per cell",
                    f"largest difference of the temperature at {name} to {TIME:g} s", gap,
                    within(gap, GRID_BAR), unit="K")
            )  # fmt: skip
        ratio = found[1, place] / found[0, place]
        rows.append(
            row(f"default, three grids, {GRID_POINTS} points per cell",
                f"second difference over first at {name}", ratio, ("< 1", bool(ratio < 1)))
        )  # fmt: skip
    return rows


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 27 to 29."""
    from lapilli.reproduce.vhfm.column_figures import draw

    return draw(folder, quick)


CASE = Case(name=NAME, title="soil column that collapses while it is heated", run=run, plot=plot)
