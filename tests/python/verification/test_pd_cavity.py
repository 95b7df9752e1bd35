"""Section 5.2 of Yang et al.: natural convection beside de Vahl Davis 1983."""

import pytest

from lapilli.reproduce.pd import cavity


def test_cavity_at_half_the_points():
    """Ra 1e4 with 40 x 40 points: 2 % in Nu and the peaks, twice the bar of 80 x 80 at most."""
    for row in cavity.run(quick=True):
        assert row.ok, row


@pytest.mark.slow
@pytest.mark.parametrize("rayleigh", list(cavity.PLANS))
def test_cavity_at_full_size(rayleigh):
    for row in cavity.plan_rows(rayleigh, cavity.PLANS[rayleigh]):
        assert row.ok, row


@pytest.mark.slow
def test_halving_the_spacing_pays():
    for row in cavity.order_rows():
        assert row.ok, row


@pytest.mark.slow
def test_cavity_beyond_the_paper():
    for row in cavity.finest_rows():
        assert row.ok, row
