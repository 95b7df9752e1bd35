"""Show how far a run has come: a bar on a terminal, a line at each tenth elsewhere."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator

from lapilli._core import Progress, progress_text, readable_time

Show = Callable[[Progress], None]


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
            print(f"{10 * tenth:3d} %  {progress_text(now)}", file=sys.stderr, flush=True)

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
            text = progress_text(now)
            if now.fraction >= 1:
                text += f", took {readable_time(now.seconds_elapsed)}"
            bar.update(task, completed=now.fraction, description=text)

        yield show
