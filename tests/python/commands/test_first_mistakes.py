"""Mistakes of a first hour: what is said names the numbers that are wrong, or their unit."""

from __future__ import annotations

import json

import pytest

import lapilli as lp
from lapilli import _core
from lapilli.note import notes_in

TETRAHEDRON = {
    "vertices": [(0, 0, 0), (30, 0, 0), (0, 30, 0), (0, 0, 30)],
    "triangles": [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)],
}


def part(scale: float, region: lp.Box) -> lp.Scene:
    """A part drawn in millimetres, cooled on a part of its surface."""
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0, 0), upper=(0.04, 0.04, 0.04), cell=0.004),
        bodies=[
            lp.Body(
                shape=lp.Mesh(**TETRAHEDRON, scale=scale),
                material=lp.Thermal(density=2700, specific_heat=900, conductivity=160),
            )
        ],
        heat=lp.Heat(
            boundaries=[lp.Convection(name="air", coefficient=10, ambient=1, region=region)]
        ),
        time=lp.Time(end=1),
    )


HERE = lp.Box(lower=(-0.01, -0.01, -0.01), upper=(0.01, 0.04, 0.04))


def test_a_part_in_millimetres_is_told_its_scale() -> None:
    lp.Simulation(part(0.001, HERE))
    with pytest.raises(ValueError, match=r"0 to 30 m, the grid 0 to 0.04 m.* scale = 0.001"):
        lp.Simulation(part(1, HERE))


def test_a_region_that_covers_nothing_says_where_it_is() -> None:
    away = lp.Box(lower=(-10, -10, -10), upper=(10, 40, 40))  # millimetres: it covers all
    lp.Simulation(part(0.001, away))
    away = lp.Box(lower=(20, 0, 0), upper=(40, 40, 40))
    with pytest.raises(ValueError, match=r"\(air\) selects no surface: its region \(x 20 to 40, "):
        lp.Simulation(part(0.001, away))


def test_a_load_that_covers_nothing_says_where_it_is() -> None:
    soil = lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3)
    region = lp.Box(lower=(3, 0), upper=(4, 1))
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(2, 2), cell=0.25),
        bodies=[lp.Body(shape=lp.Box(lower=(0, 0), upper=(1, 1)), material=soil)],
        dynamics=lp.Dynamics(boundaries=[lp.Pressure(value=1, region=region)]),
        time=lp.Time(end=0.1),
    )
    with pytest.raises(ValueError, match=r"its region \(x 3 to 4, y 0 to 1 m\) covers none"):
        lp.Simulation(scene)


@pytest.mark.parametrize(
    ("cold", "expansion", "codes"),
    [(293.0, 3.4e-3, set()), (20.0, 3.4e-3, {"peridynamics.large-expansion"})],
)
def test_kelvin_beside_celsius_is_noticed_in_a_fluid(
    cold: float, expansion: float, codes: set[str]
) -> None:
    sides = {
        "left": ((-0.3, -0.3), (0, 1.3), 303.0),
        "right": ((1, -0.3), (1.3, 1.3), cold),
        "floor": ((0, -0.3), (1, 0), None),
        "lid": ((0, 1), (1, 1.3), None),
    }
    walls = [
        lp.FluidWall(
            name=name,
            shape=lp.Box(lower=low, upper=high),
            **({} if held is None else {"heat": "temperature", "temperature": held}),
        )
        for name, (low, high, held) in sides.items()
    ]
    air = [
        lp.Thermal(density=1.2, specific_heat=1005, conductivity=0.026),
        lp.Newtonian(density=1.2, viscosity=1.8e-5, thermal_expansion=expansion),
    ]
    scene = lp.Scene(
        grid=lp.Grid(lower=(-0.5, -0.5), upper=(1.5, 1.5), cell=0.1),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0, 0), upper=(1, 1)),
                material=air,
                points_per_cell=1,
                temperature=cold,
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(), flow=lp.PeridynamicFlow(gravity=(0, -9.81)), walls=walls
        ),
        time=lp.Time(end=0.01),
    )
    said = notes_in(json.loads(_core.check_json(scene)), "notes", "note_codes")
    assert {one.code for one in said} == codes
    assert {one.code for one in lp.run(scene, progress=False).summary.notes} == codes
