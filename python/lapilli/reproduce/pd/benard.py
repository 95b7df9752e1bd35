"""Section 6.1.1: layers heated from below.

The paper gives no height and properties with which no roll can form (Prandtl number 2.35e-4), so
each case states its numbers. Its temperature differences of 9, 18 and 36 K are read as Rayleigh
numbers 1500, 3000 and 6000 at Prandtl number 0.235 (its water with the true heat capacity): 9 K
must lie below the onset near 2000, 18 K above it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Simulation
from lapilli.references.cavity import Box, solve
from lapilli.reproduce.case import Case, Row, example, quotient_within, within
from lapilli.reproduce.pd.fluid_state import FluidState, carried_nusselt, fluid_state, sample
from lapilli.reproduce.rows import NO_BAR, between, exactly, rows_of
from lapilli.reproduce.states import Array, changed

NAME = "pd/benard"
row = rows_of(NAME)
PRANDTL, WATER = 0.71, 0.235


@dataclass(frozen=True, kw_only=True)
class Layer:
    """One layer: what it is, how it starts (rolls side by side) and what it becomes."""

    rayleigh: float  # of the height
    aspect: float  # width over height
    prandtl: float = WATER
    start: int = 1  # rolls of the first disturbance
    end: float = 1.0  # l^2/alpha
    rows: int = 25

    @property
    def title(self) -> str:
        return f"Ra {self.rayleigh:g}, Pr {self.prandtl:g}, aspect {self.aspect:g}"


STILL = Layer(rayleigh=1500, aspect=2, prandtl=PRANDTL, start=2, end=0.6)
TWO_ROLLS = Layer(rayleigh=5000, aspect=2, prandtl=PRANDTL, start=2, end=0.6)
# Figs. 12 to 15, by the letters of the paper.
FIGURES = {
    "Fig. 12 (a)": Layer(rayleigh=1500, aspect=2, start=2),
    "Fig. 12 (b)": Layer(rayleigh=3000, aspect=2, start=2, end=3.0),  # grows slowly
    "Fig. 12 (c)": Layer(rayleigh=6000, aspect=2, start=3),
    "Fig. 14 (a)": Layer(rayleigh=6000, aspect=1, start=1),
    "Fig. 14 (c)": Layer(rayleigh=6000, aspect=3, start=3),
    "Fig. 14 (d)": Layer(rayleigh=48000, aspect=0.5, start=1, rows=50, end=1.0),
}
ROLLS = {"Fig. 12 (b)": 2, "Fig. 12 (c)": 3, "Fig. 14 (a)": 1}
STEADY = [*ROLLS, "Fig. 14 (c)"]


@dataclass(frozen=True)
class Grown:
    """A layer after its time."""

    nusselt: Array  # (looks,), of the volume over the last half
    state: FluidState
    rolls: int


def simulation_of(layer: Layer) -> Simulation:
    """The example as this layer, disturbed by some rolls in its temperature."""
    width = layer.aspect
    scene = changed(
        example("pd/benard"),
        f"grid.cell={1 / layer.rows!r}",
        f"grid.upper=[{width + 0.2!r}, 1.2]",
        f"bodies.0.shape.upper=[{width!r}, 1.0]",
        f"bodies.0.material.1.viscosity={layer.prandtl!r}",
        f"peridynamics.flow.gravity=[0.0, {-layer.rayleigh * layer.prandtl!r}]",
        f"peridynamics.walls.0.shape.upper=[{width + 0.2!r}, 0.0]",
        f"peridynamics.walls.1.shape.upper=[{width + 0.2!r}, 1.2]",
        f"peridynamics.walls.3.shape.lower=[{width!r}, 0.0]",
        f"peridynamics.walls.3.shape.upper=[{width + 0.2!r}, 1.0]",
        f"time.end={layer.end!r}",
    )

    def disturbed(place: Array, _: Array, __: float) -> Array:
        wave = np.cos(layer.start * np.pi * place[:, 0] / width) * np.sin(np.pi * place[:, 1])
        field: Array = 1 - place[:, 1] - 0.05 * wave
        return np.clip(field, 0, 1)

    scene.bodies[0].temperature = disturbed
    return Simulation(scene)


@cache
def grown(layer: Layer, looks: int = 20) -> Grown:
    """Run a layer; look at it over the last half."""
    simulation = simulation_of(layer)
    numbers = []
    for look in range(1, looks + 1):
        simulation.run_until(layer.end * (0.5 + 0.5 * look / looks))
        numbers.append(carried_nusselt(fluid_state(simulation), axis=1))
    state = fluid_state(simulation)
    return Grown(np.array(numbers), state, rolls_of(state, layer))


def rolls_of(state: FluidState, layer: Layer) -> int:
    """Rolls side by side: how often the vertical velocity changes sign along the middle."""
    x = np.linspace(0.03, layer.aspect - 0.03, 120)
    middle = np.column_stack([x, np.full_like(x, 0.5)])
    up = sample(state.position, state.velocity[:, 1], middle, 3.0 / layer.rows)
    strong = up[np.abs(up) > 0.05 * np.abs(up).max()]
    return int(np.count_nonzero(np.diff(np.sign(strong))))


def run(quick: bool) -> list[Row]:
    """Below and above the onset; without `quick` also the layers of the paper's figures."""
    rows = [still_row(), *two_roll_rows()]
    return rows if quick else rows + [row for name in FIGURES for row in figure_rows(name)]


def still_row() -> Row:
    """Below the onset the disturbance dies."""
    value = float(grown(STILL).nusselt[-1])
    return row(STILL.title, "Nu of the volume", value, ("< 1.02", value < 1.02), reference=1.0)


def two_roll_rows() -> list[Row]:
    """Two rolls, beside finite differences."""
    layer, found = TWO_ROLLS, grown(TWO_ROLLS)
    last = float(found.nusselt[-5:].mean())
    swing = float(np.ptp(found.nusselt[-5:]) / last)
    return [
        row(layer.title, "rolls", found.rolls, exactly(found.rolls, 2), reference=2),
        nusselt_row(layer.title, layer),
        row(layer.title, "Nu of the volume", last, between(last, 1.85, 2.0)),
        row(layer.title, "its last change", swing, within(swing, 0.01)),
    ]


def nusselt_row(setting: str, layer: Layer) -> Row:
    """The Nusselt number of steady rolls beside finite differences."""
    box = Box(rayleigh=layer.rayleigh, prandtl=layer.prandtl, heated="bottom",
              aspect=layer.aspect, rolls=layer.start)  # fmt: skip
    right, last = solve(box, 40).nusselt(), float(grown(layer).nusselt[-5:].mean())
    bar = quotient_within(last, right, 0.03)
    return row(setting, "Nu of the volume", last, bar, reference=right)


def figure_rows(name: str) -> list[Row]:
    """What became of one layer of the paper."""
    layer, found = FIGURES[name], grown(FIGURES[name])
    setting = f"{name}: {layer.title}"
    drawn = ROLLS.get(name)
    bar = NO_BAR if drawn is None else exactly(found.rolls, drawn)
    number = row(setting, "Nu of the volume", found.nusselt[-1], NO_BAR)
    return [
        nusselt_row(setting, layer) if name in STEADY else number,
        row(setting, "its change over the last half", np.ptp(found.nusselt), NO_BAR),
        row(setting, "rolls", found.rolls, bar, paper=drawn),
    ]


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figs. 12 to 15: temperature and streamlines."""
    from lapilli.reproduce.pd.figures import draw_layers

    layers = {"two rolls": TWO_ROLLS} if quick else FIGURES
    return [draw_layers(folder, layers)]


CASE = Case(name=NAME, title="layers heated from below", run=run, plot=plot)
