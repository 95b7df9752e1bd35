"""lapilli plot"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from lapilli.commands.codes import FINISHED
from lapilli.commands.options import Json, Quiet, Verbose
from lapilli.commands.wrote import wrote
from lapilli.own_output import require_own_picture
from lapilli.whole_file import require_apart

if TYPE_CHECKING:
    from lapilli.plot import Style

ANIMATED = {".gif", ".mp4", ".webm"}


def command(
    *frames: Annotated[Path, Parameter(help="frames (.vtkhdf); of several runs beside each other")],
    field: Annotated[
        str | None,
        Parameter(help="velocity, velocity.x, stress.xy, ...; temperature unless given"),
    ] = None,
    time: Annotated[float | None, Parameter(help="s; the last frame unless given")] = None,
    vectors: Annotated[str | None, Parameter(help="arrows of a vector field: velocity")] = None,
    contours: Annotated[int, Parameter(help="how many lines of equal value")] = 0,
    cut: Annotated[
        str | None, Parameter(help="in space: the layer of points a plane goes through, y=0.25 (m)")
    ] = None,
    limits: Annotated[
        str | None, Parameter(name="--range", help="ends of the colours: 0,1")
    ] = None,
    colours: Annotated[str | None, Parameter(help="a colour map of matplotlib")] = None,
    history: Annotated[
        str | None, Parameter(help="columns of the history in time instead: 'heat/*,mid'")
    ] = None,
    probe: Annotated[
        str | None,
        Parameter(help="the field at a position in time instead: 0.5,1", allow_leading_hyphen=True),
    ] = None,
    save: Annotated[
        Path | None, Parameter(help=".png, .pdf, .svg; .gif, .mp4 and .webm are animated")
    ] = None,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """A picture or an animation of a run, or its numbers in time."""
    del verbose
    from lapilli import plot

    if not frames:
        raise ValueError("plot needs the frames of a run (.vtkhdf)")
    target = save or frames[0].with_suffix(".png")
    require_apart([target], frames)
    if save is None:
        require_own_picture(target)
    if history is not None:
        plot.draw_history(frames, history.split(","), target)
    elif probe is not None:
        plot.draw_probe(frames, numbers_of("--probe", probe), field, target)
    else:
        style = style_of(vectors, contours, cut, limits, colours)
        if target.suffix.lower() in ANIMATED:
            if time is not None:
                raise ValueError("an animation shows all times: --time is for pictures")
            plot.animate(frames, target, field, style=style)
        else:
            plot.draw(frames, field, time, target, style)
    wrote([target], json, quiet)
    return FINISHED


def style_of(
    vectors: str | None, contours: int, cut: str | None, limits: str | None, colours: str | None
) -> Style:
    """What the picture shows beside its field."""
    from lapilli.plot import Style

    ends = None if limits is None else numbers_of("--range", limits)
    if ends is not None and len(ends) != 2:
        raise ValueError(f"--range {limits}: expected two numbers, 0,1")
    return Style(vectors, contours, cut, None if ends is None else (ends[0], ends[1]), colours)


def numbers_of(option: str, text: str) -> list[float]:
    """The numbers of "0.5,1"."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise ValueError(f"{option} {text}: expected numbers with commas between") from None
