"""Heat that has come less deep than the cells resolve is right or says so."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy.special import erfcx

import lapilli as lp
from lapilli import _core

CELL, WIDE, HIGH = 0.1, 2.02, 1.66


def box(strength: float, depth: float, seed: int) -> lp.Scene:
    """Exchange of so many conductivities / cell until heat is so many cells deep."""
    rng = np.random.default_rng(seed)
    start = -1.6 - rng.uniform(0, CELL, 2)
    law = (
        lp.Convection(name="all", coefficient=6.0 * strength / CELL, ambient=1.0)
        if np.isfinite(strength)
        else lp.PrescribedTemperature(name="all", value=1.0)
    )
    shape = lp.Box(lower=(-0.5 * WIDE, -0.5 * HIGH), upper=(0.5 * WIDE, 0.5 * HIGH))
    return lp.Scene(
        grid=lp.Grid(lower=tuple(start), upper=tuple(start + 33 * CELL), cell=CELL),
        bodies=[
            lp.Body(
                name="box",
                shape=lp.Rotated(shape=shape, degrees=rng.uniform(0, 90)),
                material=lp.Thermal(density=2.0, specific_heat=3.0, conductivity=6.0),
            )
        ],
        heat=lp.Heat(boundaries=[law]),
        time=lp.Time(end=(depth * CELL) ** 2),
    )


def off(scene: lp.Scene, strength: float) -> float:
    """Of the heat taken up, from a plane surface's less what corners have twice."""
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    root = np.sqrt(simulation.end)
    deep = 2 * root / np.sqrt(np.pi)
    if np.isfinite(strength):
        deep -= (1 - erfcx(strength / CELL * root)) * CELL / strength
    exact = 6.0 * (2 * (WIDE + HIGH) * deep - 4 * deep**2)
    return float(simulation.balance()[0].entries["all"] / exact - 1)


def notes(scene: lp.Scene) -> list[str]:
    found = json.loads(_core.check_json(scene))["notes"]
    return [note for note in found if "deep by time.end" in note]


@pytest.mark.parametrize("depth", [0.05, 0.2, 0.5, 0.8, 1.1, 1.5, 2.0])
@pytest.mark.parametrize("strength", [0.03, 0.2, 0.5, 2.0, 20.0, np.inf])
def test_it_is_right_or_says_so(strength: float, depth: float) -> None:
    """Found 69 % off, in silence."""
    scene = box(strength, depth, int(100 * depth))
    said = notes(scene)
    assert abs(off(scene, strength)) < 0.05 or len(said) == 1
    assert not said or depth < 1.3
    if said:
        assert "bodies.0 (box)" in said[0]
        assert f"{depth * CELL:.3g} m" in said[0]


def test_fluxes_are_right_however_short() -> None:
    scene = box(1.0, 0.1, 1)
    assert scene.heat is not None
    scene.heat.boundaries = [lp.Flux(name="all", value=1.0)]
    assert notes(scene) == []
