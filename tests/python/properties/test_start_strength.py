"""Soil that starts with the stress of its weight starts within its strength, or says so."""

from __future__ import annotations

import json

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core

G = 9.81


def ground(material: object, geostatic: lp.Geostatic, end: float = 0.2) -> lp.Scene:
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1, 5), cell=0.25),
        bodies=[
            lp.Body(
                name="clay",
                shape=lp.Box(lower=(0, 0), upper=(1, 4)),
                material=[material],
                geostatic=geostatic,
            )
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -G),
            grid_boundaries=[
                lp.RollerBoundary(face=face) for face in ("x_lower", "x_upper", "y_lower")
            ],
        ),
        time=lp.Time(end=end),
    )


def soil(angle: float, cohesion: float) -> lp.MohrCoulomb:
    return lp.MohrCoulomb(
        density=2000,
        youngs_modulus=1e7,
        poissons_ratio=0.3,
        friction_angle=angle,
        cohesion=cohesion,
    )


def fastest(scene: lp.Scene) -> tuple[float, lp.Result]:
    result = lp.run(scene, progress=False)
    return float(result.history["velocity/largest"].max()), result


@pytest.mark.parametrize("seed", range(6))
def test_ground_rests_whatever_its_strength_and_k0(seed: int) -> None:
    drawn = np.random.default_rng(seed)
    angle, cohesion = drawn.uniform(0, 40), drawn.choice([0.0, 2e3, 20e3])
    if angle < 5 and cohesion == 0.0:
        cohesion = 2e3
    k0 = drawn.choice([0.1, 0.5, 1.0, 3.0])
    speed, result = fastest(ground(soil(angle, cohesion), lp.Geostatic(k0=k0)))
    assert speed < 2e-3
    tangent = np.tan(np.radians(45 + angle / 2))
    deepest = 2000 * G * 3.9375
    least = (deepest - 2 * cohesion * tangent) / tangent**2 / deepest
    most = tangent**2 + 2 * cohesion * tangent / deepest
    said = "more than the strength of body 'clay' bears" in result.report()
    outside = k0 < least * 0.99 or k0 > most * 1.01
    assert said or not outside
    if least * 1.01 < k0 < most * 0.99:
        shallow_too = k0 * 1.01 < tangent**2 and k0 > 1.01 / tangent**2
        assert not said or not shallow_too


def test_the_note_tells_what_is_borne() -> None:
    """Clay of 5 kPa bears sigma_h = sigma_v +- 2 c."""
    scene = ground(soil(0, 5e3), lp.Geostatic())
    notes = [
        note
        for note in json.loads(_core.check_json(scene))["notes"]
        if "geostatic k0 = 0.5" in note
    ]
    assert len(notes) == 1
    words = notes[0].split(" it bears ")[1].split()
    deepest = 2000 * G * 3.9375
    assert float(words[0]) == pytest.approx(1 - 10e3 / deepest, abs=2e-3)
    assert float(words[2].rstrip(",")) == pytest.approx(1 + 10e3 / deepest, abs=2e-3)
    speed, result = fastest(scene)
    assert speed < 2e-3
    assert notes[0] in result.report()


def test_a_slope_that_no_k0_holds_says_so() -> None:
    slope = lp.Geostatic(surface=(0, 4), normal=(0.6, 0.8))
    notes = json.loads(_core.check_json(ground(soil(20, 0.0), slope)))["notes"]
    assert any("it bears none" in note for note in notes)
