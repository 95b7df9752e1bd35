"""Error against cost, log-log, with the Pareto front."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from lapilli.plot import require_matplotlib
from lapilli.study.settings import Setting
from lapilli.study.table import Table, cost_of, error_of
from lapilli.whole_file import whole_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MARKERS = "osD^vP*X<>p"  # eleven, where colours come back after ten: no two lines look alike
WIDE = 44  # letters of a label, beyond which two do not fit beside each other


def _varied(table: Table) -> set[str]:
    """The settings that take more than one value, that of the scene among them: the others need
    no mention."""
    values: dict[str, list[str]] = {}
    for row in table.rows:
        for name, value in row.setting.changes:
            values.setdefault(name, []).append(value)
    return {
        name
        for name, taken in values.items()
        if len(set(taken)) > 1 or len(taken) < len(table.rows)
    }


def _label(setting: Setting, varied: set[str]) -> str:
    return ", ".join(
        f"{name.rpartition('.')[2]} = {value}" for name, value in setting.changes if name in varied
    )


def draw(table: Table, path: str | os.PathLike[str] | None = None) -> Figure:
    """One line for each combination of all settings but the first; the front in grey."""
    require_matplotlib()
    import matplotlib.pyplot as plt

    varied = _varied(table)
    series: dict[Setting, list[tuple[float, float, str]]] = {}
    for row in table.rows:
        if row.error is not None and row.cpu_seconds:
            first, rest = row.setting.changes[0], Setting(row.setting.changes[1:])
            point = (cost_of(row), max(error_of(row), 1e-16), first[1])
            series.setdefault(rest, []).append(point)
    alone = "as in the scene" if len(series) > 1 else ""
    labels = [_label(rest, varied) or alone for rest in series]
    columns = 1 if max(map(len, labels), default=0) > WIDE else 2
    legend = 0.15 * max(0, len(labels) // columns - 4)
    figure, axes = plt.subplots(figsize=(7, 6 + legend), layout="constrained")
    front = [(cost_of(row), max(error_of(row), 1e-16)) for row in table.front]
    if front:
        axes.step(
            *zip(*front, strict=True),
            where="post",
            color="0.8",
            lw=6,
            zorder=0,
            label="Pareto front",
        )
    for number, points in enumerate(series.values()):
        cost, error, _ = zip(*points, strict=True)
        marker = MARKERS[number % len(MARKERS)]
        axes.plot(cost, error, marker=marker, lw=1, label=labels[number] or None)
        for x, y, label in points:
            axes.annotate(label, (x, y), xytext=(4, 4), textcoords="offset points", fontsize=7)
    if series:
        axes.set(xscale="log", yscale="log")
    unit = f" ({table.unit})" if table.unit and table.norm != "relative" else ""
    norm = "RMS" if table.norm == "rms" else table.norm
    along = table.rows[0].setting.changes[0][0] if table.rows else ""
    axes.set(
        xlabel="CPU time (s): building, stepping, output",
        ylabel=f"{norm} error of {table.field}{unit}",
    )
    axes.set_title(f"numbers at the marks: {along}", fontsize=9)
    axes.grid(which="both", alpha=0.2)
    if axes.get_legend_handles_labels()[0]:
        figure.legend(fontsize=7, loc="outside lower center", ncols=columns)
    failed = sum(row.error is None for row in table.rows)
    if failed:
        axes.text(
            0.01,
            0.01,
            f"not shown: {failed} unstable or refused",
            fontsize=7,
            transform=axes.transAxes,
        )
    if path is not None:
        with whole_file(path) as written:
            figure.savefig(written, dpi=150)
    plt.close(figure)
    return figure
