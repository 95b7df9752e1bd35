"""Semi-infinite rod x >= 0, uniform at first, heated through its end x = 0.

Source: Yu & Zhao 2026 (virtual heat flux method), section 4.1 and appendix A; the same solutions
stand in Carslaw & Jaeger, Conduction of Heat in Solids, 2nd ed., sections 2.7 and 2.9.
Corrected: the Laplace transforms A6, A7 and A12 carry sqrt(alpha) in the wrong place; the results
A8 (= Eq. 41) and A13 (= Eq. 42) are right. A13 is a product of exp(large) and erfc(large), which
overflows for large x or t; here it is written with the scaled erfcx(s) = exp(s^2) erfc(s).
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.special import erfc, erfcx, gamma

from lapilli.references.arrays import Array, Times, as_array, at_times
from lapilli.references.thermal import UNIT_MEDIUM, Medium

LARGEST_SIMILARITY = 1e100  # beyond it erfc is 0 for long, and inf * 0 must not appear


def constant_flux(
    x: npt.ArrayLike,
    t: Times,
    *,
    flux: float = 1.0,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> Array:
    """Temperature under a constant inward flux at x = 0 (Eq. A8).

    x: distance from the heated end, any shape S, m. t: one time or n times, s.
    flux: W/m^2, positive heats. Returns shape S or (n, *S), K.
    """
    x = _distance(x)

    def field(time: float) -> Array:
        if time == 0:
            return np.full(x.shape, initial)
        reach = np.sqrt(medium.diffusivity * time)
        z = _similarity(x, reach)
        # 2 q sqrt(alpha t)/kappa ierfc(z), with ierfc(z) = exp(-z^2) (1/sqrt(pi) - z erfcx(z))
        ierfc = np.exp(-(z**2)) * (1 / np.sqrt(np.pi) - z * erfcx(z))
        return as_array(initial + 2 * flux * reach / medium.conductivity * ierfc)

    return at_times(field, t)


def convection(
    x: npt.ArrayLike,
    t: Times,
    *,
    coefficient: float = 1.0,
    ambient: float = 1.0,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> Array:
    """Temperature with convection coefficient (ambient - T) into the end x = 0 (Eq. A13).

    Shapes and units as in constant_flux; coefficient in W/(m^2 K). Never overflows.
    """
    x = _distance(x)

    def field(time: float) -> Array:
        if time == 0:
            return np.full(x.shape, initial)
        reach = np.sqrt(medium.diffusivity * time)
        z = _similarity(x, reach)
        b = coefficient * reach / medium.conductivity
        # A13 with exp(2 z b + b^2) erfc(z + b) = exp(-z^2) erfcx(z + b)
        share = erfc(z) - np.exp(-(z**2)) * erfcx(z + b)
        return as_array(initial + (ambient - initial) * share)

    return at_times(field, t)


def convective_intake(
    t: Times,
    *,
    coefficient: float = 1.0,
    ambient: float = 1.0,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> Array:
    """Heat taken in per area of the end until t, J/m^2: the time integral of the convective flux.

    With b = coefficient sqrt(alpha t)/kappa the integral of Eq. A13 at x = 0 is
    (ambient - initial) rho c kappa/coefficient (erfcx(b) - 1 + 2 b/sqrt(pi)); the bracket is
    summed as a series for b < 1/2, where its terms cancel.
    """

    def intake(time: float) -> Array:
        if coefficient == 0:
            return as_array(0.0)
        b = coefficient * np.sqrt(medium.diffusivity * time) / medium.conductivity
        if b < 0.5:
            n = np.arange(2, 40)
            bracket = np.sum((-b) ** n / gamma(n / 2 + 1))
        else:
            bracket = erfcx(b) - 1 + 2 * b / np.sqrt(np.pi)
        scale = medium.capacity * medium.conductivity / coefficient
        return as_array((ambient - initial) * scale * bracket)

    return at_times(intake, t)


def _distance(x: npt.ArrayLike) -> Array:
    x = as_array(x)
    if np.any(x < 0):
        raise ValueError(f"x must not be negative (the rod is x >= 0), got {x.min()}")
    return x


def _similarity(x: Array, reach: float) -> Array:
    return np.minimum(x / (2 * reach), LARGEST_SIMILARITY)
