"""What hits a face of the grid, an obstacle or another body gains no energy."""

from __future__ import annotations

from typing import Any

import pytest

import lapilli as lp

SPEED = 3.0  # m/s, .03 of the wave speed


def gained(transfer: dict[str, Any], kind: str, askew: float = 0.5) -> float:
    """Energy that nothing put in, over the largest, of an elastic block that is thrown down."""
    floors: dict[str, dict[str, Any]] = {
        "face": {"grid_boundaries": [lp.FrictionalBoundary(face="y_lower", coefficient=0.5)]},
        "obstacle": {
            "obstacles": [
                lp.Obstacle(shape=lp.HalfSpace(point=(0, 0), normal=(0, 1)), friction=0.5)
            ]
        },
    }
    scene = lp.Scene(
        grid=lp.Grid(lower=(-10, 0 if kind == "face" else -10), upper=(30, 30), cell=1),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(4.37, 1.21), upper=(10.37, 9.21)),
                material=[lp.Elastic(density=1, youngs_modulus=1e4, poissons_ratio=0.3)],
                velocity=(askew * SPEED, -SPEED),
            )
        ],
        dynamics=lp.Dynamics(gravity=(0, -1), **transfer, **floors[kind]),
        time=lp.Time(end=0.8),
    )
    simulation = lp.Simulation(scene)
    largest = most = 0.0
    for k in range(1, 17):
        simulation.run_until(0.05 * k)
        now = simulation.diagnostics()
        largest = max(largest, now["dynamics/kinetic_energy"] + now["dynamics/elastic_energy"])
        most = max(most, now["dynamics/energy_gained"])
    return most / largest


@pytest.mark.parametrize("kind", ["face", "obstacle"])
@pytest.mark.parametrize(
    "transfer",
    [{}, {"transfer": "flip", "pic_fraction": 0.0}, {"transfer": "apic"}],
    ids=["blended_apic", "flip", "apic"],
)
def test_an_impact_gains_no_energy(transfer: dict[str, Any], kind: str) -> None:
    """MUSL let the strain part from a frictional face that the nodes press: 2.8 % (flip 50 %)."""
    assert gained(transfer, kind) < 0.005


@pytest.mark.parametrize("askew", [0.0, 2.0])
def test_nor_does_one_straight_on_or_grazing(askew: float) -> None:
    assert gained({}, "face", askew) < 0.005
