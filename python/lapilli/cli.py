"""The command `lapilli`; what it does lies in lapilli.commands."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from collections.abc import Sequence
from typing import NoReturn

from cyclopts import (
    App,
    CycloptsError,
    MissingArgumentError,
    Parameter,
    UnknownCommandError,
    UnusedCliTokensError,
)

from lapilli._core import OutputError, RunError
from lapilli.commands import COMMANDS, GROUPS
from lapilli.commands.codes import DISK_FAILED, FINISHED, RUN_FAILED, SIGNALLED, WRONG_INPUT
from lapilli.console import unheard_streams
from lapilli.mistakes import is_disk_failure, is_utf8
from lapilli.signals import Signalled, stopped_by_signals
from lapilli.words import meant

HELP = {"-h", "--help"}


def main(words: Sequence[str] | None = None) -> int:
    """Run one command; mistakes become one line on standard error and an exit code."""
    with unheard_streams():
        return answer(list(sys.argv[1:] if words is None else words))


def answer(words: list[str]) -> int:
    """The exit code of one command."""
    for word in words:
        if not is_utf8(word):
            return report(ValueError(f"{word!a} is a name that is no UTF-8"), WRONG_INPUT)
    if words[:1] == ["--version"]:
        print(version())
        return FINISHED
    verbose = False
    try:
        app = application()
        if not words or words[0] in HELP:
            for name in COMMANDS:
                app[name]  # imported: then its own first line stands in the list
        try:
            command, bound, _ = app.parse_args(words, print_error=False, exit_on_error=False)
        except CycloptsError as error:
            refuse(error)
        verbose = bound.arguments.get("verbose", False)
        with stopped_by_signals():
            code: int | None = command(*bound.args, **bound.kwargs)
        sys.stdout.flush()
        is_help = getattr(command, "__func__", None) is App.help_print
        return WRONG_INPUT if is_help and not HELP & set(words) else code or FINISHED
    except KeyboardInterrupt as error:
        print("\nlapilli: stopped", file=sys.stderr)
        return SIGNALLED + (error.number if isinstance(error, Signalled) else signal.SIGINT)
    except OutputError as error:
        drop_output()
        return report(error, DISK_FAILED, verbose)
    except (RunError, MemoryError) as error:
        return report(error, RUN_FAILED, verbose)
    except (ValueError, OSError) as error:
        if not is_disk_failure(error):
            return report(error, WRONG_INPUT, verbose)
        drop_output()
        return report(error, DISK_FAILED, verbose)


def application() -> App:
    """All commands; none of their modules is imported yet."""
    app = App(
        name="lapilli",
        help="Heat and large deformation with particles, on boundaries that do not fit the grid.",
        version=version,
        default_parameter=Parameter(show_default=False),
        suppress_keyboard_interrupt=False,
    )
    for number, name in enumerate(COMMANDS):
        target = "app" if name in GROUPS else "command"
        app.command(f"lapilli.commands.{name}:{target}", name=name, sort_key=number)
    return app


def version() -> str:
    """Version, and how the program was built."""
    from lapilli import _core

    return _core.version_text()


def refuse(error: CycloptsError) -> NoReturn:
    """Say what is wrong with the words and how to ask for help, in two lines."""
    chain = " ".join(["lapilli", *(error.command_chain or ())])
    print(f"{chain}: {mistake(error)}\n(see {chain} --help)", file=sys.stderr)
    raise SystemExit(WRONG_INPUT)


def mistake(error: CycloptsError) -> str:
    """What is wrong with the words, in one line."""
    unused = error.unused_tokens or []
    if isinstance(error, UnknownCommandError) and error.app and unused:
        known = [name for name in error.app if not name.startswith("-")]
        return f"unknown command '{unused[0]}'; {meant(unused[0], known)}"
    if isinstance(error, UnusedCliTokensError):
        return f"too many arguments: {' '.join(unused)}"
    if isinstance(error, MissingArgumentError) and error.argument and not error.keyword:
        return f"{error.argument.name} is missing"
    error.verbose = False
    return " ".join(str(error).split())


def drop_output() -> None:
    """Let what could not be printed go, or the interpreter fails on it once more as it ends."""
    with contextlib.suppress(OSError, ValueError):
        sys.stdout.flush()
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def report(error: Exception, code: int, verbose: bool = False) -> int:
    """Say what went wrong; where it came from when asked to be verbose."""
    if verbose:
        import traceback

        traceback.print_exception(error)
    print(f"lapilli: {error}", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
