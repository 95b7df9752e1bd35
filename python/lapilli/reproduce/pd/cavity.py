"""Section 5.2: air between a hot and a cold wall, beside de Vahl Davis 1983."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation
from lapilli.references.cavity import DE_VAHL_DAVIS
from lapilli.reproduce.case import Case, Row, example, quotient_within, within
from lapilli.reproduce.pd.fluid_state import (
    FluidState,
    carried_nusselt,
    fluid_state,
    sample,
    wall_flux,
)
from lapilli.reproduce.rows import Bar, at_least, near, rows_of
from lapilli.reproduce.states import Array, changed

NAME = "pd/cavity"
row = rows_of(NAME)
PRANDTL = 0.71
LOOKS = 8  # states averaged over the last fifth: points that pass a wall make its power flicker
LINE = np.linspace(0.015, 0.985, 195)
WALL = np.linspace(0.0, 1.0, 51)

# de Vahl Davis 1983: Nusselt number of the volume, of the hot wall at its largest.
LARGEST_LOCAL = {1e3: 1.505, 1e4: 3.528, 1e5: 7.717, 1e6: 17.925}
FINE_NUSSELT = {1e6: 8.800}


@dataclass(frozen=True, kw_only=True)
class Plan:
    """How one Rayleigh number is run and what it is held to (shares of the benchmark)."""

    rows: int
    end: float  # l^2/alpha
    nusselt: float
    horizontal: float
    vertical: float
    noise: float
    density: float = 0.02
    position: float = 0.015
    local: float = 0.05
    spacing: float = 0.7  # of points, over that at the start


PLANS = {
    1e3: Plan(rows=80, end=0.3, nusselt=0.005, horizontal=0.015, vertical=0.03, noise=0.03),
    1e4: Plan(rows=80, end=0.2, nusselt=0.01, horizontal=0.015, vertical=0.02, noise=0.03),
    1e5: Plan(rows=80, end=0.15, nusselt=0.02, horizontal=0.03, vertical=0.03, noise=0.06),
}
# At half the points: the bars doubled, and the noise of a coarser mean.
QUICK = Plan(rows=40, end=0.2, nusselt=0.02, horizontal=0.02, vertical=0.03, noise=0.06,
             local=0.1, spacing=0.65)  # fmt: skip
FINEST = Plan(rows=160, end=0.08, nusselt=0.04, horizontal=1.0, vertical=1.0, noise=0.1)


@dataclass(frozen=True)
class Measured:
    """Means over the last fifth of a run."""

    nusselt: float  # of the volume
    hot: float  # of the walls, from the heat they gave
    cold: float
    local: Array  # (WALL,), on the hot wall
    horizontal: Array  # (LINE,), u on the vertical mid-line
    vertical: Array  # (LINE,), v on the horizontal mid-line
    temperature: Array  # (LINE,), on the horizontal mid-line
    diagnostics: dict[str, float]
    state: FluidState


def scene(rayleigh: float, rows: int, *settings: str) -> Scene:
    """The example at this Rayleigh number with this many rows of points."""
    gravity = f"peridynamics.flow.gravity=[0.0, {-rayleigh * PRANDTL!r}]"
    return changed(example("pd/cavity"), f"grid.cell={1 / rows!r}", gravity, *settings)


@cache
def measured(rayleigh: float, rows: int, end: float, *settings: str) -> Measured:
    """Run to `end` and average over the last fifth."""
    simulation = Simulation(scene(rayleigh, rows, *settings))
    begin = 0.8 * end
    simulation.run_until(begin)
    before = simulation.balance()[0].entries
    profiles, locals_, means = [], [], []
    for look in range(1, LOOKS + 1):
        simulation.run_until(begin + (end - begin) * look / LOOKS)
        state = fluid_state(simulation)
        profiles.append(mid_lines(state, 2.5 / rows))
        locals_.append(wall_flux(state, np.column_stack([0 * WALL, WALL]), 1 / rows))
        means.append(carried_nusselt(state, axis=0))
    given = {
        name: (heat - before[name]) / (end - begin)
        for name, heat in simulation.balance()[0].entries.items()
    }
    horizontal, vertical, temperature = np.mean(profiles, axis=0)
    return Measured(
        float(np.mean(means)), given["wall hot"], -given["wall cold"], np.mean(locals_, axis=0),
        horizontal, vertical, temperature, simulation.diagnostics(), state,
    )  # fmt: skip


def mid_lines(state: FluidState, reach: float) -> tuple[Array, Array, Array]:
    """u on the vertical, v and T on the horizontal mid-line."""
    middle = np.full_like(LINE, 0.5)
    up = sample(state.position, state.velocity, np.column_stack([middle, LINE]), reach)
    both = np.column_stack([state.velocity, state.temperature])
    across = sample(state.position, both, np.column_stack([LINE, middle]), reach)
    return up[:, 0], across[:, 1], across[:, 2]


def run(quick: bool) -> list[Row]:
    """Rayleigh numbers 1e3, 1e4 and 1e5 with 80 x 80 points, 1e6 with 160 x 160; 1e4 with 40 x 40
    if `quick`."""
    if quick:
        return plan_rows(1e4, QUICK)
    found = [row for rayleigh, plan in PLANS.items() for row in plan_rows(rayleigh, plan)]
    return [*found, *order_rows(), *finest_rows()]


def plan_rows(rayleigh: float, plan: Plan) -> list[Row]:
    """All numbers of one Rayleigh number beside the benchmark."""
    seen = measured(rayleigh, plan.rows, plan.end)
    right = DE_VAHL_DAVIS[rayleigh]
    numbers = seen.diagnostics

    setting = f"Ra {rayleigh:.0e}, {plan.rows} x {plan.rows} points"

    def beside(quantity: str, value: float, reference: float, bar: Bar) -> Row:
        return row(setting, quantity, value, bar, reference=reference)

    def share(quantity: str, value: float, reference: float, most: float) -> Row:
        return beside(quantity, value, reference, quotient_within(value, reference, most))

    def place(quantity: str, value: float, reference: float) -> Row:
        return beside(quantity, value, reference, near(value, reference, plan.position))

    wall = 0.5 * (seen.hot + seen.cold)
    variation = max(-numbers["flow/least_density_variation"],
                    numbers["flow/greatest_density_variation"])  # fmt: skip
    spacing = numbers["flow/smallest_spacing"]
    return [
        share("Nu of the volume", seen.nusselt, right.nusselt, plan.nusselt),
        share("largest u", seen.horizontal.max(), right.horizontal_peak, plan.horizontal),
        place("its y", LINE[seen.horizontal.argmax()], right.horizontal_peak_at),
        share("largest v", seen.vertical.max(), right.vertical_peak, plan.vertical),
        place("its x", LINE[seen.vertical.argmax()], right.vertical_peak_at),
        share("Nu of the hot wall", seen.hot, seen.cold, 0.01),
        share("Nu of the walls", wall, seen.nusselt, 0.02),
        share("largest local Nu", seen.local.max(), LARGEST_LOCAL[rayleigh], plan.local),
        row(setting, "velocity noise", numbers["flow/velocity_noise"],
            within(numbers["flow/velocity_noise"], plan.noise)),
        row(setting, "density variation", variation, within(variation, plan.density)),
        row(setting, "smallest spacing", spacing, at_least(spacing, plan.spacing)),
    ]  # fmt: skip


def six_errors(rayleigh: float, plan: Plan) -> float:
    """Root mean square of the errors of the six numbers of the benchmark: Nu of the volume, largest
    u, v and local Nu (relative), and the places of u and v (of l)."""
    seen, right = measured(rayleigh, plan.rows, plan.end), DE_VAHL_DAVIS[rayleigh]
    errors = [
        seen.nusselt / right.nusselt - 1,
        seen.horizontal.max() / right.horizontal_peak - 1,
        seen.vertical.max() / right.vertical_peak - 1,
        LINE[seen.horizontal.argmax()] - right.horizontal_peak_at,
        LINE[seen.vertical.argmax()] - right.vertical_peak_at,
        seen.local.max() / LARGEST_LOCAL[rayleigh] - 1,
    ]
    return float(np.sqrt(np.mean(np.square(errors))))


def order_rows() -> list[Row]:
    """What halving the spacing gains at Ra 1e4."""
    fine = PLANS[1e4]
    coarse = Plan(rows=40, end=fine.end, nusselt=1, horizontal=1, vertical=1, noise=1)
    gain = six_errors(1e4, coarse) / six_errors(1e4, fine)
    return [
        row("Ra 1e+04, 40 x 40 to 80 x 80 points", "RMS of the six errors falls by", gain,
            at_least(gain, 1.5)),
    ]  # fmt: skip


def finest_rows() -> list[Row]:
    """Beyond the paper."""
    seen = measured(1e6, FINEST.rows, FINEST.end)
    right = FINE_NUSSELT[1e6]
    bar = quotient_within(seen.nusselt, right, FINEST.nusselt)
    setting = f"Ra 1e+06, {FINEST.rows} x {FINEST.rows} points"
    return [row(setting, "Nu of the volume", seen.nusselt, bar, reference=right)]


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figs. 7 to 10."""
    from lapilli.reproduce.pd.figures import draw_cavity

    return [draw_cavity(folder, {1e4: QUICK} if quick else PLANS)]


CASE = Case(name=NAME, title="natural convection in a square cavity", run=run, plot=plot)
