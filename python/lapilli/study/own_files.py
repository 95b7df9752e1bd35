"""The files of a study: written over its own only, never over what it reads."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from lapilli.own_output import require_own_picture
from lapilli.whole_file import require_apart

TABLE = {"status", "reason"}  # columns of every table of a study


def require_own_files(
    targets: Iterable[str], inputs: Iterable[str | os.PathLike[str] | None]
) -> None:
    """Refuse, before anything is computed, to write over files of others or over inputs."""
    targets = list(targets)
    require_apart(targets, [given for given in inputs if given is not None])
    for target in map(Path, targets):
        if not target.exists() or target.stat().st_size == 0:
            continue
        if target.suffix == ".png":
            require_own_picture(target)
        elif not is_own(target):
            raise ValueError(
                f"{target} was not written by a study: it is not overwritten; choose another "
                "--output or take it away"
            )


def is_own(path: Path) -> bool:
    """Whether a table, rows in JSON or a store are of a study, by their beginnings."""
    if not path.is_file():
        return path.suffix not in {".csv", ".json"}
    with path.open(errors="replace") as file:
        first = file.readline()
    if path.suffix == ".csv":
        return set(first.strip().split(",")) >= TABLE
    if path.suffix == ".json":
        return first.startswith("[")
    return path.suffix != ".jsonl" or first.startswith('{"study": ')
