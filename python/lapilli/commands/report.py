"""lapilli report"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from cyclopts.validators import Number

from lapilli.commands.codes import FINISHED
from lapilli.commands.options import FramesFile, Json, Quiet, Verbose
from lapilli.commands.wrote import wrote


def command(
    frames: FramesFile,
    /,
    *,
    field: Annotated[
        list[str] | None,
        Parameter(negative=(), help="what is drawn; may be repeated; usual fields unless given"),
    ] = None,
    pictures: Annotated[
        int, Parameter(validator=Number(gte=0), help="the most pictures of each field")
    ] = 30,
    vectors: Annotated[str | None, Parameter(help="arrows of a vector field: velocity")] = None,
    contours: Annotated[int, Parameter(help="how many lines of equal value")] = 0,
    save: Annotated[Path | None, Parameter(help="the page; FRAMES.html unless given")] = None,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """A run as one page of HTML.

    What was modelled and what not, pictures in time, histories, balances, settings, cost.
    """
    del verbose
    from lapilli.commands.plot import style_of
    from lapilli.report import write_report

    style = style_of(vectors, contours, None, None, None)
    wrote([write_report(frames, save, field, pictures, style)], json, quiet)
    return FINISHED
