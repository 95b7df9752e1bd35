"""Section 4.2 of Yu & Zhao 2026: Table 3 and Figures 9 and 12, and the exact ring.

The exact field is a Galerkin solution in r alone. Bars on the defaults are 1.3 times what an
independent implementation measured, rounded.
"""

import numpy as np
import pytest

from lapilli.reproduce.states import changed, order, rms, states
from lapilli.reproduce.vhfm import ring


@pytest.mark.parametrize("law", ring.LAWS)
@pytest.mark.parametrize("cell", [0.4, 0.2, 0.1])
def test_error_at_1_s(law, cell):
    assert ring.default_error(law, cell) <= ring.BARS[law][cell]


@pytest.mark.parametrize("law", ring.LAWS)
def test_order(law):
    """Second order inside, first-order noise of the rims in between: 1.5 or more from 0.4 to
    0.1 m, where the paper's algorithm has 1."""
    assert order(ring.default_error(law, 0.4), ring.default_error(law, 0.1), 4) >= 1.15
    assert order(ring.literal_error(law, 0.4), ring.literal_error(law, 0.1), 4) <= 1.2


@pytest.mark.parametrize("law", ring.LAWS)
@pytest.mark.parametrize("cell", [0.4, 0.2, 0.1])
def test_the_papers_algorithm_against_the_exact_field(law, cell):
    """Within 5 % of an independent implementation, whose two printed digits round by as much."""
    row = ring.literal_row(law, cell)
    assert row.ok, row


@pytest.mark.parametrize("cell", [0.2, 0.1])
def test_lengths_of_the_rims(cell):
    """Within 0.5 % of the circles, 0.3 % for the outer one at h = 0.1 m: the nodal normals are
    right to 2 degrees, and 1 - cos of that is 0.06 %; the rest is the staircase. The paper's
    operator loses 2.6 % outside and gains 6.7 % inside at h = 0.1 m."""
    for row in ring.area_rows(cell) + ring.literal_area_rows(cell):
        assert row.ok, row


@pytest.mark.parametrize("smoothing", [2, 4])
def test_normals(smoothing):
    """Fig. 9: RMSE below 2.2 and 1.5 degrees (the paper's particle normals: 4 to 6, and 14 to 16
    over all that contribute)."""
    assert rms(ring.normal_errors(0.1, smoothing)[1]) <= ring.NORMAL_BARS[smoothing]


@pytest.mark.parametrize("law", ring.LAWS)
def test_history_half_way_between_the_rims(law):
    """Fig. 12, h = 0.2 m: within 0.5 % of the final value, the error of the lengths."""
    times = np.array([1.0, 2.5, 5.0, 10.0])
    exact = ring.exact_solution(law).temperature(3.0, times)
    assert np.abs(ring.history(law, 0.2, times) - exact).max() <= 5e-3 * exact[-1]


def test_heat_flux_inside():
    """Fig. 13: the radial flux at 1 s, two cells and more from the rims. A gradient of linear
    functions converges at order 1; its mean over a cell's points is far better than 2e-2."""
    state = next(states(ring.ring_scene("flux", 0.1), [1.0]))
    radius = ring.radius_of(state)
    radial = np.sum(state.flux * state.position, axis=1) / radius
    inside = (radius > ring.INNER + 0.2) & (radius < ring.OUTER - 0.2)
    exact = ring.exact_solution("flux").flux(radius[inside], 1.0)
    assert rms(radial[inside] - exact) <= 2e-2


def test_implicit_steps_give_the_same_field():
    """50 steps of 0.02 s where 400 are the explicit limit: within the bar of the explicit error, to
    which large steps add one of 1e-4 in time."""
    scene = changed(
        ring.ring_scene("convection", 0.1), "heat.time_integration=implicit", "time.step=0.02"
    )
    implicit = ring.error_of("convection", next(states(scene, [1.0])))
    assert implicit <= 2.6e-4


@pytest.mark.slow
@pytest.mark.parametrize("law", ring.LAWS)
def test_error_at_1_s_on_the_finest_grid(law):
    assert ring.default_error(law, 0.05) <= ring.BARS[law][0.05]


@pytest.mark.parametrize("law", ring.LAWS)
def test_operators_of_points_converge(law):
    """Asked for by the smoothing of normals: first order at least, on a lattice. Points of an exact
    fill, whose boxes do not tile the ring, gave 3 mK under the flux on both grids."""
    coarse, fine = (ring.default_error(law, cell, 4) for cell in (0.2, 0.1))
    assert fine <= 1.1e-3
    assert fine <= 0.6 * coarse


@pytest.mark.slow
def test_more_smoothing_on_the_finest_grid():
    assert ring.default_error("flux", 0.05, 4) <= ring.SMOOTHED_4_BAR


@pytest.mark.slow
def test_table_3_as_the_paper_ran_it():
    """Within 5 %: the step the paper took on each grid is a guess (h^2/10), which moves the errors
    by about 1 %, and one of its own entries is 4 % off its neighbours."""
    for row in ring.table_3():
        assert row.ok, row
