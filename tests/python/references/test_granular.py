"""Run-out laws: values of both branches, no jump upward, band ordered."""

import numpy as np
import pytest

from lapilli.references.granular import (
    LAJEUNESSE_2005,
    LUBE_2005,
    lube_final_height,
    run_out_band,
)


def test_branches():
    assert float(LUBE_2005.run_out(1.0)) == pytest.approx(1.2)
    assert float(LUBE_2005.run_out(8.0)) == pytest.approx(1.9 * 4)
    assert float(LAJEUNESSE_2005.run_out(2.0)) == pytest.approx(3.6)
    assert float(LAJEUNESSE_2005.run_out(8.0)) == pytest.approx(2.3 * 4)


def test_branches_meet_to_within_the_scatter_of_the_fits():
    # the fits are not continuous: 12 % at a = 3 (Lajeunesse); Lube's gap is bridged monotonically
    a = np.linspace(1.7, 2.9, 200)
    assert np.all(np.diff(LUBE_2005.run_out(a)) > 0)
    below, above = LAJEUNESSE_2005.run_out([3.0, 3.0 + 1e-9])
    assert abs(above / below - 1) < 0.15


def test_band_and_height():
    low, high = run_out_band([0.5, 2.0, 10.0])
    assert np.all(low < high)
    assert low[1] == pytest.approx(2.4, abs=0.2)
    assert lube_final_height([0.5, 1.0, 2.0]) == pytest.approx([0.5, 1.0, 2.0**0.4])
    with pytest.raises(ValueError, match="must be positive"):
        LUBE_2005.run_out(0.0)
