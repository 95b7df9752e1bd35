"""lapilli study"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

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

PICTURES = ("-effects.png", "-pairs.png", "-response.png")


Vary = Annotated[
    list[str] | None,
    Parameter(
        negative=(),
        help="a member and its values, PATH=A,B,... or PATH=LOW..HIGH or 'PATH=LOW..HIGH log'; "
        "may be repeated",
    ),
]
Cases = Annotated[
    Path | None, Parameter(help="CSV file: paths in its first line, a case in each other")
]
Quantities = Annotated[
    list[str] | None,
    Parameter(
        negative=(),
        help="a scalar of the history, its last value or max(NAME), min, mean, range over "
        "time; or the mean of a field; may be repeated; all scalars unless given",
    ),
]
Sample = Annotated[
    Literal["grid", "latin-hypercube", "sobol"], Parameter(help="how cases are chosen")
]
Samples = Annotated[
    int | None,
    Parameter(help="cases drawn or tried (50); with a grid, values of each range (5)"),
]
Minimize = Annotated[
    str | None,
    Parameter(
        allow_leading_hyphen=True, help="look for the smallest of this quantity; -NAME: largest"
    ),
]
Data = Annotated[
    Path | None,
    Parameter(help="CSV file with a column time: --minimize its distance from the scalar"),
]
Output = Annotated[
    str | None,
    Parameter(help="NAME.csv, .parquet, -effects.png, .jsonl; the scene's unless given"),
]


def command(
    scene: SceneFile,
    /,
    *,
    changes: Changes = None,
    vary: Vary = None,
    cases: Cases = None,
    quantity: Quantities = None,
    sample: Sample = "grid",
    samples: Samples = None,
    seed: Annotated[int, Parameter(help="of the samples")] = 0,
    minimize: Minimize = None,
    data: Data = None,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    threads: Annotated[Count, Parameter(help="threads of each run")] = 1,
    output: Output = None,
    parquet: Annotated[bool, Parameter(negative=(), help="write NAME.parquet too")] = False,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Run many cases of a scene and gather numbers.

    Cases that fail stay in the table with the reason; a study that was stopped goes on where it
    was. Exit code 1 when no case finished.
    """
    del verbose
    from lapilli.study import show_survey
    from lapilli.study.own_files import require_own_files
    from lapilli.study.runner import runner_of
    from lapilli.study.sampling import cases_in, parse_values
    from lapilli.study.survey import study

    given = load(scene, changes)
    name = output or scene.stem + "-study"
    require_together(vary, cases, minimize, data)
    members = dict(parse_values(text) for text in vary or ())
    if len(members) < len(vary or ()):
        raise ValueError("--vary names one path twice: give all its values at once")
    endings = [".csv", ".jsonl", *PICTURES, *([".parquet"] if parquet else [])]
    require_own_files([name + ending for ending in endings], (scene, cases, data))
    how: dict[str, Any] = {
        "seed": seed,
        "threads": threads,
        "runner": runner_of(workers, scheduler),
        "store": name + ".jsonl",
        "report": None if quiet else show_survey.report,
    }
    if minimize is not None:
        from lapilli.study.optimise import minimize as search

        results = search(given, members, minimize, data=data, samples=samples or 50, **how)
    else:
        how |= {"sample": sample, "cases": None if cases is None else cases_in(cases)}
        count = samples or (5 if sample == "grid" else 50)
        results = study(given, members, quantity or (), samples=count, **how)
    written = show_survey.write(results, name, parquet)
    goal = results.quantities[0] if minimize is not None else None
    return FINISHED if show_survey.show(results, written, goal, json, quiet) else RUN_FAILED


def require_together(
    vary: list[str] | None, cases: Path | None, minimize: str | None, data: Path | None
) -> None:
    """Throw ValueError for options that contradict or need each other."""
    if bool(vary) == (cases is not None):
        raise ValueError("give either --vary or --cases")
    if minimize is not None and cases is not None:
        raise ValueError("--minimize chooses its cases: give --vary, not --cases")
    if data is not None and minimize is None:
        raise ValueError("--data needs --minimize NAME: the scalar that shall follow them")
