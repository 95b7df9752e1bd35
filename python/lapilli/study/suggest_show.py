"""The command `lapilli suggest`: what it prints and draws."""

from __future__ import annotations

import math
import os
import re
import shlex
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from lapilli._core import readable_time
from lapilli.plot import require_matplotlib
from lapilli.study.suggest import Suggestion
from lapilli.whole_file import whole_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure

UNITS = {"": 1.0, "s": 1.0, "min": 60.0, "h": 3600.0}


def seconds_of(text: str) -> float:
    """The seconds of "90", "90s", "10min" or "2h"."""
    found = re.fullmatch(r"([0-9.eE+-]+)\s*(s|min|h|)", text.strip())
    try:
        if found is None:
            raise ValueError
        return float(found[1]) * UNITS[found[2]]
    except ValueError:
        raise ValueError(f"a time is a number with s, min or h, got {text!r}") from None


def text_of(found: Suggestion, scene_file: str, changes: Sequence[str] = ()) -> str:
    """The suggestion in a few lines: the command that runs it with the changes that were asked
    for, the error, the cost."""
    if found.grade is None:
        return found.reason
    grade = found.grade
    own = [f"{path}={value}" for path, value in grade.rung.setting.changes]
    words = " ".join(f"--set {shlex.quote(change)}" for change in (*changes, *own))
    high = f"{grade.high:.2g}" if math.isfinite(grade.high) else "unknown"
    cost = "measured" if found.was_run else "predicted, without output"
    return "\n".join(
        [
            f"lapilli run {shlex.quote(scene_file)} {words}",
            f"{found.judge.norm} error of {found.judge.name}{unit_of(found)}: {grade.error:.2g} "
            f"({grade.low:.2g} to {high}, {grade.how}); target {found.target:g}",
            f"{duration(found.cpu_seconds)} of processor time, "
            f"{duration(found.wall_seconds)} of wall time, "
            f"{found.memory / 1e6:.0f} MB ({cost})",
            f"found in {duration(found.spent)} of processor time",
        ]
    )


def duration(seconds: float) -> str:
    """A time, with two digits below a second."""
    return readable_time(seconds) if seconds >= 1 else f"{seconds:.2g} s"


def as_json(found: Suggestion) -> dict[str, Any]:
    """Plain values."""
    grade = found.grade
    return {
        "target": found.target,
        "quantity": found.judge.name,
        "norm": found.judge.norm,
        "setting": None if grade is None else dict(grade.rung.setting.changes),
        "error": None if grade is None else grade.error,
        "error_low": None if grade is None else grade.low,
        "error_high": None if grade is None else grade.high,
        "how": found.reason if grade is None else grade.how,
        "cpu_seconds": found.cpu_seconds,
        "wall_seconds": found.wall_seconds,
        "memory": found.memory,
        "was_run": found.was_run,
        "spent_cpu_seconds": found.spent,
        "runs": [
            {
                "setting": dict(one.rung.setting.changes),
                "error": one.error,
                "cpu_seconds": one.rung.effort,
            }
            for one in (*found.ladder.graded(), *found.tried)
        ],
    }


def unit_of(found: Suggestion) -> str:
    """The unit of the error in brackets; none of a relative one."""
    seen = found.ladder.rungs[-1].seen
    unit = "" if seen is None or found.judge.norm == "relative" else seen.units[found.judge.name]
    return f" ({unit})" if unit else ""


def star_of(found: Suggestion) -> float:
    """Cost of the suggestion as the runs count it."""
    rung = None if found.grade is None else found.grade.rung
    return found.cpu_seconds if rung is None or rung.seen is None else rung.effort


def draw(found: Suggestion, path: str | os.PathLike[str] | None = None) -> Figure:
    """Error against cost of all runs, the target, and what is suggested."""
    require_matplotlib()
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.4, 4.8), layout="constrained")
    ladder = [(one.rung.effort, max(one.error, 1e-16), one.rung.cell)
              for one in found.ladder.graded()]  # fmt: skip
    if ladder:
        cost, error = zip(*((x, y) for x, y, _ in ladder), strict=True)
        axes.plot(cost, error, "o-", label="as in the scene, twice as fine each")
        for x, y, cell in ladder:
            note = f"{cell:.3g} m"
            axes.annotate(note, (x, y), xytext=(4, 4), textcoords="offset points", fontsize=7)
    others = [(one.rung.effort, max(one.error, 1e-16)) for one in found.tried]
    if others:
        axes.plot(*zip(*others, strict=True), "x", color="0.5", label="other settings tried")
    if found.grade is not None:
        axes.plot(
            star_of(found), max(found.grade.error, 1e-16), "*", ms=14, color="C3",
            label="suggested" + ("" if found.was_run else " (predicted)"),
        )  # fmt: skip
    axes.axhline(found.target, color="C2", ls="--", lw=1, label="target")
    axes.set(
        xscale="log", yscale="log", xlabel="CPU time (s) of building and stepping",
        ylabel=f"{found.judge.norm} error of {found.judge.name}{unit_of(found)}",
    )  # fmt: skip
    axes.grid(which="both", alpha=0.2)
    axes.legend(fontsize=8)
    if path is not None:
        with whole_file(path) as written:
            figure.savefig(written, dpi=150)
    plt.close(figure)
    return figure
