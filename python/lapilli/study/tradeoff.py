"""Run all settings of a study."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from lapilli._core import Scene, Simulation
from lapilli.study.measure import Measurement, Task
from lapilli.study.reference import Function, Reference, reference_of
from lapilli.study.runner import LocalPool, Runner
from lapilli.study.settings import Setting, settings_of
from lapilli.study.table import Table

Report = Callable[[Measurement, int, int], None]


def tradeoff(
    scene: Scene | str | os.PathLike[str],
    vary: Mapping[str, Sequence[Any]],
    reference: str | os.PathLike[str] | Function | Reference,
    *,
    times: Sequence[float] | None = None,
    field: str = "temperature",
    repeats: int = 3,
    threads: int = 1,
    runner: Runner | None = None,
    store: str | os.PathLike[str] | None = None,
    report: Report | None = None,
) -> Table:
    """Measure error against cost over every combination of settings.

    Parameters
    ----------
    vary
        Paths of members and the values to try: ``{"grid.cell": [0.4, 0.2]}``. Cells that do not
        divide the grid are replaced by the nearest that do; the table's notes say which.
    reference
        What errors are measured against; see `lapilli.study.reference.reference_of`.
    times
        When errors are measured, s; the end of the scene unless given.
    repeats
        Runs of each setting, interleaved (all settings once, then all again), so that a slow spell
        of the machine does not fall on one setting.
    threads
        Threads of each run.
    store
        File of measurements, one JSON line each. What it holds already is not run again.
    report
        Called with each measurement, how many are done, and how many there are.
    """
    scene = scene if isinstance(scene, Scene) else Scene.load(os.fspath(scene))
    settings, notes = fitted(settings_of(vary), scene)
    require_known(settings, scene)
    moments = tuple(sorted(times)) if times is not None else (scene.time.end,)
    if repeats < 1:
        raise ValueError(f"repeats must be at least 1, got {repeats}")
    kept = Store(store, study_key(scene, reference, moments, field, threads))
    wanted = [(setting, repeat) for repeat in range(repeats) for setting in settings]
    done = [m for m in kept.measurements if (m.setting, m.repeat) in set(wanted)]
    known = {(m.setting, m.repeat) for m in done}
    left = [pair for pair in wanted if pair not in known]
    if left:
        truth = reference_of(reference, scene, field, moments)
        tasks = [Task(scene, s, r, truth, field, moments, threads) for s, r in left]
        for measurement in (runner or LocalPool()).run(tasks):
            kept.add(measurement)
            done.append(measurement)
            if report is not None:
                report(measurement, len(done), len(wanted))
    return Table.of(settings, done, field, unit_of(scene, field), notes)


def fitted(settings: Sequence[Setting], scene: Scene) -> tuple[list[Setting], list[str]]:
    """The settings with cells that divide their grid, each once, and what was changed."""
    kept: dict[Setting, None] = {}
    notes: dict[str, None] = {}
    for setting in settings:
        changes = dict(setting.changes)
        cell = fitting_cell(setting.apply(scene)) if "grid.cell" in changes else None
        if cell is not None:
            notes[f"grid.cell={changes['grid.cell']} does not fit the grid: {cell!r} instead"] = (
                None
            )
            changes["grid.cell"] = repr(cell)
        kept[Setting(tuple(changes.items()))] = None
    return list(kept), list(notes)


def fitting_cell(scene: Scene) -> float | None:
    """The cell nearest to that of a scene that divides its grid along every axis, within a quarter;
    None where its own does, or where there is none."""
    cell = scene.grid.cell
    lengths = [high - low for low, high in zip(scene.grid.lower, scene.grid.upper, strict=True)]
    most = round(lengths[0] / cell * 1.4) + 1
    fitting = [
        lengths[0] / count
        for count in range(1, most)
        if all(is_whole(length * count / lengths[0]) for length in lengths)
    ]
    nearest = min(fitting, key=lambda one: abs(one / cell - 1), default=None)
    if (
        nearest is None
        or abs(nearest / cell - 1) > 0.25
        or all(is_whole(length / cell) for length in lengths)
    ):
        return None
    return nearest


def is_whole(number: float) -> bool:
    """Whether a number of cells is whole, but for rounding."""
    return abs(number - round(number)) <= 1e-6 * max(1.0, number)


def require_known(settings: Sequence[Setting], scene: Scene) -> None:
    """A misspelt path is the user's mistake; a value that does not work is a result."""
    for setting in settings:
        setting.apply(scene)


def unit_of(scene: Scene, field: str) -> str:
    """The unit of a field, from a simulation that is not run; empty where it cannot be built."""
    try:
        return Simulation(scene).unit(field)
    except (ValueError, KeyError):
        return ""


def study_key(
    scene: Scene, reference: object, times: Sequence[float], field: str, threads: int
) -> str:
    """A name for all that measurements of one study have in common."""
    named = reference if isinstance(reference, str | os.PathLike) else repr(reference)
    text = json.dumps([scene.to_json(), str(named), list(times), field, threads])
    return hashlib.sha256(text.encode()).hexdigest()[:16]


class Store:
    """Measurements kept in a file, appended one by one: a study that was stopped goes on."""

    def __init__(self, path: str | os.PathLike[str] | None, key: str) -> None:
        self.path = None if path is None else Path(path)
        self.key = key
        self.measurements: list[Measurement] = []
        if self.path is not None and self.path.exists():
            lines = self.path.read_text().splitlines()
            self.measurements = [m for m in map(self._parse, lines) if m is not None]

    def _parse(self, line: str) -> Measurement | None:
        try:
            row = json.loads(line)
            return Measurement.from_json(row["measurement"]) if row["study"] == self.key else None
        except (ValueError, KeyError, TypeError):
            return None  # the last line of a run that was killed

    def add(self, measurement: Measurement) -> None:
        """Append one measurement, on a line of its own after one that was cut short."""
        self.measurements.append(measurement)
        if self.path is not None:
            line = json.dumps({"study": self.key, "measurement": measurement.as_json()})
            cut = self.path.exists() and self.path.read_bytes()[-1:] not in (b"\n", b"")
            with self.path.open("a") as file:
                file.write(("\n" if cut else "") + line + "\n")
