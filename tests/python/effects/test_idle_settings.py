"""A setting that changes nothing says so.

Every setting that has an effect somewhere is put into scenes that others have their effects in. A
run whose bytes stay the same must hold a note that the setting is idle there.
"""

from __future__ import annotations

import copy
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core

sys.path.insert(0, str(Path(__file__).parent))
from effect import Effect
from registry import EFFECTS

sys.path.pop(0)

Bytes = dict[str, bytes]

SCENES = {f"{one.scene.__module__}.{one.scene.__qualname__}": one.scene for one in EFFECTS.values()}

# What may change nothing for a reason that no note could know before the run.
RARELY = {
    "Body.fill": "boxes of a lattice may fit the shape",
    "Grid.shape_function": "heat of bodies at rest takes linear functions for gimp",
    "Heat.temperature_unit": "tells what is below absolute zero",
    "Heat.tolerance": "explicit steps may be the cheapest within both",
    "Heat.blend": "nothing flows where all has one temperature",
    "Heat.corner_fit": "a round body has no corners",
    "PeridynamicFlow.sound_speed_factor": "a wall or viscosity may ask for more",
    "PeridynamicFlow.length": "as sound_speed_factor",
    "PeridynamicFlow.temperature_range": "as sound_speed_factor",
    "PeridynamicFlow.viscous_step": "sound may bound the step",
    "PeridynamicHeat.step_factor": "the flow may bound the step",
    **dict.fromkeys(
        (key for key in EFFECTS if key.endswith(".density")),
        "required; nothing weighs in statics without gravity",
    ),
}


def bytes_of(scene: lp.Scene) -> Bytes:
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    found = {name: simulation.by_id(name).tobytes() for name in simulation.fields}
    found["position"] = simulation.position.tobytes()
    found["clock"] = np.array([simulation.time, simulation.step_index]).tobytes()
    for balance in simulation.balance():
        found[f"balance of {balance.quantity}"] = np.array([balance.stored]).tobytes()
    found["diagnostics"] = repr(simulation.diagnostics()).encode()
    return found


def changed(scene: lp.Scene, effect: Effect, value: Any) -> lp.Scene | None:
    """The scene with the setting; nothing where it has no place or is refused."""
    try:
        other = copy.deepcopy(scene).set(effect.path, value)
        lp.Simulation(copy.deepcopy(other))
    except (ValueError, TypeError, AttributeError, IndexError):
        return None
    return other


def is_silent(scene: lp.Scene, effect: Effect) -> bool:
    """Whether two values give one result, and nothing says that the setting is idle."""
    first, second = (changed(scene, effect, value) for value in (effect.first, effect.second))
    if first is None or second is None or first == second:
        return False
    usual = set(_core.unused_settings(scene))
    if any(set(_core.unused_settings(one)) - usual for one in (first, second)):
        return False
    try:
        return bytes_of(first) == bytes_of(second)
    except RuntimeError:
        return False


@pytest.mark.parametrize("name", SCENES)
def test_what_changes_nothing_says_so(name: str) -> None:
    scene = SCENES[name]()
    silent = [
        f"{key}: {effect.path}"
        for key, effect in EFFECTS.items()
        if key not in RARELY and is_silent(scene, effect)
    ]
    assert silent == []
