"""lapilli suggest"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

from lapilli.commands.codes import FINISHED, RUN_FAILED
from lapilli.commands.options import Changes, Count, Json, Quiet, SceneFile, Verbose, load
from lapilli.console import beside, print_json, say


def command(
    scene: SceneFile,
    /,
    *,
    changes: Changes = None,
    target_error: Annotated[float, Parameter(help="the error that is wanted")],
    quantity: Annotated[
        str | None,
        Parameter(
            help="a field, or a scalar of the history; temperature, displacement or velocity "
            "unless given"
        ),
    ] = None,
    norm: Annotated[
        Literal["rms", "max", "mean", "relative"], Parameter(help="of the error")
    ] = "rms",
    times: Annotated[str | None, Parameter(help="S,S,...; the end unless given")] = None,
    budget: Annotated[str, Parameter(help="CPU time of all runs: 90s, 10min, 1h")] = "2min",
    threads: Annotated[Count, Parameter(help="threads of each run")] = 1,
    output: Annotated[Path | None, Parameter(help="the picture, SCENE-suggest.png")] = None,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Find the cheapest setting within an error.

    Runs the scene coarse, then finer, judges each run by the finest, and tries other settings where
    the target is reached. Exit code 1 when it cannot tell within the budget.
    """
    del verbose
    from lapilli.study.show import times_of
    from lapilli.study.suggest import suggest
    from lapilli.study.suggest_show import as_json, draw, seconds_of, text_of

    found = suggest(
        load(scene, changes),
        target_error,
        quantity=quantity,
        times=None if times is None else times_of(times),
        norm=norm,
        budget=seconds_of(budget),
        threads=threads,
        tell=lambda text: say(text, quiet),
    )
    picture = output or Path(scene.stem + "-suggest.png")
    try:
        draw(found, picture)
        say(f"wrote {picture}", quiet)
    except ValueError as error:
        say(f"no picture: {error}", quiet)
    if json:
        print_json(as_json(found))
    elif found.grade is None:
        say(f"lapilli: {text_of(found, str(scene), changes or ())}")
    if found.grade is None:
        return RUN_FAILED
    say(text_of(found, str(scene), changes or ()), quiet and json, beside(json))
    return FINISHED
