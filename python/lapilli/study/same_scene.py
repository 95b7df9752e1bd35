"""Whether the frames of a run are of the problem that a scene poses."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from lapilli._core import Scene
from lapilli.record import read_record
from lapilli.study.settings import Setting

# Of each section, the members that say how a problem is solved or what is written of it. All others
# pose it: a list that forgets a member refuses too much, never too little.
HOW = {
    "": ("title", "grid", "time", "output", "probes"),
    "bodies": ("name", "points_file", "points", "points_per_cell", "fill", "jitter", "random",
               "seed"),
    "heat": ("method", "transfer", "time_integration", "tolerance", "theta", "solver", "blend",
             "normal_smoothing", "surface_fraction", "implicit_robin", "corner_fit", "subcycling"),
    "heat.boundaries": ("name",),
    "dynamics": ("transfer", "blend_rate", "pic_fraction", "stress_update", "b_bar", "courant"),
    "dynamics.obstacles": ("name",),
    "dynamics.boundaries": ("name",),
    "quasi_static": ("enforcement", "bandwidth", "gap_bandwidth", "ghost_penalty",
                     "hold_empty_cells", "reset", "relaxation", "update_volumes", "b_bar",
                     "max_penetration", "tolerance", "max_iterations", "max_cutbacks"),
    "quasi_static.supports": ("name",),
    "quasi_static.tractions": ("name",),
    "peridynamics.heat": ("horizon", "influence", "laplacian", "zero_energy", "skin",
                          "step_factor"),
    "peridynamics.flow": ("horizon", "influence", "laplacian", "zero_energy", "sound_speed",
                          "sound_speed_factor", "length", "temperature_range",
                          "stiffness_exponent", "density_diffusion", "shifting", "courant",
                          "viscous_step", "skin", "largest_density_variation"),
    "peridynamics.walls": ("name",),
    "stages": ("name",),
}  # fmt: skip


def require_same_problem(
    frames: str | os.PathLike[str], scene: Scene, settings: Sequence[Setting] = ()
) -> None:
    """A ValueError names what the run of the frames had otherwise than the scene.

    Members that the study varies may differ; so may cells, points, steps and all else that says how
    a problem is solved.
    """
    record = Path(frames).with_suffix(".json")
    if not record.is_file():
        return
    held = read_record(record)
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
    names = [name for name in path.split(".") if not name.isdigit()]
    if names[0] == "stages" and len(names) > 2:  # what a stage sets or adds is of another section
        added = {"set": [], "add_bodies": ["bodies"], "add_obstacles": ["dynamics", "obstacles"]}
        names = added.get(names[1], names[:2]) + names[2:]
    return not any(name in HOW.get(".".join(names[:depth]), ()) for depth, name in enumerate(names))


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
