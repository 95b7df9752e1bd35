"""States of a scene at given times, and what is measured on them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli._core import Scene, Simulation

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class State:
    """Copies of what the points hold at one time, in the order of their ids."""

    time: float  # s
    position: Array  # (points, dimension), m
    temperature: Array  # (points,), K, interpolated from the nodes
    carried: Array  # (points,), K, what the points carry; the interpolated one where nothing is
    flux: Array  # (points, dimension), W/m^2


def states(scene: Scene, times: Sequence[float], *, late: float = 0.0) -> Iterator[State]:
    """The scene at each of the ascending times, taken `late` seconds after it (see `literal`)."""
    simulation = Simulation(scene)
    for time in times:
        simulation.run_until(time + late)
        temperature = simulation.by_id("temperature")
        held = "temperature_carried" in simulation.fields
        rows = len(simulation)
        yield State(
            time,
            simulation.by_id("position").reshape(rows, -1),
            temperature,
            simulation.by_id("temperature_carried") if held else temperature,
            simulation.by_id("heat_flux").reshape(rows, -1),
        )


def changed(scene: Scene, *assignments: str) -> Scene:
    """A copy of the scene with some members changed: changed(scene, "grid.cell=0.2")."""
    for assignment in assignments:
        scene = scene.set(assignment)
    return scene


def rms(errors: npt.ArrayLike) -> float:
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(errors))))


def order(coarse: float, fine: float, ratio: float) -> float:
    """Order of convergence from the errors on two grids whose cells differ by `ratio`."""
    return float(np.log(coarse / fine) / np.log(ratio))
