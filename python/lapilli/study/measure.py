"""One run of one setting: errors at the named times, and what they cost."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli._core import Scene
from lapilli.study.cost import Cost
from lapilli.study.failure import FAILURES, is_passing, reason_of
from lapilli.study.norms import field_errors, scalar_errors
from lapilli.study.observe import Observation, observe
from lapilli.study.quantity import unknown_quantity
from lapilli.study.settings import Setting
from lapilli.study.truth import Truth

Array = npt.NDArray[Any]

Errors = dict[str, dict[str, float]]  # of each quantity in each norm


@dataclass(frozen=True)
class Measurement:
    """What came of one run. `reason` says why there is no error."""

    setting: Setting
    repeat: int
    error: float | None  # of the first quantity, in the norm that was asked for
    largest: float | None  # largest error of any point at any time
    reason: str
    cost: Cost | None
    errors: Errors = field(default_factory=dict)
    passing: bool = False  # no error for want of memory or a file: another time it may work

    @property
    def status(self) -> str:
        """measured, refused (before its first step), failed or unstable."""
        return self.reason.partition(":")[0] if self.reason else "measured"

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
    truth: Truth
    quantities: tuple[tuple[str, bool], ...]  # name, whether it is a field
    times: tuple[float, ...]
    threads: int = 1
    norm: str = "rms"
    output_cost: bool = True

    def __call__(self) -> Measurement:
        """Run and measure. Settings that are refused or fail are results, not errors."""
        try:
            return self._measure()
        except FAILURES as error:
            return replace(self.stopped(reason_of(error)), passing=is_passing(error))

    def without_error(self, reason: str) -> Measurement:
        """A measurement that says why there is none; the next study tries it again."""
        return replace(self.stopped(reason), passing=True)

    def stopped(self, reason: str, cost: Cost | None = None) -> Measurement:
        """The same for a reason that stays."""
        return Measurement(self.setting, self.repeat, None, None, reason, cost)

    def _measure(self) -> Measurement:
        scene = self.setting.apply(self.scene)
        fields = [name for name, is_field in self.quantities if is_field]
        seen = observe(
            scene, self.times, fields, threads=self.threads, output_cost=self.output_cost
        )
        errors: Errors = {}
        for name, is_field in self.quantities:
            if is_field:
                found, reason = self._field_errors(seen, name)
            else:
                found, reason = self._scalar_errors(seen, name)
            if reason:
                return self.stopped(reason, seen.cost)
            errors[name] = found
        first = errors[self.quantities[0][0]]
        return Measurement(
            self.setting, self.repeat, first[self.norm], first["max"], "", seen.cost, errors
        )

    def _field_errors(self, seen: Observation, name: str) -> tuple[dict[str, float], str]:
        values, truths = [], []
        for one in seen.snapshots:
            values.append(one.fields[name])
            truths.append(truth_at(self.truth, name, one.position, one.time, values[-1]))
            reason = reason_of_blow_up(values[-1], truths[-1], one.time)
            if reason:
                return {}, reason
        return field_errors(values, truths, [one.volume for one in seen.snapshots]), ""

    def _scalar_errors(self, seen: Observation, name: str) -> tuple[dict[str, float], str]:
        if name not in seen.history:
            raise ValueError(unknown_quantity(name, seen.history))
        values = np.array([seen.scalar(name, time) for time in self.times])
        truths = np.array([float(self.truth.scalars[name](time)) for time in self.times])
        if not np.all(np.isfinite(values)):
            return {}, f"unstable: {name} is no longer finite"
        return scalar_errors(values.tolist(), truths.tolist()), ""


def truth_at(truth: Truth, name: str, position: Array, time: float, values: Array) -> Array:
    """The reference of a field at the points; of another shape than the field is an error."""
    found = np.asarray(truth.fields[name](position, time), float)
    if found.shape != values.shape:
        raise ValueError(
            f"the reference of {name} returned an array {found.shape}, the field is {values.shape}"
        )
    return found


def reason_of_blow_up(values: Array, truth: Array, time: float) -> str:
    """Why the values are no solution at all; empty when they may be one."""
    if not np.all(np.isfinite(values)):
        return f"unstable: values are no longer finite at t = {time:g} s"
    span = max(np.ptp(truth), np.abs(truth).max(), 1e-300)
    beyond = max(values.max() - truth.max(), truth.min() - values.min())
    if beyond > 10 * span:
        return f"unstable: values stray {beyond:.3g} beyond the reference at t = {time:g} s"
    return ""
