"""The command `lapilli tradeoff`: progress, files, table and advice."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from lapilli._core import Scene
from lapilli.console import beside, print_json, say
from lapilli.study.measure import Measurement
from lapilli.study.runner import Runner
from lapilli.study.settings import parse_variation
from lapilli.study.table import Table
from lapilli.study.tradeoff import tradeoff


def show_study(
    scene: Scene,
    vary: Sequence[str],
    reference: str | None,
    *,
    name: str,
    times: str | None,
    quantities: Sequence[str],
    norm: str,
    repeats: int,
    runner: Runner,
    threads: int,
    target_error: float | None,
    budget: float | None,
    json: bool,
    quiet: bool,
) -> bool:
    """Run the study that was asked for; write its files beside each other; print it. Whether any
    setting worked."""
    table = tradeoff(
        scene,
        variations(vary),
        reference,
        times=None if times is None else times_of(times),
        quantities=quantities,
        norm=norm,
        repeats=repeats,
        threads=threads,
        runner=runner,
        store=name + ".jsonl",
        report=None if quiet else report,
        target_error=target_error,
    )
    for note in table.notes:
        say(note.line)
    table.to_csv(name + ".csv")
    table.to_json(name + ".json")
    picture = save_picture(table, name + ".png")
    if json:
        print_json([row.as_json() for row in table.rows])
    else:
        print_table(table)
    say(f"wrote {name}.csv, .json{picture}", quiet, beside(json))
    if not table.worked:
        say(f"lapilli: {table.advice()}")
        return False
    advice = table.advice(target_error, budget)
    if not table.meets(target_error, budget):
        say(f"lapilli: {advice}")
        return False
    say(advice, quiet and json, beside(json))
    return True


def variations(texts: Sequence[str]) -> dict[str, list[str]]:
    """The values of each path, from several "path=a,b"."""
    given = [parse_variation(text) for text in texts]
    if len(dict(given)) < len(given):
        raise ValueError("--vary names one path twice: give all its values at once")
    return dict(given)


def save_picture(table: Table, path: str) -> str:
    """Draw it where matplotlib is installed; what to say of it."""
    try:
        table.picture(path)
    except ValueError as error:
        return f"; no picture: {error}"
    return ", .png"


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
    say(f"[{done}/{all_of_them}] {measurement.setting}: {said}")


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
    unit = f" ({table.error_unit.strip()})" if table.error_unit else ""
    norm = table.norm.upper() if table.norm == "rms" else table.norm
    titles = (f"{norm} error{unit}", "largest")
    for title in (*titles, "CPU s", "spread", "build", "steps", "output", "wall s"):
        lines.add_column(title, justify="right", no_wrap=True)
    for title in ("steps", "points", "MB", ""):
        lines.add_column(title, justify="right", no_wrap=True)
    reasons: dict[str, int] = {}
    for row in table.rows:
        values = [value for _, value in row.setting.changes]
        if row.error is None:
            note = reasons.setdefault(row.reason, len(reasons) + 1)
            lines.add_row(*values, f"{row.status} ({note})")
            continue
        times = (row.cpu_seconds, row.cpu_spread, row.build_seconds, row.step_seconds)
        lines.add_row(
            *values,
            f"{row.error:.3g}",
            f"{row.largest:.3g}",
            *(f"{seconds or 0:.2g}" for seconds in (*times, row.output_seconds, row.wall_seconds)),
            str(row.steps),
            str(row.points),
            f"{(row.peak_memory or 0) / 1e6:.0f}",
            "*" if row.on_front else "inaccurate" if row.status == "inaccurate" else "",
        )
    console = Console(width=None if sys.stdout.isatty() else 160)
    console.print(lines)
    for reason, note in reasons.items():
        console.print(f"({note}) {reason}", highlight=False, markup=False)
