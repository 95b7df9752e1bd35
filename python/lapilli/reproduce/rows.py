"""Rows of the tables, shorter to write."""

from __future__ import annotations

from collections.abc import Callable

from lapilli.reproduce.case import Row

Bar = tuple[str, bool]
NO_BAR: Bar = ("", True)


def rows_of(case: str) -> Callable[..., Row]:
    """A function that makes the rows of one case."""

    def row(
        setting: str,
        quantity: str,
        found: float,
        bar: Bar,
        *,
        unit: str = "",
        paper: float | None = None,
        reference: float | None = None,
    ) -> Row:
        words, ok = bar
        return Row(
            case=case,
            setting=setting,
            quantity=quantity,
            unit=unit,
            paper=paper,
            reference=reference,
            lapilli=float(found),
            bar=words,
            ok=ok,
        )

    return row


def near(value: float, other: float, most: float) -> Bar:
    """A bar on the distance between two numbers."""
    return f"within {most:g}", bool(abs(value - other) <= most)


def exactly(value: float, wanted: float) -> Bar:
    """A bar that only one number keeps."""
    return f"{wanted:g}", bool(value == wanted)


def between(value: float, low: float, high: float) -> Bar:
    """A bar on both sides."""
    return f"{low:g} to {high:g}", bool(low <= value <= high)


def at_least(value: float, least: float) -> Bar:
    """A bar from below."""
    return f">= {least:g}", bool(value >= least)


def below(value: float, most: float) -> Bar:
    """A bar from above, sign and all."""
    return f"<= {most:g}", bool(value <= most)
