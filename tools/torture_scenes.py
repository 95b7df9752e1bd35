"""Small scenes of every method for torture.py, and ways to spoil them."""

from __future__ import annotations

import copy
import json
import random
import re
from collections.abc import Iterator
from typing import Any

import tomllib

THERMAL = '{kind = "thermal", density = 1.0, specific_heat = 1.0, conductivity = 1.0}'
ELASTIC = '{kind = "elastic", density = 1000.0, youngs_modulus = 1e9, poissons_ratio = 0.3}'
SOIL = (
    '{kind = "mohr_coulomb", density = 2000.0, youngs_modulus = 1e6, poissons_ratio = 0.3,'
    " friction_angle = 30.0}"
)
CONVECTION = '[[heat.boundaries]]\nkind = "convection"\ncoefficient = 1.0\nambient = 1.0\n'

HEAT = f"""
[grid]
lower = [-6.0, -6.0]
upper = [6.0, 6.0]
cell = 0.4
[[bodies]]
shape = {{kind = "annulus", inner = 1.0, outer = 5.0}}
points_per_cell = 4
material = {THERMAL}
{CONVECTION}
[time]
end = 0.5
step = 2e-3
[output]
every = 0.01
"""
DISK = f"""[[bodies]]
name = "NAME"
shape = {{kind = "disk", center = [MIDDLE, 0.5], radius = 0.3}}
points_per_cell = 9
velocity = [SPEED, 0.0]
material = {ELASTIC.replace("1e9", "1e6")}
"""


def _disk(name: str, middle: float, speed: float) -> str:
    text = DISK.replace("NAME", name).replace("MIDDLE", str(middle))
    return text.replace("SPEED", str(speed))


TURNING = """motion = {kind = "rotation", center = [0.0, 0.0], revolutions_per_second = 1.0}
points_per_cell"""
SCENES = {
    "heat": HEAT,
    "moving": HEAT.replace("points_per_cell", TURNING).replace("end = 0.5", "end = 0.3"),
    "soil": f"""
[grid]
lower = [0.0, 0.0]
upper = [3.0, 1.5]
cell = 0.25
[[bodies]]
shape = {{kind = "box", lower = [0.0, 0.0], upper = [1.0, 1.0]}}
points_per_cell = 9
material = {SOIL}
[dynamics]
gravity = [0.0, -9.81]
grid_boundaries = [{{kind = "roller", face = "x_lower"}}, {{kind = "no_slip", face = "y_lower"}}]
[time]
end = 1.0
[output]
every = 0.02
""",
    "contact": f"""
[grid]
lower = [0.0, 0.0]
upper = [2.0, 1.0]
cell = 0.1
{_disk("left", 0.55, 2.0)}{_disk("right", 1.35, -2.0)}[dynamics]
contacts = [{{bodies = ["left", "right"], friction = 0.3}}]
[time]
end = 0.2
[output]
every = 0.005
""",
    "quasi_static": f"""
[grid]
lower = [-0.02, -0.06]
upper = [0.14, 0.12]
cell = 0.01
shape_function = "linear"
[[bodies]]
shape = {{kind = "box", lower = [0.0, 0.0], upper = [0.1, 0.1]}}
points_per_cell = 16
material = {ELASTIC}
[quasi_static]
body_force = [0.0, {{times = [0.0, 1.0], values = [0.0, -1e9]}}]
supports = [{{name = "left", kind = "fixed", line = [[0.0, 0.1], [0.0, 0.0]]}}]
[time]
end = 1.0
steps = 20
[output]
every_steps = 1
""",
    "peridynamics": f"""
[grid]
lower = [-0.2, -0.2]
upper = [1.2, 1.2]
cell = 0.1
[[bodies]]
shape = {{kind = "box", lower = [0.0, 0.0], upper = [1.0, 1.0]}}
points_per_cell = 1
material = {THERMAL}
[peridynamics]
heat = {{horizon = 2.015}}
[time]
end = 0.2
[output]
every = 0.005
""",
}

NUMBERS = [0, -1, 1, 3, 64, 1e9, 2**63 - 1, 1e308, 1e-308, 5e-324, 0.5, 1e6, 1e-6, 90.0, 1e30]
WORDS = ["", "x", "é", "a" * 3000, "../x", "/dev/zero", "/proc/self/mem", "auto"]


def _paths(tree: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    entries = tree.items() if isinstance(tree, dict) else enumerate(tree)
    for key, value in entries:
        yield (*path, key)
        if isinstance(value, dict | list):
            yield from _paths(value, (*path, key))


def _at(tree: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        tree = tree[key]
    return tree


def _text(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        pairs = (
            f"{key if re.fullmatch('[A-Za-z0-9_-]+', key) else json.dumps(key)} = {_text(inner)}"
            for key, inner in value.items()
        )
        return "{" + ", ".join(pairs) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_text, value)) + "]"
    if isinstance(value, float):
        text = repr(value)
        return text if any(mark in text for mark in ".en") else text + ".0"
    return json.dumps(value)


def _near(choose: random.Random, value: Any) -> Any:
    if isinstance(value, bool):
        return not value
    if isinstance(value, int | float):
        factors = [0, -1, 0.5, 2, 10, 100, 1e3, 1e-3, 1e6, 1e-6, 1e12, 1.0000001]
        return value * choose.choice(factors)
    return _any(choose)


def _any(choose: random.Random) -> Any:
    kind = choose.randrange(6)
    if kind < 2:
        return choose.choice(NUMBERS)
    if kind == 2:
        return choose.choice(WORDS)
    if kind == 3:
        return [choose.choice(NUMBERS) for _ in range(choose.choice([0, 1, 2, 3, 7, 5000]))]
    if kind == 4:
        nest: Any = {"kind": "disk", "radius": 1.0}
        for _ in range(choose.choice([3, 60, 400])):
            nest = {"kind": "union", "shapes": [nest]}
        return nest
    return choose.choice([True, {}, {"kind": "box"}, {"times": [0.0, 1.0], "values": [0.0, 2.0]}])


def mutated(choose: random.Random) -> str:
    """One of the scenes with some of its values, keys or bytes spoilt."""
    tree = tomllib.loads(SCENES[choose.choice(sorted(SCENES))])
    for _ in range(choose.choice([1, 1, 2, 3])):
        path = choose.choice(list(_paths(tree)))
        holder, key = _at(tree, path[:-1]), path[-1]
        kind = choose.randrange(8)
        if kind == 0:
            del holder[key]
        elif kind == 1 and isinstance(holder, list):
            holder.extend(copy.deepcopy(holder) * choose.choice([1, 20]))
        elif kind == 2:
            holder[key] = copy.deepcopy(_at(tree, choose.choice(list(_paths(tree)))))
        else:
            holder[key] = _near(choose, holder[key]) if kind > 3 else _any(choose)
        if not list(_paths(tree)):
            break
    text = "\n".join(f"{key} = {_text(value)}" for key, value in tree.items())
    if choose.random() < 0.1:
        at = choose.randrange(len(text) + 1)
        text = text[:at] + choose.choice(["\x00", "\ud800", "[[", "'''", "=", "\u202e"]) + text[at:]
    return text
