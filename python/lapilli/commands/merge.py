"""lapilli merge"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from lapilli import _core
from lapilli.commands.codes import FINISHED
from lapilli.commands.options import FramesFile, Json, Quiet, Verbose
from lapilli.commands.wrote import wrote


def command(
    frames: FramesFile,
    target: Annotated[Path, Parameter(help="the one file (.vtkhdf)")],
    /,
    *,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Gather the files of a run into one."""
    del verbose
    _core.merge(frames, target)
    wrote([target], json, quiet)
    return FINISHED
