"""The command `lapilli tradeoff`: progress, files, table and advice."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from lapilli._core import Scene
from lapilli.study.measure import Measurement
from lapilli.study.runner import LocalPool
from lapilli.study.settings import parse_variation
from lapilli.study.table import Table
from lapilli.study.tradeoff import tradeoff


def show_study(scene: Scene, given: argparse.Namespace) -> bool:
    """Run the study that was asked for; write its files beside each other; print it. Whether any
    setting worked."""
    name = given.output or Path(given.scene).stem + "-tradeoff"
    vary = dict(parse_variation(text) for text in given.vary)
    if len(vary) < len(given.vary):
        raise ValueError("--vary names one path twice: give all its values at once")
    table = tradeoff(
        scene,
        vary,
        given.reference,
        times=None if given.times is None else times_of(given.times),
        field=given.field,
        repeats=given.repeats,
        threads=given.threads,
        runner=LocalPool(given.workers),
        store=name + ".jsonl",
        report=report,
    )
    for note in table.notes:
        print(note, file=sys.stderr)
    table.to_csv(name + ".csv")
    table.to_json(name + ".json")
    print_table(table)
    try:
        table.picture(name + ".png")
        print(f"wrote {name}.csv, .json, .png")
    except ValueError as error:
        print(f"wrote {name}.csv, .json; no picture: {error}")
    if not table.worked:
        print(f"lapilli: {table.advice()}", file=sys.stderr)
        return False
    print(table.advice(given.target_error, given.budget))
    return True


def times_of(text: str) -> list[float]:
    """The times of "1,2.5"."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise ValueError(f"--times {text}: expected numbers with commas between") from None


def report(measurement: Measurement, done: int, all_of_them: int) -> None:
    """One line on standard error for each run."""
    said = measurement.reason or f"error {measurement.error:.3g}"
    if measurement.cost is not None:
        said += f", {measurement.cost.total_cpu_seconds:.3g} CPU s"
    print(f"[{done}/{all_of_them}] {measurement.setting}: {said}", file=sys.stderr, flush=True)


def short_names(paths: list[str]) -> list[str]:
    """The last members of paths, as many as tell them apart."""
    parts = [path.split(".") for path in paths]
    length = 1
    while len({".".join(one[-length:]) for one in parts}) < len(set(paths)):
        length += 1
    return [".".join(one[-length:]) for one in parts]


def print_table(table: Table) -> None:
    """One line a setting, * marks the Pareto front; then why some settings have no error."""
    from rich.console import Console
    from rich.table import Table as Lines

    lines = Lines()
    for name in short_names([path for path, _ in table.rows[0].setting.changes]):
        lines.add_column(name, no_wrap=True)
    for title in ("RMS error", "largest", "CPU s", "spread", "steps", "points", "MB", ""):
        lines.add_column(title, justify="right", no_wrap=True)
    reasons: dict[str, int] = {}
    for row in table.rows:
        values = [value for _, value in row.setting.changes]
        if row.error is None:
            note = reasons.setdefault(row.reason, len(reasons) + 1)
            lines.add_row(*values, f"{row.reason.partition(':')[0]} ({note})")
            continue
        lines.add_row(
            *values,
            f"{row.error:.3g}",
            f"{row.largest:.3g}",
            f"{row.cpu_seconds:.3g}",
            f"{row.cpu_spread:.2g}",
            str(row.steps),
            str(row.points),
            f"{(row.peak_memory or 0) / 1e6:.0f}",
            "*" if row.on_front else "",
        )
    console = Console(width=None if sys.stdout.isatty() else 140)
    console.print(lines)
    for reason, note in reasons.items():
        console.print(f"({note}) {reason}", highlight=False, markup=False)
