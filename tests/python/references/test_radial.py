"""The Galerkin solution in r: closed forms, heat balance, steady states, its own error estimate."""

import itertools

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import j0, j1, jn_zeros

from lapilli.references import rod
from lapilli.references.radial import RadialProblem, RadialSolution
from lapilli.references.thermal import Convection, Flux, Insulated, Medium, Prescribed

HEATED = Flux(inward=1.0)
AIR = Convection(coefficient=1.0, ambient=1.0)
STONE = Medium(density=2.0, specific_heat=3.0, conductivity=0.5)


def roots_between(function, poles):
    return np.array(
        [brentq(function, a + 1e-9, b - 1e-9, xtol=1e-14) for a, b in itertools.pairwise(poles)]
    )


def test_cooling_sphere_against_its_series():
    # beta cot(beta) = 1 - Bi (Carslaw & Jaeger, section 9.4); 60 terms are exact for t >= 0.1
    radius, biot, r = 5.0, 5.0, np.linspace(1e-6, 5, 80)
    beta = roots_between(lambda b: b * np.cos(b) - (1 - biot) * np.sin(b), np.pi * np.arange(61))
    amplitude = 4 * (np.sin(beta) - beta * np.cos(beta)) / (2 * beta - np.sin(2 * beta))
    shapes = np.sinc(np.outer(r / radius, beta) / np.pi)
    solution = RadialSolution(
        RadialProblem(
            inner=0,
            outer=radius,
            dimension=3,
            at_outer=Convection(coefficient=1.0, ambient=0.0),
            initial=100.0,
        )
    )
    for t in (0.1, 0.5, 1.0, 2.0, 5.0, 10.0):
        series = 100 * shapes @ (amplitude * np.exp(-(beta**2) * t / radius**2))
        assert solution.temperature(r, t) == pytest.approx(series, abs=1e-7)  # 1e-9 of the span


def test_disc_against_its_bessel_series():
    # beta J1(beta) = Bi J0(beta) (Carslaw & Jaeger, section 7.7)
    radius, biot, r = 2.0, 2.0, np.linspace(0, 2, 50)
    poles = np.concatenate([[0.0], jn_zeros(1, 50)])
    beta = roots_between(lambda b: b * j1(b) - biot * j0(b), poles)
    amplitude = 2 * biot / ((beta**2 + biot**2) * j0(beta))
    solution = RadialSolution(RadialProblem(inner=0, outer=radius, dimension=2, at_outer=AIR))
    for t in (0.1, 1.0, 6.0):
        series = 1 - j0(np.outer(r / radius, beta)) @ (
            amplitude * np.exp(-(beta**2) * t / radius**2)
        )
        assert solution.temperature(r, t) == pytest.approx(series, abs=1e-9)


def test_thick_slab_is_a_rod():
    x = np.linspace(0, 5, 60)
    for boundary, exact in ((HEATED, rod.constant_flux), (AIR, rod.convection)):
        solution = RadialSolution(
            RadialProblem(inner=0, outer=20, dimension=1, at_inner=boundary), degree=128
        )
        for t in (0.1, 0.5, 2.5):
            assert solution.temperature(x, t) == pytest.approx(exact(x, t), abs=1e-8)


@pytest.mark.parametrize("dimension", [1, 2, 3])
@pytest.mark.parametrize(
    ("at_inner", "at_outer"),
    [
        (HEATED, HEATED),
        (AIR, AIR),
        (Insulated(), Flux(inward=-2.0)),
        (Prescribed(temperature=2.0), AIR),
        (Prescribed(temperature=2.0), Prescribed(temperature=-1.0)),
        (HEATED, Prescribed(temperature=-1.0)),
    ],
)
def test_stored_heat_is_what_came_in(dimension, at_inner, at_outer):
    solution = RadialSolution(
        RadialProblem(
            inner=1,
            outer=5,
            dimension=dimension,
            at_inner=at_inner,
            at_outer=at_outer,
            initial=lambda r: np.cos(r),
            medium=STONE,
        )
    )
    t = np.array([0.0, 1e-3, 0.1, 1.0, 10.0])
    balance = solution.heat_content(t) - solution.heat_content(0.0)
    taken = solution.heat_taken_in(t).sum(axis=1)
    scale = np.abs(solution.heat_taken_in(t)).max() + np.abs(solution.heat_content(t)).max()
    assert np.max(np.abs(balance - taken)) < 1e-10 * scale


def test_taken_heat_is_the_integral_of_the_flux():
    # independent of the balance: the wall flux -kappa dT/dr is integrated over time by Gauss
    problem = RadialProblem(
        inner=1,
        outer=5,
        dimension=2,
        at_inner=Prescribed(temperature=1.0),
        at_outer=AIR,
    )
    solution = RadialSolution(problem)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    start, end = 0.5, 2.0
    t = 0.5 * (start + end) + 0.5 * (end - start) * nodes
    flux = solution.flux([1.0, 5.0], t) * [problem.area(1.0), -problem.area(5.0)]
    integral = 0.5 * (end - start) * weights @ flux
    taken = solution.heat_taken_in([start, end])
    assert taken[1] - taken[0] == pytest.approx(integral, rel=1e-7)


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_steady_states(dimension):
    # harmonic in d dimensions: r, log r, -1/r
    harmonic = {1: lambda r: r, 2: np.log, 3: lambda r: -1 / r}[dimension]
    r = np.linspace(1, 5, 30)
    profile = (harmonic(r) - harmonic(1.0)) / (harmonic(5.0) - harmonic(1.0))
    solution = RadialSolution(
        RadialProblem(
            inner=1,
            outer=5,
            dimension=dimension,
            at_inner=Prescribed(temperature=2.0),
            at_outer=Prescribed(temperature=7.0),
        )
    )
    assert solution.temperature(r, 1e4) == pytest.approx(2 + 5 * profile, abs=1e-9)


def test_constant_flux_ring_becomes_quasi_steady():
    # the mean rises at q (perimeter)/(area) = 12 pi/(24 pi) and the profile no longer changes
    solution = RadialSolution(
        RadialProblem(inner=1, outer=5, dimension=2, at_inner=HEATED, at_outer=HEATED)
    )
    r = np.linspace(1, 5, 30)
    late, later = solution.temperature(r, [200.0, 300.0])
    assert later - late == pytest.approx(np.full(30, 50.0), abs=1e-8)
    assert float(solution.mean_temperature(8.0)) == pytest.approx(4.0, rel=1e-10)


def test_smooth_start_is_resolved_at_once():
    # a cosine of a slab decays by itself: exp(-(pi/2)^2 t)
    x = np.linspace(0, 2, 40)
    solution = RadialSolution(
        RadialProblem(inner=0, outer=2, dimension=1, initial=lambda x: np.cos(np.pi * x / 2))
    )
    for t in (1e-6, 0.3):
        exact = np.cos(np.pi * x / 2) * np.exp(-((np.pi / 2) ** 2) * t)
        assert solution.temperature(x, t) == pytest.approx(exact, abs=1e-10)


@pytest.mark.parametrize("boundary", [HEATED, AIR, Prescribed(temperature=1.0)])
def test_default_error_of_the_ring_is_below_1e_7(boundary):
    solution = RadialSolution(
        RadialProblem(inner=1, outer=5, dimension=2, at_inner=boundary, at_outer=boundary)
    )
    assert solution.estimated_error([0.01, 0.1, 1.0, 2.5, 10.0]) < 1e-7


def test_error_falls_exponentially_with_the_degree():
    problem = RadialProblem(inner=1, outer=5, dimension=2, at_inner=AIR, at_outer=AIR)
    r = np.linspace(1, 5, 100)
    best = RadialSolution(problem).temperature(r, 0.05)
    errors = [
        np.max(np.abs(RadialSolution(problem, degree).temperature(r, 0.05) - best))
        for degree in (12, 24, 48)
    ]
    assert errors[1] < errors[0] / 50
    assert errors[2] < errors[1] / 1000


def test_shapes_and_refusals():
    problem = RadialProblem(inner=1, outer=5, dimension=2, initial=3.0)
    solution = RadialSolution(problem)
    assert solution.temperature(np.ones((4, 2)), [0.0, 1.0]).shape == (2, 4, 2)
    assert np.all(solution.temperature([1.0, 5.0], 0.0) == 3.0)
    with pytest.raises(ValueError, match=r"radii must lie in \[1, 5\]"):
        solution.temperature(0.5, 1.0)
    with pytest.raises(ValueError, match="dimension must be 1, 2 or 3, got 4"):
        RadialProblem(inner=1, outer=5, dimension=4)
    with pytest.raises(ValueError, match="the centre r = 0 has no surface"):
        RadialProblem(inner=0, outer=5, dimension=2, at_inner=AIR)
    with pytest.raises(ValueError, match="need 0 <= inner < outer"):
        RadialProblem(inner=5, outer=1, dimension=2)
