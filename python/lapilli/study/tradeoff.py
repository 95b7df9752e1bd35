"""Run all settings of a study."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence

from lapilli import _core
from lapilli._core import Scene
from lapilli.study.fitting import fitted, fitting_cell
from lapilli.study.keys import Keys, contents_of
from lapilli.study.measure import Measurement, Task
from lapilli.study.norms import NORMS
from lapilli.study.observe import names_of
from lapilli.study.quantity import parted
from lapilli.study.runner import LocalPool, Runner
from lapilli.study.settings import Setting, Vary, require_paths, settings_of
from lapilli.study.store import Store
from lapilli.study.table import Table
from lapilli.study.truth import Given, named, truth_of

__all__ = ["fitting_cell", "tradeoff"]

Report = Callable[[Measurement, int, int], None]


def tradeoff(
    scene: Scene | str | os.PathLike[str],
    vary: Vary | Sequence[Vary],
    reference: Given | Mapping[str, Given] = None,
    *,
    times: Sequence[float] | None = None,
    field: str = "temperature",
    quantities: Sequence[str] | None = None,
    norm: str = "rms",
    repeats: int = 3,
    threads: int = 1,
    runner: Runner | None = None,
    store: str | os.PathLike[str] | None = None,
    report: Report | None = None,
    target_error: float | None = None,
) -> Table:
    """Measure error against cost over every combination of settings.

    Parameters
    ----------
    vary
        Paths of members and the values to try: ``{"grid.cell": [0.4, 0.2]}``. Several such
        mappings are tried one after the other, each with all of its combinations. Cells that do not
        divide the grid are replaced by the nearest that do, or the grid grows; the table's notes
        say which.
    reference
        What errors are measured against; see `lapilli.study.reference.reference_of`. One for all
        quantities, or one by the name of each; a known number serves a scalar. None: a run with
        half of the smallest cell and step tried, which the table's notes name.
    times
        When errors are measured, s; the end of the scene unless given.
    field
        The quantity, where `quantities` names none.
    quantities
        Fields, and scalars of the history ("heat/supplied_by_convection"); the first is the one
        that settings are ranked by.
    norm
        By which: rms, max, mean or relative.
    repeats
        Runs of each setting, interleaved (all settings once, then all again), so that a slow spell
        of the machine does not fall on one setting.
    threads
        Threads of each run.
    store
        File of measurements, one JSON line each. What it holds already is not run again, as in
        `study`; it must be of the same reference, byte by byte.
    report
        Called with each measurement, how many are done, and how many there are.
    target_error
        Settings with a larger error are called inaccurate.
    """
    scene = scene if isinstance(scene, Scene) else Scene.load(os.fspath(scene))
    chosen = settings_of(vary)
    require_paths(chosen, scene)
    settings, notes = fitted(chosen, scene)
    moments = tuple(sorted(times)) if times is not None else (scene.time.end,)
    if repeats < 1:
        raise ValueError(f"repeats must be at least 1, got {repeats}")
    if norm not in NORMS:
        raise ValueError(_core.unknown_name("norm", norm, list(NORMS)))
    names = tuple(quantities or (field,))
    told = named(reference), contents_of(reference)
    keys = Keys(scene, told, moments, names, threads, norm)
    place = keys.place(store, notes, reference)
    kept = Store(
        place, keys, Measurement.from_json, Measurement.as_json, lambda row: not row.passing
    )
    wanted = [(setting, repeat) for repeat in range(repeats) for setting in settings]
    done = [m for m in kept.rows if (m.setting, m.repeat) in set(wanted)]
    known = {(m.setting, m.repeat) for m in done}
    left = [pair for pair in wanted if pair not in known]
    kinds, units = kinds_of(names, scene, settings)
    if left:
        truth = truth_of(reference, scene, kinds, moments, settings)
        notes += truth.notes
        tasks = [Task(scene, s, r, truth, kinds, moments, threads, norm) for s, r in left]
        for measurement in (runner or LocalPool()).run(tasks):
            kept.add(measurement)
            done.append(measurement)
            if report is not None:
                report(measurement, len(done), len(wanted))
    table = Table.of(settings, done, names[0], units.get(names[0], ""), notes)
    return table.judged(target_error, norm)


def kinds_of(
    names: Sequence[str], scene: Scene, settings: Sequence[Setting]
) -> tuple[tuple[tuple[str, bool], ...], dict[str, str]]:
    """Whether each name is a field or a scalar, and the units, from the first setting that works,
    in its first step."""
    for changed in [setting.applied(scene) for setting in settings] + [scene]:
        if changed is None:
            continue
        try:
            fields, units = names_of(changed, names)
        except (ValueError, RuntimeError):
            continue
        are_fields = set(parted(names, fields, units))
        return tuple((name, name in are_fields) for name in names), units
    return tuple((name, "/" not in name) for name in names), {}
