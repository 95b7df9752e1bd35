"""lapilli check"""

from __future__ import annotations

from lapilli.commands.codes import FINISHED
from lapilli.commands.options import Changes, Json, Quiet, SceneFile, Verbose, load


def command(
    scene: SceneFile,
    /,
    *,
    changes: Changes = None,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Say what a scene models and costs.

    Nothing is run. With --quiet only mistakes are said.
    """
    del verbose
    from lapilli import _core

    given = load(scene, changes)
    text = _core.check_json(given) if json else _core.check_text(given)
    if json or not quiet:
        print(text, end="" if text.endswith("\n") else "\n")
    return FINISHED
