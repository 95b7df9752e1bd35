"""The command `lapilli study`: progress, files, table."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from pathlib import Path

from lapilli.console import beside, print_json, say
from lapilli.study.results import Results
from lapilli.study.show import short_names
from lapilli.study.survey import Outcome

MOST_LINES, MOST_COLUMNS = 40, 6


def report(outcome: Outcome, done: int, all_of_them: int) -> None:
    """One line on standard error for each case."""
    shown = list(outcome.numbers.items())[:3]
    said = outcome.reason or ", ".join(f"{name} {value:.4g}" for name, value in shown)
    say(f"[{done}/{all_of_them}] {outcome.setting}: {said}")


def write(results: Results, name: str, parquet: bool) -> list[str]:
    """The table as CSV (and Parquet), and pictures where they can be drawn; what was written."""
    results.to_csv(name + ".csv")
    written = [name + ".csv"]
    if parquet:
        results.to_parquet(name + ".parquet")
        written.append(name + ".parquet")
    if results.finished and results.quantities:
        from lapilli.study import effects

        try:
            written += [str(path) for path in effects.draw(results, name)]
        except ValueError as error:
            say(f"no pictures: {error}")
    return written


def show(
    results: Results, written: Sequence[str], goal: str | None, json: bool, quiet: bool
) -> bool:
    """Print the table, where it lies and what was best; whether any case finished."""
    for note in results.notes:
        say(note.line)
    if json:
        print_json(results.rows())
    elif not quiet:
        print_table(results)
    say(f"wrote {', '.join(str(Path(path)) for path in written)}", quiet, beside(json))
    if not results.finished:
        say("lapilli: no case finished: " + "; ".join(results.reasons))
        return False
    if goal is not None:
        best = results.best(goal)
        say(f"smallest {goal}: {best.numbers[goal]:.6g} with {best.setting}", False, beside(json))
    return True


def print_table(results: Results) -> None:
    """One line a case, the first of many; then why cases failed."""
    from rich.console import Console
    from rich.table import Table as Lines

    lines = Lines()
    shown = results.quantities[:MOST_COLUMNS]
    for name in short_names(results.paths):
        lines.add_column(name, no_wrap=True)
    for name in (*shown, "CPU s", ""):
        lines.add_column(name, justify="right", overflow="fold")
    for row in results.rows()[:MOST_LINES]:
        numbers = (row[name] for name in shown)
        lines.add_row(
            *("" if row[path] is None else str(row[path]) for path in results.paths),
            *("" if math.isnan(number) else f"{number:.5g}" for number in numbers),
            "" if row["cpu_seconds"] is None else f"{row['cpu_seconds']:.3g}",
            "" if row["status"] == "finished" else row["status"],
        )
    console = Console(width=None if sys.stdout.isatty() else 160)
    console.print(lines)
    hidden = len(results) - MOST_LINES
    if hidden > 0:
        console.print(f"and {hidden} more cases")
    for reason in results.reasons[:10]:
        count = sum(one.reason == reason for one in results.failed)
        console.print(f"{count} x {reason}", highlight=False, markup=False)
