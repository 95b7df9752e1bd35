"""The column in its settings: states at 0.5 and 2 s, nodal temperatures, monitored points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np

from lapilli._core import Scene, Simulation, Table
from lapilli.reproduce.case import example
from lapilli.reproduce.states import Array, changed, rms

NAME = "vhfm/column"
EARLY, TIME = 0.5, 2.0  # s, of the figures; the second is compared
LATE = 1.5  # s, when heating begins in the harder test
FILLED = 0.3  # share of a node's cell that both runs must fill
LOOKS = np.linspace(0.05, TIME, 40)  # s
NEAR = 0.05  # m, half the side of the square whose points a monitor follows


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
            f"bodies.0.material.0.friction_angle={self.friction!r}",
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
                "heat.implicit_robin=false",
            )
        if self.late:
            start = Table(times=[LATE, LATE + 1e-9], values=[0.0, self.coefficient])
            assert scene.heat is not None
            scene.heat.boundaries[0].coefficient = start
        return scene


@dataclass(frozen=True, kw_only=True)
class Heated:
    """The points and the nodes of the surface at one time."""

    position: Array  # (points, 2), m
    temperature: Array  # (points,), K, interpolated from the nodes
    carried: Array  # (points,), K
    volume: Array  # (points,), m2
    surface: Array  # (nodes, 2), m
    normal: Array  # (nodes, 2)


@dataclass(frozen=True, kw_only=True)
class Run:
    """A run to 2 s, and what was seen on the way."""

    early: Heated
    final: Heated
    history: Array  # (looks, monitors), K: mean over the points that began around each
    heat: float  # J, taken up
    residual: float  # of the balance of heat
    low: float  # K, the least and the largest temperature at any look
    high: float


@cache
def column(setting: Setting) -> Run:
    """The column in a setting."""
    return run_of(setting.scene())


def run_of(scene: Scene) -> Run:
    """A scene of the column, looked at every 0.05 s."""
    simulation = Simulation(scene)
    start = simulation.by_id("position")
    near = [np.abs(start - np.array(probe.position)).max(axis=1) < NEAR for probe in scene.probes]
    low, high = np.inf, -np.inf
    history, states = [], {}
    for time in LOOKS.round(3):
        simulation.run_until(time)
        both = np.concatenate([simulation["temperature"], simulation["temperature_carried"]])
        low, high = min(low, float(both.min())), max(high, float(both.max()))
        temperature = simulation.by_id("temperature")
        history.append([float(temperature[rows].mean()) for rows in near])
        if time in (EARLY, TIME):
            states[float(time)] = heated(simulation)
    balance = next(account for account in simulation.balance() if account.quantity == "heat")
    return Run(
        early=states[EARLY],
        final=states[TIME],
        history=np.array(history),
        heat=balance.stored - balance.initial,
        residual=abs(balance.residual),
        low=low,
        high=high,
    )


def heated(simulation: Simulation) -> Heated:
    """Copies of what the simulation holds now."""
    surface = simulation.surface()
    return Heated(
        position=simulation["position"].copy(),
        temperature=simulation["temperature"].copy(),
        carried=simulation["temperature_carried"].copy(),
        volume=simulation["volume"].copy(),
        surface=surface["position"],
        normal=surface["normal"],
    )


def on_nodes(state: Heated, cell: float) -> tuple[Array, Array]:
    """Share of its cell that each node fills, and its temperature (linear, weighted by volume),
    over the nodes of a grid from CORNER on, wide enough for every run."""
    count = np.array([round(12.0 / cell) + 2, round(5.0 / cell) + 2])
    at = (state.position - CORNER) / cell
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


CORNER = np.array([-6.0, -1.0])  # m


def difference(one: Run, other: Run, cell: float) -> tuple[float, float]:
    """RMS of the temperature over the common nodes in per cent of the span of 1 K, and the
    difference of the heat taken up in per cent."""
    (filled, found) = on_nodes(one.final, cell)
    (filled_too, wanted) = on_nodes(other.final, cell)
    common = (filled > FILLED) & (filled_too > FILLED)
    return 100 * rms((found - wanted)[common]), 100 * (one.heat / other.heat - 1)


def gaps(runs: Sequence[Run]) -> Array:
    """Largest difference of the histories of each run and the next, (runs - 1, monitors), K."""
    return np.array(
        [np.abs(one.history - other.history).max(axis=0) for one, other in pairwise(runs)]
    )
