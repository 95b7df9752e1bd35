"""lapilli run"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from lapilli.commands.codes import FINISHED
from lapilli.commands.options import Changes, Count, Json, Quiet, SceneFile, Verbose, load
from lapilli.console import print_json, say

if TYPE_CHECKING:
    from lapilli.result import Result


def command(
    scene: SceneFile,
    /,
    *,
    changes: Changes = None,
    output: Annotated[Path | None, Parameter(help="frames for ParaView (.vtkhdf)")] = None,
    every: Annotated[float | None, Parameter(help="time between frames, s")] = None,
    threads: Annotated[Count | None, Parameter(help="as many as pay, unless given")] = None,
    resume: Annotated[bool, Parameter(negative=(), help="go on from the checkpoint")] = False,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Run a scene.

    Writes frames for ParaView, a checkpoint, and beside them the run record (.json) and history
    (.csv). Ctrl-C ends the run after its step, with frame and checkpoint written.
    """
    from lapilli import _core
    from lapilli.result import run

    given = load(scene, changes)
    if verbose:
        say(_core.check_text(given).rstrip())
    path = output or given.output.path or scene.stem + ".vtkhdf"
    result = run(given, path, every, threads=threads, progress=not quiet, resume=resume)
    if json:
        print_json(as_json(result, Path(path)))
    elif not quiet:
        print(result.report(), end="")
    return FINISHED


def as_json(result: Result, output: Path) -> dict[str, Any]:
    """What a run did: its balances and last values, and where the rest lies."""
    summary, simulation, warnings = result.summary, result.simulation, result.warnings
    return {
        "finished": summary.finished,
        "time": result.time,
        "steps": simulation.step_index,
        "points": len(simulation),
        "frames": summary.frames,
        "cpu_seconds": summary.cpu_seconds,
        "balances": {
            name: {
                "unit": one.unit,
                "initial": one.initial,
                "supplied": one.supplied,
                "stored": one.stored,
                "residual": one.residual,
                "entries": dict(one.entries),
            }
            for name, one in result.balance.items()
        },
        "last": {
            name: float(values[-1]) for name, values in summary.history.items() if len(values)
        },
        "notes": summary.notes,
        "note_codes": [one.code for one in summary.notes],
        "warnings": warnings,
        "warning_codes": [one.code for one in warnings],
        "output": str(output),
        "record": str(output.with_suffix(".json")),
    }
