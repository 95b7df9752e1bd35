"""Faces of the grid hold bodies up to a cell away, and say so."""

from __future__ import annotations

import json

import pytest

import lapilli as lp
from lapilli import _core


def notes(bottom: float, *, obstacle: bool = False, face: str = "y_lower") -> list[str]:
    """Of a block above the lower face of a grid of cells of 0.25 m."""
    block = lp.Body(
        name="block",
        shape=lp.Box(lower=(1, bottom), upper=(2, bottom + 1)),
        material=lp.Elastic(density=1000, youngs_modulus=1e5, poissons_ratio=0.3),
    )
    floor = lp.HalfSpace(point=(0, 0.5), normal=(0, 1))
    hold = (
        {"obstacles": [lp.Obstacle(name="floor", shape=floor)]}
        if obstacle
        else {"grid_boundaries": [lp.FrictionalBoundary(face=face, coefficient=0.2)]}
    )
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 4), cell=0.25),
        bodies=[block],
        dynamics=lp.Dynamics(gravity=(0, -10), **hold),
        time=lp.Time(end=0.1),
    )
    found = json.loads(_core.check_json(scene))["notes"]
    return [note for note in found if "grid boundary" in note]


def test_a_body_that_touches_a_face_is_held_where_it_is() -> None:
    assert notes(0.0) == []


@pytest.mark.parametrize("bottom", [0.0625, 0.125, 0.25])
def test_a_body_near_a_face_is_held_already(bottom: float) -> None:
    (note,) = notes(bottom)
    assert "cells from the grid boundary y_lower, whose nodes hold it already" in note


def test_a_body_that_falls_stops_early() -> None:
    (note,) = notes(1.0)
    assert "falls onto the grid boundary y_lower" in note
    assert notes(1.0, face="x_upper") == []


def test_an_obstacle_is_where_it_is_drawn() -> None:
    assert notes(1.0, obstacle=True) == []
