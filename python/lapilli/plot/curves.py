"""Numbers in time: columns of the history, fields at a position; of one run or of several."""

from __future__ import annotations

import fnmatch
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from lapilli.components import label, typeset
from lapilli.frames import Frames
from lapilli.plot.canvas import require_matplotlib
from lapilli.plot.picture import Source, frames_of
from lapilli.plot.view import drawn_field
from lapilli.whole_file import whole_file
from lapilli.words import meant

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Curve = tuple[str, npt.NDArray[Any], npt.NDArray[Any]]  # name, times (s), values


def draw_history(
    source: Source | Sequence[Source],
    columns: Sequence[str],
    save: str | os.PathLike[str] | None = None,
) -> Figure:
    """Columns of the history ("heat/stored", or patterns, "heat/*") in time, a panel for each unit.

    Reads the run record beside the frames.
    """
    runs = frames_of(source)
    by_unit: dict[str, list[Curve]] = {}
    for run in runs:
        history, units = recorded(run)
        for name in chosen(columns, list(units)):
            of_run = f"{run.path.stem}: {name}" if len(runs) > 1 else name
            by_unit.setdefault(units[name], []).append((of_run, history["time"], history[name]))
    return _curves({typeset(unit) or "no unit": one for unit, one in by_unit.items()}, save)


def draw_probe(
    source: Source | Sequence[Source],
    position: Sequence[float],
    field: str | None = None,
    save: str | os.PathLike[str] | None = None,
) -> Figure:
    """A field at a position in time, from the frames."""
    runs = frames_of(source)
    field = drawn_field(runs[0], field)
    curves: list[Curve] = []
    for run in runs:
        series = run.time_series(field, probe=position)
        names = [name for name in series.keys() if name != "time"]  # noqa: SIM118
        if not any(np.isfinite(np.asarray(series[name], float)).any() for name in names):
            raise ValueError(
                f"there is no material at ({', '.join(f'{x:g}' for x in position)}) m in any frame "
                f"of {run.path}"
            )
        for name in names:
            of_run = f"{run.path.stem}: {name}" if len(runs) > 1 else name
            curves.append((of_run, run.times, np.asarray(series[name])))
    where = ", ".join(f"{x:g}" for x in position)
    title = label(field, np.zeros(1), runs[0].unit(field))
    return _curves({f"{title} at ({where}) m": curves}, save)


def recorded(run: Frames) -> tuple[dict[str, npt.NDArray[Any]], dict[str, str]]:
    """The history in the record of a run, and the units of its columns."""
    if run.record is None:
        raise ValueError(f"{run.record_path} is missing: it holds the history of the run")
    history = {name: np.array(values, float) for name, values in run.record["history"].items()}
    return history, {row["name"]: row["unit"] for row in run.record["history_columns"]}


def chosen(wanted: Sequence[str], known: Sequence[str]) -> list[str]:
    """The columns of these names and patterns."""
    found: list[str] = []
    for one in wanted:
        here = [name for name in known if fnmatch.fnmatchcase(name, one)]
        if not here:
            raise ValueError(f"no column {one!r} in the history; {meant(one, known)}")
        found += [name for name in here if name not in found]
    return found


def _curves(panels: dict[str, list[Curve]], save: str | os.PathLike[str] | None) -> Figure:
    require_matplotlib()
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(
        len(panels), figsize=(6.4, 0.6 + 2.8 * len(panels)), layout="constrained", squeeze=False
    )
    for panel, (unit, curves) in zip(axes.flat, panels.items(), strict=True):
        for name, times, values in curves:
            panel.plot(times, values, ".-" if len(times) < 40 else "-", markersize=4, label=name)
        panel.set_xlabel("time (s)")
        panel.set_ylabel(unit)
        panel.grid(alpha=0.3)
        panel.legend(fontsize=8)
    if save is not None:
        with whole_file(save) as written:
            figure.savefig(written, dpi=150)
    plt.close(figure)
    return figure
