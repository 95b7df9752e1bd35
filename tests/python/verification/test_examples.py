"""Every scene of the heat paper runs as it stands in its file, on a coarser grid."""

import math
from pathlib import Path

import pytest

import lapilli as lp

SCENES = sorted((Path(__file__).parents[3] / "examples" / "vhfm").glob("*.toml"))


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_scene_runs_and_keeps_its_heat(path):
    """Three steps on cells twice as wide; the heat balance closes to rounding."""
    scene = lp.Scene.load(str(path))
    cell = 2 * scene.grid.cell
    corners = zip(scene.grid.lower, scene.grid.upper, strict=True)
    cells = [math.ceil((b - a) / cell - 1e-9) for a, b in corners]
    scene = scene.set(f"grid.cell={cell}")
    upper = [a + n * cell for a, n in zip(scene.grid.lower, cells, strict=True)]
    scene = scene.set(f"grid.upper={upper}")
    simulation = lp.Simulation(scene)
    for _ in range(3):
        simulation.step()
    balance = next(account for account in simulation.balance() if account.quantity == "heat")
    assert balance.turnover > 0
    assert abs(balance.residual) <= 1e-12
