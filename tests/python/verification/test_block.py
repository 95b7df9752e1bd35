"""Section 5.1 of Cortis et al. 2018: a contained block in uniform stress, turned against the grid.

A patch test: the only errors are those of rounding, 1e-16 over the bandwidth of the stiff
constraint and the smallest cut. The bars are 1e-12 for aligned walls, 1e-9 for inclined ones in the
literal mode (bandwidth 1e-6 cells) and 1e-11 in the default one (1e-3 cells); the paper reports
1.6e-9 to 1.3e-8.
"""

import pytest

from lapilli.reproduce.ib import block
from lapilli.reproduce.ib.balance import MODES


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("degrees", block.ANGLES)
def test_patch(degrees, mode):
    """Displacement and stress at four angles, in both modes."""
    for row in block.angle_rows(degrees, mode):
        assert row.ok, row


def test_aligned_angles_agree():
    """0 and 90 degrees to 1e-12: the frame of the wall does not enter."""
    flat, upright = (block.solved(block.block_scene(degrees), degrees) for degrees in (0, 90))
    assert abs(flat.displacement - upright.displacement) <= 1e-12
    assert abs(flat.stress - upright.stress) <= 1e-12


@pytest.mark.parametrize("bandwidth", block.BANDWIDTHS)
def test_bandwidth_costs_only_rounding(bandwidth):
    """From 1e-1 to 1e-12 cells."""
    row = block.bandwidth_row(bandwidth)
    assert row.ok, row


@pytest.mark.parametrize("cell", block.CELLS)
def test_no_cell_size_is_better(cell):
    """The exact field is linear."""
    row = block.cell_row(cell)
    assert row.ok, row
