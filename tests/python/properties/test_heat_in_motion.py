"""Surfaces of bodies that may deform exchange as those of bodies at rest, from weak to held."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import j0, j1, jn_zeros

import lapilli as lp


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


def given_off(biot: float, fourier: float, cells: int) -> tuple[float, float]:
    """Heat that an elastic disk has lost, over all it can lose; its least temperature."""
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
    simulation = lp.Simulation(
        lp.Scene(
            grid=lp.Grid(lower=(-reach, -reach), upper=(reach, reach), cell=cell),
            bodies=[body],
            heat=lp.Heat(boundaries=[law]),
            dynamics=lp.Dynamics(),
            time=lp.Time(end=fourier),
        )
    )
    simulation.run_until(fourier)
    temperature = simulation["temperature"]
    left = np.average(temperature, weights=simulation["volume"])
    return float(1 - left), float(temperature.min())


@pytest.mark.parametrize("biot", [0.3, 3.0, 30.0, 300.0, np.inf])
@pytest.mark.parametrize("fourier", [0.05, 0.2])
def test_a_deforming_disk_gives_off_its_heat(biot: float, fourier: float) -> None:
    # Found .65 % at most; at 300 on the nodes themselves 10.8 and 4 %. What strays below the
    # surroundings is 3 % of the range where the surface is held, early.
    found, least = given_off(biot, fourier, 12)
    assert found == pytest.approx(1 - mean_left(biot, fourier), rel=0.015)
    assert least > -0.05
