"""Closed forms of elasticity: equilibrium, Hooke's law, boundary values, energy, limits."""

import numpy as np
import pytest

from lapilli.references.elastic import Annulus, Elastic, SelfWeightColumn, contained_block

STEEL = Elastic(young=1000.0, poisson=0.3)


def test_moduli():
    # M = 1346.15, G = 384.6 for E = 1000, nu = 0.3
    assert STEEL.confined == pytest.approx(1346.1538461538, rel=1e-12)
    assert STEEL.shear == pytest.approx(384.6153846154, rel=1e-12)
    assert STEEL.confined - STEEL.lame == pytest.approx(2 * STEEL.shear)
    assert Elastic(young=5.0, poisson=0.0).confined == pytest.approx(5.0)
    with pytest.raises(ValueError, match=r"poisson < 0\.5"):
        Elastic(young=1.0, poisson=0.5)


@pytest.mark.parametrize(
    "annulus",
    [
        Annulus.under_pressure(1.0, 3.0, inner_pressure=2.0, outer_pressure=0.5, material=STEEL),
        Annulus.under_displacement(12.0, 40.0, inner_displacement=0.01, material=STEEL),
    ],
)
def test_annulus_is_in_equilibrium_and_obeys_hooke(annulus):
    # central differences of fourth order: truncation below 1e-9 of the stress
    r = np.linspace(annulus.inner * 1.1, annulus.outer * 0.95, 20)
    h = 1e-3 * annulus.inner
    weights = np.array([1, -8, 0, 8, -1]) / (12 * h)
    around = [annulus.at(r + k * h) for k in range(-2, 3)]
    state = annulus.at(r)
    slope = sum(w * s.radial for w, s in zip(weights, around, strict=True))
    scale = np.max(np.abs(state.hoop)) / annulus.inner
    assert slope + (state.radial - state.hoop) / r == pytest.approx(0, abs=1e-8 * scale)
    radial_strain = sum(w * s.displacement for w, s in zip(weights, around, strict=True))
    hoop_strain = state.displacement / r
    matrix = STEEL.plane_strain()
    expected = matrix[:2, :2] @ np.stack([radial_strain, hoop_strain])
    assert state.radial == pytest.approx(expected[0], abs=1e-8 * np.abs(expected).max())
    assert state.hoop == pytest.approx(expected[1], abs=1e-8 * np.abs(expected).max())
    assert state.axial == pytest.approx(STEEL.poisson * (state.radial + state.hoop))


def test_pressures_are_met():
    ends = Annulus.under_pressure(
        1.0, 3.0, inner_pressure=2.0, outer_pressure=0.5, material=STEEL
    ).at([1.0, 3.0])
    assert ends.radial == pytest.approx([-2.0, -0.5])
    uniform = Annulus.under_pressure(
        1.0, 3.0, inner_pressure=2.0, outer_pressure=2.0, material=STEEL
    ).at(2.0)
    assert (uniform.radial, uniform.hoop) == (pytest.approx(-2.0), pytest.approx(-2.0))


def test_thin_cylinder_limit():
    # hoop = p R/t to relative order t/R = 1e-3
    thin = Annulus.under_pressure(1.0, 1.001, inner_pressure=1.0, material=STEEL).at(1.0)
    assert float(thin.hoop) == pytest.approx(1000.0, rel=2e-3)


def test_displacements_are_met_and_match_the_pressures():
    annulus = Annulus.under_displacement(12.0, 40.0, inner_displacement=0.01, material=STEEL)
    ends = annulus.at([12.0, 40.0])
    assert ends.displacement == pytest.approx([0.01, 0.0], abs=1e-17)
    same = Annulus.under_pressure(
        12.0,
        40.0,
        inner_pressure=-float(ends.radial[0]),
        outer_pressure=-float(ends.radial[1]),
        material=STEEL,
    )
    assert same.stretch == pytest.approx(annulus.stretch)
    assert same.ring == pytest.approx(annulus.ring)


def test_energy_is_the_integral_of_its_density():
    annulus = Annulus.under_displacement(12.0, 40.0, inner_displacement=0.01, material=STEEL)
    nodes, weights = np.polynomial.legendre.leggauss(60)
    r = 26.0 + 14.0 * nodes
    state = annulus.at(r)
    radial_strain = annulus.stretch - annulus.ring / r**2
    density = 0.5 * (state.radial * radial_strain + state.hoop * state.displacement / r)
    assert annulus.strain_energy() == pytest.approx(14.0 * weights @ (2 * np.pi * r * density))


def test_column_under_its_weight():
    column = SelfWeightColumn(height=100.0, weight=1e-3, material=STEEL)
    y = np.linspace(0, 100, 21)
    h = 1e-2
    strain = (column.displacement(y + h) - column.displacement(y - h)) / (2 * h)
    assert STEEL.confined * strain == pytest.approx(column.vertical_stress(y), abs=1e-12)
    assert float(column.displacement(0.0)) == 0.0
    assert float(column.vertical_stress(0.0)) == pytest.approx(-0.1)  # all the weight
    assert column.lateral_stress(y) == pytest.approx(column.vertical_stress(y) * 3 / 7)
    nodes, weights = np.polynomial.legendre.leggauss(4)
    work = 50 * weights @ (-1e-3 * column.displacement(50 + 50 * nodes))
    assert column.compliance() == pytest.approx(work)
    # the notes on implicit boundaries state b^2 L^4/(3 M) for the square of side L = 100
    assert column.compliance(100.0) == pytest.approx(1e-6 * 1e8 / (3 * STEEL.confined))


def test_contained_block():
    # implicit boundaries, section 5.1: 1 of 100, s_nn = 13.461538, s_tt = 5.769231
    normal, transverse, shear = contained_block(1.0, 100.0, STEEL)
    assert (normal, transverse) == (
        pytest.approx(13.461538, abs=5e-7),
        pytest.approx(5.769231, abs=5e-7),
    )
    assert shear == 0.0
