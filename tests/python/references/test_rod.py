"""The rod solutions satisfy their equation, their end condition, their start and one another."""

import numpy as np
import pytest

from lapilli.references import rod
from lapilli.references.thermal import Medium

STONE = Medium(density=2000.0, specific_heat=800.0, conductivity=2.5)


def residual_of_heat_equation(temperature, x, t, medium):
    """dT/dt - alpha d2T/dx2 by five-point differences, relative to the size of dT/dt."""
    alpha = medium.diffusivity
    dx = 0.01 * np.sqrt(alpha * t)
    dt = 1e-3 * t
    weights = np.array([1, -8, 0, 8, -1]) / 12
    rate = (
        sum(w * temperature(x, t + k * dt) for w, k in zip(weights, range(-2, 3), strict=True)) / dt
    )
    curve = np.array([-1, 16, -30, 16, -1]) / 12
    bend = (
        sum(w * temperature(x + k * dx, t) for w, k in zip(curve, range(-2, 3), strict=True))
        / dx**2
    )
    return np.max(np.abs(rate - alpha * bend)) / np.max(np.abs(rate))


@pytest.mark.parametrize("solution", [rod.constant_flux, rod.convection])
@pytest.mark.parametrize("medium", [Medium(), STONE])
def test_heat_equation_is_satisfied(solution, medium):
    # differences of fourth order with 1 % steps: error about 1e-8, rounding about 1e-10 / 1e-4
    t = 3.0 / medium.diffusivity
    x = np.linspace(0.1, 6.0, 50)
    residual = residual_of_heat_equation(
        lambda x, t: solution(x, t, initial=4.0, medium=medium), x, t, medium
    )
    assert residual < 1e-6


def test_end_flux_is_the_given_one():
    # one-sided fourth-order gradient at x = 0, step 1e-3: error about 1e-12 + rounding 1e-13/1e-3
    h = 1e-3
    weights = np.array([-25, 48, -36, 16, -3]) / (12 * h)
    x = h * np.arange(5)
    constant = rod.constant_flux(x, 0.7, flux=3.0)
    assert -weights @ constant == pytest.approx(3.0, abs=1e-9)
    convective = rod.convection(x, 0.7, coefficient=2.0, ambient=5.0, initial=1.0)
    assert -weights @ convective == pytest.approx(2.0 * (5.0 - convective[0]), abs=1e-9)


def test_surface_value_of_constant_flux():
    # Eq. A8 at x = 0: T = 2 q sqrt(alpha t/pi)/kappa
    t = np.array([0.1, 0.5, 1.0])
    assert rod.constant_flux(0.0, t) == pytest.approx(2 * np.sqrt(t / np.pi), rel=1e-15)


def test_scaled_form_equals_the_printed_one_where_that_is_finite():
    from scipy.special import erfc

    x, t = np.linspace(0, 5, 40), 1.3
    z, b = x / (2 * np.sqrt(t)), np.sqrt(t)
    printed = erfc(z) - np.exp(x + t) * erfc(z + b)
    assert rod.convection(x, t) == pytest.approx(printed, abs=1e-14)


def test_no_overflow_for_large_arguments():
    x = np.array([0.0, 1.0, 1e3, 1e9])
    with np.errstate(over="raise", invalid="raise", divide="raise"):
        far = rod.convection(x, [1e-12, 1.0, 1e6, 1e12], coefficient=1e4)
        hot = rod.constant_flux(x, [1e-12, 1.0, 1e6, 1e12])
    assert np.all(np.isfinite(far))
    assert np.all(np.isfinite(hot))
    assert np.all((far >= 0) & (far <= 1))


def test_strong_convection_becomes_a_prescribed_end():
    # T = Ta erfc(x / 2 sqrt(alpha t)) up to kappa/(gamma sqrt(alpha t)) = 1e-8
    from scipy.special import erfc

    x = np.linspace(0, 4, 30)
    assert rod.convection(x, 1.0, coefficient=1e8) == pytest.approx(erfc(x / 2), abs=1e-8)


def test_weak_convection_becomes_a_constant_flux():
    # the correction is of relative size coefficient sqrt(alpha t)/kappa = 1e-6
    x = np.linspace(0, 4, 30)
    weak = rod.convection(x, 1.0, coefficient=1e-6) / 1e-6
    assert weak == pytest.approx(rod.constant_flux(x, 1.0), abs=1e-6)


@pytest.mark.parametrize("coefficient", [1e-4, 0.3, 1.0, 40.0])
def test_stored_heat_is_what_came_in(coefficient):
    # Gauss quadrature of rho c T to a depth where T < 1e-30; intake from its own closed form
    t = 0.9
    nodes, weights = np.polynomial.legendre.leggauss(120)
    depth = 24.0
    x = 0.5 * depth * (nodes + 1)
    stored = 0.5 * depth * weights @ rod.convection(x, t, coefficient=coefficient)
    assert float(rod.convective_intake(t, coefficient=coefficient)) == pytest.approx(
        stored, rel=1e-11
    )
    stored = 0.5 * depth * weights @ rod.constant_flux(x, t, flux=2.0)
    assert stored == pytest.approx(2.0 * t, rel=1e-11)


def test_shapes_start_and_refusals():
    x = np.zeros((3, 2))
    assert rod.convection(x, 1.0).shape == (3, 2)
    assert rod.convection(x, [0.0, 1.0]).shape == (2, 3, 2)
    assert np.all(rod.convection(x, 0.0, initial=7.0) == 7.0)
    with pytest.raises(ValueError, match="x must not be negative"):
        rod.convection(-1.0, 1.0)
    with pytest.raises(ValueError, match="times must be finite and not negative"):
        rod.constant_flux(1.0, -1.0)
