"""Section 4.5 of Yu & Zhao 2026: a fan from a picture."""

import pytest

from lapilli.reproduce.states import rms
from lapilli.reproduce.vhfm import fan


def test_a_turning_fan_is_as_warm_as_one_at_rest():
    """At h = 0.2 m, 0.5 s, of 100 K. The grid cuts the outline anew in each step, and cells in the
    roots of the blades count as filled while it turns: both are errors of first order."""
    turning, resting = fan.cooled(0.2), fan.cooled(0.2, turning=False)
    assert abs(turning.carried.mean() - resting.carried.mean()) <= fan.MEAN_BARS[0.2]
    assert rms(turning.carried - resting.carried) <= fan.REST_BAR
    assert 0 <= turning.carried.min() <= turning.carried.max() <= 100


@pytest.mark.slow
def test_two_grids_agree():
    """The grids of Fig. 25 but the finest: mean temperatures at 0.5 s."""
    for row in fan.run(quick=True):
        assert row.ok, row
