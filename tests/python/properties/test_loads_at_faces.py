"""Pressures on surfaces that end at held faces of the grid: the whole force, wherever the region
begins."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

SOIL = lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3)


def force_down(lower: tuple[float, ...], upper: tuple[float, ...], cell: float = 0.1) -> float:
    """N (per metre of depth in the plane) of 100 Pa on the top of a block between smooth sides."""
    dimension = len(lower)
    size = (1.0, 0.6, 0.8)[:dimension]
    faces = ["x_lower", "x_upper", "y_lower", "z_lower", "z_upper"][: 2 * dimension - 1]
    scene = lp.Scene(
        grid=lp.Grid(lower=(0,) * dimension, upper=(1.0, 1.2, 0.8)[:dimension], cell=cell),
        bodies=[lp.Body(shape=lp.Box(lower=(0,) * dimension, upper=size), material=SOIL)],
        dynamics=lp.Dynamics(
            boundaries=[lp.Pressure(value=100.0, region=lp.Box(lower=lower, upper=upper))],
            grid_boundaries=[lp.RollerBoundary(face=face) for face in faces],
        ),
        time=lp.Time(end=1e-3, steps=1),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(1e-3)
    momentum = next(one for one in simulation.balance() if one.quantity == "momentum y")
    return -dict(momentum.entries)["pressure 1"] / 1e-3


@pytest.mark.parametrize("ends", [(0, 0.5), (0, 1), (0.3, 1), (0.2, 0.7), (-1, 0.5), (-1, 2)])
@pytest.mark.parametrize("cell", [0.1, 0.05])
def test_a_pressure_from_a_held_face_has_its_whole_force(
    ends: tuple[float, float], cell: float
) -> None:
    width = min(ends[1], 1.0) - max(ends[0], 0.0)
    found = force_down((ends[0], 0.5), (ends[1], 0.7), cell)
    assert found == pytest.approx(100 * width, rel=1e-9)


def test_edges_of_regions_at_any_place_move_the_force_evenly() -> None:
    """Mirrored at the symmetry plane, what a region leaves is what its complement has."""
    for edge in np.random.default_rng(3).uniform(0.01, 0.99, 8):
        left = force_down((0, 0.5), (edge, 0.7))
        right = force_down((edge, 0.5), (1, 0.7))
        assert left + right == pytest.approx(100, rel=1e-9)
        assert left == pytest.approx(100 * edge, abs=0.5)


@pytest.mark.parametrize(("x", "z"), [(0.3, 0.3), (1.0, 0.8), (0.4, 0.8), (1.0, 0.2)])
def test_a_quarter_of_a_footing_has_a_quarter_of_its_force(x: float, z: float) -> None:
    found = force_down((0, 0.5, 0), (x, 0.7, z))
    assert found == pytest.approx(100 * x * z, rel=0.03)
