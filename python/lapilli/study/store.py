"""What a study has found so far, in a file: a study that was stopped goes on."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Generic, TypeVar

Row = TypeVar("Row")


def key_of(*parts: object) -> str:
    """A name for all that the rows of one study have in common."""
    return hashlib.sha256(json.dumps(parts, default=str).encode()).hexdigest()[:16]


class Store(Generic[Row]):
    """Rows appended one by one, each on a line of its own; those of other studies stay.

    `key` names the study that a row belongs to. What does not last is done again by the next study:
    a run that failed for want of memory.
    """

    def __init__(
        self,
        path: str | os.PathLike[str] | None,
        key: str | Callable[[Row], str],
        read: Callable[[dict[str, Any]], Row],
        write: Callable[[Row], dict[str, Any]],
        lasts: Callable[[Row], bool] = lambda row: True,
    ) -> None:
        self.path = None if path is None else Path(path)
        self._key: Callable[[Row], str] = key if callable(key) else lambda row: key
        self._write, self._lasts = write, lasts
        self.rows: list[Row] = list(self._held(read))

    def _held(self, read: Callable[[dict[str, Any]], Row]) -> Iterator[Row]:
        if self.path is None or not self.path.exists():
            return
        for line in self.path.read_text().splitlines():
            try:
                held = json.loads(line)
                row = read(held["row"])
                if held["study"] == self._key(row) and self._lasts(row):
                    yield row
            except (ValueError, KeyError, TypeError):
                continue  # the last line of a run that was killed

    def add(self, row: Row) -> None:
        """Append one row, on a line of its own after one that was cut short."""
        self.rows.append(row)
        if self.path is not None:
            line = json.dumps({"study": self._key(row), "row": self._write(row)})
            with self.path.open("ab+") as file:
                length = file.seek(0, os.SEEK_END)
                file.seek(max(0, length - 1))
                cut = file.read(1) not in (b"\n", b"")
                file.write((("\n" if cut else "") + line + "\n").encode())
