"""Say which files were written."""

from __future__ import annotations

import os
from collections.abc import Sequence

from lapilli.console import print_json


def wrote(paths: Sequence[str | os.PathLike[str]], json: bool, quiet: bool) -> None:
    """One line for each file, or a list in JSON; nothing when quiet."""
    if json:
        print_json({"wrote": [os.fspath(path) for path in paths]})
    elif not quiet:
        for path in paths:
            print(f"wrote {os.fspath(path)}")
