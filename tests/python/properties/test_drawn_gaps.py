"""Bodies that lie apart by less than a drawing means are told by name; bodies that touch, that are
round beside the place where they touch, or lie clearly apart are not."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core

CELL = 0.1


def scene(shapes: list[lp.Shape], **more: object) -> lp.Scene:
    dimension = len(shapes[0].lower) if isinstance(shapes[0], lp.Box) else 2
    bodies = [
        lp.Body(
            name=f"part {k}",
            shape=shape,
            temperature=float(k),
            material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
        )
        for k, shape in enumerate(shapes)
    ]
    return lp.Scene(
        grid=lp.Grid(lower=[-2.5] * dimension, upper=[2.5] * dimension, cell=CELL),
        bodies=bodies,
        heat=lp.Heat(boundaries=[lp.Convection(coefficient=1, ambient=0)], **more),
        time=lp.Time(end=0.01),
    )


def notes(found: lp.Scene) -> list[str]:
    return [note for note in json.loads(_core.check_json(found))["notes"] if "of a drawing" in note]


def pair(gap: float, degrees: float = 0.0, dimension: int = 2) -> list[lp.Shape]:
    """Two boxes of a cell and more, side by side in x but for a gap, turned together."""
    reach = [0.5] * (dimension - 1)
    boxes: list[lp.Shape] = [
        lp.Box(lower=[-1.0, *(-r for r in reach)], upper=[0.03, *reach]),
        lp.Box(lower=[0.03 + gap, *(-r for r in reach)], upper=[1.0, *reach]),
    ]
    if degrees == 0.0:
        return boxes
    return [lp.Rotated(shape=box, degrees=degrees) for box in boxes]


@pytest.mark.parametrize("seed", range(12))
def test_a_gap_of_rounding_is_said_with_its_width_and_both_names(seed: int) -> None:
    rng = np.random.default_rng(seed)
    gap = CELL * 10 ** rng.uniform(np.log10(0.0025), np.log10(0.048))
    degrees = 0.0 if seed % 3 == 0 else rng.uniform(0, 90)
    (note,) = notes(scene(pair(gap, degrees)))
    assert "part 0 and part 1 are" in note
    assert f"({round(gap / CELL, 4):g} cells) apart" in note
    assert "no heat passes between them" in note


def test_a_gap_in_space_is_said() -> None:
    boxes = pair(0.01 * CELL, dimension=3)
    found = scene(boxes)
    found.grid = lp.Grid(lower=[-1.5] * 3, upper=[1.5] * 3, cell=CELL)
    assert len(notes(found)) == 1


@pytest.mark.parametrize("gap", [0.0, 0.0005 * CELL, 0.06 * CELL, 0.3 * CELL, -0.01 * CELL])
@pytest.mark.parametrize("degrees", [0.0, 23.0])
def test_what_touches_or_lies_apart_is_not_said(gap: float, degrees: float) -> None:
    assert notes(scene(pair(gap, degrees))) == []


@pytest.mark.parametrize("radius", [0.4, 1.0])
def test_round_bodies_that_touch_are_not_said(radius: float) -> None:
    for gap, said in ((0.0, 0), (-1e-9, 0), (0.01 * CELL, 1)):
        disks: list[lp.Shape] = [
            lp.Disk(center=(-radius, 0.0), radius=radius),
            lp.Disk(center=(radius + gap, 0.0), radius=radius),
        ]
        assert len(notes(scene(disks))) == said, gap


def test_a_gap_that_opens_along_a_face_is_said() -> None:
    """Turned by rounding: the boxes touch at one end of the face and gape at the other."""
    turned: list[lp.Shape] = [
        lp.Box(lower=(-1.0, -1.0), upper=(0.0, 1.0)),
        lp.Rotated(shape=lp.Box(lower=(0.0, -1.0), upper=(1.0, 1.0)), degrees=0.1, center=(0, 1)),
    ]
    (note,) = notes(scene(turned))
    assert "beside where they touch" in note


def test_the_record_says_it(tmp_path: Path) -> None:
    result = lp.run(scene(pair(0.01 * CELL)), tmp_path / "apart.vtkhdf", progress=False)
    assert sum("of a drawing" in note for note in result.warnings) == 1


def test_a_contact_across_a_gap_says_how_wide_it_is() -> None:
    contact = lp.HeatContact(bodies=["part 0", "part 1"], conductance=10.0)
    with pytest.raises(ValueError, match=r"do not touch: 0.001 m \(0.01 cells\) lie"):
        lp.Simulation(scene(pair(0.01 * CELL), contacts=[contact]))


def test_a_table_of_a_start_is_said() -> None:
    """Of a temperature in time a start has the first alone."""
    found = scene(pair(0.0))

    def about_start() -> list[str]:
        return [n for n in json.loads(_core.check_json(found))["notes"] if ".temperature" in n]

    assert about_start() == []
    found.bodies[1].temperature = lp.Table([0.0, 1.0], [300.0, 300.0])
    assert about_start() == []
    found.bodies[1].temperature = lp.Table([0.0, 1.0], [300.0, 400.0])
    (note,) = about_start()
    assert note.startswith("bodies.1.temperature (part 1) is a table in time")
    assert "300" in note
