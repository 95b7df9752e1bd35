"""A fluid that is stirred conducts as well as one at rest: points that have moved lie anyhow."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp
from lapilli.references.cavity import Box, solve
from lapilli.reproduce.pd.cavity import scene

RAYLEIGH = 300.0  # too little to carry much heat, enough to turn the points a quarter round


@pytest.mark.parametrize("across", [15, 20])
def test_points_that_flow_conduct_as_those_at_rest(across: int) -> None:
    """Heat of the walls of a cavity within 0.2 % of finite differences; it was 0.5 to 0.6 % low on
    any number of points, as each conducted unlike along its directions."""
    flow = solve(Box(rayleigh=RAYLEIGH, prandtl=0.71), 24)
    simulation = lp.Simulation(scene(RAYLEIGH, across, "peridynamics.heat.horizon=2.015"))
    simulation.run_until(0.8)
    before = simulation.balance()[0].entries
    simulation.run_until(1.0)
    after = simulation.balance()[0].entries
    hot, cold = ((after[name] - before[name]) / 0.2 for name in ("wall hot", "wall cold"))
    np.testing.assert_allclose([hot, -cold], flow.nusselt(), rtol=2e-3)
