"""The command `lapilli extremes`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from lapilli.console import beside, finite, print_json, say
from lapilli.extremes.cases import TRANSFERS, all_cases
from lapilli.extremes.picture import draw, print_map
from lapilli.extremes.steps import FACTORS, Outcome, Row, measure
from lapilli.extremes.supports import (
    SupportRow,
    is_astray,
    measure_support,
    print_supports,
    support_cases,
)
from lapilli.whole_file import write_text


def show_extremes(
    wanted: Sequence[str],
    quick: bool,
    json_file: str | None,
    plot_folder: str | None,
    quiet: bool = False,
) -> bool:
    """Try every case; print, write and draw the map. Whether all automatic steps are stable, and
    all walls accurate."""
    transfers = tuple(wanted or TRANSFERS)
    cases = list(all_cases(transfers))
    factors = tuple(f for f in FACTORS if not quick or f in (0.5, 1.0, 1.41, 2.0))
    rows: list[Row] = []
    for number, case in enumerate(cases, 1):
        say(f"[{number}/{len(cases)}] {case.transfer}: {case.name}", quiet)
        rows.extend(measure(case, factors))
    walls = [] if wanted else [measure_support(case) for case in support_cases()]
    found = [as_json(row) for row in rows] + [wall_as_json(row) for row in walls]
    words = beside(json_file == "-")
    if json_file == "-":
        print_json(found)
    else:
        print_map(rows)
        if walls:
            print_supports(walls)
    if json_file is not None and json_file != "-":
        Path(json_file).parent.mkdir(parents=True, exist_ok=True)
        write_text(json_file, json.dumps(finite(found), indent=1) + "\n")
    if plot_folder is not None:
        folder = Path(plot_folder)
        folder.mkdir(parents=True, exist_ok=True)
        draw(rows, folder / "extremes.png")
        say(f"wrote {folder / 'extremes.png'}", quiet, words)
    bad = [row for row in rows if row.factor <= 1.0 and row.outcome is Outcome.UNSTABLE]
    for row in bad:
        say(
            f"unstable at {row.factor:g} of the automatic step: {row.case.transfer}, "
            f"{row.case.name}: {row.reason or f'strays {row.stray:.3g}'}",
            file=words,
        )
    astray = [row for row in walls if is_astray(row)]
    for wall in astray:
        error = wall.reason or f"error {wall.error:.3g}, bar {wall.bar:.3g}"
        say(f"{wall.outcome}: {wall.case.form}, {wall.case.name}: {error}", file=words)
    return not bad and not astray


def wall_as_json(row: SupportRow) -> dict[str, str | float | None]:
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


def as_json(row: Row) -> dict[str, str | float | None]:
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
