"""lapilli tradeoff"""

from __future__ import annotations

from typing import Annotated, Literal

from cyclopts import Parameter

from lapilli.commands.codes import FINISHED, RUN_FAILED
from lapilli.commands.options import (
    Changes,
    Count,
    Json,
    Quiet,
    SceneFile,
    Scheduler,
    Verbose,
    Workers,
    load,
)

Vary = Annotated[
    list[str],
    Parameter(
        negative=(),
        help="values of one member to try, PATH=A,B,...; may be repeated",
    ),
]
Reference = Annotated[
    str | None,
    Parameter(
        help="radial, slab, finer:grid.cell=0.05, a .vtkhdf file, or module:function; "
        "a finer run of the scene unless given",
    ),
]
Quantities = Annotated[
    list[str] | None,
    Parameter(
        negative=(),
        help="a field, or a scalar of the history (heat/supplied_by_rims); may be repeated, "
        "the first ranks",
    ),
]
Norm = Annotated[Literal["rms", "max", "mean", "relative"], Parameter(help="of the error")]
Output = Annotated[
    str | None,
    Parameter(help="NAME.csv, .json, .png, .jsonl; the scene's unless given"),
]


def command(
    scene: SceneFile,
    /,
    *,
    changes: Changes = None,
    vary: Vary,
    reference: Reference = None,
    times: Annotated[str | None, Parameter(help="S,S,...; the end unless given")] = None,
    field: Annotated[str, Parameter(help="which field; temperature unless given")] = "temperature",
    quantity: Quantities = None,
    norm: Norm = "rms",
    repeats: Count = 3,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    threads: Annotated[Count, Parameter(help="threads of each run")] = 1,
    target_error: Annotated[float | None, Parameter(help="name the cheapest within")] = None,
    budget: Annotated[float | None, Parameter(help="name the best within CPU s")] = None,
    output: Output = None,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Measure error against cost.

    Cost is building, stepping and output, as a user waits for them. Exit code 1 when no setting
    worked, or none is within the target.
    """
    del verbose
    from lapilli.study.own_files import require_own_files
    from lapilli.study.runner import runner_of
    from lapilli.study.show import show_study

    name = output or scene.stem + "-tradeoff"
    require_own_files(
        [name + ending for ending in (".csv", ".json", ".png", ".jsonl")], (scene, reference)
    )
    worked = show_study(
        load(scene, changes),
        vary,
        reference,
        name=name,
        times=times,
        quantities=quantity or [field],
        norm=norm,
        repeats=repeats,
        runner=runner_of(workers, scheduler),
        threads=threads,
        target_error=target_error,
        budget=budget,
        json=json,
        quiet=quiet,
    )
    return FINISHED if worked else RUN_FAILED
