"""lapilli schema"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from lapilli import _core
from lapilli.commands.codes import FINISHED
from lapilli.commands.options import Quiet, Verbose
from lapilli.commands.wrote import wrote


def command(
    *,
    save: Annotated[Path | None, Parameter(help="write it there")] = None,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """JSON Schema of scene files, for editors."""
    del verbose
    if save is None:
        print(_core.scene_schema(), end="")
    else:
        save.write_text(_core.scene_schema())
        wrote([save], False, quiet)
    return FINISHED
