"""All cases side by side; what was found before is kept."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from lapilli.extremes.cases import Case
from lapilli.extremes.steps import Outcome, Row, measure
from lapilli.extremes.supports import SupportCase, SupportRow, measure_support
from lapilli.extremes.trials import Mark, Trial, Verdict
from lapilli.study.runner import InProcess, LocalPool, Runner, Work
from lapilli.study.store import Store, key_of

Finding = dict[str, Any]  # plain values, as kept in a file
Report = Callable[[int, int, str], None]


class Task:
    """Something to be found out once, under a name that nothing else has."""

    @property
    def name(self) -> str:
        """Unique among all tasks."""
        raise NotImplementedError

    def measured(self) -> Finding:
        """What is found."""
        raise NotImplementedError

    def lost(self, reason: str) -> Finding:
        """What is said of it where its process died."""
        raise NotImplementedError

    def __call__(self) -> Finding:
        return {"name": self.name, **self.measured()}

    def without_error(self, reason: str) -> Finding:
        return {"name": self.name, **self.lost(reason)}


@dataclass(frozen=True)
class Steps(Task):
    """A case over a range of steps."""

    case: Case
    factors: tuple[float, ...]

    @property
    def name(self) -> str:
        return f"{self.case.transfer}: {self.case.name}, {len(self.factors)} steps"

    def measured(self) -> Finding:
        return {"rows": [row_as_json(row) for row in measure(self.case, self.factors)]}

    def lost(self, reason: str) -> Finding:
        row = Row(self.case, 0.0, 1.0, Outcome.UNSTABLE, None, None, reason)
        return {"rows": [row_as_json(row)]}

    def rows(self, found: Finding) -> list[Row]:
        """As measured."""
        return [row_from_json(self.case, row) for row in found["rows"]]


@dataclass(frozen=True)
class Wall(Task):
    """A support."""

    case: SupportCase

    @property
    def name(self) -> str:
        return f"{self.case.form}: {self.case.name}"

    def measured(self) -> Finding:
        return wall_as_json(measure_support(self.case))

    def lost(self, reason: str) -> Finding:
        return wall_as_json(SupportRow(self.case, Outcome.UNSTABLE, None, 0.0, None, reason))

    def row(self, found: Finding) -> SupportRow:
        """As measured."""
        return SupportRow(
            self.case,
            Outcome(found["outcome"]),
            found["error"],
            found["bar"],
            found["condition"],
            found["reason"],
        )


@dataclass(frozen=True)
class Judged(Task):
    """A trial."""

    trial: Trial

    @property
    def name(self) -> str:
        return f"{self.trial.group}: {self.trial.name}"

    def measured(self) -> Finding:
        return verdict_as_json(self.trial())

    def lost(self, reason: str) -> Finding:
        return verdict_as_json(self.trial.without_error(reason))

    def verdict(self, found: Finding) -> Verdict:
        """As judged."""
        return Verdict(
            self.trial.group,
            self.trial.name,
            Outcome(found["outcome"]),
            tuple(Mark(**mark) for mark in found["marks"]),
            tuple(found["says"]),
            found["reason"],
            found["seconds"],
        )


def survey(
    work: Sequence[Task],
    workers: int = 1,
    kept: str | os.PathLike[str] | None = None,
    report: Report | None = None,
) -> dict[str, Finding]:
    """Do all work that the file `kept` has not got, several at once; findings by name."""
    from lapilli import __version__

    store: Store[Finding] = Store(kept, key_of("extremes", __version__), dict, dict)
    names = {one.name for one in work}
    found = {row["name"]: row for row in store.rows if row["name"] in names}
    left: list[Work[Finding]] = [one for one in work if one.name not in found]
    runner: Runner = InProcess() if workers == 1 else LocalPool(workers)
    for finding in runner.run(left):
        store.add(finding)
        found[finding["name"]] = finding
        if report is not None:
            report(len(found), len(work), finding["name"])
    return found


def row_as_json(row: Row) -> Finding:
    """Plain values."""
    return {
        "case": row.case.name,
        "transfer": row.case.transfer,
        "step": row.step,
        "over_automatic": row.factor,
        "outcome": str(row.outcome),
        "error": row.error,
        "stray": row.stray,
        "reason": row.reason,
    }


def row_from_json(case: Case, row: Finding) -> Row:
    """The row of a case."""
    return Row(
        case,
        row["step"],
        row["over_automatic"],
        Outcome(row["outcome"]),
        row["error"],
        row["stray"],
        row["reason"],
    )


def wall_as_json(row: SupportRow) -> Finding:
    """Plain values."""
    return {
        "case": row.case.name,
        "form": row.case.form,
        "bandwidth": row.case.bandwidth,
        "outcome": str(row.outcome),
        "error": row.error,
        "bar": row.bar,
        "condition": row.condition,
        "reason": row.reason,
    }


def verdict_as_json(verdict: Verdict) -> Finding:
    """Plain values."""
    return {
        "case": verdict.name,
        "group": verdict.group,
        "outcome": str(verdict.outcome),
        "marks": [{"what": one.what, "value": one.value, "bar": one.bar} for one in verdict.marks],
        "says": list(verdict.said),
        "reason": verdict.reason,
        "seconds": verdict.seconds,
    }
