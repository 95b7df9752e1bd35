"""Python functions handed to a scene: what they may answer, and what is said when they do not."""

import numpy as np
import pytest

import lapilli as lp


def stepped(ring: lp.Scene, law) -> lp.Simulation:
    ring.heat = lp.Heat(boundaries=[law])
    simulation = lp.Simulation(ring)
    simulation.step()
    return simulation


def test_a_function_is_called_on_whole_arrays(ring: lp.Scene) -> None:
    shapes = []

    def ambient(position, temperature, time):
        shapes.append((position.shape, temperature.shape, time))
        return np.ones(len(position))

    stepped(ring, lp.Convection(coefficient=1, ambient=ambient))
    nodes = shapes[0][0][0]
    assert nodes > 10
    assert all(one[:2] == ((nodes, 3), (nodes,)) for one in shapes)
    assert 0 < shapes[-1][2] < 0.1  # s: in the middle of the step; asked ahead before that


@pytest.mark.parametrize(
    ("function", "message"),
    [
        (lambda x, T, t: -3.0, r"heat.boundaries\[0\].coefficient, at \(.*\) and .* s: .*got -3"),
        (lambda x, T, t: np.nan, r"heat.boundaries\[0\].coefficient, at .*got nan"),
        (
            lambda x, T, t: "hot",
            r"heat.boundaries\[0\].coefficient was called for .* places and answered 'hot'",
        ),
        (lambda x, T, t: None, "answered None|got nan"),
        (lambda x, T, t: np.ones((2, 2)), r"answered an array of shape \(2, 2\)"),
    ],
)
def test_a_useless_answer_is_named(ring: lp.Scene, function, message: str) -> None:
    with pytest.raises(lp.RunError, match=message):
        stepped(ring, lp.Convection(coefficient=function, ambient=1))


def test_an_error_of_the_function_keeps_its_type_and_says_where_it_was_called(
    ring: lp.Scene,
) -> None:
    with pytest.raises(TypeError, match="positional argument") as error:
        stepped(ring, lp.Flux(value=lambda x: 1.0))
    notes = getattr(error.value, "__notes__", [])
    assert any("heat.boundaries[0].value" in note for note in notes)


def test_points_say_which_arrays_they_need() -> None:
    with pytest.raises(TypeError, match="unknown key 'volume'; did you mean 'volumes'"):
        lp.Points(positions=[[0.0, 0.0]], volume=[1.0])
    with pytest.raises(TypeError, match="needs two arrays"):
        lp.Points(positions=[["a", "b"]], volumes=[1.0])


def test_a_position_that_is_not_finite_is_named() -> None:
    points = lp.Points(positions=[[0.5, 0.5], [np.nan, 0.5]], volumes=[0.01, 0.01])
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1, 1), cell=0.1),
        bodies=[
            lp.Body(
                points=points,
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
            )
        ],
        heat=lp.Heat(),
        time=lp.Time(end=1),
    )
    with pytest.raises(ValueError, match="point 1 has a position that is not finite"):
        lp.Simulation(scene)


def test_run_until_needs_a_time(ring: lp.Scene) -> None:
    with pytest.raises(ValueError, match="run_until needs a time, got nan"):
        lp.Simulation(ring).run_until(float("nan"))
