"""The command `lapilli reproduce`: a table, JSON rows, figures."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from rich.console import Console
from rich.table import Table

from lapilli._core import readable_time
from lapilli.console import beside, print_json, say
from lapilli.reproduce import cases
from lapilli.reproduce.case import Row
from lapilli.whole_file import write_text


def show_cases(
    wanted: Sequence[str],
    list_only: bool = False,
    quick: bool = False,
    json_file: str | None = None,
    plot_folder: str | None = None,
    quiet: bool = False,
) -> bool:
    """Run cases and print them; whether every bar is kept. `json_file` "-": JSON, no tables."""
    names = cases.names(wanted)
    if list_only and json_file == "-":
        print_json([{"name": name, "title": cases.load(name).title} for name in names])
        return True
    rows: list[Row] = []
    for name in names:
        case = cases.load(name)
        if list_only:
            print(f"{name:20s} {case.title}")
            continue
        say(f"{name}: {case.title}", quiet)
        started = time.perf_counter()
        found = case.run(quick)
        if json_file != "-":
            print_rows(name, found, time.perf_counter() - started)
        rows += found
        if plot_folder is not None and case.plot is not None:
            Path(plot_folder).mkdir(parents=True, exist_ok=True)
            for picture in case.plot(Path(plot_folder), quick):
                say(f"wrote {picture}", quiet, beside(json_file == "-"))
        if json_file is not None and json_file != "-":
            write_text(json_file, json.dumps([asdict(row) for row in rows], indent=1) + "\n")
    if json_file == "-":
        print_json([asdict(row) for row in rows])
    return all(row.ok for row in rows)


def print_rows(name: str, rows: Sequence[Row], seconds: float) -> None:
    """Paper, reference and lapilli side by side."""
    table = Table(title=f"{name} ({readable_time(seconds)})", title_justify="left")
    for title in ("setting", "quantity"):
        table.add_column(title, overflow="fold")
    for title in ("paper", "reference", "lapilli", "bar", ""):
        table.add_column(title, justify="right")
    for row in rows:
        unit = f" ({row.unit})" if row.unit else ""
        table.add_row(
            row.setting,
            row.quantity + unit,
            text(row.paper),
            text(row.reference),
            text(row.lapilli),
            row.bar,
            verdict(row),
            style=None if row.ok else "bold red",
        )
    console = Console(width=None if sys.stdout.isatty() else 140)
    console.print(table)


def verdict(row: Row) -> str:
    """Whether a row keeps its bar; it is reported where it has none."""
    if not row.ok:
        return "MISSED"
    return "ok" if row.bar and not row.bar.startswith("none") else "reported"


def text(value: float | None) -> str:
    """Four digits; nothing where there is no number."""
    return "" if value is None else f"{value:.4g}"
