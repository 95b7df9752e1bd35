"""Bodies that a prescribed motion takes past conditions that stay in space: automatic steps follow
the motion where the result depends on it, and only there; a given step that does not says so."""

from __future__ import annotations

import json

import numpy as np
import numpy.typing as npt
import pytest

import lapilli as lp
from lapilli import _core

Array = npt.NDArray[np.float64]
CELL = 0.125
UPPER = lp.HalfSpace(point=(0, 0), normal=(0, -1))


def notes(scene: lp.Scene, words: str) -> list[str]:
    return [note for note in json.loads(_core.check_json(scene))["notes"] if words in note]


def roll(motion: object, boundaries: list[object], end: float, **time: object) -> lp.Scene:
    """A disk of 10 cells across and diffusivity 1, insulated but for its boundaries."""
    return lp.Scene(
        grid=lp.Grid(lower=(-1, -1), upper=(1, 1), cell=CELL),
        bodies=[
            lp.Body(
                name="roll",
                shape=lp.Disk(radius=0.625),
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
                motion=motion,
            )
        ],
        heat=lp.Heat(boundaries=boundaries),
        time=lp.Time(end=end, **time),
    )


def by_regions() -> list[object]:
    return [
        lp.Flux(name="burner", value=1.0, region=UPPER),
        lp.Convection(name="water", coefficient=1.0, ambient=0.0),
    ]


def by_place() -> list[object]:
    def ambient(place: Array, _temperature: Array, _time: float) -> Array:
        return np.where(place[:, 1] > 0, 1.0, 0.0)

    return [lp.Convection(name="gas", coefficient=1.0, ambient=ambient)]


def at_end(scene: lp.Scene) -> tuple[Array, lp.Simulation]:
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    return simulation.by_id("temperature").copy(), simulation


@pytest.mark.parametrize("conditions", [by_regions, by_place])
@pytest.mark.parametrize("turns", [0.3, 1.0])
def test_a_turn_within_a_step_of_heat_is_followed(conditions, turns: float) -> None:
    """Worst where the step of heat is a whole turn: one side would always be the heated one."""
    end = 0.05
    heat = lp.Simulation(roll(None, conditions(), end))
    for _ in range(15):  # past the short steps of the start
        heat.step()
    before = heat.time
    heat.step()
    period = (heat.time - before) / turns
    motion = lp.Rotation(revolutions_per_second=1 / period)
    found, simulation = at_end(roll(motion, conditions(), end))
    fine, _ = at_end(roll(motion, conditions(), end, step=period / 250))
    # Found .011 with regions, whose edges are sharp, and .001 with functions.
    assert np.abs(found - fine).max() < 0.015 * np.abs(fine).max()
    assert abs(simulation.balance()[0].residual) < 1e-11


@pytest.mark.parametrize("velocity", [(3.0, 0.0), (2.0, -2.0)])
def test_a_burner_that_a_body_passes_gives_what_it_should(velocity: tuple[float, float]) -> None:
    """The heat is the flux times the length that the region covers, in the mean of a passage."""
    scene = roll(lp.Translation(velocity=velocity), [], 0.3)
    scene.grid = lp.Grid(lower=(-1, -2), upper=(2, 1), cell=CELL)
    burner = lp.Flux(value=1.0, region=lp.Box(lower=(0.2, -0.4), upper=(0.6, 0.2)))
    scene.heat = lp.Heat(boundaries=[burner])
    found, simulation = at_end(scene)
    _, fine = at_end(scene.set(f"time.step={simulation.step_size / 4!r}"))
    gave, should = (one.balance()[0].supplied for one in (simulation, fine))
    assert gave == pytest.approx(should, rel=0.01)
    assert np.isfinite(found).all()


def test_uniform_conditions_do_not_pay_for_the_motion() -> None:
    uniform = [lp.Convection(coefficient=1.0, ambient=1.0)]
    _, at_rest = at_end(roll(None, uniform, 0.1))
    for motion in (lp.Rotation(revolutions_per_second=1e4), lp.Translation(velocity=(1e3, 0))):
        _, simulation = at_end(roll(motion, uniform, 0.1))
        gave, should = (one.balance()[0].supplied for one in (simulation, at_rest))
        assert gave == pytest.approx(should, rel=1e-9)
        assert simulation.step_index == at_rest.step_index


def test_a_given_step_that_outruns_the_motion_says_so() -> None:
    motion = lp.Rotation(revolutions_per_second=50.0)
    step = 1e-3  # a twentieth of a turn
    for conditions in (by_regions(), by_place()):
        (note,) = notes(roll(motion, conditions, 0.1, step=step), "follows the motion")
        assert "leave time.step out" in note
        assert not notes(roll(motion, conditions, 0.01), "follows the motion")
    uniform = [lp.Convection(coefficient=1.0, ambient=1.0)]
    assert not notes(roll(motion, uniform, 0.1, step=step), "follows the motion")


def test_strong_convection_says_so_where_a_region_does_not_turn_along() -> None:
    motion = lp.Rotation(revolutions_per_second=1.0)
    strong = [
        lp.Convection(coefficient=300.0, ambient=1.0, region=UPPER),
        lp.Convection(coefficient=300.0, ambient=1.0),
    ]
    assert len(notes(roll(motion, strong, 0.01), "times conductivity / cell")) == 2
    assert notes(roll(motion, strong[1:], 0.01), "times conductivity / cell") == []
    assert notes(roll(None, strong, 0.01), "times conductivity / cell") == []


def test_a_conductivity_with_axes_says_where_it_does_not_turn() -> None:
    def with_axes(motion: object, boundaries: list[object], rotation: float = 0.0) -> lp.Scene:
        scene = roll(motion, boundaries, 0.01)
        scene.bodies[0].material = lp.Thermal(
            density=1, specific_heat=1, conductivity=(1, 0.1, 0.1, 0, 0, 0)
        )
        scene.bodies[0].rotation = rotation
        return scene

    turning = lp.Rotation(revolutions_per_second=1.0)
    uniform = [lp.Convection(coefficient=1.0, ambient=1.0)]
    assert notes(with_axes(turning, by_regions()), "axes of its conductivity stay")
    assert notes(with_axes(None, uniform, 90.0), "does not turn the conductivity")
    assert not notes(with_axes(turning, uniform), "conductivity")
    assert not notes(with_axes(None, uniform), "conductivity")
    sliding = lp.Translation(velocity=(0.1, 0.0))
    assert not notes(with_axes(sliding, by_regions()), "axes of its conductivity")
