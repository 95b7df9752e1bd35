"""lapilli new"""

from __future__ import annotations

import shlex
import sys
from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

from lapilli.commands.codes import FINISHED
from lapilli.commands.options import Json, Quiet, Verbose
from lapilli.commands.wrote import wrote


def command(
    method: Annotated[
        Literal["heat", "soil", "static", "flow"] | None, Parameter(help="asked for if not given")
    ] = None,
    /,
    *,
    output: Annotated[Path | None, Parameter(help="METHOD.toml unless given")] = None,
    size: Annotated[float | None, Parameter(help="width of the body, m")] = None,
    cells: Annotated[int | None, Parameter(help="cells across the body")] = None,
    end: Annotated[float | None, Parameter(help="simulated time, s")] = None,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Write a commented scene to start from.

    heat: conduction in a solid; soil: explicit dynamics of sand; static: equilibrium of an elastic
    body; flow: buoyant flow by peridynamics. Nothing is overwritten.
    """
    del verbose
    from lapilli import new_scene

    if method is None:
        chosen, output, size, cells = ask(output, size, cells)
    else:
        chosen = method
    file = output or Path(f"{chosen}.toml")
    text = new_scene.text(chosen, file.name, size, cells, end)
    try:
        with file.open("x") as written:
            written.write(text)
    except FileExistsError:
        raise ValueError(f"{file} is there already: nothing was written") from None
    wrote([file], json, quiet)
    if not json and not quiet:
        scene, frames = shlex.quote(str(file)), shlex.quote(f"{file.stem}.vtkhdf")
        print(f"next: lapilli check {scene}; lapilli run {scene}; lapilli plot {frames}")
    return FINISHED


def ask(
    output: Path | None, size: float | None, cells: int | None
) -> tuple[str, Path, float | None, int | None]:
    """Method, file, size and cells from the terminal; what was given is not asked for."""
    from lapilli.new_scene import METHODS

    if not sys.stdin.isatty():
        raise ValueError(f"which method? there is: {', '.join(METHODS)}")
    from rich.prompt import FloatPrompt, IntPrompt, Prompt

    for name, one in METHODS.items():
        print(f"{name:8}{one.title}")
    method = Prompt.ask("method", choices=list(METHODS), default="heat")
    usual = METHODS[method]
    size = FloatPrompt.ask("width of the body, m", default=usual.size) if size is None else size
    cells = IntPrompt.ask("cells across it", default=usual.cells) if cells is None else cells
    return method, output or Path(Prompt.ask("file", default=f"{method}.toml")), size, cells
