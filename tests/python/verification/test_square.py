"""Section 4.4 of Yu & Zhao 2026: the square, turned, cut from a lattice and rotating.

The exact field is the product of two slabs. The paper's norms (Fig. 19: 2.6, 4.9, 5.5 and 6.4e-3)
could not be had from its own algorithm in any convention tried, so they are bounds to stay below
and no targets. Bars are 1.3 times what an independent implementation measured, rounded.
"""

import numpy as np
import pytest

from lapilli.reproduce.states import changed, order, rms, states
from lapilli.reproduce.vhfm import square


@pytest.mark.parametrize("angle", square.ANGLES)
def test_turned_square(angle):
    """RMSE, largest error and length at h = 0.2 m. The largest error, 3.5e-3 K, sits at corners; a
    unit normal, which gives them 0.7 of their length, leaves 6e-3 K there and misses 1 % of the
    length, where 0.6 % is asked for."""
    for row in square.turned_rows(angle):
        assert row.ok, row


def test_corners_need_their_fitted_vector():
    """The reason for it: without it the corners of the aligned square are 5 times worse."""
    scene = changed(square.turned_scene(0), "heat.corner_fit=false")
    plain = np.abs(square.errors(next(states(scene, [square.TIME])), 0)).max()
    assert plain > 4 * np.abs(square.errors(square.turned(0, 0.2), 0)).max()


def test_order_of_the_aligned_square():
    """Second order: 1.8 asked for from h = 0.4 to 0.2 m."""
    coarse, fine = (rms(square.errors(square.turned(0, cell), 0)) for cell in (0.4, 0.2))
    assert order(coarse, fine, 2) >= 1.8


def test_configuration_b():
    """Points cut from the lattice enclose 0.6 % less than the square, which costs 3.6e-3 K; clipped
    boundary points bring it to what the turned square has."""
    plain, clipped = square.lattice_rows()
    assert plain.ok, plain
    assert clipped.lapilli <= 1.3e-3


def test_middle_line_to_50_s():
    """Fig. 19, second column: as near as the largest error at 5 s all along."""
    row = square.central_line_row()
    assert row.ok, row


@pytest.mark.parametrize(
    "name", ["1", *(pytest.param(n, marks=pytest.mark.slow) for n in ("1/16", "1/4", "4"))]
)
def test_rotating_square(name):
    """Fig. 22: what the points carry is right to 1.5e-3 K at every speed, since the transfer adds
    no conduction of its own; FLIP carries errors of 6e-3 K."""
    for row in square.rotating_rows(name):
        assert row.ok, row


@pytest.mark.slow
@pytest.mark.parametrize("angle", square.ANGLES)
def test_turned_square_on_the_finer_grid(angle):
    row = square.fine_row(angle)
    assert row.ok, row
