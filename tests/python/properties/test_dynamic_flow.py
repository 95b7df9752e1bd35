"""What yields without end under a tool bears one load: a strip pressed into clay has Prandtl's,
wherever it ends in a cell, at every angle, however stiff the clay is and however it slides."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lapilli as lp

sys.path.insert(0, str(Path(__file__).parent))
from clay_strip import PRANDTL, ClayStrip

sys.path.pop(0)

WIDTH, DEPTH = 2.0, 1.25  # of the ground, in widths of the strip
SIDES = ("lower", "upper")


@dataclass
class Strip(ClayStrip):
    settlement: float = 0.012
    stiffness: float = 3000.0
    material: str = "mohr_coulomb"
    speed: float = 5e-4  # over the root of the stiffness and the density
    contact: str = "no_slip"
    of_two: bool = False  # obstacles side by side

    def along(self, *direction: float) -> tuple[float, ...]:
        return tuple((self.at([direction]) - self.at([[0, 0]]))[0].tolist())

    @property
    def end(self) -> float:
        return 1.05 * self.settlement / (self.speed * np.sqrt(self.stiffness))

    def walls(self) -> dict[str, list[Any]]:
        """Symmetry, side and base of the ground."""
        if self.degrees == 0 and self.by == (0.0, 0.0):
            faces = [lp.RollerBoundary(face=face) for face in ("x_lower", "x_upper")]
            return {"grid_boundaries": [*faces, lp.NoSlipBoundary(face="y_lower")], "obstacles": []}
        planes = {"symmetry": (0, 0, 1, 0), "side": (WIDTH, 0, -1, 0), "base": (0, 0, 0, 1)}
        obstacles = [
            lp.Obstacle(
                name=name,
                shape=lp.HalfSpace(point=self.at([[x, y]])[0].tolist(), normal=self.along(*normal)),
                contact="no_slip" if name == "base" else "slip",
                separation=False,
            )
            for name, (x, y, *normal) in planes.items()
        ]
        return {"grid_boundaries": [], "obstacles": obstacles}

    def tools(self) -> list[lp.Obstacle]:
        ends = [-1.0, self.half - 3 / self.cells, self.half] if self.of_two else [-1.0, self.half]
        down = self.speed * np.sqrt(self.stiffness) * np.array(self.along(0, -1))
        return [
            lp.Obstacle(
                name=f"strip {k}",
                shape=lp.Polygon(
                    vertices=self.at(
                        [[a, DEPTH], [b, DEPTH], [b, DEPTH + 0.5], [a, DEPTH + 0.5]]
                    ).tolist()
                ),
                contact=self.contact,
                velocity=tuple(down),
                factor=lp.Table([0, 0.1 * self.end], [0, 1]),
            )
            for k, (a, b) in enumerate(pairwise(ends))
        ]

    def scene(self) -> lp.Scene:
        """Half of it, beside its plane of symmetry."""
        corners = self.at([[0, 0], [WIDTH, 0], [WIDTH, DEPTH], [0, DEPTH]])
        cell = 1.0 / self.cells
        walls = self.walls()
        room = 0 if walls["grid_boundaries"] else 4
        low, high = corners.min(axis=0), corners.max(axis=0)
        lower = cell * (np.floor(low / cell + 1e-9) - room)
        upper = cell * (np.ceil(high / cell - 1e-9) + np.array([room, 4]))
        return lp.Scene(
            grid=lp.Grid(lower=lower.tolist(), upper=upper.tolist(), cell=cell),
            bodies=[lp.Body(shape=lp.Polygon(vertices=corners.tolist()), material=self.clay())],
            dynamics=lp.Dynamics(
                grid_boundaries=walls["grid_boundaries"],
                obstacles=self.tools() + walls["obstacles"],
            ),
            time=lp.Time(end=self.end),
        )

    def pressure(self) -> np.ndarray:
        """Under the strip, over Prandtl's: means of the fourth and the last sixth of its way."""
        simulation = lp.Simulation(self.scene())
        times, force = [], []
        up = -np.array(self.along(0, -1))
        names = [f"dynamics/strip_{k}_force" for k in range(1 + self.of_two)]
        while simulation.time < self.end * (1 - 1e-9):
            simulation.step()
            found = simulation.diagnostics()
            times.append(simulation.time)
            force.append(
                sum(
                    up[k] * found[f"{name}_{axis}"] for name in names for k, axis in enumerate("xy")
                )
            )
        sixth = np.floor(6 * np.array(times) / self.end * (1 - 1e-9)).astype(int)
        means = [np.mean(np.array(force)[sixth == k]) for k in (3, 5)]
        return np.array(means) / self.half / PRANDTL


@pytest.mark.parametrize("edge", [0.0, -0.25, -0.4, -0.5, -0.6, -0.75, -0.95])
def test_a_strip_may_end_anywhere_in_a_cell(edge: float) -> None:
    """It carried half a cell to one and a half along with it: 1.09 to 1.22."""
    pressure = Strip(edge=edge).pressure()
    assert pressure[-1] == pytest.approx(1.045, abs=0.035)
    assert pressure[-1] < 1.02 * pressure[0]


@pytest.mark.parametrize(
    ("degrees", "by"), [(0.0, (0.3, 0.4)), (17.0, (0.0, 0.0)), (45.0, (0.1, 0.2)), (71.0, (0.5, 0))]
)
def test_the_ground_may_lie_anywhere_on_the_grid(degrees: float, by: tuple[float, float]) -> None:
    """1.13 to 1.18 before; 1.10 at the worst of these places, and 1.03 with 16 cells."""
    assert 1.0 < Strip(degrees=degrees, by=by).pressure()[-1] < 1.11


@pytest.mark.parametrize("contact", ["slip", "no_slip"])
@pytest.mark.parametrize("edge", [0.0, -0.5])
def test_a_smooth_strip_bears_as_much_as_a_rough_one(contact: str, edge: float) -> None:
    """What had parted from a rough tool was held along it for good, and what lay beside its edge
    hung from it: 1.15 and rising."""
    assert Strip(contact=contact, edge=edge).pressure()[-1] == pytest.approx(1.03, abs=0.015)


@pytest.mark.parametrize("stiffness", [1e3, 1e4])
def test_stiffness_does_not_matter(stiffness: float) -> None:
    settlement = 0.03 * np.sqrt(1e3 / stiffness)
    pressure = Strip(stiffness=stiffness, settlement=settlement).pressure()
    assert pressure[-1] == pytest.approx(1.04, abs=0.03)


@pytest.mark.parametrize("speed", [2e-4, 1e-3])
def test_nor_does_the_speed(speed: float) -> None:
    assert Strip(speed=speed).pressure()[-1] == pytest.approx(1.03, abs=0.02)


def test_clays_of_one_strength_bear_one_load() -> None:
    one, other = (Strip(material=name).pressure()[-1] for name in ("von_mises", "mohr_coulomb"))
    assert other == pytest.approx(one, rel=5e-3)


def test_a_strip_of_two_pieces_bears_as_much() -> None:
    """Where another obstacle goes on, a face does not end."""
    assert Strip(of_two=True).pressure()[-1] == pytest.approx(Strip().pressure()[-1], abs=0.02)


@pytest.mark.parametrize(
    "strip",
    [Strip(cells=16), Strip(cells=16, edge=-0.5), Strip(cells=16, degrees=71.0, by=(0.5, 0))],
    ids=["on a node", "in a cell", "turned"],
)
def test_sixteen_cells_bear_prandtls_load_within_three_percent(strip: Strip) -> None:
    """1.05 to 1.07 before."""
    pressure = strip.pressure()
    assert pressure[-1] == pytest.approx(1.0, abs=0.03)
    assert pressure[-1] < 1.02 * pressure[0]


@pytest.mark.parametrize(("edge", "least"), [(0.0, 6.6), (-0.5, 6.1)])
def test_a_square_pad_ends_where_it_is_drawn(edge: float, least: float) -> None:
    """Four cells wide, at their ends in space: 7.6 and 12.3 times the cohesion before. With eight
    cells 6.06 and 5.79; 6.5 and 7.8 before, and 5.8 to 6.2 in the literature (Salgado 2008)."""
    cell, depth, settlement, stiffness = 0.25, 1.0, 0.02, 1000.0
    half = 0.5 + edge * cell
    speed = 1e-3 * np.sqrt(stiffness)
    end = 1.05 * settlement / speed
    rollers = [lp.RollerBoundary(face=f"{axis}_{side}") for axis in "xy" for side in SIDES]
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0, 0), upper=(1.5, 1.5, depth + 3 * cell), cell=cell),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0, 0, 0), upper=(1.5, 1.5, depth)),
                material=lp.VonMises(
                    density=1.0,
                    youngs_modulus=stiffness,
                    poissons_ratio=0.45,
                    yield_stress=float(np.sqrt(3)),
                ),
                points_per_cell=8,
            )
        ],
        dynamics=lp.Dynamics(
            grid_boundaries=[*rollers, lp.NoSlipBoundary(face="z_lower")],
            obstacles=[
                lp.Obstacle(
                    name="pad",
                    shape=lp.Box(lower=(-1, -1, depth), upper=(half, half, depth + 0.5)),
                    contact="no_slip",
                    velocity=(0, 0, -speed),
                    factor=lp.Table([0, 0.1 * end], [0, 1]),
                )
            ],
        ),
        time=lp.Time(end=end),
    )
    simulation = lp.Simulation(scene)
    force = []
    while simulation.time < end * (1 - 1e-9):
        simulation.step()
        if simulation.time > 5 / 6 * end:
            force.append(simulation.diagnostics()["dynamics/pad_force_z"])
    assert np.mean(force) / half**2 == pytest.approx(least + 0.3, abs=0.3)
