"""Bilinear finite elements: the published beam, patch exactness, order, the cantilever."""

import numpy as np
import pytest

from lapilli.references.elastic import Elastic
from lapilli.references.plane_strain import (
    cantilever_compliance,
    deep_beam,
    solve_rectangle,
)


def test_deep_beam():
    # free-corner values of Cortis et al. 2018, section 5.2, as recomputed independently
    published = {10.0: -28.0786326, 5.0: -28.3761769, 2.0: -28.4981250, 1.0: -28.5253447}
    for cell, value in published.items():
        assert deep_beam(cell) == pytest.approx(value, abs=6e-8)


def test_cantilever_reference():
    # order 1.66-1.76 (singular corners); the reference 2.905869e-3 is good to 1e-4 of itself
    values = np.array([cantilever_compliance(cell) for cell in (4.0, 2.0, 1.0, 0.5)])
    steps = np.diff(values)
    orders = np.log2(steps[:-1] / steps[1:])
    assert np.all((orders > 1.6) & (orders < 1.9))
    aitken = values[-1] + steps[-1] ** 2 / (steps[-2] - steps[-1])
    assert aitken == pytest.approx(2.905869e-3, rel=1e-4)
    errors = values[1:3] / 2.905869e-3 - 1
    assert errors == pytest.approx([-0.0086, -0.0026], abs=5e-5)


def test_beam_theory_for_a_slender_cantilever():
    # tip deflection q L^4/(8 E' I) + q L^2/(2 kappa G A), E' = E/(1 - nu^2); Q4 with 16 cells
    # across is 0.4 % too stiff
    material = Elastic(young=1000.0, poisson=0.0)
    solution = solve_rectangle((80.0, 4.0), 0.25, body_force=(0.0, -1e-4), material=material)
    load, inertia = 1e-4 * 4.0, 4.0**3 / 12
    theory = load * 80.0**4 / (8 * 1000.0 * inertia) + load * 80.0**2 / (2 * 5 / 6 * 500.0 * 4.0)
    assert -solution.displacement[-1, 8, 1] == pytest.approx(theory, rel=5e-3)


def test_self_weight_bar_is_exact_at_the_nodes():
    # nu = 0 hanging from its top: one-dimensional, where nodal values are exact
    material = Elastic(young=50.0, poisson=0.0)
    solution = solve_rectangle(
        (2.0, 6.0), 0.5, body_force=(0.0, -3.0), held="top", material=material
    )
    y = np.linspace(0, 6, 13)
    exact = -3.0 / 50.0 * (36.0 - y**2) / 2
    assert solution.displacement[:, :, 1] == pytest.approx(np.tile(exact, (5, 1)), abs=1e-12)
    assert solution.displacement[..., 0] == pytest.approx(0.0, abs=1e-12)


def test_held_sides_are_equivalent():
    material = Elastic()
    left = solve_rectangle((4.0, 2.0), 0.5, body_force=(0.3, -1.0), material=material)
    right = solve_rectangle(
        (4.0, 2.0), 0.5, body_force=(-0.3, -1.0), held="right", material=material
    )
    top = solve_rectangle((2.0, 4.0), 0.5, body_force=(-1.0, -0.3), held="top", material=material)
    assert right.displacement[::-1] * [-1, 1] == pytest.approx(left.displacement, abs=1e-12)
    turned = top.displacement.transpose(1, 0, 2)[::-1, :, ::-1] * [-1, 1]
    assert turned == pytest.approx(left.displacement, abs=1e-12)
    assert left.compliance == pytest.approx(top.compliance)


def test_refusals():
    with pytest.raises(ValueError, match="multiple of the cell"):
        solve_rectangle((1.0, 1.0), 0.3, body_force=(0.0, 1.0), material=Elastic())
    with pytest.raises(ValueError, match="held must be one of"):
        solve_rectangle((1.0, 1.0), 0.5, body_force=(0.0, 1.0), held="west", material=Elastic())
