"""A region takes the surface up to where its boundary passes through it, at whatever angle; where
its boundary runs along the surface, all of it."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pytest

import lapilli as lp

CELL = 0.1
Array = npt.NDArray[np.float64]


def found_area(shape: lp.Shape, region: lp.Shape) -> float:
    scene = lp.Scene(
        grid=lp.Grid(lower=(-2, -2), upper=(2, 2), cell=CELL),
        bodies=[
            lp.Body(shape=shape, material=lp.Thermal(density=1, specific_heat=1, conductivity=1))
        ],
        heat=lp.Heat(boundaries=[lp.Flux(name="part", value=1.0, region=region)]),
        time=lp.Time(end=0.001),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(0.001)
    return simulation.balance()[0].entries["part"] / 0.001


def length_within(corners: Array, point: Array, normal: Array) -> float:
    """Of the edges of a polygon, on the inner side of a half-space."""
    total = 0.0
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        depth = np.array([(point - a) @ normal, (point - b) @ normal])
        share = 0.5 * (1 + np.sign(depth[0])) if np.ptp(depth) == 0 else 0.0
        if np.ptp(depth) > 0:
            share = np.clip(depth.max() / np.ptp(depth), 0.0, 1.0)
        total += share * np.linalg.norm(b - a)
    return total


@pytest.mark.parametrize("tilt", [6.0, 10.0, 15.0, 20.0, 30.0, 50.0, 80.0])
@pytest.mark.parametrize("turn", [0.0, 17.0, 63.0])
def test_a_half_space_that_passes_a_face(tilt: float, turn: float) -> None:
    """Found 1.1 cells more at 15 degrees."""
    a, b = np.radians(turn), np.radians(turn + tilt)
    corners = np.array([(-1.0, -0.6), (1.0, -0.6), (1.0, 0.6), (-1.0, 0.6)])
    corners = corners @ np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]])
    middle = 0.5 * (corners[2] + corners[3]) + 0.013  # of the face that it passes
    normal = np.array([-np.sin(b), np.cos(b)])
    shape = lp.Polygon(vertices=[tuple(corner) for corner in corners])
    area = found_area(shape, lp.HalfSpace(point=tuple(middle), normal=tuple(normal)))
    assert area == pytest.approx(length_within(corners, middle, normal), abs=0.05 * CELL)


@pytest.mark.parametrize("angle", [17.0, 25.0, 40.0, 70.0])
def test_a_half_space_that_takes_the_cap_of_a_disk(angle: float) -> None:
    """The complement of the cap, whose ends lie at `angle` from its middle."""
    height = np.cos(np.radians(angle))
    region = lp.HalfSpace(point=(0.0, height), normal=(0.0, 1.0))
    area = found_area(lp.Disk(center=(0.0, 0.0), radius=1.0), region)
    assert area == pytest.approx(2 * np.pi - 2 * np.radians(angle), abs=0.06 * CELL)


@pytest.mark.parametrize(("depth", "tilt"), [(0.0, 0.0), (0.3, 0.0), (0.1, 0.3), (0.15, -1.0)])
def test_a_region_that_runs_along_a_face_has_it(depth: float, tilt: float) -> None:
    """Drawn up to a third of a cell below it, and not quite parallel."""
    angle = np.radians(tilt)
    region = lp.HalfSpace(point=(0.0, 0.5 - depth * CELL), normal=(np.sin(angle), np.cos(angle)))
    shape = lp.Box(lower=(-1.0, -0.5), upper=(1.0, 0.5))
    # Its ends pass the faces beside.
    assert found_area(shape, region) == pytest.approx(6.0 - 2 * depth * CELL, abs=0.05 * CELL)


@pytest.mark.parametrize("corners", [16, 24, 40])
def test_a_round_region_has_the_polygon_that_stands_for_its_circle(corners: int) -> None:
    """The circle touches the middles of its edges."""
    angles = 2 * np.pi * np.arange(corners) / corners
    inner = np.cos(np.pi / corners)
    shape = lp.Polygon(vertices=[(np.cos(a), np.sin(a)) for a in angles])
    region = lp.Disk(center=(0.0, 0.0), radius=inner)
    whole = 2 * corners * np.sin(np.pi / corners)
    assert found_area(shape, region) == pytest.approx(whole, rel=1e-3)
