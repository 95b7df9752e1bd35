"""Section 6.1 of Yang et al.: layers heated from below, and thermals above a plate."""

import math

import numpy as np
import pytest

from lapilli.reproduce.pd import benard, thermals


def test_below_the_onset_nothing_moves_above_it_two_rolls():
    """Ra 1500 and 5000 at aspect 2; the rolls beside finite differences."""
    for row in benard.run(quick=True):
        assert row.ok, row


def test_a_plate_heats_the_water_above_it():
    """Coarse and short: heat rises above the plate, nothing is hotter than the plate, and the
    density varies by less than 2 %."""
    found = thermals.record(0.003, 2.0, 4)
    state = found.state
    above = np.abs(state.position[:, 0] - 0.06) < 0.045
    low = state.position[:, 1] < 0.003  # the layer of points next to the plate
    assert state.temperature[above & low].mean() > thermals.COLD + 1
    assert state.temperature[~above & low].mean() < thermals.COLD + 0.5
    assert state.temperature.max() <= thermals.HOT
    assert state.temperature.min() >= thermals.COLD - 1e-6
    assert found.density_variation < 0.02


def test_period_of_a_known_trace():
    """Warm for 1 s every 4 s."""
    time = np.arange(1, 200) * 0.1
    assert math.isclose(thermals.period(time, (time % 4.0 > 3.0) * 1.0), 4.0, rel_tol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("name", list(benard.FIGURES))
def test_layers_of_the_figures(name):
    for row in benard.figure_rows(name):
        assert row.ok, row
