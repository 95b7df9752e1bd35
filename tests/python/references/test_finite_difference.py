"""The paper's schemes, corrected, converge to the independent references; printed ones do not."""

import numpy as np
import pytest

from lapilli.references import finite_difference, slab
from lapilli.references.radial import RadialProblem, RadialSolution
from lapilli.references.thermal import Convection, Flux, Medium

AIR = Convection(coefficient=1.0, ambient=1.0)
COLD = Convection(coefficient=1.0, ambient=0.0)
STONE = Medium(density=2.0, specific_heat=3.0, conductivity=0.5)


def rates(errors):
    return np.log2(np.array(errors[:-1]) / np.array(errors[1:]))


@pytest.mark.parametrize("wall", [Flux(inward=1.0), AIR])
def test_ring_converges_at_second_order(wall):
    # step proportional to dr^2, so space and time both give order 2
    radial = RadialSolution(
        RadialProblem(inner=1, outer=5, dimension=2, at_inner=wall, at_outer=wall)
    )
    errors = []
    for intervals in (40, 80, 160):
        result = finite_difference.ring([1.0, 2.5], intervals=intervals, wall=wall)
        exact = radial.temperature(result.positions, result.times)
        errors.append(np.max(np.abs(result.temperature - exact)))
    assert np.all(rates(errors) > 1.8)
    assert errors[-1] < 1e-3  # measured 6.6e-4 (flux), 1.4e-4 (convection)


@pytest.mark.parametrize("wall", [Flux(inward=1.0), AIR])
def test_ring_with_other_properties(wall):
    # inner and outer sign and kappa of B6 and B7: a wrong one would cost tenths
    radial = RadialSolution(
        RadialProblem(inner=1, outer=5, dimension=2, at_inner=wall, at_outer=wall, medium=STONE)
    )
    step = 0.0025 / (4 * STONE.diffusivity)
    result = finite_difference.ring([400 * step], wall=wall, medium=STONE, step=step)
    exact = radial.temperature(result.positions, result.times)
    assert result.temperature == pytest.approx(exact, abs=5e-3)


def test_sphere_converges_at_second_order():
    radial = RadialSolution(
        RadialProblem(inner=0, outer=5, dimension=3, at_outer=COLD, initial=100.0)
    )
    errors = []
    for intervals in (20, 40, 80):
        result = finite_difference.sphere([2.0, 5.0], intervals=intervals, wall=COLD)
        exact = radial.temperature(result.positions, result.times)
        errors.append(np.max(np.abs(result.temperature - exact)))
    assert np.all(rates(errors) > 1.8)
    assert errors[-1] < 0.05  # K of 100 K


def test_centre_needs_the_factor_six():
    # Eq. C5 as printed (3 in place of 6) lags at the centre. With the centre node lagging, the
    # scheme still has the right steady state, so a transient shows it.
    result = finite_difference.sphere([10.0], intervals=10, wall=COLD)
    radial = RadialSolution(
        RadialProblem(inner=0, outer=5, dimension=3, at_outer=COLD, initial=100.0)
    )
    exact = radial.temperature(0.0, 10.0)
    right = abs(result.temperature[0, 0] - exact)

    field, dr, step = np.full(11, 100.0), 0.5, 0.5**2 / 8
    r = dr * np.arange(11)
    for _ in range(round(10.0 / step)):
        centre = field[0] + 3 * step / dr**2 * (field[1] - field[0])
        curve = (field[2:] - 2 * field[1:-1] + field[:-2]) / dr**2
        field[1:-1] += step * (curve + (field[2:] - field[:-2]) / dr / r[1:-1])
        field[0] = centre
        field[-1] = (4 * field[-2] - field[-3]) / (3 + 2 * dr)
    assert abs(field[0] - exact) > 2 * right


def test_square_converges_at_second_order():
    errors = []
    for intervals in (20, 40, 80):
        result = finite_difference.square([5.0], intervals=intervals, wall=AIR)
        x = result.positions - 5.0
        grid = np.stack(np.meshgrid(x, x, indexing="ij"), axis=-1)
        exact = slab.convective_box(grid, 5.0, half_widths=5.0)
        errors.append(np.max(np.abs(result.temperature[0] - exact)[1:-1, 1:-1]))
    assert np.all(rates(errors) > 1.8)
    assert errors[-1] < 1e-3


def test_square_keeps_its_symmetry():
    field = finite_difference.square([1.0], intervals=20, wall=Flux(inward=2.0)).temperature[0]
    assert field == pytest.approx(field.T, abs=1e-14)
    assert field == pytest.approx(field[::-1, ::-1], abs=1e-14)


def test_refusals():
    with pytest.raises(ValueError, match="step must lie in"):
        finite_difference.ring([1.0], wall=AIR, step=1.0)
    with pytest.raises(ValueError, match="multiples of the step"):
        finite_difference.ring([1.00001], wall=AIR, step=1e-3)
