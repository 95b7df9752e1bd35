"""References of closed boxes of fluid, set up from peridynamic scenes."""

import pytest

import lapilli as lp
from lapilli.extremes.fluid import cavity
from lapilli.study import tradeoff
from lapilli.study.reference import reference_of
from lapilli.study.runner import InProcess


def test_conduction_between_plates_improves_with_the_spacing() -> None:
    """Second order on a lattice: 3 leaves room for the next term; points of walls do not count."""
    scene = cavity(0.0, rows=10)
    study = {"vary": {"grid.cell": [0.1, 0.05]}, "reference": "plates", "times": [0.05]}
    rows = tradeoff(scene, **study, repeats=1, runner=InProcess()).rows
    assert rows[0].error > 3 * rows[1].error > 0
    assert rows[1].points > 400


def test_steady_cavity_beside_finite_differences() -> None:
    """20 x 20 points at Ra 1e4: 1 % of the temperature difference."""
    scene = cavity(1e4, rows=20)
    study = {"vary": {"peridynamics.flow.sound_speed_factor": [3, 5]}, "reference": "cavity"}
    rows = tradeoff(scene, **study, times=[0.12], repeats=1, runner=InProcess()).rows
    assert all(row.error < 0.015 for row in rows)


@pytest.mark.parametrize(
    ("name", "scene", "says"),
    [
        ("cavity", cavity(0.0), "a viscous flow"),
        ("plates", cavity(1e4), "heat alone"),
        ("plates", cavity(0.0).set('peridynamics.walls.0.heat="adiabatic"'), "two walls"),
    ],
)
def test_scenes_without_such_a_reference_are_refused(name: str, scene: lp.Scene, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        reference_of(name, scene, "temperature", [0.1])
