"""Which settings a study tries."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from lapilli._core import Scene


@dataclass(frozen=True)
class Setting:
    """Some members of a scene with the values to try: (("grid.cell", "0.1"), ...)."""

    changes: tuple[tuple[str, str], ...]

    def __str__(self) -> str:
        return ", ".join(f"{path}={value}" for path, value in self.changes)

    def apply(self, scene: Scene) -> Scene:
        """The scene with these members changed; a wrong path or value is a ValueError."""
        for path, value in self.changes:
            scene = scene.set(f"{path}={value}")
        return scene

    def applied(self, scene: Scene) -> Scene | None:
        """The same; None where a path or a value is wrong."""
        try:
            return self.apply(scene)
        except ValueError:
            return None


def require_paths(settings: Sequence[Setting], scene: Scene) -> None:
    """A path that works with none of its values is a mistake; a value that does not is a result."""
    tried: dict[str, list[str]] = {}
    for setting in settings:
        for path, value in setting.changes:
            tried.setdefault(path, []).append(value)
    for path, values in tried.items():
        alone = [Setting(((path, value),)) for value in dict.fromkeys(values)]
        if all(one.applied(scene) is None for one in alone):
            alone[0].apply(scene)


def parse_variation(text: str) -> tuple[str, list[str]]:
    """The path and values of "grid.cell=0.4,0.2"; commas inside brackets do not part values."""
    path, equals, values = text.partition("=")
    parted = split_outside_brackets(values)
    if not path.strip() or not equals or not all(parted):
        raise ValueError(f"--vary {text}: expected path=value,value,... as in grid.cell=0.4,0.2")
    return path.strip(), parted


def split_outside_brackets(text: str) -> list[str]:
    """Parts between commas that are in no brackets and no quotes."""
    parts, depth, quote = [""], 0, ""
    for letter in text:
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "\"'":
            quote = letter
        depth += (letter in "[{") - (letter in "]}") if not quote else 0
        if letter == "," and depth == 0 and not quote:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def as_toml(value: Any) -> str:
    """A value of Python as a scene file spells it."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key} = {quoted(item)}" for key, item in value.items()) + "}"
    if isinstance(value, Iterable):
        return "[" + ", ".join(quoted(item) for item in value) + "]"
    return repr(value.item() if hasattr(value, "item") else value)


def quoted(value: Any) -> str:
    """Like `as_toml`, with texts in quotes, as lists and tables need them."""
    return json.dumps(value) if isinstance(value, str) else as_toml(value)


Vary = Mapping[str, Sequence[Any]]


def settings_of(vary: Vary | Sequence[Vary]) -> list[Setting]:
    """Every combination of the values, the last path changing fastest; of several mappings, those
    of the first, then what the others add."""
    if not vary:
        raise ValueError("nothing to vary: give paths and values, as in grid.cell=0.4,0.2")
    if not isinstance(vary, Mapping):
        return list(dict.fromkeys(setting for one in vary for setting in settings_of(one)))
    paths = list(vary)
    return [
        Setting(tuple(zip(paths, (as_toml(value) for value in values), strict=True)))
        for values in itertools.product(*vary.values())
    ]
