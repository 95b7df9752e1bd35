"""What a reproduced case is: rows of numbers with bars, and figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from lapilli import examples
from lapilli._core import Scene


@dataclass(frozen=True, kw_only=True)
class Row:
    """One number of a paper beside ours. `bar` says in words what is asked for."""

    case: str
    setting: str
    quantity: str
    unit: str
    paper: float | None
    reference: float | None
    lapilli: float
    bar: str
    ok: bool


@dataclass(frozen=True, kw_only=True)
class Case:
    """A case of a paper: `run(quick)` computes rows, `plot(folder, quick)` draws figures."""

    name: str  # "vhfm/ring"
    title: str
    run: Callable[[bool], list[Row]]
    plot: Callable[[Path, bool], list[Path]] | None = None


def within(value: float, bar: float) -> tuple[str, bool]:
    """A bar on an error: ("<= 0.01", whether the value keeps it)."""
    return f"<= {bar:g}", bool(abs(value) <= bar)


def quotient_within(value: float, reference: float, share: float) -> tuple[str, bool]:
    """A bar on a number near a reference: ("within 0.5 %", whether it is kept)."""
    return f"within {100 * share:g} %", bool(abs(value - reference) <= share * abs(reference))


def example(name: str) -> Scene:
    """A scene of the examples that come with the package."""
    return examples.load(name)
