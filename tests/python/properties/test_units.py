"""Every example in other units takes the same steps to the same state.

The units are powers of two, so that rounding is the same: a number with a dimension that is written
into the code, or compared with one of another dimension, shows. Measured: the same bits.
"""

import numpy as np
import pint
import pytest

import lapilli as lp
from lapilli import examples
from lapilli.accept import _unit

LENGTH, MASS, TIME = 2.0**10, 2.0**-7, 2.0**5
REGISTRY = pint.UnitRegistry()
# Their points lie in files, in units of their own.
FROM_FILES = {"vhfm/fan", "heat/heat_sink", "soil/terrain"}
# Built for long.
LARGE = {"pd/thermals", "vhfm/sphere"}
STEPS = 4


def factor(unit: str) -> float:
    if unit in ("", "cells", "degree", "K"):
        return 1.0
    powers = REGISTRY.parse_units(unit).dimensionality
    return float(
        LENGTH ** powers.get("[length]", 0)
        * MASS ** powers.get("[mass]", 0)
        * TIME ** powers.get("[time]", 0)
    )


def converted(value: object, unit: str) -> object:
    if isinstance(value, lp.Table):
        scale = factor(unit)
        return lp.Table([t * TIME for t in value.times], [v * scale for v in value.values])
    if isinstance(value, bool) or not isinstance(value, (int, float, list, tuple)):
        return in_other_units(value) if hasattr(type(value), "__signature__") else value
    if isinstance(value, (int, float)):
        scale = factor(unit)
        return value if scale == 1.0 else value * scale
    if unit in ("J/(kg K)", "W/(m K)"):  # a table over the temperature
        temperatures, values = value
        return (temperatures, [entry * factor(unit) for entry in values])
    return type(value)([converted(entry, unit) for entry in value])


def in_other_units(made: object) -> object:
    kind = type(made)
    return kind(
        **{
            name: converted(getattr(made, name), _unit(kind, name))
            for name in kind.__signature__.parameters  # type: ignore[attr-defined]
            if name != "self"
        }
    )


def scenes() -> list[object]:
    return [
        pytest.param(name, marks=pytest.mark.slow if name in LARGE else ())
        for name in examples.names()
        if name not in FROM_FILES
    ]


@pytest.mark.parametrize("name", scenes())
def test_an_example_in_other_units(name: str) -> None:
    scene = examples.load(name)
    here, there = lp.Simulation(scene), lp.Simulation(in_other_units(scene))
    for _ in range(STEPS):
        if here.time < here.end * (1 - 1e-12):
            here.step()
            there.step()
    assert there.time == pytest.approx(here.time * TIME, rel=1e-13)
    for field in here.fields:
        one, other = np.asarray(here.by_id(field)), np.asarray(there.by_id(field))
        size, scaled = np.linalg.norm(one), np.linalg.norm(other)
        assert (size == 0) == (scaled == 0), field
        if size > 0:
            assert np.linalg.norm(one / size - other / scaled) < 1e-12, field
