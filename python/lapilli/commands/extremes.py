"""lapilli extremes"""

from __future__ import annotations

from typing import Annotated, Literal

from cyclopts import Parameter

from lapilli.commands.codes import BAR_MISSED, FINISHED
from lapilli.commands.options import JsonFile, Quiet, Verbose, Workers

Transfer = Literal["nodal", "flip", "pic", "tpic", "affine", "peridynamics", "dynamics"]
Group = Literal["supports", "heat", "vibration", "rest", "impact", "contact", "static", "fluid"]


def command(
    *,
    transfer: Annotated[
        list[Transfer] | None,
        Parameter(
            negative=(),
            help="steps of one transfer of heat, or of a method; may be repeated; with neither "
            "this nor --only all",
        ),
    ] = None,
    only: Annotated[
        list[Group] | None,
        Parameter(negative=(), help="one group of runs at their automatic steps; may be repeated"),
    ] = None,
    quick: Annotated[bool, Parameter(negative=(), help="four steps a case")] = False,
    workers: Workers = 1,
    store: Annotated[
        str | None,
        Parameter(help="file that keeps what was found: a run that was stopped goes on"),
    ] = None,
    json: JsonFile = None,
    plot: Annotated[str | None, Parameter(help="folder for the map")] = None,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Map what is stable and accurate at the extremes.

    Tries steps around the automatic one on hard cases, and judges runs of every method at their
    automatic steps by energy, range, balance and closed forms. Exit code 4 when an automatic step
    is unstable, a support inaccurate, or a run wrong without a warning.
    """
    del verbose
    from lapilli.extremes.show import show_extremes

    kept = show_extremes(
        [*(transfer or ()), *(only or ())], quick, workers, store, json, plot, quiet
    )
    return FINISHED if kept else BAR_MISSED
