"""Section 4.6 of Yu & Zhao 2026: few points a cell beside many, and the paper's operator."""

import pytest

from lapilli.reproduce.vhfm import column
from lapilli.reproduce.vhfm.column import Setting


def test_nine_points_a_cell_are_as_good_as_twenty_five():
    """At h = 0.1 m, 2 s: 0.11 % RMS and 0.06 % of heat measured, bars of the case 0.5 %."""
    rows = column.compared("default", Setting(), {9: column.BARS[9], 4: column.BARS[4]})
    for row in rows:
        assert row.ok, row


@pytest.mark.slow
def test_every_bar_of_the_case():
    """As `lapilli reproduce vhfm/column`, with its harder test and the operator of the paper."""
    for row in column.run(quick=False):
        assert row.ok, row
