"""Runs of one scene from coarse to fine, and what may be concluded from their differences."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from lapilli._core import Scene
from lapilli.study.cost import Cost
from lapilli.study.failure import FAILURES, reason_of
from lapilli.study.norms import field_errors, scalar_errors
from lapilli.study.observe import Observation, observe
from lapilli.study.reference import PointsReference
from lapilli.study.settings import Setting

DESIGN_ORDER = 2.0  # of every method in the cell
FALLS = (1.5, 2.6)  # orders between successive differences at which they fall as they should
UNCERTAIN = 2.0  # factor either way of an error that was extrapolated


@dataclass(frozen=True)
class Rung:
    """One run: how fine it was, what was seen, what it took. `reason` says why it failed."""

    setting: Setting
    cell: float
    seen: Observation | None = None
    reason: str = ""

    @property
    def cost(self) -> Cost:
        """What it takes; its output where that was measured."""
        assert self.seen is not None
        return self.seen.cost

    @property
    def effort(self) -> float:
        """CPU seconds that it took here: its output was not written."""
        return self.cost.build_seconds + self.cost.cpu_seconds


@dataclass(frozen=True)
class Climb:
    """One run to do; everything a worker process needs."""

    scene: Scene
    setting: Setting
    cell: float
    fields: tuple[str, ...]
    times: tuple[float, ...]
    threads: int = 1
    output_cost: bool = False

    def __call__(self) -> Rung:
        """Run; a setting that does not work is a result."""
        try:
            seen = observe(
                self.setting.apply(self.scene),
                self.times,
                self.fields,
                threads=self.threads,
                output_cost=self.output_cost,
            )
        except FAILURES as error:
            return self.without_error(reason_of(error))
        return Rung(self.setting, self.cell, seen)

    def without_error(self, reason: str) -> Rung:
        """A run that did not work."""
        return Rung(self.setting, self.cell, None, reason)


@dataclass(frozen=True)
class Judge:
    """Differences between runs in one quantity and norm."""

    name: str
    is_field: bool
    times: tuple[float, ...]
    norm: str = "rms"

    def difference(self, coarse: Rung, fine: Rung) -> float:
        """How far a run is from a finer one; infinite where it is no number."""
        assert coarse.seen is not None
        assert fine.seen is not None
        if not self.is_field:
            values, truths = (
                [seen.scalar(self.name, time) for time in self.times]
                for seen in (coarse.seen, fine.seen)
            )
            found = scalar_errors(values, truths)[self.norm]
        else:
            truth = PointsReference(
                np.array([one.time for one in fine.seen.snapshots]),
                [one.position for one in fine.seen.snapshots],
                [one.fields[self.name] for one in fine.seen.snapshots],
            )
            shots = coarse.seen.snapshots
            found = field_errors(
                [one.fields[self.name] for one in shots],
                [np.asarray(truth(one.position, one.time)) for one in shots],
                [one.volume for one in shots],
            )[self.norm]
        return found if math.isfinite(found) else math.inf


@dataclass(frozen=True)
class Grade:
    """The error of a setting as far as other runs tell it."""

    rung: Rung
    error: float
    low: float
    high: float
    how: str


@dataclass
class Ladder:
    """Rungs that worked, coarse to fine, each half of the cell of the one before."""

    judge: Judge
    rungs: list[Rung] = field(default_factory=list)
    _known: dict[tuple[int, int], float] = field(default_factory=dict, repr=False)

    def difference(self, coarse: Rung, fine: Rung) -> float:
        """How far a run is from a finer one, found once."""
        key = (id(coarse), id(fine))
        if key not in self._known:
            self._known[key] = self.judge.difference(coarse, fine)
        return self._known[key]

    def graded(self) -> list[Grade]:
        """Every rung but the finest, judged by the finest: with design order p, a cell m halvings
        coarser errs by its difference over 1 - 2^(-pm); over 1 - 2^(-m) at first order."""
        if len(self.rungs) < 2:
            return []
        return [self.grade(rung) for rung in self.rungs[:-1]]

    def grade(self, rung: Rung) -> Grade:
        """A rung judged by the finest."""
        difference = self.difference(rung, self.rungs[-1])
        ratio = rung.cell / self.rungs[-1].cell
        error = difference / (1 - ratio ** -self.order())
        return Grade(
            rung,
            error,
            difference / UNCERTAIN**0.5,
            difference / (1 - 1 / ratio),
            "against a finer run",
        )

    def grade_other(self, rung: Rung) -> Grade:
        """A run with other settings judged by the finest rung, whose own error may add to the
        difference or hide in it."""
        difference, last = self.difference(rung, self.rungs[-1]), self.steps()[-1]
        own = last / (2 ** self.order() - 1)
        error = math.hypot(difference, own)
        low = min(max(0.0, difference - last), error / UNCERTAIN**0.5)
        return Grade(rung, error, low, difference + last, "against a finer run")

    def order(self) -> float:
        """The design order; 1 where the last two differences say that it is no more."""
        last = self.orders()[-2:]
        return 1.0 if len(last) == 2 and all(one < FALLS[0] for one in last) else DESIGN_ORDER

    def steps(self) -> list[float]:
        """Differences of successive rungs."""
        pairs = itertools.pairwise(self.rungs)
        return [self.difference(coarse, fine) for coarse, fine in pairs]

    def orders(self) -> list[float]:
        """Orders at which successive differences fall with the cell."""
        d = self.steps()
        falls = zip(itertools.pairwise(d), itertools.pairwise(self.rungs), strict=False)
        return [
            math.log(a / b) / math.log(coarse.cell / fine.cell)
            if 0 < b < math.inf and 0 < a < math.inf
            else math.nan
            for (a, b), (coarse, fine) in falls
        ]

    def falls_as_it_should(self) -> bool:
        """Whether the last two orders are near the design order: then, and only then, errors may
        be extrapolated."""
        orders = self.orders()
        return len(orders) >= 2 and all(FALLS[0] <= one <= FALLS[1] for one in orders[-2:])

    def finest_error(self) -> float:
        """The error of the finest rung by the design order."""
        return self.steps()[-1] / (2**DESIGN_ORDER - 1)

    def growth(self, what: str) -> float:
        """By how much a cost grows from a rung to the next: that of the last two; without two,
        that of an explicit scheme."""
        if len(self.rungs) < 2:
            return 2.0 ** (dimension_of(self.rungs) + 2)
        costs: Sequence[Any] = [
            rung.effort if what == "effort" else getattr(rung.cost, what)
            for rung in self.rungs[-2:]
        ]
        grown = float(costs[1]) / max(float(costs[0]), 1e-12)
        most: float = 2.0 ** (dimension_of(self.rungs) + 2.5)
        return min(max(grown, 2.0), most)


def dimension_of(rungs: Sequence[Rung]) -> int:
    """Of space; that of a plane for no rung."""
    for rung in rungs[-1:]:
        assert rung.seen is not None
        return int(rung.seen.snapshots[0].position.shape[1])
    return 2
