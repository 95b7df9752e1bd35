"""Surfaces of bodies that may deform exchange as they should where convection is weak or they are
held; between, they say that they do not."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import j0, j1, jn_zeros

import lapilli as lp
from lapilli import _core


def mean_left(biot: float, fourier: float) -> float:
    """Mean excess temperature of a disk that cools, over that of its start."""
    if np.isinf(biot):
        roots = jn_zeros(0, 60)
        return float(np.sum(4 / roots**2 * np.exp(-(roots**2) * fourier)))
    at = np.linspace(1e-6, 190, 40_000)
    value = at * j1(at) - biot * j0(at)
    pairs = np.flatnonzero(value[1:] * value[:-1] < 0)[:60]
    roots = np.array([brentq(lambda x: x * j1(x) - biot * j0(x), at[k], at[k + 1]) for k in pairs])
    share = 4 * biot**2 / (roots**2 * (roots**2 + biot**2))
    return float(np.sum(share * np.exp(-(roots**2) * fourier)))


def cooling_disk(biot: float, fourier: float, cells: int, **more: object) -> lp.Scene:
    """An elastic disk."""
    cell = 1 / cells
    reach = cell * (cells + 4)
    law = (
        lp.PrescribedTemperature(value=0.0)
        if np.isinf(biot)
        else lp.Convection(coefficient=biot, ambient=0.0)
    )
    body = lp.Body(
        shape=lp.Disk(center=(0.31 * cell, 0.17 * cell), radius=1.0),
        material=[
            lp.Thermal(density=1, specific_heat=1, conductivity=1),
            lp.Elastic(density=1, youngs_modulus=100, poissons_ratio=0.3),
        ],
        temperature=1.0,
    )
    return lp.Scene(
        grid=lp.Grid(lower=(-reach, -reach), upper=(reach, reach), cell=cell),
        bodies=[body],
        heat=lp.Heat(boundaries=[law]),
        time=lp.Time(end=fourier),
        **({"dynamics": lp.Dynamics()} | more),
    )


@pytest.mark.parametrize("biot", [0.3, 3.0, np.inf])
@pytest.mark.parametrize("fourier", [0.05, 0.2])
def test_a_deforming_disk_gives_off_its_heat(biot: float, fourier: float) -> None:
    # Found .65 % at most.
    simulation = lp.Simulation(cooling_disk(biot, fourier, 12))
    simulation.run_until(fourier)
    left = np.average(simulation["temperature"], weights=simulation["volume"])
    assert 1 - left == pytest.approx(1 - mean_left(biot, fourier), rel=0.015)


def notes(scene: lp.Scene) -> list[str]:
    found = json.loads(_core.check_json(scene))["notes"]
    return [note for note in found if "times conductivity / cell" in note]


def test_convection_too_strong_for_the_cells_of_what_deforms_says_so() -> None:
    # 4.5 % at a Biot number of 30, 10.8 % at 300.
    for biot in (30.0, 300.0):
        (note,) = notes(cooling_disk(biot, 0.05, 12))
        assert f"its coefficient is {biot / 12:g} times" in note
    for scene in (
        cooling_disk(3.0, 0.05, 12),
        cooling_disk(np.inf, 0.05, 12),
        cooling_disk(300.0, 0.05, 12, dynamics=None),
    ):
        assert notes(scene) == []


def share_told(scene: lp.Scene) -> float:
    found = [re.search(r"up to ([0-9.]+) % too large", note) for note in notes(scene)]
    return max([float(one[1]) / 100 for one in found if one], default=0.0)


@pytest.mark.parametrize("strength", [0.25, 0.6, 1.0, 3.0, 10.0, 30.0])
@pytest.mark.parametrize("depth", [1.3, 2.0, 3.0])
def test_strong_convection_says_by_how_much_heat_is_too_large(
    strength: float, depth: float
) -> None:
    """Found 29 % where 4 to 11 were said, and 3 % at one conductivity / cell in silence."""
    scene = cooling_disk(12 * strength, (depth / 12) ** 2, 12)
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    given = 1 - np.average(simulation["temperature"], weights=simulation["volume"])
    off = given / (1 - mean_left(12 * strength, simulation.end)) - 1
    assert abs(off) < max(0.015, 1.4 * share_told(scene))


def test_strong_radiation_says_so_too() -> None:
    scene = cooling_disk(3.0, 0.05, 12)
    assert scene.heat is not None
    hot = lp.Radiation(ambient=1000.0, stefan_boltzmann=30.0 / 4e9)
    scene.heat = lp.Heat(boundaries=[hot], temperature_unit="kelvin")
    assert share_told(scene) > 0.03
