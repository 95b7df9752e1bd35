"""The run record, read from its file: what is damaged in it is named with the file."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from lapilli._core import OutputError

# What every record has.
NEEDED = ("lapilli", "status", "time", "end", "points", "steps", "notes", "physics", "history",
          "history_columns", "bodies", "settings", "scene")  # fmt: skip


class Record(dict[str, Any]):
    """A table of a record; a member that it lacks is damage to the file, not a mistake."""

    path: Path | None = None

    def __missing__(self, name: str) -> Any:
        raise OutputError(f"the record '{self.path}' is damaged: it has no {name!r}")


def read_record(path: Path) -> Record:
    """The record in a file. An OutputError names the file where it cannot be read as one."""

    def table(members: dict[str, Any]) -> Record:
        made = Record(members)
        made.path = path
        return made

    try:
        record = json.loads(path.read_text(encoding="utf-8"), object_hook=table)
    except ValueError as error:
        raise OutputError(f"the record '{path}' is damaged: {error}") from error
    if not isinstance(record, Record):
        raise OutputError(f"the record '{path}' is damaged: it holds no table")
    return record


def damages_of(path: Path) -> list[str]:
    """What is wrong with a record that should be there; nothing where there is none."""
    if not path.is_file():
        return []
    try:
        record = read_record(path)
        for name in NEEDED:
            record[name]
    except OSError as error:
        return [str(error)]
    return []
