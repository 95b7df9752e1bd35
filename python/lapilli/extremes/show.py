"""The command `lapilli extremes`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from lapilli.console import beside, finite, print_json, say
from lapilli.extremes.cases import TRANSFERS, all_cases
from lapilli.extremes.picture import draw, draw_trials, print_map, print_trials
from lapilli.extremes.steps import FACTORS, Outcome, Row
from lapilli.extremes.supports import SupportRow, is_astray, print_supports, support_cases
from lapilli.extremes.survey import Judged, Steps, Wall, survey
from lapilli.extremes.trials import Verdict, all_trials
from lapilli.whole_file import write_text

QUICK_FACTORS = (0.5, 1.0, 1.41, 2.0)


def show_extremes(
    wanted: Sequence[str],
    quick: bool = False,
    workers: int = 1,
    kept: str | None = None,
    json_file: str | None = None,
    plot_folder: str | None = None,
    quiet: bool = False,
) -> bool:
    """Try every case; print, write and draw the map. Whether all automatic steps are stable, all
    walls accurate, and no trial is wrong without saying so."""
    factors = tuple(f for f in FACTORS if not quick or f in QUICK_FACTORS)
    transfers = tuple(one for one in TRANSFERS if not wanted or one in wanted)
    steps = [Steps(case, factors) for case in all_cases(transfers)]
    walls = [Wall(case) for case in support_cases() if not wanted or "supports" in wanted]
    trials = [Judged(one) for one in all_trials() if not wanted or one.group in wanted]

    def report(done: int, among: int, name: str) -> None:
        say(f"[{done}/{among}] {name}", quiet)

    found = survey([*steps, *walls, *trials], workers, kept, report)
    words = beside(json_file == "-")
    rows = [row for one in steps for row in one.rows(found[one.name])]
    held = [one.row(found[one.name]) for one in walls]
    verdicts = [one.verdict(found[one.name]) for one in trials]
    plain = [row for one in steps for row in found[one.name]["rows"]]
    plain += [found[one.name] for one in walls]
    plain += [found[one.name] for one in trials]
    if json_file == "-":
        print_json(plain)
    else:
        if rows:
            print_map(rows)
        if held:
            print_supports(held)
        if verdicts:
            print_trials(verdicts)
    if json_file is not None and json_file != "-":
        Path(json_file).parent.mkdir(parents=True, exist_ok=True)
        write_text(json_file, json.dumps(finite(plain), indent=1) + "\n")
    if plot_folder is not None:
        folder = Path(plot_folder)
        folder.mkdir(parents=True, exist_ok=True)
        if rows:
            draw(rows, folder / "extremes.png")
        if verdicts:
            draw_trials(verdicts, folder / "extremes_trials.png")
        say(f"wrote {folder}", quiet, words)
    wrong = [*bad_steps(rows), *bad_walls(held), *bad_trials(verdicts)]
    for line in wrong:
        say(line, file=words)
    return not wrong


def bad_steps(rows: Sequence[Row]) -> list[str]:
    """Steps up to the automatic one that are unstable."""
    return [
        f"unstable at {row.factor:g} of the automatic step: {row.case.transfer}, "
        f"{row.case.name}: {row.reason or f'strays {row.stray:.3g}'}"
        for row in rows
        if row.factor <= 1.0 and row.outcome is Outcome.UNSTABLE
    ]


def bad_walls(walls: Sequence[SupportRow]) -> list[str]:
    """Supports that are worse than they should be."""
    return [
        f"{row.outcome}: {row.case.form}, {row.case.name}: "
        + (row.reason or f"error {row.error:.3g}, bar {row.bar:.3g}")
        for row in walls
        if is_astray(row)
    ]


def bad_trials(verdicts: Sequence[Verdict]) -> list[str]:
    """Trials that are unstable, or inaccurate without a warning."""
    return [
        f"{one.outcome}: {one.group}, {one.name}: {one.text()}" for one in verdicts if one.is_silent
    ]
