"""Whether the frames of a run are of the problem that a scene poses."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from lapilli._core import Scene
from lapilli.study.settings import Setting

# What poses the problem; everything else says how it is solved.
PROBLEM = (
    "shape", "material", "temperature", "rotation", "translation", "motion", "velocity",
    "geostatic", "source", "boundaries", "gravity", "grid_boundaries", "obstacles", "tractions",
    "pressures", "supports", "body_force", "walls", "thermal_expansion", "plastic_heating",
)  # fmt: skip


def require_same_problem(
    frames: str | os.PathLike[str], scene: Scene, settings: Sequence[Setting] = ()
) -> None:
    """A ValueError names what the run of the frames had otherwise than the scene.

    Members that the study varies may differ; so may cells, points and steps.
    """
    record = Path(frames).with_suffix(".json")
    if not record.is_file():
        return
    held = json.loads(record.read_text())
    theirs = flat(held.get("settings") or {})
    ours = flat(json.loads(scene.to_json()))
    varied = {path for setting in settings for path, _ in setting.changes}
    differing = [
        path
        for path in sorted(ours.keys() | theirs.keys())
        if poses_problem(path)
        and not any(path == one or path.startswith(one + ".") for one in varied)
        and ours.get(path) != theirs.get(path)
    ]
    if differing:
        told = ", ".join(
            f"{path} = {theirs.get(path, 'absent')} there, {ours.get(path, 'absent')} here"
            for path in differing[:3]
        )
        raise ValueError(f"the reference {os.fspath(frames)} is of another scene: {told}")


def poses_problem(path: str) -> bool:
    """Whether a member is part of the problem."""
    return any(part in PROBLEM for part in path.split("."))


def flat(value: Any, path: str = "") -> dict[str, Any]:
    """Every number and word of a nested value by its path."""
    return dict(leaves(value, path))


def leaves(value: Any, path: str) -> Iterator[tuple[str, Any]]:
    """One after the other."""
    items = (
        value.items()
        if isinstance(value, dict)
        else enumerate(value)
        if isinstance(value, list)
        else None
    )
    if items is None:
        yield path, value
        return
    for key, item in items:
        yield from leaves(item, f"{path}.{key}" if path else str(key))
