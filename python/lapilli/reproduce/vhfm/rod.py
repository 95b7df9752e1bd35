"""Section 4.1: a half-infinite rod heated through its end."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene
from lapilli.references import rod as exact
from lapilli.reproduce.case import Case, Row, example, quotient_within, within
from lapilli.reproduce.rows import at_least, rows_of
from lapilli.reproduce.states import Array, State, changed, order, rms, states
from lapilli.reproduce.vhfm.literal import literal
from lapilli.reproduce.vhfm.tables import TABLE_1, TABLE_2, TIMES, Errors

NAME = "vhfm/rod"
row = rows_of(NAME)
LAWS = ("flux", "convection")
FINEST = 0.02  # m, the finest grid of Table 2
METHODS = {"node boundary": "node", "particle boundary": "particle"}  # the rest is "paper"

# Largest RMSE (K) of the default settings, h = 0.1 m: (law, conforming) -> at the times of the law.
BARS = {
    ("flux", True): (4e-5, 2.7e-5, 2.3e-5),
    ("flux", False): (9e-5, 5e-5, 4e-5),
    ("convection", True): (1.2e-4, 1.0e-4, 6e-5),
    ("convection", False): (1.6e-4, 2.0e-4, 2.2e-4),
}
FINE_BARS = (2.2e-6, 1.3e-6, 1.0e-6)  # constant flux, h = 0.02 m, not conforming
ORDER_BARS = {"flux": 1.9, "convection": 1.85}  # from h = 0.2 to 0.02 m


def rod_scene(law: str, cell: float, conforming: bool) -> Scene:
    """The example of this law on a grid of this cell; half a cell beyond the ends if it shall not
    conform."""
    name = "vhfm/rod" + ("" if conforming else "_nonconforming")
    scene = example(name + ("_convection" if law == "convection" else ""))
    beyond = 0.0 if conforming else cell / 2
    return changed(
        scene, f"grid.cell={cell!r}", f"grid.lower=[{-beyond!r}]", f"grid.upper=[{20 + beyond!r}]"
    )


def exact_temperature(law: str, x: Array, time: float) -> Array:
    """Eq. 41 or 42."""
    return exact.constant_flux(x, time) if law == "flux" else exact.convection(x, time)


def errors(law: str, scene: Scene, late: float = 0.0) -> list[float]:
    """RMSE over all points of the rod at the times of its law, K (Eq. 43)."""
    return [error_of(law, state) for state in states(scene, TIMES[law], late=late)]


def error_of(law: str, state: State) -> float:
    """RMSE of one state, K."""
    return rms(state.temperature - exact_temperature(law, state.position[:, 0], state.time))


@cache
def literal_errors(law: str, method: str, cell: float, conforming: bool) -> list[float]:
    """RMSE of the paper's algorithm, or of one of the two it is compared with, K."""
    step = cell**2 / 10
    return errors(law, literal(rod_scene(law, cell, conforming), step, method), late=step)


@cache
def default_errors(law: str, cell: float, conforming: bool, transfer: str) -> list[float]:
    """RMSE of lapilli's defaults at the paper's step, K."""
    scene = changed(
        rod_scene(law, cell, conforming),
        f"heat.transfer={transfer}",
        f"time.step={cell**2 / 10!r}",
    )
    return errors(law, scene)


def run(quick: bool) -> list[Row]:
    """Tables 1 and 2 as the paper ran them, then the defaults."""
    rows = [*table_1(), nodes_equal_virtual_flux(), *table_2(quick), *default_rows()]
    return rows if quick else rows + fine_rows()


def table_1() -> list[Row]:
    """Table 1."""
    rows = []
    for column, by_law in TABLE_1.items():
        for law, printed in by_law.items():
            conforming = column != "VHFM, not conforming"
            found = literal_errors(law, METHODS.get(column, "paper"), 0.1, conforming)
            rows += table_rows(f"Table 1, {law}, {column}", law, printed, found)
    return rows


def table_2(quick: bool) -> list[Row]:
    """Table 2; its finest grid takes a minute."""
    rows = []
    for (law, method), by_cell in TABLE_2.items():
        for cell, printed in by_cell.items():
            if quick and cell == FINEST:
                continue
            name = "paper" if method == "VHFM" else "particle"
            found = literal_errors(law, name, cell, False)
            rows += table_rows(f"Table 2, {law}, {method}, h = {cell:g} m", law, printed, found)
    return rows


def table_rows(setting: str, law: str, printed: Errors, found: list[float]) -> list[Row]:
    """One row for each time."""
    rows = []
    for k, time in enumerate(TIMES[law]):
        rows.append(
            row(
                setting,
                f"RMSE at {time:g} s",
                found[k],
                quotient_within(found[k], printed.corrected[k], 0.005),
                unit="K",
                paper=printed.printed[k],
                reference=printed.corrected[k],
            )
        )
    return rows


def nodes_equal_virtual_flux() -> Row:
    """Where the rod conforms, the paper's operator gives each node its exact area."""
    largest = 0.0
    for law in LAWS:
        both = [
            list(states(literal(rod_scene(law, 0.1, True), 1e-3, method), TIMES[law]))
            for method in ("node", "paper")
        ]
        for one, other in zip(*both, strict=True):
            largest = max(largest, float(np.abs(one.temperature - other.temperature).max()))
    return row(
        "Table 1, VHFM, conforming - node boundary",
        "largest difference",
        largest,
        within(largest, 1e-12),
        unit="K",
        paper=0.0,
        reference=0.0,
    )


def default_rows() -> list[Row]:
    """lapilli's defaults, and the transfer of TPIC, which agrees on points at rest."""
    rows = []
    for transfer in ("nodal", "tpic"):
        for (law, conforming), bars in BARS.items():
            found = default_errors(law, 0.1, conforming, transfer)
            column = "VHFM, conforming" if conforming else "VHFM, not conforming"
            for k, time in enumerate(TIMES[law]):
                words = "" if conforming else " not"
                rows.append(
                    error_row(
                        f"default, {transfer}, {law},{words} conforming, h = 0.1 m",
                        time,
                        TABLE_1[column][law].corrected[k],
                        found[k],
                        bars[k],
                    )
                )
    return rows


def fine_rows() -> list[Row]:
    """The finest grid of Table 2 and the order down to it."""
    rows = []
    for law in LAWS:
        fine = default_errors(law, FINEST, False, "nodal")
        coarse = default_errors(law, 0.2, False, "nodal")
        for k, time in enumerate(TIMES[law]):
            if law == "flux":
                paper = TABLE_2[law, "VHFM"][FINEST].corrected[k]
                setting = f"default, kept, {law}, not conforming, h = {FINEST:g} m"
                rows.append(error_row(setting, time, paper, fine[k], FINE_BARS[k]))
            found = order(coarse[k], fine[k], 0.2 / FINEST)
            least = ORDER_BARS[law]
            rows.append(
                row(
                    f"default, kept, {law}, not conforming, h = 0.2 to {FINEST:g} m",
                    f"order of convergence at {time:g} s",
                    found,
                    at_least(found, least),
                    paper=2.0,
                    reference=2.0,
                )
            )
    return rows


def error_row(setting: str, time: float, paper: float, found: float, bar: float) -> Row:
    """An error against the exact solution."""
    return row(setting, f"RMSE at {time:g} s", found, within(found, bar), unit="K", paper=paper)


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 5 and 6."""
    from lapilli.reproduce.vhfm.rod_figures import draw

    return draw(folder, quick)


CASE = Case(name=NAME, title="rod heated through its end", run=run, plot=plot)
