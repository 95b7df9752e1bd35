"""Section 4.3 of Yu & Zhao 2026: the sphere, against an exact solution in r alone."""

import numpy as np
import pytest

from lapilli.reproduce.states import order
from lapilli.reproduce.vhfm import sphere


def test_coarse_sphere():
    """h = 0.8 and 0.4 m to 2 s, on automatic steps. Of second order inside; noise of the surface of
    order 1 leaves 1.2. The area is right to 1 % with 25 cells across the sphere."""
    coarse, fine = (sphere.errors(sphere.sphere_scene(8, cell), (2.0,))[0] for cell in (0.8, 0.4))
    assert order(coarse, fine, 2) >= 1.2
    assert fine <= 0.2
    assert abs(sphere.area_share(sphere.sphere_scene(8, 0.4)) - 1) <= 0.01


@pytest.mark.slow
@pytest.mark.parametrize("points_per_cell", [8, 27])
def test_sphere_of_the_paper(points_per_cell):
    """RMSE of 0.30 to 0.05 of 100 K; the paper's algorithm, in an independent implementation, has
    1.5 to 2.6 K, and is worse with more points, not better as the paper finds."""
    for row in sphere.default_rows(points_per_cell, sphere.TIMES):
        assert row.ok, row


@pytest.mark.slow
def test_the_papers_algorithm():
    """Within 1 % of an independent implementation, which is stated to three digits at most."""
    rows = sphere.literal_rows(8)
    assert all(row.ok for row in rows), rows
    assert np.mean([row.lapilli for row in rows[:-1]]) > 1
