"""What a study measured, as a table: median and spread, the Pareto front, advice."""

from __future__ import annotations

import csv
import json
import os
import statistics
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import TYPE_CHECKING, Any

from lapilli.note import Note
from lapilli.study.measure import Errors, Measurement
from lapilli.study.settings import Setting
from lapilli.whole_file import whole_file, write_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Row:
    """One setting. Without an error, `reason` says why."""

    setting: Setting
    error: float | None
    largest: float | None
    cpu_seconds: float | None  # building, stepping and output, median over the repeats
    cpu_spread: float | None  # slowest minus fastest
    steps: int | None
    points: int | None
    peak_memory: int | None  # bytes, median
    repeats: int
    on_front: bool
    reason: str
    status: str = "measured"  # or inaccurate, unstable, failed, refused
    build_seconds: float | None = None  # CPU, medians
    step_seconds: float | None = None
    output_seconds: float | None = None
    wall_seconds: float | None = None  # all three
    wall_spread: float | None = None
    errors: Errors = field(default_factory=dict)  # of every quantity in every norm

    def as_json(self) -> dict[str, Any]:
        """Plain values, one key for each varied setting, and for each quantity and norm."""
        rest = {
            key: value for key, value in asdict(self).items() if key not in {"setting", "errors"}
        }
        flat = {
            f"{norm} error of {name}": value
            for name, norms in self.errors.items()
            for norm, value in norms.items()
        }
        return {**dict(self.setting.changes), **rest, **flat}


class Table:
    """One row a setting, in the order in which settings were given."""

    def __init__(
        self, rows: Sequence[Row], field: str, unit: str = "", notes: Sequence[Note] = ()
    ) -> None:
        self.rows = list(rows)
        self.field = field
        self.unit = unit
        self.notes = list(notes)  # settings that were changed to fit, what errors are against
        self.norm = "rms"

    def __repr__(self) -> str:
        return f"<{len(self.rows)} settings, {len(self.front)} on the front; {self.advice()}>"

    def _repr_html_(self) -> str:
        from lapilli.html import study_as_html

        return study_as_html(self)

    @property
    def worked(self) -> bool:
        """Whether any setting has an error to show."""
        return any(row.error is not None for row in self.rows)

    @property
    def reasons(self) -> list[str]:
        """Why settings have no error, each reason once."""
        return list(dict.fromkeys(row.reason for row in self.rows if row.error is None))

    @classmethod
    def of(
        cls,
        settings: Sequence[Setting],
        measurements: Iterable[Measurement],
        field: str,
        unit: str,
        notes: Sequence[Note] = (),
    ) -> Table:
        """Gather the repeats of each setting."""
        found: dict[Setting, list[Measurement]] = {setting: [] for setting in settings}
        for measurement in measurements:
            found.setdefault(measurement.setting, []).append(measurement)
        rows = [row_of(setting, repeats) for setting, repeats in found.items() if repeats]
        return cls(with_front(rows), field, unit, notes)

    @property
    def front(self) -> list[Row]:
        """The settings that no other beats in both error and cost, cheapest first."""
        return sorted((row for row in self.rows if row.on_front), key=cost_of)

    def judged(self, target_error: float | None, norm: str = "rms") -> Table:
        """The table with settings called inaccurate: those beyond the target; without one, those
        further from the reference than its own mean is."""

        def is_inaccurate(row: Row) -> bool:
            if target_error is None:
                return row.errors.get(self.field, {}).get("relative", 0.0) > 1
            return row.error is not None and row.error > target_error

        rows = [
            replace(row, status="inaccurate") if is_inaccurate(row) else row for row in self.rows
        ]
        table = Table(rows, self.field, self.unit, self.notes)
        table.norm = norm
        return table

    def meets(self, target_error: float | None = None, budget: float | None = None) -> bool:
        """Whether some setting is within the error, or without one within the cost."""
        if target_error is not None:
            return any(error_of(row) <= target_error for row in self.front)
        return budget is None or any(cost_of(row) <= budget for row in self.front)

    @property
    def error_unit(self) -> str:
        """The unit of errors with a blank before it; empty where they are shares."""
        return "" if self.norm == "relative" or not self.unit else f" {self.unit}"

    def advice(self, target_error: float | None = None, budget: float | None = None) -> str:
        """The cheapest setting within an error, or the most accurate within a cost (CPU s)."""
        if not self.worked:
            return "no setting worked: " + "; ".join(self.reasons)
        if target_error is not None:
            good = [row for row in self.front if error_of(row) <= target_error]
            if good:
                return f"cheapest within {target_error:g}{self.error_unit}: {self.said(good[0])}"
            best = self.said(self.front[-1])
            return (
                f"no setting tried has an error within {target_error:g}{self.error_unit}; "
                f"the best is {best}"
            )
        if budget is not None:
            paid = [row for row in self.front if cost_of(row) <= budget]
            if paid:
                return f"most accurate within {budget:g} CPU s: {self.said(paid[-1])}"
            least = self.said(self.front[0])
            return f"no setting tried costs at most {budget:g} CPU s; the cheapest is {least}"
        return f"most accurate: {self.said(self.front[-1])}"

    def said(self, row: Row) -> str:
        """A row in one line of advice."""
        error = f"{error_of(row):.3g}{self.error_unit}"
        return f"{row.setting} (error {error}, {cost_of(row):.3g} CPU s)"

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """One line a setting."""
        rows = [row.as_json() for row in self.rows]
        names = list(dict.fromkeys(name for row in rows for name in row))
        with whole_file(path) as written, written.open("w", newline="") as file:
            writer = csv.DictWriter(file, names)
            writer.writeheader()
            writer.writerows(rows)

    def to_json(self, path: str | os.PathLike[str]) -> None:
        """A list of rows."""
        write_text(path, json.dumps([row.as_json() for row in self.rows], indent=1) + "\n")

    def picture(self, path: str | os.PathLike[str] | None = None) -> Figure:
        """Error against cost with the Pareto front, log-log."""
        from lapilli.study.picture import draw

        return draw(self, path)


def row_of(setting: Setting, repeats: Sequence[Measurement]) -> Row:
    """Median and spread of one setting."""
    failed = next((m for m in repeats if m.error is None), None)
    costs = [m.cost for m in repeats if m.cost is not None]
    last = failed or repeats[-1]
    cpu = [cost.total_cpu_seconds for cost in costs]
    wall = [cost.total_wall_seconds for cost in costs]
    memory = median(float(cost.peak_memory) for cost in costs)
    return Row(
        setting,
        last.error,
        last.largest,
        median(cpu),
        max(cpu) - min(cpu) if cpu else None,
        costs[-1].steps if costs else None,
        costs[-1].points if costs else None,
        None if memory is None else int(memory),
        len(repeats),
        False,
        last.reason,
        last.status,
        median(cost.build_seconds for cost in costs),
        median(cost.cpu_seconds for cost in costs),
        median(cost.output_seconds for cost in costs),
        median(wall),
        max(wall) - min(wall) if wall else None,
        last.errors,
    )


def median(values: Iterable[float]) -> float | None:
    """The median; None of nothing."""
    known = list(values)
    return statistics.median(known) if known else None


def with_front(rows: Sequence[Row]) -> list[Row]:
    """Mark the rows that no other row beats in both error and cost."""
    best = float("inf")
    on_front = set()
    for row in sorted(
        (r for r in rows if r.error is not None), key=lambda r: (cost_of(r), r.error)
    ):
        if error_of(row) < best:
            best = error_of(row)
            on_front.add(row.setting)
    return [replace(row, on_front=row.setting in on_front) for row in rows]


def error_of(row: Row) -> float:
    """The error; infinite where there is none."""
    return float("inf") if row.error is None else row.error


def cost_of(row: Row) -> float:
    """CPU seconds; infinite where unknown."""
    return float("inf") if row.cpu_seconds is None else row.cpu_seconds
