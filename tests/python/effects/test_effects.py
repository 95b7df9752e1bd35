"""Every key that users see changes what it says, or is listed with who shows it."""

from __future__ import annotations

import inspect
import sys
from pathlib import Path

import pytest

import lapilli as lp

sys.path.insert(0, str(Path(__file__).parent))
from effect import Effect
from elsewhere import ELSEWHERE
from registry import EFFECTS

sys.path.pop(0)


def described() -> set[str]:
    """Every member of every class of a scene: "Heat.theta"."""
    classes = [
        one for one in vars(lp).values() if isinstance(one, type) and "__signature__" in vars(one)
    ]
    return {
        f"{one.__name__}.{name}" for one in classes for name in inspect.signature(one).parameters
    }


def values(effect: Effect) -> tuple[float, float]:
    found = []
    for value in (effect.first, effect.second):
        simulation = lp.Simulation(effect.scene().set(effect.path, value))
        if effect.steps:
            simulation.run_until(simulation.end)
        found.append(effect.quantity(simulation))
    return found[0], found[1]


def test_every_key_has_an_effect_or_a_reason() -> None:
    keys = described()
    assert len(keys) > 150
    missing = {key for key in keys if key not in EFFECTS and key not in ELSEWHERE}
    missing = {key for key in missing if key.split(".")[0] not in ELSEWHERE}
    assert not missing
    assert set(EFFECTS) <= keys, "an effect of a key that is gone"
    listed = {key for key in ELSEWHERE if "." in key}
    assert listed <= keys, "a reason for a key that is gone"
    assert not listed & set(EFFECTS)


@pytest.mark.parametrize("key", EFFECTS)
def test_the_key_changes_what_it_says(key: str) -> None:
    effect = EFFECTS[key]
    first, second = values(effect)
    if effect.relation == "x":
        assert second == pytest.approx(effect.factor * first, rel=effect.tolerance)
        assert effect.factor != 1
    elif effect.relation == "!=":
        # seen by the weighted sum of a field: beyond rounding, whatever the direction
        assert abs(second - first) > 1e-11 * max(abs(first), abs(second))
    else:
        assert (second < first) == (effect.relation == "<")
        assert second != first
