"""Show how far a run has come: a bar on a terminal or in a notebook, else a line a tenth."""

from __future__ import annotations

import contextlib
import html
import sys
from collections.abc import Callable, Iterator
from typing import Any

from lapilli._core import Progress, progress_text, readable_time
from lapilli.extras import required

Show = Callable[[Progress], None]


@contextlib.contextmanager
def progress_bar(wanted: bool = True) -> Iterator[Show | None]:
    """A function that shows progress; None when none is wanted or nothing can be said."""
    if not wanted:
        yield None
    elif _in_notebook():
        yield _notebook_bar()
    elif sys.stderr is None or sys.stderr.closed:
        yield None
    elif sys.stderr.isatty():
        with _terminal_bar() as show:
            yield _until_unheard(show)
    else:
        yield _until_unheard(_plain_lines())


def _until_unheard(show: Show) -> Show:
    """The same, silent once it cannot be written: a run does not end for want of a log."""
    heard = True

    def tell(now: Progress) -> None:
        nonlocal heard
        if heard:
            try:
                show(now)
            except (OSError, ValueError):
                heard = False

    return tell


def _text(now: Progress) -> str:
    text = progress_text(now)
    return text + f", took {readable_time(now.seconds_elapsed)}" if now.fraction >= 1 else text


def _plain_lines() -> Show:
    shown = -1

    def show(now: Progress) -> None:
        nonlocal shown
        tenth = int(10 * now.fraction + 1e-9)
        if tenth > shown:
            shown = tenth
            print(f"{10 * tenth:3d} %  {progress_text(now)}", file=sys.stderr, flush=True)

    return show


def _in_notebook() -> bool:
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and getattr(shell, "kernel", None) is not None


def _notebook_bar() -> Show:
    """One output that is rewritten. (The bar of rich needs ipywidgets in notebooks, and shows
    nothing in a saved one.)"""
    ipython: Any = required("IPython.display", "progress in a notebook")
    make, display = ipython.HTML, ipython.display
    shown = display(make("building the scene"), display_id=True)

    def show(now: Progress) -> None:
        bar = f'<progress value="{now.fraction:.4f}" max="1" style="width:20em"></progress>'
        shown.update(make(f"{bar} {100 * now.fraction:.0f} % {html.escape(_text(now))}"))

    return show


@contextlib.contextmanager
def _terminal_bar() -> Iterator[Show]:
    from rich.console import Console
    from rich.progress import BarColumn, TaskProgressColumn, TextColumn
    from rich.progress import Progress as Bar

    columns = (BarColumn(), TaskProgressColumn(), TextColumn("{task.description}"))
    with Bar(*columns, console=Console(stderr=True)) as bar:
        task = bar.add_task("building the scene", total=1.0)
        yield lambda now: bar.update(task, completed=now.fraction, description=_text(now))
