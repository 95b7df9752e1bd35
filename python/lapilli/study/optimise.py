"""Find the members of a scene that make a number smallest: `lapilli study --minimize`."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from lapilli._core import Scene
from lapilli.note import Note
from lapilli.study.keys import Keys
from lapilli.study.observe import observe
from lapilli.study.quantity import unknown_quantity
from lapilli.study.results import Results, needs
from lapilli.study.runner import LocalPool, Runner
from lapilli.study.sampling import Range, Values
from lapilli.study.series import Series, series_of_table
from lapilli.study.settings import Setting, as_toml, require_paths
from lapilli.study.store import Store
from lapilli.study.survey import HISTORY_ROWS, Case, Outcome, Report, quantities_of

if TYPE_CHECKING:
    import optuna

BATCH = 8  # cases chosen at once, whatever the number of workers: so results do not depend on it


@dataclass(frozen=True)
class MisfitCase(Case):
    """A run judged by how far a scalar of its history is from data, root mean square."""

    name: str = ""
    data: Series | None = None

    def _run(self) -> Outcome:
        assert self.data is not None
        scene = self.setting.apply(self.scene)
        end, last = scene.time.end, float(self.data.times[-1])
        if last > end * (1 + 1e-9):
            raise ValueError(f"the data go to {last:g} s, the scene ends at {end:g} s")
        every = scene.output.history_every or end / HISTORY_ROWS
        seen = observe(scene, (end,), threads=self.threads, history_every=every)
        if self.name not in seen.history:
            raise ValueError(unknown_quantity(self.name, seen.history))
        squares = [
            (seen.scalar(self.name, float(time)) - value) ** 2
            for time, value in zip(self.data.times, self.data.values, strict=True)
        ]
        misfit = math.sqrt(sum(squares) / len(squares))
        cost = seen.cost
        return Outcome(
            self.setting,
            {misfit_name(self.name): misfit},
            "" if math.isfinite(misfit) else "failed: the misfit is no number",
            cost.total_cpu_seconds,
            cost.total_wall_seconds,
            cost.steps,
            cost.points,
        )


def misfit_name(name: str) -> str:
    """The name of the misfit of a scalar in the table."""
    return f"misfit({name})"


def minimize(
    scene: Scene | str | os.PathLike[str],
    vary: Mapping[str, Values],
    quantity: str,
    *,
    data: str | os.PathLike[str] | Series | None = None,
    samples: int = 50,
    seed: int = 0,
    threads: int = 1,
    runner: Runner | None = None,
    store: str | os.PathLike[str] | None = None,
    report: Report | None = None,
) -> Results:
    """Try `samples` cases, each batch chosen by what the former ones gave (optuna's TPE).

    Parameters
    ----------
    vary
        Paths of members and what they may be: a `Range` or a list of values.
    quantity
        What shall be smallest: a field or a scalar as for `study`; "-NAME" for largest. With
        `data`, the scalar of the history that shall follow them.
    data
        A CSV file with the columns "time" and one named like the scalar (or any, if it is the only
        other one): calibration, by the root mean square difference at its times.

    The other parameters are those of `study`. Cases that fail count as worst. The result's `best`
    names the best case.
    """
    scene = scene if isinstance(scene, Scene) else Scene.load(os.fspath(scene))
    first = Setting(tuple((path, as_toml(start_of(values))) for path, values in vary.items()))
    if not vary:
        raise ValueError("nothing to vary: give paths and ranges, as in grid.cell=0.1..0.4")
    require_paths([first], scene)
    make, goal, units = case_maker(scene, quantity, data, threads, first)
    search = sampler_study(seed)
    known = None if data is None else series_of(data, quantity)
    numbers = None if known is None else [known.times.tolist(), known.values.tolist()]
    keys, notes = Keys(scene, goal, numbers, "minimize"), list[Note]()
    pool = runner or LocalPool()
    place = keys.place(store, notes)
    kept = Store(place, keys, Outcome.from_json, Outcome.as_json, lambda row: not row.passing)
    held = {row.setting: row for row in kept.rows}
    order: list[Setting] = []
    while len(order) < samples:
        trials = [search.ask() for _ in range(min(BATCH, samples - len(order)))]
        chosen = [suggestion(trial, vary) for trial in trials]
        new = [make(one) for one in dict.fromkeys(chosen) if one not in held]
        for outcome in pool.run(new):
            kept.add(outcome)
            held[outcome.setting] = outcome
            if report is not None:
                report(outcome, len(held), samples)
        for trial, setting in zip(trials, chosen, strict=True):
            value = held[setting].numbers.get(goal, math.nan)
            tell(search, trial, value)
        order += chosen
    settings = list(dict.fromkeys(order))
    return Results([held[one] for one in settings], [goal], units, notes)


def case_maker(
    scene: Scene,
    quantity: str,
    data: str | os.PathLike[str] | Series | None,
    threads: int,
    first: Setting,
) -> tuple[Callable[[Setting], Case], str, dict[str, str]]:
    """How a case is made, what it is judged by, and units."""
    wanted, fields, units = quantities_of([quantity], scene, [first])
    if data is None:
        plain = Case(scene, first, wanted, fields, threads)
        return lambda one: replace(plain, setting=one), str(wanted[0]), units
    misfit = MisfitCase(scene, first, (), (), threads, quantity, series_of(data, quantity))
    goal = misfit_name(quantity)
    return lambda one: replace(misfit, setting=one), goal, {goal: units.get(quantity, "")}


def series_of(data: str | os.PathLike[str] | Series, quantity: str) -> Series:
    """The data, read from their file if need be."""
    return data if isinstance(data, Series) else series_of_table(data, quantity)


def sampler_study(seed: int) -> optuna.Study:
    """A search that is the same for the same seed."""
    optuna = needs("optuna")
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    found: Any = optuna.create_study(
        direction="minimize", sampler=optuna.samplers.TPESampler(seed=seed, constant_liar=True)
    )
    return found  # type: ignore[no-any-return]


def suggestion(trial: optuna.trial.Trial, vary: Mapping[str, Values]) -> Setting:
    """What the search wants to try next."""
    changes = []
    for path, values in vary.items():
        if isinstance(values, Range):
            number = trial.suggest_float(path, values.low, values.high, log=values.logarithmic)
            changes.append((path, repr(float(f"{number:.9g}"))))
        else:
            index = trial.suggest_categorical(path, range(len(values)))
            changes.append((path, as_toml(values[index])))
    return Setting(tuple(changes))


def tell(search: optuna.Study, trial: optuna.trial.Trial, value: float) -> None:
    """What came of it; a failed case is one to stay away from."""
    if math.isfinite(value):
        search.tell(trial, value)
    else:
        search.tell(trial, state=needs("optuna").trial.TrialState.FAIL)


def start_of(values: Values) -> Any:
    """A value that is allowed."""
    return values.at(0.5) if isinstance(values, Range) else values[0]
