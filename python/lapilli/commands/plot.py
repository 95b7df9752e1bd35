"""lapilli plot"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from lapilli.commands.codes import FINISHED
from lapilli.commands.options import FramesFile, Json, Quiet, Verbose
from lapilli.commands.wrote import wrote


def command(
    frames: FramesFile,
    /,
    *,
    field: Annotated[str | None, Parameter(help="temperature unless given")] = None,
    time: Annotated[float | None, Parameter(help="s; the last frame unless given")] = None,
    save: Annotated[
        Path | None, Parameter(help=".png, .pdf, .svg; .gif and .mp4 are animated")
    ] = None,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """A picture or an animation of a run."""
    del verbose
    from lapilli import plot

    target = save or frames.with_suffix(".png")
    if target.suffix.lower() in {".gif", ".mp4", ".webm"}:
        plot.animate(frames, target, field)
    else:
        plot.draw(frames, field, time, target)
    wrote([target], json, quiet)
    return FINISHED
