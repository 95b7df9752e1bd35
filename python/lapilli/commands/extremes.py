"""lapilli extremes"""

from __future__ import annotations

from typing import Annotated, Literal

from cyclopts import Parameter

from lapilli.commands.codes import BAR_MISSED, FINISHED
from lapilli.commands.options import JsonFile, Quiet, Verbose

Transfer = Literal["nodal", "flip", "pic", "tpic", "affine", "peridynamics", "dynamics"]


def command(
    *,
    transfer: Annotated[
        list[Transfer] | None,
        Parameter(
            negative=(),
            help="one transfer of heat, or a method; may be repeated; all unless given",
        ),
    ] = None,
    quick: Annotated[bool, Parameter(negative=(), help="four steps a case")] = False,
    json: JsonFile = None,
    plot: Annotated[str | None, Parameter(help="folder for the map")] = None,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Map stable, inaccurate and refused steps.

    Tries steps around the automatic one on hard cases.
    Exit code 4 when an automatic step is unstable or a support is inaccurate.
    """
    del verbose
    from lapilli.extremes.show import show_extremes

    kept = show_extremes(transfer or [], quick, json, plot, quiet)
    return FINISHED if kept else BAR_MISSED
