"""lapilli reproduce"""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from lapilli.commands.codes import BAR_MISSED, FINISHED
from lapilli.commands.options import JsonFile, Quiet, Verbose


def command(
    *case: Annotated[str, Parameter(help="vhfm/ring, or vhfm for all of it; all if none")],
    list: Annotated[bool, Parameter(negative=(), help="list the cases")] = False,
    quick: Annotated[bool, Parameter(negative=(), help="smaller sizes, in seconds")] = False,
    json: JsonFile = None,
    plot: Annotated[str | None, Parameter(help="folder for the paper's figures")] = None,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Paper, reference and lapilli side by side.

    Exit code 4 when a bar is missed.
    """
    del verbose
    from lapilli.reproduce import show_cases

    kept = show_cases(case, list, quick, json, plot, quiet)
    return FINISHED if kept else BAR_MISSED
