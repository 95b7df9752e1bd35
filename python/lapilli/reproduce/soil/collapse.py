"""Collapse of a column of dry sand, without cohesion, on a rough floor.

Run-out (d_inf - d_i)/d_i of an aspect a: 1.2 a in the plane (Lube et al. 2005, grains with angles
of repose of 30 degrees and more), up to 1.8 a (Lajeunesse et al. 2005, glass beads between smooth
walls). Mohr-Coulomb without dilation, rate or critical state, and without numerical damping, lies
between: the bar is 1 to 1.35 times Lube's law. For tall columns the laws end, and continuum models
are known to overrun: those rows have no bar.

Soil that yields at constant volume bears a shear of sin(phi) times the pressure on the planes on
which it slips, not tan(phi) (Davis 1968): its angle of repose is atan(sin(phi)). The laws' grains,
which repose at 30 degrees, have a friction angle of 35.3; at 30 degrees, which reposes at 26.6,
columns run out 20 to 30 % farther: rows without a bar.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation
from lapilli.references.granular import LUBE_2005
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.rows import between, rows_of
from lapilli.reproduce.states import Array, changed

NAME = "soil/collapse"
SHORT, TALL = (0.5, 1.0, 1.5), (2.0, 4.0, 8.0)
CELLS = (0.1, 0.05, 0.025)  # m, of a half width of 1 m
OVERRUN = 1.35  # times the law
REPOSE = 30.0  # degrees, of the laws' grains
HALVING_BAR = 10.0  # %, change of the run-out from one grid to the next
ENERGY_BAR = 0.01  # of the energy released
REPORTED = ("none", True)  # tall columns, and ten cells to a half width or a height

row = rows_of(NAME)


def friction_of(repose: float) -> float:
    """Friction angle, degrees, of soil without dilation that comes to rest at this angle."""
    return math.degrees(math.asin(math.tan(math.radians(repose))))


def scene(aspect: float, cell: float, friction: float) -> Scene:
    """The example with a column of this aspect and friction angle, until it rests."""
    reach = math.ceil(1 + 4 * max(aspect, 1.0) ** (2 / 3))
    return changed(
        example(NAME),
        f"grid.cell={cell!r}",
        f"grid.upper=[{float(reach)!r}, {math.ceil(aspect + 0.5)!r}.0]",
        f"bodies.0.shape.upper=[1.0, {aspect!r}]",
        f"bodies.0.material.mohr_coulomb.friction_angle={friction!r}",
        f"time.end={3 * math.sqrt(2 * aspect / 9.81) + 1.5!r}",
    )


@dataclass(frozen=True)
class Deposit:
    """A column at rest."""

    run_out: float  # over the half width
    left: float  # what the account of energy leaves over what was released
    profile: Array  # (cells, 2), m: middle of each occupied column of cells, its highest point


@cache
def collapsed(aspect: float, cell: float, friction: float | None = None) -> Deposit:
    """The deposit of a column of this aspect; of grains that repose as those of the laws."""
    angle = friction_of(REPOSE) if friction is None else friction
    simulation = Simulation(scene(aspect, cell, angle))
    before = simulation.diagnostics()["dynamics/potential_energy"]
    simulation.run_until(simulation.end)
    released = before - simulation.diagnostics()["dynamics/potential_energy"]
    energy = next(account for account in simulation.balance() if account.quantity == "energy")
    left = energy.stored - energy.initial - energy.supplied
    position = simulation["position"]
    column = np.floor(position[:, 0] / cell).astype(int)
    profile = [((k + 0.5) * cell, float(position[column == k, 1].max())) for k in np.unique(column)]
    return Deposit(front(position) - 1.0, left / released, np.array(profile))


def front(position: Array) -> float:
    """As far as 99.5 % of the points have come: single points fly ahead of a collapse."""
    return float(np.quantile(position[:, 0], 0.995))


def run(quick: bool) -> list[Row]:
    """Short columns beside the laws, tall ones reported; without `quick` on three grids."""
    cells = CELLS[:2] if quick else CELLS
    rows = []
    for aspect in (1.0,) if quick else SHORT:
        for cell in cells:
            rows += collapse_rows(aspect, cell)
        rows.append(grid_row(aspect, cells))
    if not quick:
        for aspect in TALL:
            rows += collapse_rows(aspect, CELLS[1])
    for aspect in (1.0,) if quick else SHORT:
        farther = collapsed(aspect, CELLS[1], REPOSE).run_out
        setting = f"aspect {aspect:g}, h = {CELLS[1]:g} m, friction angle {REPOSE:g}"
        law = float(LUBE_2005.run_out(aspect))
        rows.append(row(setting, "run-out over the half width", farther, REPORTED, paper=law))
    return rows


def collapse_rows(aspect: float, cell: float) -> list[Row]:
    """Run-out beside the law, a short column's inside the band; the energy."""
    found = collapsed(aspect, cell)
    law = float(LUBE_2005.run_out(aspect))
    low, high = law, OVERRUN * law
    resolved = aspect in SHORT and min(1.0, aspect) > 10.5 * cell
    bar = between(found.run_out, low, high) if resolved else REPORTED
    setting = f"aspect {aspect:g}, h = {cell:g} m"
    return [
        row(setting, "run-out over the half width", found.run_out, bar, paper=law),
        row(setting, "energy left over / released", found.left, within(found.left, ENERGY_BAR)),
    ]


def grid_row(aspect: float, cells: tuple[float, ...]) -> Row:
    """How the run-out depends on the grid: between the two finest."""
    coarse, fine = (collapsed(aspect, cell).run_out for cell in cells[-2:])
    growth = 100 * (fine / coarse - 1)
    return row(
        f"aspect {aspect:g}, h = {cells[-2]:g} to {cells[-1]:g} m",
        "growth of the run-out",
        growth,
        within(growth, HALVING_BAR),
        unit="%",
    )


def plot(folder: Path, quick: bool) -> list[Path]:
    """Run-out over the aspect, and the deposits of one column, on each grid."""
    from lapilli.reproduce.figures import new_figure, save

    figure, ((laws, deposits),) = new_figure(1, 2, width=5.0)
    for cell in CELLS[:2] if quick else CELLS:
        aspects: tuple[float, ...] = (1.0,) if quick else SHORT
        if not quick and cell == CELLS[1]:
            aspects += TALL
        found = [collapsed(aspect, cell).run_out for aspect in aspects]
        laws.loglog(aspects, found, "o-", label=f"lapilli, h = {cell:g} m")
        deposits.plot(*collapsed(1.0, cell).profile.T, label=f"h = {cell:g} m")
    every = np.geomspace(0.4, 9.0, 50)
    laws.loglog(every, LUBE_2005.run_out(every), "k--", label=LUBE_2005.source)
    laws.set(xlabel="aspect", ylabel="run-out over the half width")
    laws.legend(fontsize=8)
    deposits.plot([0, 1, 1], [1, 1, 0], "k:", label="at the start")
    deposits.set(xlabel="x (m)", ylabel="height (m)", title="aspect 1", aspect="equal")
    deposits.legend(fontsize=8)
    return [save(figure, folder / "collapse_run_out.png")]


CASE = Case(name=NAME, title="collapse of a column of dry sand", run=run, plot=plot)
