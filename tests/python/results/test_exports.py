"""Frames as time series, and as objects of xarray and pyvista."""

import logging

import numpy as np
import pytest

import lapilli as lp
from lapilli import examples


def test_a_time_series_is_what_a_probe_of_the_run_records(heated: lp.Result) -> None:
    series = heated.frames.time_series("temperature", probe=(2.03, 1.71))
    history = heated.history
    rows = [int(np.argmin(np.abs(history["time"] - t))) for t in heated.times]
    # the same fit; sums in another order
    np.testing.assert_allclose(
        series["temperature"], history["middle"].to_numpy()[rows], rtol=1e-12
    )
    assert series.unit("temperature") == "K"
    by_name = heated.frames.time_series("temperature", probe="middle")
    np.testing.assert_array_equal(by_name["temperature"], series["temperature"])


def test_a_time_series_has_nothing_where_no_material_is(heated: lp.Result) -> None:
    assert np.isnan(heated.frames.time_series("temperature", probe=(0.2, 0.2))["temperature"]).all()


def test_a_time_series_of_a_point_has_each_component(falling: lp.Result) -> None:
    frames = falling.frames
    series = frames.time_series("velocity", point=3)
    expected = [frame["velocity"][3] for frame in frames]
    for k, axis in enumerate("xyz"):
        np.testing.assert_array_equal(series[f"velocity.{axis}"], np.array(expected)[:, k])
    assert list(frames.time_series("velocity.y", point=3).keys()) == ["time", "velocity.y"]


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({}, "either probe=.* or point=id"),
        ({"probe": (1, 1), "point": 3}, "either probe=.* or point=id"),
        ({"probe": (1, 1, 1)}, "2 coordinates"),
        ({"probe": "centre"}, "no probe 'centre' in .* there is 'middle'"),
        ({"point": 10**6}, "no point 1000000 .* from 0 to"),
    ],
)
def test_a_time_series_says_what_it_needs(heated: lp.Result, given: dict, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        heated.frames.time_series("temperature", **given)


def test_components_are_fields_by_name(falling: lp.Result) -> None:
    last = falling.frames[-1]
    np.testing.assert_array_equal(last["velocity.y"], last["velocity"][:, 1])
    np.testing.assert_array_equal(last["stress.xy"], last["stress"][:, 1])
    np.testing.assert_array_equal(last["stress.yy"], falling.by_id("stress.yy"))
    # nine numbers on disk, fewer in the state: one size
    np.testing.assert_allclose(last["stress.magnitude"], falling.by_id("stress.magnitude"))
    right = last.body("right")
    assert repr(right) == f"<body right, {len(right)} points>"
    np.testing.assert_array_equal(right["velocity.y"], last["velocity"][right.rows][:, 1])
    simulation = falling.simulation
    np.testing.assert_array_equal(simulation["stress.yy"], falling["stress.yy"])
    np.testing.assert_array_equal(simulation.by_id("velocity.x"), falling.by_id("velocity.x"))
    for state in (falling, simulation):
        with pytest.raises(KeyError, match=r"did you mean 'velocity\.x'"):
            state["velocity.q"]


def test_xarray_holds_every_frame_with_units(falling: lp.Result) -> None:
    pytest.importorskip("xarray")
    data = falling.to_xarray()
    frames = falling.frames
    assert data["velocity"].dims == ("time", "point", "axis")
    assert data["velocity"].attrs["units"] == "m/s"
    np.testing.assert_array_equal(data["time"], frames.times)
    np.testing.assert_array_equal(data["velocity"].sel(axis="y")[2], frames[2]["velocity.y"])
    speed = data["velocity"].sel(axis="y").groupby("body").mean().isel(time=0)
    np.testing.assert_allclose(speed, [-1, -2], atol=1e-12)


def test_xarray_without_frames_holds_the_last_state() -> None:
    pytest.importorskip("xarray")
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1, 1), cell=0.25),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0, 0), upper=(1, 1)),
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
            )
        ],
        heat=lp.Heat(),
        time=lp.Time(end=0.01),
    )
    result = lp.run(scene, progress=False)
    data = result.to_xarray()
    np.testing.assert_array_equal(data["temperature"][0], result.by_id("temperature"))


def test_pyvista_has_the_points_with_all_fields(falling: lp.Result) -> None:
    pytest.importorskip("pyvista")
    frame = falling.frames[-1]
    cloud = frame.to_pyvista()
    np.testing.assert_array_equal(cloud.points, frame.position)
    np.testing.assert_array_equal(cloud["velocity"], frame["velocity"])
    assert set(cloud.point_data.keys()) == set(falling.frames.fields)
    assert frame.to_pyvista(["body"]).point_data.keys() == ["body"]
    with pytest.raises(ValueError, match="no field 'heat'"):
        frame.to_pyvista(["heat"])


def test_runs_are_logged(caplog: pytest.LogCaptureFixture) -> None:
    scene = lp.Scene.parse(SCENE)
    with caplog.at_level(logging.INFO, "lapilli"):
        lp.run(scene, progress=False)
    told = [(record.levelname, record.getMessage()) for record in caplog.records]
    assert told[0] == ("INFO", "small: run of 64 points to 0.01 s")
    assert any(level == "WARNING" and "heat.theta has no effect" in text for level, text in told)
    assert told[-1][1].startswith("small: <finished at 0.01 s, 64 points>")


SCENE = """
title = "small"
[grid]
lower = [0.0, 0.0]
upper = [1.0, 1.0]
cell = 0.25
[[bodies]]
shape = {kind = "box", lower = [0.0, 0.0], upper = [1.0, 1.0]}
points_per_cell = 4
material = {kind = "thermal", density = 1.0, specific_heat = 1.0, conductivity = 1.0}
[heat]
theta = 0.7
[time]
end = 0.01
"""


def test_what_a_run_in_memory_should_say_is_heard(caplog: pytest.LogCaptureFixture) -> None:
    # A bar under FLIP, which leaves nothing on disk that could tell.
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(2, 1), cell=0.25),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0.5, 0.25), upper=(1.5, 0.75)),
                material=lp.Elastic(density=1000, youngs_modulus=1e5, poissons_ratio=0.2),
            )
        ],
        dynamics=lp.Dynamics(transfer="flip"),
        time=lp.Time(end=0.01),
    )
    with caplog.at_level(logging.WARNING, "lapilli"):
        result = lp.run(scene, progress=False)
    assert result.warnings
    assert result.warnings == lp.Simulation(scene).warnings()
    logged = [record.getMessage() for record in caplog.records]
    assert all(any(one.line in line for line in logged) for one in result.warnings)
    assert all(one in result._repr_html_() for one in result.warnings)


def test_check_says_what_the_command_says() -> None:
    scene = examples.path("vhfm/ring")
    of_file, of_scene = lp.check(scene), lp.check(lp.Scene.load(scene))
    assert "models        heat conduction, convection" in of_file
    assert of_scene.partition("step ")[0] == of_file.partition("step ")[0]
    with pytest.raises(ValueError, match="no such file"):
        lp.check("nowhere.toml")
