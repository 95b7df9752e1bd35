"""lapilli tradeoff"""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from lapilli.commands.codes import FINISHED, RUN_FAILED
from lapilli.commands.options import Changes, Count, Json, Quiet, SceneFile, Verbose, load


def command(
    scene: SceneFile,
    /,
    *,
    changes: Changes = None,
    vary: Annotated[
        list[str],
        Parameter(
            negative=(),
            help="values of one member to try, PATH=A,B,...; may be repeated",
        ),
    ],
    reference: Annotated[
        str,
        Parameter(
            help="radial, slab, finer:grid.cell=0.05, a .vtkhdf file, or module:function",
        ),
    ],
    times: Annotated[str | None, Parameter(help="S,S,...; the end unless given")] = None,
    field: Annotated[str, Parameter(help="which field; temperature unless given")] = "temperature",
    repeats: Count = 3,
    workers: Annotated[Count, Parameter(help="runs at once")] = 1,
    threads: Annotated[Count, Parameter(help="threads of each run")] = 1,
    target_error: Annotated[float | None, Parameter(help="name the cheapest within")] = None,
    budget: Annotated[float | None, Parameter(help="name the best within CPU s")] = None,
    output: Annotated[
        str | None,
        Parameter(help="NAME.csv, .json, .png, .jsonl; the scene's unless given"),
    ] = None,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Measure error against cost.

    Exit code 1 when no setting worked.
    """
    del verbose
    from lapilli.study.show import show_study

    worked = show_study(
        load(scene, changes),
        vary,
        reference,
        name=output or scene.stem + "-tradeoff",
        times=times,
        field=field,
        repeats=repeats,
        workers=workers,
        threads=threads,
        target_error=target_error,
        budget=budget,
        json=json,
        quiet=quiet,
    )
    return FINISHED if worked else RUN_FAILED
