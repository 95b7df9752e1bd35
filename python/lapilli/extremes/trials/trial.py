"""A scene at the steps it chooses itself, and what it is judged by."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

import lapilli as lp
from lapilli._core import RunError
from lapilli.extremes.steps import Outcome


@dataclass(frozen=True)
class Mark:
    """One number that a run is judged by, and the most it may be."""

    what: str
    value: float
    bar: float

    @property
    def is_kept(self) -> bool:
        """Whether it is within its bar; what is not a number is not."""
        return self.value <= self.bar


@dataclass(frozen=True)
class Trial:
    """A scene and its judge, which runs it from its start."""

    group: str
    name: str
    scene: lp.Scene
    judge: Callable[[lp.Scene], Sequence[Mark]]
    unstable: tuple[str, ...] = ()  # marks whose miss is an instability, not an inaccuracy

    def __call__(self) -> Verdict:
        """Run and judge it; an error is a verdict too."""
        start = perf_counter()
        try:
            marks = tuple(self.judge(self.scene))
        except ValueError as error:
            return Verdict(self.group, self.name, Outcome.REFUSED, reason=str(error))
        except RunError as error:
            return Verdict(self.group, self.name, Outcome.UNSTABLE, reason=str(error))
        missed = [mark for mark in marks if not mark.is_kept]
        outcome = Outcome.STABLE
        if any(mark.what in self.unstable for mark in missed):
            outcome = Outcome.UNSTABLE
        elif missed:
            outcome = Outcome.INACCURATE
        said = warnings_of(self.scene) if missed else ()
        return Verdict(self.group, self.name, outcome, marks, said, seconds=perf_counter() - start)

    def without_error(self, reason: str) -> Verdict:
        """What is said of it where its process died."""
        return Verdict(self.group, self.name, Outcome.UNSTABLE, reason=reason)


@dataclass(frozen=True)
class Verdict:
    """What came of a trial. `said`: warnings of the run, asked for where a bar was missed."""

    group: str
    name: str
    outcome: Outcome
    marks: tuple[Mark, ...] = ()
    said: tuple[str, ...] = ()
    reason: str = ""
    seconds: float = 0.0

    @property
    def is_silent(self) -> bool:
        """Whether it is wrong and does not say so: unstable, or inaccurate without a warning."""
        return self.outcome is Outcome.UNSTABLE or (
            self.outcome is Outcome.INACCURATE and not self.said
        )

    def text(self) -> str:
        """What was missed, and what the run says of it."""
        if self.reason:
            return self.reason
        missed = [one for one in self.marks if not one.is_kept]
        words = ", ".join(f"{one.what} {one.value:.3g} (at most {one.bar:.3g})" for one in missed)
        return words + "".join(f"; says: {line}" for line in self.said)


def warnings_of(scene: lp.Scene) -> tuple[str, ...]:
    """What `check` and a run say of a scene that is not quite right."""
    with tempfile.TemporaryDirectory() as folder:
        result = lp.run(scene, Path(folder) / "trial.vtkhdf", progress=False)
        return tuple(dict.fromkeys([*result.summary.notes, *result.warnings]))
