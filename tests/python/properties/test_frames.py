"""How often somebody looks at heat that moves must not matter to it."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli.reproduce.case import example

sys.path.insert(0, str(Path(__file__).parent))
from test_coarse_flow import cavity

sys.path.pop(0)


def conduction() -> lp.Scene:
    scene = cavity(16, 1e4)
    assert scene.peridynamics is not None
    scene.peridynamics.flow = None
    scene.bodies[0].material = scene.bodies[0].material[:1]
    return scene


def after_frames(scene: lp.Scene, frames: int) -> tuple[float, lp.Simulation]:
    """Heat that came in until the end, J; and the simulation there."""
    simulation = lp.Simulation(scene)
    for k in range(1, frames + 1):
        simulation.run_until(scene.time.end * k / frames)
    # What a cavity gives back at its cold side would hide what comes in.
    entries = simulation.balance()[0].entries
    return sum(max(heat, 0.0) for heat in entries.values()), simulation


@pytest.mark.parametrize(
    ("scene", "bar"),
    [
        (conduction, 2e-4),  # found 8e-5: a step is a fifth of the time between frames
        (lambda: cavity(12, 1e3), 1e-4),  # 1.1e-5
        (lambda: cavity(16, 1e4), 5e-4),  # 1.2e-4: points of a flow soon part
        (lambda: example("vhfm/swirl"), 2e-4),  # 1.0e-4
    ],
    ids=["conduction", "flow", "strong flow", "swirl"],
)
def test_frames_do_not_change_the_heat(scene, bar: float) -> None:
    alone = after_frames(scene(), 1)[0]
    for frames in (7, 50):
        assert after_frames(scene(), frames)[0] == pytest.approx(alone, rel=bar)


def test_a_sheared_disc_keeps_its_field_however_often_it_is_looked_at() -> None:
    """Steps of one size up to a frame: the same bytes where frames divide the steps there are;
    cut ones moved the field by 2.8e-4."""
    fields = [
        np.array(after_frames(example("vhfm/swirl"), frames)[1].by_id("temperature"))
        for frames in (1, 7, 50)
    ]
    assert np.abs(fields[1] - fields[0]).max() < 1e-12
    assert np.sqrt(np.mean((fields[2] - fields[0]) ** 2)) < 1e-4
