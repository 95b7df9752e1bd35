"""Every peridynamic scene runs as it stands in its file, on wider spacings."""

from pathlib import Path

import pytest

import lapilli as lp

SCENES = sorted((Path(__file__).parents[3] / "examples" / "pd").glob("*.toml"))
COARSE = {"thermals": 0.003}  # others: 0.05


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_scene_runs_and_keeps_its_heat(path):
    """Three steps; the heat balance closes to the rounding of what is stored (3e6 J of thermals, of
    which 11 J turn over)."""
    cell = COARSE.get(path.stem, 0.05)
    simulation = lp.Simulation(lp.Scene.load(str(path)).set(f"grid.cell={cell}"))
    for _ in range(3):
        simulation.step()
    (balance,) = simulation.balance()
    assert balance.turnover > 0
    assert abs(balance.residual) <= 1e-12 * max(1.0, abs(balance.stored) / balance.turnover)
