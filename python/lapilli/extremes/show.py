"""The command `lapilli extremes`."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

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


def show_extremes(given: argparse.Namespace) -> bool:
    """Try every case; print, write and draw the map. Whether all automatic steps are stable, and
    all walls accurate."""
    transfers = tuple(given.transfer or TRANSFERS)
    cases = list(all_cases(transfers))
    factors = tuple(f for f in FACTORS if not given.quick or f in (0.5, 1.0, 1.41, 2.0))
    rows: list[Row] = []
    for number, case in enumerate(cases, 1):
        print(f"[{number}/{len(cases)}] {case.transfer}: {case.name}", file=sys.stderr, flush=True)
        rows.extend(measure(case, factors))
    print_map(rows)
    walls: list[SupportRow] = []
    if not given.transfer:
        walls = [measure_support(case) for case in support_cases()]
        print_supports(walls)
    if given.json:
        found = [as_json(row) for row in rows] + [wall_as_json(row) for row in walls]
        Path(given.json).parent.mkdir(parents=True, exist_ok=True)
        write_text(given.json, json.dumps(found, indent=1) + "\n")
    if given.plot:
        folder = Path(given.plot)
        folder.mkdir(parents=True, exist_ok=True)
        draw(rows, folder / "extremes.png")
        print(f"wrote {folder / 'extremes.png'}")
    bad = [row for row in rows if row.factor <= 1.0 and row.outcome is Outcome.UNSTABLE]
    for row in bad:
        print(
            f"unstable at {row.factor:g} of the automatic step: {row.case.transfer}, "
            f"{row.case.name}: {row.reason or f'strays {row.stray:.3g}'}"
        )
    astray = [row for row in walls if is_astray(row)]
    for wall in astray:
        error = wall.reason or f"error {wall.error:.3g}, bar {wall.bar:.3g}"
        print(f"{wall.outcome}: {wall.case.form}, {wall.case.name}: {error}")
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
