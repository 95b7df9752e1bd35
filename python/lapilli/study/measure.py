"""One run of one setting: errors at the named times, and what they cost."""

from __future__ import annotations

import math
import time as clock
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli import _core
from lapilli._core import RunError, Scene, Simulation
from lapilli.study.reference import Reference
from lapilli.study.settings import Setting

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class Cost:
    """What a run took."""

    cpu_seconds: float  # stepping, all threads together
    build_seconds: float  # processor time before the first step
    wall_seconds: float  # stepping
    steps: int
    points: int
    peak_memory: int  # bytes, of the process

    @property
    def total_cpu_seconds(self) -> float:
        """Building and stepping."""
        return self.build_seconds + self.cpu_seconds


@dataclass(frozen=True)
class Measurement:
    """What came of one run. `reason` says why there is no error."""

    setting: Setting
    repeat: int
    error: float | None  # largest RMS error over the times, weighted by volume
    largest: float | None  # largest error of any point at any time
    reason: str
    cost: Cost | None

    def as_json(self) -> dict[str, Any]:
        """Plain values."""
        return {**asdict(self), "setting": list(self.setting.changes)}

    @classmethod
    def from_json(cls, row: dict[str, Any]) -> Measurement:
        """The inverse of `as_json`."""
        setting = Setting(tuple((path, value) for path, value in row["setting"]))
        cost = Cost(**row["cost"]) if row["cost"] else None
        return cls(**{**row, "setting": setting, "cost": cost})


@dataclass(frozen=True)
class Task:
    """One run to do; everything a worker process needs."""

    scene: Scene
    setting: Setting
    repeat: int
    reference: Reference
    field: str
    times: tuple[float, ...]
    threads: int

    def __call__(self) -> Measurement:
        """Run and measure. Settings that are refused or fail are results, not errors."""
        try:
            return self._measure()
        except ValueError as error:
            return self.without_error(f"refused: {error}")
        except RunError as error:
            return self.without_error(f"failed: {error}")

    def without_error(self, reason: str, cost: Cost | None = None) -> Measurement:
        """A measurement that says why there is none."""
        return Measurement(self.setting, self.repeat, None, None, reason, cost)

    def _measure(self) -> Measurement:
        _core.set_thread_count(self.threads)
        started = _core.cpu_seconds()
        simulation = Simulation(self.setting.apply(self.scene))
        build_seconds = _core.cpu_seconds() - started
        worst, largest, cpu, wall, reason = 0.0, 0.0, 0.0, 0.0, ""
        for time in self.times:
            cpu_start, wall_start = _core.cpu_seconds(), clock.perf_counter()
            simulation.run_until(time)
            cpu += _core.cpu_seconds() - cpu_start
            wall += clock.perf_counter() - wall_start
            # Points of walls are no part of what is computed.
            own = simulation["body"] < len(self.scene.bodies)
            values = simulation[self.field][own]
            truth = self.reference(simulation.position[own], time)
            reason = reason_of_blow_up(values, truth, time)
            if reason:
                break
            rms, most = errors(values, truth, simulation["volume"][own])
            worst, largest = max(worst, rms), max(largest, most)
        cost = Cost(
            cpu, build_seconds, wall, simulation.step_index, len(simulation), _core.peak_memory()
        )
        if reason:
            return self.without_error(reason, cost)
        return Measurement(self.setting, self.repeat, worst, largest, "", cost)


def errors(values: Array, truth: Array, volume: Array) -> tuple[float, float]:
    """RMS (weighted by volume) and largest difference."""
    square = (np.asarray(values, float) - truth) ** 2
    square = square if square.ndim == 1 else square.sum(axis=1)
    return math.sqrt(np.average(square, weights=volume)), math.sqrt(square.max())


def reason_of_blow_up(values: Array, truth: Array, time: float) -> str:
    """Why the values are no solution at all; empty when they may be one."""
    if not np.all(np.isfinite(values)):
        return f"unstable: values are no longer finite at t = {time:g} s"
    span = max(np.ptp(truth), np.abs(truth).max(), 1e-300)
    beyond = max(values.max() - truth.max(), truth.min() - values.min())
    if beyond > 10 * span:
        return f"unstable: values stray {beyond:.3g} beyond the reference at t = {time:g} s"
    return ""
