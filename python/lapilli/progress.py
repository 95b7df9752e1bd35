"""Show how far a run has come: a bar on a terminal, a line at each tenth elsewhere."""

from __future__ import annotations

import contextlib
import math
import sys
from collections.abc import Callable, Iterator

from lapilli._core import Progress

Show = Callable[[Progress], None]


def readable_time(seconds: float) -> str:
    """3.2 s, 14 min, 2 h 5 min."""
    if not math.isfinite(seconds):
        return "?"
    if seconds < 99.5:
        return f"{seconds:.1f} s" if seconds < 9.95 else f"{seconds:.0f} s"
    minutes = round(seconds / 60)
    return f"{minutes} min" if minutes < 100 else f"{minutes // 60} h {minutes % 60} min"


def state_line(now: Progress) -> str:
    """Simulated time, step and speed on one line."""
    speed = now.points * now.step / now.seconds_elapsed / 1e6 if now.seconds_elapsed > 0 else 0.0
    return f"t = {now.time:.4g} s, step {now.step}, {speed:.3g} million point-steps/s"


@contextlib.contextmanager
def progress_bar(wanted: bool = True) -> Iterator[Show | None]:
    """A function that shows progress on standard error; None when none is wanted."""
    if not wanted:
        yield None
    elif sys.stderr.isatty():
        with _terminal_bar() as show:
            yield show
    else:
        yield _plain_lines()


def _plain_lines() -> Show:
    shown = -1

    def show(now: Progress) -> None:
        nonlocal shown
        tenth = int(10 * now.fraction + 1e-9)
        if tenth > shown:
            shown = tenth
            left = "" if tenth == 10 else f", {readable_time(now.seconds_left)} left"
            print(f"{10 * tenth:3d} %  {state_line(now)}{left}", file=sys.stderr, flush=True)

    return show


@contextlib.contextmanager
def _terminal_bar() -> Iterator[Show]:
    from rich.console import Console
    from rich.progress import BarColumn, TaskProgressColumn, TextColumn
    from rich.progress import Progress as Bar

    columns = (BarColumn(), TaskProgressColumn(), TextColumn("{task.description}"))
    with Bar(*columns, console=Console(stderr=True)) as bar:
        task = bar.add_task("building the scene", total=1.0)

        def show(now: Progress) -> None:
            left = readable_time(now.seconds_left)
            took = readable_time(now.seconds_elapsed)
            end = f"{took}" if now.fraction >= 1 else f"{left} left"
            bar.update(task, completed=now.fraction, description=f"{end}  {state_line(now)}")

        yield show
