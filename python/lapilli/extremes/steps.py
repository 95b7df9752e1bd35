"""One case at one step: stable, inaccurate, unstable or refused."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import numpy.typing as npt

from lapilli._core import RunError, Simulation
from lapilli.extremes.cases import Case

# Steps over the automatic one.
FACTORS = (0.125, 0.25, 0.5, 0.71, 1.0, 1.25, 1.41, 2.0, 2.83, 4.0)
STRAY = 0.25  # of the span, beyond which a run counts as unstable
CLOSE = 0.03  # RMS over the span within which it counts as accurate
FAST = 2.0  # times the speed of the fine run, beyond which a flow counts as unstable


class Outcome(StrEnum):
    """What came of a step."""

    STABLE = "stable"
    INACCURATE = "inaccurate"
    UNSTABLE = "unstable"
    REFUSED = "refused"


@dataclass(frozen=True)
class Row:
    """One step of one case, s. `error` is the RMS difference to fine steps, over the span."""

    case: Case
    step: float
    factor: float  # over the automatic step
    outcome: Outcome
    error: float | None
    stray: float | None  # beyond [0, 1], over the span
    reason: str


def measure(case: Case, factors: tuple[float, ...] = FACTORS) -> Iterator[Row]:
    """Try every step. Steps that are refused or blow up are results."""
    automatic = min(limit for limit, _, _ in Simulation(case.scene).limits().values())
    end = case.length * automatic
    truth, _, speed = _run(case, case.fine * automatic, end)
    for factor in factors:
        step = factor * automatic
        try:
            values, stray, fast = _run(case, step, end)
        except ValueError as error:
            yield Row(case, step, factor, Outcome.REFUSED, None, None, str(error))
            continue
        except RunError as error:
            yield Row(case, step, factor, Outcome.UNSTABLE, None, None, str(error))
            continue
        error_size = float(np.sqrt(np.mean((values - truth) ** 2)))
        outcome = Outcome.STABLE
        if not (stray <= max(STRAY, 2.0 * _stray(truth)) and fast <= FAST * speed):
            outcome = Outcome.UNSTABLE
        elif error_size > CLOSE:
            outcome = Outcome.INACCURATE
        yield Row(case, step, factor, outcome, error_size, stray, "")


def _run(case: Case, step: float, end: float) -> tuple[npt.NDArray[np.float64], float, float]:
    """Nodal temperatures at the points at the end, how far they strayed then, and the root mean
    square of the speed of a flow (0 without)."""
    scene = case.scene.set(f"time.end={end!r}").set(f"time.step={step!r}")
    simulation = Simulation(scene)
    simulation.run_until(end)
    values = simulation.by_id("temperature")
    speed = 0.0
    if case.scene.peridynamics is not None and "velocity" in simulation.fields:
        speed = float(np.sqrt(np.mean(simulation["velocity"] ** 2)))
    return values, _stray(values), speed


def _stray(values: npt.NDArray[np.float64]) -> float:
    return float(max(values.max() - 1.0, -values.min(), 0.0))
