"""Whether what a study kept belongs to it: the bytes that shape its runs, by their checksums."""

from __future__ import annotations

import hashlib
import importlib.util
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

from lapilli import _core
from lapilli._core import Scene
from lapilli.note import Note, note
from lapilli.study.settings import Setting
from lapilli.study.store import key_of


class Row(Protocol):
    """What came of one run."""

    @property
    def setting(self) -> Setting: ...


class Keys:
    """The name of the problem of each row: scene, input files, arrays, version and what is asked.

    Input files that only a setting names belong to the rows of that setting.
    """

    def __init__(self, scene: Scene, *asked: object) -> None:
        self._scene = scene
        lines, self.functions = _core.scene_identity(scene)
        self._shared = key_of(scene.to_json(), lines, asked)
        self._own: dict[tuple[tuple[str, str], ...], str] = {}

    def __call__(self, row: Row) -> str:
        words = tuple(change for change in row.setting.changes if may_name_file(change[1]))
        if not words:
            return self._shared
        if words not in self._own:
            changed = Setting(words).applied(self._scene)
            lines = "" if changed is None else _core.scene_identity(changed)[0]
            self._own[words] = key_of(self._shared, lines)
        return self._own[words]

    def place(
        self, path: str | os.PathLike[str] | None, notes: list[Note], *given: object
    ) -> str | os.PathLike[str] | None:
        """Where rows are kept: nowhere where the scene, or a reference `given`, is a function,
        which nothing can compare; a note says so."""
        functions = list(self.functions)
        functions += ["the reference" for one in given if holds_function(one)]
        if path is None or not functions:
            return path
        words = (
            f"nothing is kept in {os.fspath(path)}: functions cannot be compared with those of "
            f"another run ({', '.join(functions)})"
        )
        notes.append(note("study.nothing-kept", words))
        return None


def may_name_file(value: str) -> bool:
    """Whether a value of a setting is no plain number."""
    try:
        float(value)
    except ValueError:
        return value not in ("true", "false")
    return False


def holds_function(reference: object) -> bool:
    """Whether a reference is known by its address only."""
    if isinstance(reference, Mapping):
        return any(holds_function(one) for one in reference.values())
    return callable(reference)


def contents_of(reference: object) -> object:
    """The checksum of each file that a reference names: frames with their data and record, the
    module of a function."""
    if isinstance(reference, Mapping):
        return {str(name): contents_of(one) for name, one in reference.items()}
    if not isinstance(reference, str | os.PathLike):
        return None
    path = Path(reference)
    if path.suffix == ".vtkhdf":
        data = sorted(path.parent.glob(f"{path.name}.data*"))
        return [checksum_of(one) for one in (path, path.with_suffix(".json"), *data)]
    module, colon, _ = os.fspath(reference).partition(":")
    if not colon or module == "finer":
        return checksum_of(path)
    try:
        found = importlib.util.find_spec(module)
    except (ImportError, ValueError):
        return None
    return None if found is None or found.origin is None else checksum_of(Path(found.origin))


def checksum_of(path: Path) -> str | None:
    """Of all bytes of a file; None where there is none."""
    try:
        found = hashlib.blake2b()
        with path.open("rb") as file:
            while piece := file.read(1 << 20):
                found.update(piece)
        return found.hexdigest()
    except OSError:
        return None
