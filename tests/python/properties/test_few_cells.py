"""A body so few cells across that its place on the grid tells in its motion says so."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core


def falling(cells: float, degrees: float, dimension: int = 2) -> lp.Scene:
    """A bar this many cells thick, turned and off the lattice."""
    cell = 0.02
    half = cells * cell / 2
    length = 3 * half if dimension == 2 else 2 * half
    box = lp.Box(
        lower=(-length, *(-half,) * (dimension - 1)), upper=(length, *(half,) * (dimension - 1))
    )
    shape = lp.Translated(
        shape=lp.Rotated(shape=box, degrees=degrees, center=(0,) * dimension),
        by=(0.37 * cell, 0.21 * cell, 0.11 * cell)[:dimension],
    )
    reach = cell * np.ceil(1.6 * length / cell + 3)
    return lp.Scene(
        grid=lp.Grid(lower=(-reach,) * dimension, upper=(reach,) * dimension, cell=cell),
        bodies=[
            lp.Body(
                name="bar",
                shape=shape,
                points_per_cell=4 if dimension == 2 else 1,
                material=lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3),
            )
        ],
        dynamics=lp.Dynamics(gravity=(0, -9.81, 0)[:dimension]),
        time=lp.Time(end=1e-4),
    )


def said(scene: lp.Scene) -> list[str]:
    report = json.loads(_core.check_json(scene))
    return [
        note
        for note, code in zip(report["notes"], report["note_codes"], strict=True)
        if code == "dynamics.few-cells"
    ]


@pytest.mark.parametrize("degrees", [0.0, 31.0])
@pytest.mark.parametrize("dimension", [2, 3])
def test_a_thin_body_says_how_thin_it_is(degrees: float, dimension: int) -> None:
    (note,) = said(falling(5.0, degrees, dimension))
    assert note.startswith("bar is ")
    assert float(note.split()[2]) == pytest.approx(5.0, abs=0.15)
    assert float(note.split("grid.cell = ")[1].split()[0]) == pytest.approx(0.02 * 5 / 8, rel=0.03)
    assert said(falling(9.0, degrees, dimension)) == []


def test_the_record_says_it_too(tmp_path: Path) -> None:
    result = lp.run(falling(5.0, 31.0), tmp_path / "bar.vtkhdf", progress=False)
    assert [one.code for one in result.summary.notes].count("dynamics.few-cells") == 1
    assert result.record["notes"] == [str(one) for one in result.summary.notes]


def bouncing(cells: float, frame: float, material: lp.Elastic | lp.MohrCoulomb) -> lp.Scene:
    """A square that falls on a plane at an angle, beside the lattice by this much of a cell."""
    half = cells / 2
    speed = 0.05 * np.sqrt(material.youngs_modulus / material.density)
    end = 2 * half / speed
    shape = lp.Rotated(
        shape=lp.Box(lower=(-half, -half), upper=(half, half)), degrees=37.0, center=(0, 0)
    )
    shift = np.array([0.37, 0.21]) * frame
    plane = np.array([0, -half * np.sqrt(2) - 0.5])
    reach = np.ceil(2 * cells + 4)
    return lp.Scene(
        grid=lp.Grid(lower=(-reach, -reach), upper=(reach, reach), cell=1.0),
        bodies=[
            lp.Body(
                name="square",
                shape=lp.Translated(shape=shape, by=tuple(shift)),
                material=material,
                velocity=(0, -speed),
            )
        ],
        dynamics=lp.Dynamics(
            obstacles=[
                lp.Obstacle(
                    shape=lp.HalfSpace(point=tuple(plane + shift), normal=(0, 1)), contact="slip"
                )
            ]
        ),
        time=lp.Time(end=end),
    )


def bounce(scene: lp.Scene) -> np.ndarray:
    simulation = lp.Simulation(scene)
    simulation.run_until(scene.time.end)
    mass = simulation["density"] * simulation["volume"]
    return np.asarray((mass / mass.sum()) @ simulation["velocity"])


RUBBER = lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3)


@pytest.mark.parametrize("cells", [7.0, 11.0, 19.0])
def test_what_may_bounce_says_how_much_its_place_tells(cells: float) -> None:
    """A square on its corner is among the one in ten: 5.3 % with 11 cells, 5 said."""
    one, other = bouncing(cells, 0.0, RUBBER), bouncing(cells, 1.0, RUBBER)
    (note,) = said(one)
    percent = float(note.split("more than ")[1].split()[0])
    assert percent == pytest.approx(55 / cells, abs=0.6)
    speed = 0.05 * np.sqrt(RUBBER.youngs_modulus / RUBBER.density)
    change = np.abs(bounce(other) - bounce(one)).max() / speed
    assert change < 1.5 * percent / 100


def test_what_is_fine_enough_or_flows_does_not() -> None:
    sand = lp.MohrCoulomb(density=1000, youngs_modulus=1e6, poissons_ratio=0.3, friction_angle=30)
    assert said(bouncing(28.0, 0.0, RUBBER)) == []
    assert said(bouncing(11.0, 0.0, sand)) == []


@pytest.mark.parametrize("cells", [3.0, 5.0])
def test_what_rolls_says_what_holds_it_back(cells: float) -> None:
    """On a level plane a disk of .5 m that rolls loses two thirds of the share said of g."""
    radius, speed, end = 0.5, 1.0, 0.5
    cell = radius / cells
    scene = lp.Scene(
        grid=lp.Grid(lower=(-1.0, -0.5), upper=(2.0, 1.5), cell=cell),
        bodies=[
            lp.Body(
                shape=lp.Disk(center=(0.013, radius), radius=radius),
                material=lp.Elastic(density=1000, youngs_modulus=1e8, poissons_ratio=0.3),
                velocity=(speed, 0.0),
                spin=(-speed / radius,),
            )
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -9.81),
            obstacles=[
                lp.Obstacle(
                    shape=lp.HalfSpace(point=(0.0, 0.0), normal=(0, 1)),
                    contact="frictional",
                    friction=0.6,
                )
            ],
        ),
        time=lp.Time(end=end),
    )
    (note,) = said(scene)
    held = float(note.split("slower than a round body, and ")[1].split()[0]) / 100
    lost = 1.0 - bounce(scene)[0] / speed
    assert lost == pytest.approx(2 / 3 * held * 9.81 * end / speed, rel=0.6)
