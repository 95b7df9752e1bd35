"""Collapse of a column of dry sand (friction 30 degrees, no cohesion) on a rough floor.

Run-out (d_inf - d_i)/d_i of an aspect a: 1.2 a (Lube et al. 2005) and a, the two laws between
which continuum models of this friction are commonly placed; Lajeunesse et al. 2005 give a for the
axisymmetric column and 1.8 a for the plane one, with glass beads between smooth walls. For tall
columns the laws end, and continuum models are known to overrun: those rows have no bar.
"""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation
from lapilli.references.granular import LUBE_2005
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.rows import rows_of
from lapilli.reproduce.states import Array, changed

NAME = "soil/collapse"
SHORT, TALL = (0.5, 1.0, 1.5), (2.0, 4.0, 8.0)
CELLS = (0.1, 0.05, 0.025)  # m, of a half width of 1 m
WIDENED = 0.15  # of both laws
ENERGY_BAR = 0.01  # of the energy released

row = rows_of(NAME)


def scene(aspect: float, cell: float) -> Scene:
    """The example with a column of this aspect, until it rests."""
    reach = math.ceil(1 + 4 * max(aspect, 1.0) ** (2 / 3))
    return changed(
        example(NAME),
        f"grid.cell={cell!r}",
        f"grid.upper=[{float(reach)!r}, {math.ceil(aspect + 0.5)!r}.0]",
        f"bodies.0.shape.upper=[1.0, {aspect!r}]",
        f"time.end={3 * math.sqrt(2 * aspect / 9.81) + 1.5!r}",
    )


@cache
def collapsed(aspect: float, cell: float) -> tuple[float, float]:
    """Run-out over the half width, and what the account of energy leaves over what was released."""
    simulation = Simulation(scene(aspect, cell))
    before = simulation.diagnostics()["momentum/potential energy"]
    simulation.run_until(simulation.end)
    released = before - simulation.diagnostics()["momentum/potential energy"]
    energy = next(account for account in simulation.ledger() if account.quantity == "energy")
    left = energy.stored - energy.initial - energy.taken_in
    return front(simulation["position"], cell) - 1.0, left / released


def front(position: Array, cell: float) -> float:
    """The farthest point that occupied cells connect to the axis."""
    from scipy import ndimage

    at = np.floor(position / cell).astype(int)
    occupied = np.zeros(at.max(axis=0) + 1, dtype=bool)
    occupied[at[:, 0], at[:, 1]] = True
    parts, _ = ndimage.label(occupied, structure=np.ones((3, 3)))
    main = parts[0, 0]
    return float(position[parts[at[:, 0], at[:, 1]] == main, 0].max())


def run(quick: bool) -> list[Row]:
    """Short columns beside the laws, tall ones reported; without `quick` on three grids."""
    rows = []
    for aspect in (1.0,) if quick else SHORT:
        for cell in CELLS[:2] if quick else CELLS:
            rows += short_rows(aspect, cell)
    if not quick:
        rows += [tall_row(aspect) for aspect in TALL]
    return rows


def short_rows(aspect: float, cell: float) -> list[Row]:
    """Run-out inside the band of the two laws; energy accounted for."""
    run_out, left = collapsed(aspect, cell)
    low, high = (1 - WIDENED) * aspect, (1 + WIDENED) * float(LUBE_2005.run_out(aspect))
    setting = f"aspect {aspect:g}, h = {cell:g} m"
    return [
        row(setting, "run-out over the half width", run_out,
            (f"{low:.3g} to {high:.3g}", cell > CELLS[1] or low <= run_out <= high),
            paper=float(LUBE_2005.run_out(aspect))),
        row(setting, "energy left over / released", left, within(left, ENERGY_BAR)),
    ]  # fmt: skip


def tall_row(aspect: float) -> Row:
    """A tall column beside 1.9 a^(2/3)."""
    run_out, _ = collapsed(aspect, CELLS[1])
    law = float(LUBE_2005.run_out(aspect))
    return row(
        f"aspect {aspect:g}, h = {CELLS[1]:g} m",
        "run-out over the half width",
        run_out,
        ("no bar", True),
        paper=law,
    )


def plot(folder: Path, quick: bool) -> list[Path]:
    """Run-out over the aspect, on each grid."""
    from lapilli.reproduce.figures import new_figure, save

    figure, axes = new_figure(1, 1, width=5.0)
    aspects = (0.5, 1.0) if quick else (*SHORT, *TALL)
    for cell in CELLS[:2]:
        found = [collapsed(aspect, cell)[0] for aspect in aspects]
        axes[0, 0].loglog(aspects, found, "o-", label=f"lapilli, h = {cell:g} m")
    axes[0, 0].loglog(aspects, LUBE_2005.run_out(aspects), "k--", label=LUBE_2005.source)
    axes[0, 0].set(xlabel="aspect", ylabel="run-out over the half width")
    axes[0, 0].legend()
    return [save(figure, folder / "collapse_run_out.png")]


CASE = Case(name=NAME, title="collapse of a column of dry sand", run=run, plot=plot)
