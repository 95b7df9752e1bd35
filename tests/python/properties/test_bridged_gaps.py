"""Gaps that are too narrow for the cells are said: heat passes through them."""

from __future__ import annotations

import json

import pytest

import lapilli as lp
from lapilli import _core

CELL = 0.1
WARM = lp.Thermal(density=1, specific_heat=1, conductivity=1)


def notes(shapes: list[lp.Shape], degrees: float, material: lp.Thermal = WARM) -> list[str]:
    turned = [lp.Rotated(shape=shape, degrees=degrees, center=(0, 0)) for shape in shapes]
    scene = lp.Scene(
        grid=lp.Grid(lower=(-2, -2), upper=(2, 2), cell=CELL),
        bodies=[
            lp.Body(name=f"body {k}", shape=shape, material=material)
            for k, shape in enumerate(turned)
        ],
        heat=lp.Heat(boundaries=[lp.Flux(value=1.0)]),
        time=lp.Time(end=0.01),
    )
    return [note for note in json.loads(_core.check_json(scene))["notes"] if "is bridged" in note]


def fork(slot: float) -> lp.Shape:
    body = lp.Box(lower=(-1, -0.8), upper=(1, 0.8))
    return lp.Difference(shape=body, minus=lp.Box(lower=(-0.6, -0.5 * slot), upper=(2, 0.5 * slot)))


@pytest.mark.parametrize("degrees", [0, 20])
@pytest.mark.parametrize(("cells", "told"), [(0.3, True), (1.0, True), (3.0, False)])
def test_a_slot(degrees: float, cells: float, told: bool) -> None:
    found = notes([fork(cells * CELL)], degrees)
    assert bool(found) == told
    if told:
        assert f"a gap of {cells * CELL:g}" in found[0]


def test_a_slot_in_a_body_that_melts() -> None:
    ice = lp.Thermal(
        density=1, specific_heat=1, conductivity=1, latent_heat=1, solidus=1.0, liquidus=2.0
    )
    assert notes([fork(CELL)], 0, ice)


@pytest.mark.parametrize("degrees", [0, 20])
def test_whole_bodies_say_nothing(degrees: float) -> None:
    square = lp.Box(lower=(-0.5, -0.5), upper=(0.5, 0.5))
    assert not notes([square], degrees)
    assert not notes([lp.Annulus(inner=0.3, outer=1.0)], degrees)
    # Apart, they have nodes of their own.
    assert not notes([square, lp.Box(lower=(0.55, -0.5), upper=(1.0, 0.5))], degrees)
