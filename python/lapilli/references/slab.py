"""Slab series and their products: slab, rectangle, square and cube.

A body with convection on all faces, uniform start and one ambient temperature: the dimensionless
temperature (T - ambient)/(initial - ambient) of a box is the product of those of its slabs
(Carslaw & Jaeger, Conduction of Heat in Solids, 2nd ed., sections 1.15, 3.11 and 5.6). It serves
the square of Yu & Zhao 2026, section 4.4 (whose "side 5 m" is the HALF side), for which the paper
states no solution. Series for late times, sums of semi-infinite solutions for early ones; both are
exact to rounding where they meet.

Also the slab with two prescribed faces (Crank 1975, Mathematics of Diffusion, section 4.3), the
conduction case of Yang et al., multi-horizon peridynamics, Eq. 41 (where the exponent reads
rho_c^2 for rho c).
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.special import erfc

from lapilli.references import rod
from lapilli.references.arrays import Array, Times, as_array, at_times
from lapilli.references.thermal import UNIT_MEDIUM, Medium

EARLY = 0.02  # alpha t / a^2 below which the far face is not felt: erfc(1/sqrt(0.02)) = 1.5e-23
TERMS = 24  # at EARLY the term of the last root is exp(-0.02 (23 pi)^2) = 3e-46


def convective_roots(biot: float, count: int) -> Array:
    """First positive roots of beta tan(beta) = biot, shape (count,).

    Root n lies in (n pi, n pi + pi/2): bisection there, then Newton steps, on the form
    beta sin(offset) - biot cos(offset), offset = beta - n pi, which rises through its one root.
    """
    if not 0 < biot < float("inf"):
        raise ValueError(f"the Biot number must be positive and finite, got {biot}")
    turns = np.pi * np.arange(count)
    low, high = np.zeros(count), np.full(count, np.pi / 2)
    for _ in range(60):
        middle = 0.5 * (low + high)
        above = (turns + middle) * np.sin(middle) > biot * np.cos(middle)
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    offset = 0.5 * (low + high)
    for _ in range(3):
        value = (turns + offset) * np.sin(offset) - biot * np.cos(offset)
        slope = (1 + biot) * np.sin(offset) + (turns + offset) * np.cos(offset)
        offset = offset - value / slope
    return as_array(turns + offset)


def convective_slab(
    x: npt.ArrayLike,
    t: Times,
    *,
    half_thickness: float,
    coefficient: float = 1.0,
    ambient: float = 1.0,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> Array:
    """Temperature of a slab |x| <= half_thickness with the same convection on both faces.

    x: distance from the middle plane, any shape S, m. Returns shape S or (n, *S), K.
    """
    x = _inside(x, half_thickness)

    def field(time: float) -> Array:
        share = _remaining(x, time, half_thickness, coefficient, medium)
        return ambient + (initial - ambient) * share

    return at_times(field, t)


def convective_box(
    points: npt.ArrayLike,
    t: Times,
    *,
    half_widths: npt.ArrayLike,
    coefficient: float = 1.0,
    ambient: float = 1.0,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> Array:
    """Temperature of a rectangle or a box |x_k| <= half_widths[k], convection on all faces.

    points: (..., d) in the axes of the box, from its centre, m. half_widths: (d,) or one number.
    Returns shape (...) or (n, ...), K.
    """
    points = as_array(points)
    widths = np.broadcast_to(as_array(half_widths), points.shape[-1:])

    def field(time: float) -> Array:
        share = np.ones(points.shape[:-1])
        for axis, width in enumerate(widths):
            x = _inside(points[..., axis], float(width))
            share = share * _remaining(x, time, float(width), coefficient, medium)
        return ambient + (initial - ambient) * share

    return at_times(field, t)


def convective_box_mean(
    t: Times,
    *,
    half_widths: npt.ArrayLike,
    coefficient: float = 1.0,
    ambient: float = 1.0,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> Array:
    """Volume mean of the temperature of the box (a slab for one half width), K.

    half_widths: (d,). Times the heat capacity of the box it is the heat content.
    """
    widths = np.atleast_1d(as_array(half_widths))

    def mean(time: float) -> Array:
        share = 1.0
        for width in widths:
            share *= _mean_remaining(time, float(width), coefficient, medium)
        return as_array(ambient + (initial - ambient) * share)

    return at_times(mean, t)


def prescribed_slab(
    x: npt.ArrayLike,
    t: Times,
    *,
    thickness: float = 1.0,
    left: float = 1.0,
    right: float = 0.0,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> Array:
    """Temperature of a slab 0 <= x <= thickness whose faces are held at left and right.

    x: any shape S, m. Returns shape S or (n, *S), K. At t = 0 the initial value everywhere.
    Late: the sine series. Early: images, initial + (left - initial) (erfc(x/2s) - erfc((2l-x)/2s)
    + erfc((2l+x)/2s)) + the same from the right, s = sqrt(alpha t).
    """
    x = as_array(x)
    if np.any(x < 0) or np.any(x > thickness):
        raise ValueError(f"x must lie in [0, {thickness}], got [{x.min()}, {x.max()}]")

    def field(time: float) -> Array:
        if time == 0:
            return np.full(x.shape, initial)
        if medium.diffusivity * time < EARLY * thickness**2:
            reach = 2 * np.sqrt(medium.diffusivity * time)
            near_left, near_right = (
                _images(x, reach, thickness),
                _images(thickness - x, reach, thickness),
            )
            return initial + (left - initial) * near_left + (right - initial) * near_right
        result = left + (right - left) * x / thickness
        n = np.arange(1, 3 * TERMS)
        # integral of (initial - steady state) against sin(n pi x/l), times 2/l
        odd_even = (-1.0) ** n
        amplitude = 2 / (n * np.pi) * ((initial - left) - (initial - right) * odd_even)
        decay = np.exp(-medium.diffusivity * time * (n * np.pi / thickness) ** 2)
        return as_array(
            result + np.sin(np.multiply.outer(x, n * np.pi / thickness)) @ (amplitude * decay)
        )

    return at_times(field, t)


def _images(x: Array, reach: float, thickness: float) -> Array:
    return as_array(
        erfc(x / reach) - erfc((2 * thickness - x) / reach) + erfc((2 * thickness + x) / reach)
    )


def _inside(x: npt.ArrayLike, half_thickness: float) -> Array:
    x = as_array(x)
    if np.any(np.abs(x) > half_thickness * (1 + 1e-9)):
        raise ValueError(f"positions must lie within +-{half_thickness}, got {np.abs(x).max()}")
    return np.clip(x, -half_thickness, half_thickness)


def _remaining(x: Array, time: float, half: float, coefficient: float, medium: Medium) -> Array:
    """(T - ambient)/(initial - ambient) of the slab."""
    if coefficient == 0 or time == 0:
        return np.ones(x.shape)
    fourier = medium.diffusivity * time / half**2
    if fourier < EARLY:
        taken = rod.convection(half - x, time, coefficient=coefficient, medium=medium)
        return 1 - taken - rod.convection(half + x, time, coefficient=coefficient, medium=medium)
    roots = convective_roots(coefficient * half / medium.conductivity, TERMS)
    amplitude = 4 * np.sin(roots) / (2 * roots + np.sin(2 * roots))
    waves = np.cos(np.multiply.outer(x / half, roots))
    return as_array(waves @ (amplitude * np.exp(-(roots**2) * fourier)))


def _mean_remaining(time: float, half: float, coefficient: float, medium: Medium) -> float:
    """Mean over the slab of (T - ambient)/(initial - ambient)."""
    if coefficient == 0 or time == 0:
        return 1.0
    fourier = medium.diffusivity * time / half**2
    if fourier < EARLY:
        taken = rod.convective_intake(time, coefficient=coefficient, medium=medium)
        return 1 - float(taken) / (medium.capacity * half)
    roots = convective_roots(coefficient * half / medium.conductivity, TERMS)
    amplitude = 4 * np.sin(roots) ** 2 / (roots * (2 * roots + np.sin(2 * roots)))
    return float(np.sum(amplitude * np.exp(-(roots**2) * fourier)))
