"""Stress of bodies that expand unevenly, wherever they lie, as stiff against volume as they are."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

E, EXPANSION, WARMTH = 1e6, 1e-5, 100.0  # Pa, 1/K, K at the centre


def material(ratio: float, expansion: float = EXPANSION) -> list[object]:
    return [
        lp.Elastic(density=1000, youngs_modulus=E, poissons_ratio=ratio),
        lp.ThermalExpansion(coefficient=expansion),
        lp.Thermal(density=1000, specific_heat=1, conductivity=2000),
    ]


def disk(cell: float, ratio: float, middle: np.ndarray, transfer: str) -> lp.Simulation:
    """A source inside, its edge held at zero: a temperature of WARMTH (1 - r^2), at rest."""
    scene = lp.Scene(
        grid=lp.Grid(lower=(-1.4, -1.4), upper=(1.4, 1.4), cell=cell),
        bodies=[
            lp.Body(
                name="disk",
                shape=lp.Disk(center=tuple(middle), radius=1),
                material=material(ratio),
                source=4 * 2000 * WARMTH,
            )
        ],
        heat=lp.Heat(boundaries=[lp.PrescribedTemperature(value=0)]),
        dynamics=lp.Dynamics(local_damping=0.5, transfer=transfer),
        time=lp.Time(end=1.5),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(1.5)
    return simulation


def error(simulation: lp.Simulation, ratio: float, middle: np.ndarray) -> float:
    """Of the radial stress in plane strain (Timoshenko & Goodier, article 151), root mean square
    over the volume, over the largest."""
    away = np.asarray(simulation.position) - middle
    radius = np.hypot(*away.T)
    normal = away / radius[:, None]
    xx, yy, xy = (simulation["stress"][:, k] for k in (0, 1, 3))
    radial = xx * normal[:, 0] ** 2 + yy * normal[:, 1] ** 2 + 2 * xy * normal.prod(axis=1)
    largest = EXPANSION * E * WARMTH / (4 * (1 - ratio))
    off = radial + largest * (1 - radius**2)
    return float(np.sqrt(np.average(off**2, weights=simulation["volume"]))) / largest


@pytest.mark.parametrize(("ratio", "transfer"), [(0.0, "blended_apic"), (0.3, "flip")])
def test_stress_converges_with_the_cell(ratio: float, transfer: str) -> None:
    """First order: the strain of a cell is one, that of the disk varies across it. Found .13 and
    .10 at ten cells to the radius, .077 and .057 at twenty."""
    middle = np.random.default_rng(5).uniform(-0.1, 0.1, 2)
    coarse, fine = (error(disk(h, ratio, middle, transfer), ratio, middle) for h in (0.1, 0.05))
    assert coarse < 0.2
    assert fine < 0.7 * coarse


@pytest.mark.parametrize("ratio", [0.35, 0.45, 0.49])
def test_stress_does_not_grow_with_stiffness_against_volume(ratio: float) -> None:
    """Found .14, .16 and .19; .23, .70 and 3.2 where each point has a free strain of its own."""
    middle = np.random.default_rng(int(100 * ratio)).uniform(-0.1, 0.1, 2)
    assert error(disk(0.1, ratio, middle, "blended_apic"), ratio, middle) < 0.25


@pytest.mark.parametrize("place", [0.5, 0.537])
def test_bodies_in_one_cell_keep_their_own(place: float) -> None:
    """Two layers between walls that hold all faces, one heat in both: along their face each has
    the stress of its own expansion, the rows of points in their common cells too."""
    expansions = (1e-5, 3e-5)
    faces = ("x_lower", "x_upper", "y_lower", "y_upper")
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1, 1), cell=0.1),
        bodies=[
            lp.Body(
                name=name,
                shape=lp.Box(lower=(lower, 0), upper=(upper, 1)),
                material=material(0.0, expansion),
                source=1e5,
            )
            for name, lower, upper, expansion in (
                ("one", 0.0, place, expansions[0]),
                ("other", place, 1.0, expansions[1]),
            )
        ],
        heat=lp.Heat(),
        dynamics=lp.Dynamics(
            local_damping=0.5, grid_boundaries=[lp.RollerBoundary(face=face) for face in faces]
        ),
        time=lp.Time(end=1.0),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(1.0)
    for body, expansion in enumerate(expansions):
        along = simulation["stress"][simulation["body"] == body, 1]
        np.testing.assert_allclose(along, -E * expansion * WARMTH, rtol=5e-3)
