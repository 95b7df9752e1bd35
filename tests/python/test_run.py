"""Running scenes from Python: views, callbacks, functions, frames, resume, interrupts."""

import gc
import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp


def test_a_run_gives_fields_ledger_frames_and_record(ring: lp.Scene, tmp_path: Path) -> None:
    result = lp.run(ring, tmp_path / "ring.vtkhdf", every=0.25, progress=False)
    assert result.summary.finished
    assert result.time == 1.0
    np.testing.assert_allclose(result.times, [0, 0.25, 0.5, 0.75, 1])
    assert 0 < result["temperature"].min() < result["temperature"].max() < 1
    heat = result.balance["heat"]
    assert abs(heat.residual) < 1e-12
    assert heat.supplied == pytest.approx(sum(heat.entries.values()))
    assert heat.stored == pytest.approx(result["volume"] @ result["temperature"], rel=1e-2)
    last = result.frames[-1]
    np.testing.assert_array_equal(last["temperature"], result.by_id("temperature"))
    np.testing.assert_array_equal(last.position[:, :2], result.by_id("position"))
    assert result.record["status"] == "finished"


def test_a_view_keeps_the_simulation_alive(ring: lp.Scene) -> None:
    simulation = lp.Simulation(ring)
    simulation.step()
    view = simulation["temperature"]
    before = view.copy()
    del simulation
    gc.collect()
    np.testing.assert_array_equal(view, before)
    assert not view.flags.writeable
    assert not view.flags.owndata


def test_by_id_is_a_sorted_copy(ring: lp.Scene) -> None:
    simulation = lp.Simulation(ring)
    assert (simulation.by_id("id") == np.arange(len(simulation))).all()
    np.testing.assert_array_equal(
        simulation.by_id("position"), simulation.position[np.argsort(simulation["id"])]
    )


def test_an_unknown_field_names_the_nearest(ring: lp.Scene) -> None:
    with pytest.raises(KeyError, match="did you mean 'temperature'"):
        lp.Simulation(ring)["temprature"]


def test_run_until_stops_exactly_and_when_told(ring: lp.Scene) -> None:
    simulation = lp.Simulation(ring)
    simulation.run_until(0.3)
    assert simulation.time == 0.3
    steps = []
    simulation.run_until(1.0, lambda s: steps.append(s.time) or len(steps) < 3)
    assert len(steps) == 3
    assert simulation.time == steps[-1] < 1.0


def test_an_error_in_a_callback_comes_through(ring: lp.Scene) -> None:
    def fail(simulation: lp.Simulation) -> None:
        raise LookupError("stop here")

    with pytest.raises(LookupError, match="stop here"):
        lp.Simulation(ring).run_until(1.0, fail)
    with pytest.raises(LookupError, match="stop here"):
        lp.run(ring, progress=False, callback=fail)


def test_a_function_is_called_with_whole_arrays(ring: lp.Scene) -> None:
    calls = []

    def ambient(position, temperature, time):
        calls.append((position.shape, temperature.shape, time))
        return np.ones(len(position))

    constant = lp.run(ring, progress=False)["temperature"].copy()
    ring.heat.boundaries[0].ambient = ambient
    function = lp.run(ring, progress=False)["temperature"]
    # The exchange of a constant coefficient and ambient is centred in the step, others are not.
    np.testing.assert_allclose(function, constant, atol=3e-3)
    (rows, columns), states, _ = calls[-1]
    assert columns == 3
    assert states == (rows,)


def test_a_function_that_fails_or_answers_nonsense_stops_the_run(ring: lp.Scene) -> None:
    ring.heat.boundaries[0].ambient = lambda position, temperature, time: 1 / 0
    with pytest.raises(ZeroDivisionError):
        lp.run(ring, progress=False)
    ring.heat.boundaries[0].ambient = lambda position, temperature, time: np.ones(3)
    with pytest.raises(lp.RunError, match=r"shape \(3,\); one number, or one a place"):
        lp.run(ring, progress=False)


def test_a_step_above_the_limit_is_refused(ring: lp.Scene) -> None:
    ring.time.step = 1e3
    with pytest.raises(ValueError, match=r"time\.step of 1000 s is above the limit"):
        lp.Simulation(ring)


def test_a_stopped_run_resumes_to_the_same_bytes(ring: lp.Scene, tmp_path: Path) -> None:
    whole = lp.run(ring, tmp_path / "whole.vtkhdf", every=0.25, progress=False)
    path = tmp_path / "cut.vtkhdf"
    cut = lp.run(ring, path, every=0.25, progress=False, callback=lambda s: s.time < 0.6)
    assert not cut.summary.finished
    resumed = lp.run(ring, path, every=0.25, progress=False, resume=True)
    assert resumed["temperature"].tobytes() == whole["temperature"].tobytes()
    np.testing.assert_array_equal(resumed.times, whole.times)


def test_threads_do_not_change_the_bytes(ring: lp.Scene) -> None:
    before = lp.thread_count()
    states = [lp.run(ring, threads=n, progress=False)["temperature"].tobytes() for n in (1, 2, 4)]
    assert states[0] == states[1] == states[2]
    assert lp.thread_count() == before


def test_ctrl_c_ends_the_run_with_frame_and_checkpoint(ring: lp.Scene, tmp_path: Path) -> None:
    ring.time.end = 1e9
    ring.heat.time_integration = "explicit"  # steps that are chosen grow without end at rest
    path = tmp_path / "long.vtkhdf"
    # a runner started in the background ignores the signal
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    started = time.perf_counter()
    try:
        with pytest.raises(KeyboardInterrupt):
            lp.run(ring, path, progress=False)
    finally:
        timer.join()
        signal.signal(signal.SIGINT, before)
    assert time.perf_counter() - started < 60
    assert len(lp.Frames(path)) >= 1
    assert path.with_suffix(".checkpoint").is_file()


def test_two_threads_cannot_step_one_simulation(ring: lp.Scene) -> None:
    simulation = lp.Simulation(ring)
    inside, done, said = threading.Event(), threading.Event(), []

    def wait(_: lp.Simulation) -> None:
        inside.set()
        done.wait(60)

    thread = threading.Thread(target=simulation.run_until, args=(0.1, wait))
    thread.start()
    assert inside.wait(60)
    for use in (simulation.step, lambda: simulation["temperature"]):
        try:
            use()
        except RuntimeError as error:
            said.append(str(error))
    done.set()
    thread.join()
    assert len(said) == 2
    assert "another thread" in said[1]


def test_positions_have_rows_and_columns_in_one_dimension_too(steel: lp.Thermal) -> None:
    scene = lp.Scene(
        grid=lp.Grid(lower=[0], upper=[1], cell=0.25),
        bodies=[lp.Body(shape=lp.Box(lower=[0], upper=[1]), material=steel)],
        heat=lp.Heat(),
        time=lp.Time(end=1),
    )
    simulation = lp.Simulation(scene)
    assert simulation.position.shape == (len(simulation), 1)
    assert simulation["temperature"].shape == (len(simulation),)


def test_every_field_has_a_unit(ring: lp.Scene) -> None:
    simulation = lp.Simulation(ring)
    units = {name: simulation.unit(name) for name in simulation.fields}
    assert units["position"] == "m"
    assert units["volume"] == "m^2"
    assert units["id"] == ""
    assert units["temperature"] == "K"
