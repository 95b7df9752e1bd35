"""Run many cases of a scene and gather numbers of each: `lapilli study`."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from lapilli._core import Scene
from lapilli.study.failure import FAILURES, is_passing, reason_of
from lapilli.study.fitting import fitted
from lapilli.study.keys import Keys
from lapilli.study.observe import names_of, observe
from lapilli.study.quantity import Quantity, parted
from lapilli.study.results import Results
from lapilli.study.runner import LocalPool, Runner
from lapilli.study.sampling import Values, cases_of
from lapilli.study.settings import Setting, require_paths
from lapilli.study.store import Store

HISTORY_ROWS = 200  # of a case, where quantities are reduced over time


@dataclass(frozen=True)
class Outcome:
    """What came of one case. `reason` says why there are no numbers."""

    setting: Setting
    numbers: dict[str, float] = field(default_factory=dict)
    reason: str = ""
    cpu_seconds: float | None = None
    wall_seconds: float | None = None
    steps: int | None = None
    points: int | None = None
    passing: bool = False  # without numbers for want of memory or a file: another time it may work

    @property
    def status(self) -> str:
        """finished, refused (before its first step) or failed."""
        return self.reason.partition(":")[0] if self.reason else "finished"

    def as_json(self) -> dict[str, Any]:
        """Plain values."""
        return {**asdict(self), "setting": list(self.setting.changes)}

    @classmethod
    def from_json(cls, row: dict[str, Any]) -> Outcome:
        """The inverse of `as_json`."""
        setting = Setting(tuple((path, value) for path, value in row["setting"]))
        return cls(**{**row, "setting": setting})


@dataclass(frozen=True)
class Case:
    """One run to do; everything a worker process needs."""

    scene: Scene
    setting: Setting
    quantities: tuple[Quantity, ...]  # none: every scalar of the history
    fields: tuple[str, ...]
    threads: int = 1

    def __call__(self) -> Outcome:
        """Run; cases that are refused or fail are results, not errors."""
        try:
            return self._run()
        except FAILURES as error:
            return Outcome(self.setting, reason=reason_of(error), passing=is_passing(error))

    def without_error(self, reason: str) -> Outcome:
        """A case without numbers, which is tried again by the next study."""
        return Outcome(self.setting, reason=reason, passing=True)

    def _run(self) -> Outcome:
        started = time.perf_counter()
        scene = self.setting.apply(self.scene)
        over_time = any(one.reduction != "last" for one in self.quantities)
        every = scene.output.history_every or (scene.time.end / HISTORY_ROWS if over_time else None)
        seen = observe(
            scene, (scene.time.end,), self.fields, threads=self.threads, history_every=every
        )
        wanted = self.quantities or [Quantity(name) for name in seen.history if name != "time"]
        numbers = {str(one): one.of(seen) for one in wanted}
        return Outcome(
            self.setting,
            numbers,
            cpu_seconds=seen.cost.total_cpu_seconds,
            wall_seconds=time.perf_counter() - started,
            steps=seen.cost.steps,
            points=seen.cost.points,
        )


Report = Callable[[Outcome, int, int], None]


def study(
    scene: Scene | str | os.PathLike[str],
    vary: Mapping[str, Values] | None = None,
    quantities: Sequence[str] = (),
    *,
    sample: str = "grid",
    samples: int = 5,
    seed: int = 0,
    cases: Sequence[Setting] | None = None,
    threads: int = 1,
    runner: Runner | None = None,
    store: str | os.PathLike[str] | None = None,
    report: Report | None = None,
) -> Results:
    """Run every case of a scene and gather numbers of each.

    Parameters
    ----------
    vary
        Paths of members and what they may be: a list of values or a `Range`.
    quantities
        What is gathered: scalars of the history (their last value, or "max(NAME)", "min",
        "mean", "range" over time) and fields (mean over the volume of the bodies at the end).
        None: the last value of every scalar.
    sample
        "grid": every combination, `samples` numbers of each range. "latin-hypercube" and "sobol":
        `samples` cases drawn from all at once, the same for the same `seed`.
    cases
        Cases of your own instead of `vary`; `lapilli.study.cases_in` reads them from a CSV file.
    threads
        Threads of each run. Results are the same for any number of threads and workers.
    runner
        Where cases run: `LocalPool(workers)` or `DaskCluster(address)`.
    store
        File of cases done, one JSON line each. What it holds already is not run again, unless an
        input file, an array or the version has changed, or memory or a file was wanting. Scenes
        with functions keep nothing there: nothing can compare these.
    report
        Called with each case, how many are done, and how many there are.
    """
    scene = scene if isinstance(scene, Scene) else Scene.load(os.fspath(scene))
    chosen = list(dict.fromkeys(cases or cases_of(vary or {}, sample, samples, seed)))
    require_paths(chosen, scene)
    settings, notes = fitted(chosen, scene)
    wanted, fields, units = quantities_of(quantities, scene, settings)
    keys = Keys(scene, [str(one) for one in wanted])
    place = keys.place(store, notes)
    kept = Store(place, keys, Outcome.from_json, Outcome.as_json, lambda row: not row.passing)
    held = {row.setting: row for row in kept.rows}
    left = [Case(scene, one, wanted, fields, threads) for one in settings if one not in held]
    for outcome in (runner or LocalPool()).run(left):
        kept.add(outcome)
        held[outcome.setting] = outcome
        if report is not None:
            done = sum(one in held for one in settings)
            report(outcome, done, len(settings))
    return Results([held[one] for one in settings], [str(one) for one in wanted], units, notes)


def quantities_of(
    names: Sequence[str], scene: Scene, settings: Sequence[Setting]
) -> tuple[tuple[Quantity, ...], tuple[str, ...], dict[str, str]]:
    """The quantities, those of them that are fields, and their units, from the first case that can
    be built; a name that none has is an error."""
    wanted = tuple(Quantity.parse(name) for name in names)
    for changed in [setting.applied(scene) for setting in settings] + [scene]:
        if changed is None:
            continue
        try:
            fields, units = names_of(changed, [one.name for one in wanted])
        except (ValueError, RuntimeError):
            continue
        found = parted([one.name for one in wanted], fields, units)
        held = {str(one): units.get(one.name, "") for one in wanted} or units
        return wanted, tuple(dict.fromkeys(found)), held
    return wanted, tuple(one.name for one in wanted if "/" not in one.name), {}
