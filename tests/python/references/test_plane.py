"""Finite volumes on a cell mask: exact solutions, orders, heat balance, the L-shape."""

import numpy as np
import pytest
from scipy.sparse import csc_array

from lapilli.references import slab
from lapilli.references.implicit_steps import integrate
from lapilli.references.plane import PlaneProblem, PlaneSolution, l_shape
from lapilli.references.thermal import Convection, Flux, Insulated, Medium, Prescribed

AIR = Convection(coefficient=1.0, ambient=1.0)
STONE = Medium(density=2.0, specific_heat=3.0, conductivity=0.5)


def block(nx, ny, size, **more):
    return PlaneProblem(
        cells=np.ones((nx, ny), dtype=bool), cell=(size[0] / nx, size[1] / ny), **more
    )


def test_time_stepping_is_second_order_and_damps():
    # dT/dt = -k T with k = 1 (accuracy) and k = 1e9 (stiff), start 1
    mass, stiffness = np.ones(2), csc_array(np.diag([1.0, 1e9]))
    errors = []
    for step in (0.02, 0.01, 0.005):
        end = integrate(mass, stiffness, np.zeros(2), np.ones(2), np.array([1.0, 3.0]), step)
        errors.append(np.max(np.abs(end[:, 0] - np.exp([-1.0, -3.0]))))
        assert np.max(np.abs(end[:, 1])) < 1e-12
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.15)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.15)


def test_square_converges_to_the_product_series():
    # both h and dt halve: order 2 (measured rms 2.6e-4, 6.4e-5, 1.6e-5)
    errors = []
    for n, step in ((25, 0.2), (50, 0.1), (100, 0.05)):
        problem = block(n, n, (10.0, 10.0), lower=(-5.0, -5.0), boundary=AIR)
        solution = PlaneSolution(problem, [5.0], step=step)
        exact = slab.convective_box(solution.nodes, 5.0, half_widths=5.0)
        errors.append(np.sqrt(np.mean((solution.temperature[0] - exact) ** 2)))
    assert np.all(np.log2(np.array(errors[:-1]) / errors[1:]) > 1.9)
    assert errors[-1] < 3e-5


def test_rectangle_with_other_properties_and_cells():
    problem = block(
        60, 80, (4.0, 6.0), lower=(-2.0, -3.0), boundary=AIR, initial=-2.0, medium=STONE
    )
    solution = PlaneSolution(problem, [2.0, 20.0], step=0.1)
    exact = slab.convective_box(
        solution.nodes, [2.0, 20.0], half_widths=[2.0, 3.0], initial=-2.0, medium=STONE
    )
    assert solution.temperature == pytest.approx(exact, abs=2e-3)  # measured 8e-4, at a corner
    mean = slab.convective_box_mean([2.0, 20.0], half_widths=[2.0, 3.0], initial=-2.0, medium=STONE)
    assert solution.heat_content() == pytest.approx(mean * 24.0 * 6.0, abs=1e-3 * 3 * 24.0 * 6.0)


def test_prescribed_and_insulated_sides_make_a_slab():
    sides = {"left": Prescribed(temperature=1.0), "right": Prescribed(temperature=0.0)}
    problem = block(80, 3, (1.0, 0.1), sides=sides, boundary=Insulated())
    solution = PlaneSolution(problem, [0.05, 0.16], step=0.001)
    exact = slab.prescribed_slab(solution.nodes[..., 0], [0.05, 0.16])
    assert solution.temperature == pytest.approx(exact, abs=1e-4)


def test_heat_adds_up_under_constant_flux():
    # outline of the L is 40 m, its area 75 m2
    problem = l_shape(20)
    heated = PlaneProblem(
        cells=problem.cells, cell=problem.cell, boundary=Flux(inward=0.5), medium=STONE
    )
    solution = PlaneSolution(heated, [1.0, 7.0])
    assert solution.heat_content() == pytest.approx([20.0, 140.0], rel=1e-12)
    assert solution.capacity.sum() == pytest.approx(75.0 * 6.0, rel=1e-12)


def test_uniform_ambient_is_a_steady_state():
    problem = l_shape(20)
    solution = PlaneSolution(problem, [1e3])
    inside = ~np.isnan(solution.temperature[0])
    assert solution.temperature[0][inside] == pytest.approx(1.0, abs=1e-8)


def test_l_shape_converges():
    # smooth parts at second order; 0.1 from the re-entrant corner at about 4/3
    points = np.array([[-2.5, 2.5], [-1.0, -1.0], [-0.1, -0.1]])
    values = [
        PlaneSolution(l_shape(n), [5.0], step=step).at(points)[0]
        for n, step in ((25 * 2, 0.2), (100, 0.1), (200, 0.05))
    ]
    first, second = np.abs(values[1] - values[0]), np.abs(values[2] - values[1])
    assert np.all(np.log2(first / second)[:2] > 1.7)
    assert second[2] < 3e-4
    assert np.all(second[:2] < 1e-4)


def test_l_shape_is_symmetric_and_warmer_than_the_square():
    solution = PlaneSolution(l_shape(50), [5.0])
    field = solution.temperature[0]
    assert np.nanmax(np.abs(field - field.T)) < 1e-12
    square = slab.convective_box(solution.nodes, 5.0, half_widths=5.0)
    assert np.nanmin(field - square) > -1e-3


def test_interpolation_and_refusals():
    solution = PlaneSolution(l_shape(20), [1.0])
    nodes = solution.nodes.reshape(-1, 2)[[0, 5, 30]]
    assert solution.at(nodes)[0] == pytest.approx(solution.temperature[0].ravel()[[0, 5, 30]])
    with pytest.raises(ValueError, match="inside the material"):
        solution.at([[1.0, 1.0]])
    with pytest.raises(ValueError, match="sides must be among"):
        block(2, 2, (1.0, 1.0), sides={"west": AIR})
