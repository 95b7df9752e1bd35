"""lapilli verify"""

from __future__ import annotations

import os
from typing import Annotated

from cyclopts import Parameter

from lapilli import _core
from lapilli.commands.codes import DISK_FAILED, FINISHED
from lapilli.commands.options import FramesFile, Json, Quiet, Verbose
from lapilli.console import print_json


def command(
    frames: FramesFile,
    /,
    *,
    rebuild: Annotated[
        bool, Parameter(negative=(), help="make a lost index anew from the data files first")
    ] = False,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Compare the files of a run with their checksums.

    Exit code 3 when something is damaged.
    """
    del verbose
    from lapilli.frames import way_back
    from lapilli.record import damages_of

    rebuilt = _core.rebuild_index(os.fspath(frames)) if rebuild else None
    try:
        total, whole, damages = _core.verify(os.fspath(frames))
    except (_core.OutputError, ValueError) as error:
        raise type(error)(f"{error}{way_back(frames)}") from None
    damages += damages_of(frames.with_suffix(".json"))
    code = DISK_FAILED if damages else FINISHED
    if json:
        print_json({"frames": total, "whole": whole, "damages": damages, "rebuilt": rebuilt})
        return code
    if rebuilt is not None and not quiet:
        print(f"made the index anew, with {rebuilt} frames")
    for damage in damages:
        print(damage)
    if damages or not quiet:
        print(f"{whole} of {total} frames are whole" + ("" if damages else "; no damage found"))
    return code
