"""What yields without end bears one load: a rough strip pressed into clay has Prandtl's, wherever
it ends in a cell, however far it has sunk and however stiff the clay is before it yields."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lapilli as lp

sys.path.insert(0, str(Path(__file__).parent))
from clay_strip import PRANDTL, ClayStrip

sys.path.pop(0)

WIDTH, DEPTH = 2.5, 1.5  # of the ground, in widths of the strip


@dataclass
class Strip(ClayStrip):
    more: dict[str, Any] = field(default_factory=dict)

    def scene(self, steps: int = 12) -> lp.Scene:
        """Half of it, beside its plane of symmetry."""
        corners = self.at([[0, 0], [WIDTH, 0], [WIDTH, DEPTH], [0, DEPTH]]).tolist()
        a, b, c, d = corners
        down = (self.at([[0, -self.settlement]]) - self.at([[0, 0]]))[0]
        edge, middle = self.at([[self.half, DEPTH], [0, DEPTH]]).tolist()
        cell = self.metre / self.cells
        low, high = (np.array(corners).min(axis=0), np.array(corners).max(axis=0))
        lower = cell * np.floor(low / cell + 1e-9) - 2 * cell
        upper = lower + cell * np.ceil((high - lower) / cell + 2 - 1e-9)
        return lp.Scene(
            grid=lp.Grid(lower=lower.tolist(), upper=upper.tolist(), cell=cell),
            bodies=[lp.Body(shape=lp.Polygon(vertices=corners), material=[self.clay()])],
            quasi_static=lp.QuasiStatic(
                supports=[
                    lp.Support(name="symmetry", kind="roller", line=[d, a]),
                    lp.Support(name="base", kind="fixed", line=[a, b]),
                    lp.Support(name="side", kind="roller", line=[b, c]),
                    lp.Support(
                        name="strip",
                        kind="fixed",
                        line=[edge, middle],
                        displacement=[lp.Table([0, 1], [0, float(x)]) for x in down],
                    ),
                ],
                **self.more,
            ),
            time=lp.Time(end=1.0, steps=steps),
            output=lp.Output(path="strip.vtkhdf", every=1.0 / steps),
        )

    def pressure(self, steps: int = 12) -> np.ndarray:
        """Under the strip at every step, over Prandtl's."""
        history = lp.run(self.scene(steps), progress=False).history
        force = [history[f"quasi_static/force_of_wall_strip_along_{axis}"] for axis in "xy"]
        angle = np.radians(self.degrees)
        along = np.array([np.sin(angle), -np.cos(angle)]) @ np.asarray(force)
        return np.asarray(along / (self.half * self.metre * self.pascal) / PRANDTL)


@pytest.mark.parametrize("edge", [0.0, -0.25, -0.5, -0.75, -0.95])
def test_a_strip_may_end_anywhere_in_a_cell(edge: float) -> None:
    """It carried along all of the cell that it ended in and half of the next one: 1.20, 1.28, 1.37
    and 1.46 at a settlement of .03."""
    assert Strip(edge=edge, settlement=0.03).pressure()[-1] == pytest.approx(1.04, abs=0.035)


@pytest.mark.parametrize(
    ("degrees", "by"), [(0.0, (0.3, 0.4)), (17.0, (0.0, 0.0)), (45.0, (0.1, 0.2)), (71.0, (0.5, 0))]
)
def test_the_ground_may_lie_anywhere_on_the_grid(degrees: float, by: tuple[float, float]) -> None:
    """1.36 to 1.4 before; at the worst of these places 1.09, and 1.03 with 16 cells."""
    assert 1.0 < Strip(degrees=degrees, by=by).pressure()[-1] < 1.11


@pytest.mark.parametrize("stiffness", [1e3, 1e4])
def test_flow_bears_no_more_the_further_it_goes(stiffness: float) -> None:
    """Ghost stabilisation resisted what had yielded: 1.33 with stiff clay, and still rising."""
    settlement = 0.03 * np.sqrt(1e3 / stiffness)
    pressure = Strip(stiffness=stiffness, settlement=settlement).pressure()
    assert pressure[-1] < 1.07
    assert pressure[-1] < 1.01 * pressure[len(pressure) // 2]


def test_clays_of_one_strength_bear_one_load() -> None:
    """Strain across the plane, from averaging the dilatation along all three axes, cost Tresca's
    clay 2 % more."""
    one, other = (Strip(material=name).pressure()[-1] for name in ("von_mises", "mohr_coulomb"))
    assert other == pytest.approx(one, rel=5e-3)


def test_units_do_not_matter() -> None:
    one, other = Strip(), Strip(metre=2000.0, pascal=0.01)
    assert other.pressure()[-1] == pytest.approx(one.pressure()[-1], rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("material", ["von_mises", "mohr_coulomb"])
@pytest.mark.parametrize("edge", [0.0, -0.5])
def test_sixteen_cells_bear_prandtls_load_within_three_percent(material: str, edge: float) -> None:
    """1.13 to 1.26 before."""
    pressure = Strip(cells=16, material=material, edge=edge, settlement=0.03).pressure()
    assert pressure[-1] == pytest.approx(1.0, abs=0.03)
    assert pressure[-1] < 1.01 * pressure[len(pressure) // 2]
