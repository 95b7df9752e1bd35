"""What an effect is, and the numbers that effects are seen in."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

import lapilli as lp

Quantity = Callable[[lp.Simulation], float]


@dataclass(frozen=True)
class Effect:
    """`quantity` after the run with `path` set to `first` and to `second`."""

    scene: Callable[[], lp.Scene]
    path: str
    first: Any
    second: Any
    quantity: Quantity
    relation: str  # "<", ">", "!=": of the second to the first; or "x": second = factor x first
    factor: float = 1.0
    tolerance: float = 1e-6
    steps: bool = True  # whether the scene runs to its end, or is only built


def mean(name: str) -> Quantity:
    """The mean of a field over the volume."""
    return lambda s: float(np.average(s[name], weights=s["volume"]))


def size(name: str) -> Quantity:
    """A number that any change of a field changes: its weighted sum by id."""

    def quantity(simulation: lp.Simulation) -> float:
        values = simulation.by_id(name).ravel()
        return float(values @ np.sin(1 + np.arange(len(values))))

    return quantity


def largest(name: str) -> Quantity:
    """The largest value or magnitude of a field."""
    return lambda s: float(np.linalg.norm(np.atleast_2d(s[name].T), axis=0).max())


def supplied(name: str) -> Quantity:
    """What came in of a conserved quantity."""
    return lambda s: next(one for one in s.balance() if one.quantity == name).supplied


def number(name: str) -> Quantity:
    """One of the diagnostics."""
    return lambda s: s.diagnostics()[name]


def step_size(simulation: lp.Simulation) -> float:
    """The step the clock takes."""
    return simulation.step_size


def steps(simulation: lp.Simulation) -> float:
    """How many were taken."""
    return simulation.step_index


def points(simulation: lp.Simulation) -> float:
    """How many there are."""
    return len(simulation)


def volume(simulation: lp.Simulation) -> float:
    """Of all points."""
    return float(np.sum(simulation["volume"]))


def centre(axis: int) -> Quantity:
    """The middle of the points along an axis."""
    return lambda s: float(np.average(s.position[:, axis], weights=s["volume"]))


def radius_of_gyration(simulation: lp.Simulation) -> float:
    """Changes with the shape of a body, not with its place."""
    away = simulation.position - simulation.position.mean(axis=0)
    return float(np.sqrt((away**2).sum(axis=1).mean()))
