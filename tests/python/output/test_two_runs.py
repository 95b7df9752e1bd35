"""Runs beside each other: in two processes, in threads, in forked processes."""

import gc
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core


def test_of_two_runs_on_one_output_one_is_refused(ring, tmp_path):
    output = tmp_path / "run.vtkhdf"
    ring.save(str(tmp_path / "ring.toml"))
    words = [
        sys.executable,
        "-m",
        "lapilli",
        "run",
        str(tmp_path / "ring.toml"),
        "--set=time.step=2e-3",
        "--every=0.05",
        "--quiet",
        f"--output={output}",
    ]
    pair = [
        subprocess.Popen(
            [*words, f"--set=bodies.0.temperature={number}"], stderr=subprocess.PIPE, text=True
        )
        for number in (0, 5)
    ]
    said = [process.communicate()[1] for process in pair]
    codes = [process.returncode for process in pair]
    refused = [number for number, code in enumerate(codes) if code == 3]
    for number in refused:  # the other may have ended before this one began
        assert f"process {pair[1 - number].pid}" in said[number]
    assert set(codes) <= {0, 3}, said
    last = max(range(2), key=lambda number: codes[number] == 0)
    frames = lp.Frames(output)
    assert len(frames) == 21
    if refused:
        start = frames[0]["temperature"]
        np.testing.assert_allclose(start, 5.0 * last, rtol=1e-14)


def contents(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in folder.iterdir() if file.suffix != ".json"}


def test_runs_in_threads_give_the_bytes_of_runs_one_after_the_other(ring, tmp_path):
    _core.set_thread_count(1)
    try:
        lp.run(ring, tmp_path / "alone" / "run.vtkhdf", 0.1, progress=False)
        errors = []

        def work(number):
            try:
                for turn in range(3):
                    folder = tmp_path / f"{number}_{turn}"
                    lp.run(ring, folder / "run.vtkhdf", 0.1, progress=False)
                    for frame in lp.Frames(folder / "run.vtkhdf"):
                        assert frame["temperature"].size > 0
                    _core.merge(str(folder / "run.vtkhdf"), str(tmp_path / f"{number}.vtkhdf"))
            except BaseException as error:
                errors.append(repr(error))

        threads = [threading.Thread(target=work, args=(number,)) for number in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert errors == []
        expected = contents(tmp_path / "alone")
        for folder in tmp_path.glob("?_?"):
            assert contents(folder) == expected
        merged = {file.read_bytes()[:4000] for file in tmp_path.glob("?.vtkhdf")}
        assert len(merged) >= 1
    finally:
        _core.set_thread_count(0)


def _step_once(scene):
    simulation = lp.Simulation(scene)
    simulation.step()
    return _core.thread_count(), simulation.by_id("temperature")


def test_a_process_forked_after_a_step_with_threads_can_go_on(ring):
    ring.grid.cell = 0.1
    _core.set_thread_count(2)
    try:
        here = _step_once(ring)
        pool = multiprocessing.get_context("fork").Pool(1)
        threads, there = pool.apply_async(_step_once, (ring,)).get(timeout=60)
        pool.terminate()
        assert threads == 1
        assert here[0] == 2
        np.testing.assert_array_equal(here[1], there)
    finally:
        _core.set_thread_count(0)


def test_other_threads_run_while_a_scene_is_built_and_checked(ring):
    ring.grid.cell = 0.03
    for work in (lambda: lp.Simulation(ring), lambda: _core.check_text(ring)):
        ticks, stop = [0], threading.Event()

        def spin(ticks=ticks, stop=stop):
            while not stop.is_set():
                ticks[0] += 1
                time.sleep(0.005)

        thread = threading.Thread(target=spin)
        thread.start()
        begun = time.monotonic()
        work()
        took = time.monotonic() - begun
        stop.set()
        thread.join()
        assert ticks[0] > 0.1 * took / 0.005


def test_ctrl_c_is_answered_while_a_scene_is_built(ring):
    """Within a second of computing, on one thread; other programs do not count."""
    ring.grid.cell = 0.01  # seconds of building
    asked = []

    def interrupt() -> None:
        asked.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    _core.set_thread_count(1)
    try:
        threading.Timer(0.1, interrupt).start()
        with pytest.raises(KeyboardInterrupt):
            lp.Simulation(ring)
        assert time.process_time() - asked[0] < 0.8
    finally:
        _core.set_thread_count(0)


def test_objects_without_init_are_errors(ring):
    simulation = lp.Simulation.__new__(lp.Simulation)
    for use in (
        lambda: simulation.step(),
        lambda: simulation.time,
        lambda: simulation["temperature"],
        lambda: len(simulation),
        lambda: len(_core.Points.__new__(_core.Points)),
        lambda: lp.Table.__new__(lp.Table).times,
        lambda: _core.Balance.__new__(_core.Balance),
        lambda: _core.FrameReader.__new__(_core.FrameReader).times,
    ):
        with pytest.raises((TypeError, RuntimeError)):
            use()
    gc.collect()


def test_a_shape_that_contains_itself_is_an_error(ring):
    union = lp.Union(shapes=[lp.Disk(radius=1)])
    union.shapes.append(union)
    ring.bodies[0].shape = union
    for use in (
        lambda: lp.Simulation(ring),
        lambda: _core.check_text(ring),
        lambda: ring.to_toml(),
        lambda: union.distance(np.zeros((1, 2))),
    ):
        with pytest.raises((ValueError, RecursionError)):
            use()
    assert "..." in repr(union)


def test_nested_shapes_cost_what_they_hold():
    def nest(depth):
        shape = lp.Disk(radius=1)
        for _ in range(depth):
            shape = lp.Union(shapes=[shape, lp.Disk(radius=1)])
        return shape

    begun = time.process_time()
    nest(2000)
    assert time.process_time() - begun < 2
    with pytest.raises(ValueError, match="nested more than"):
        nest(300).distance(np.zeros((1, 2)))
    assert nest(100).distance(np.zeros((1, 2)))[0] == -1


def test_a_simulation_cannot_be_copied_or_pickled(ring):
    import copy
    import pickle

    simulation = lp.Simulation(ring)
    for use in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match="Simulation"):
            use(simulation)


def test_cycles_of_a_function_and_its_simulation_are_collected(ring):
    alive = [0]

    class Law:
        def __init__(self):
            alive[0] += 1

        def __del__(self):
            alive[0] -= 1

        def __call__(self, position, state, time):
            return 1.0

    for _ in range(10):
        law = Law()
        ring.heat = lp.Heat(boundaries=[lp.Convection(coefficient=1, ambient=law)])
        law.simulation = lp.Simulation(ring)
        law.simulation.step()
        ring.heat = lp.Heat()
        del law
    gc.collect()
    assert alive[0] == 0


def test_a_failed_simulation_refuses_to_go_on(ring):
    def fails(position, state, time):
        if state.max() > 0.01:  # ahead of the run it is asked at the temperatures of the start
            raise KeyError("later")
        return 1.0

    ring.heat = lp.Heat(boundaries=[lp.Convection(coefficient=1, ambient=fails)])
    simulation = lp.Simulation(ring)
    with pytest.raises(KeyError):
        simulation.run_until(1)
    with pytest.raises(lp.RunError, match="cannot go on"):
        simulation.step()


@pytest.mark.parametrize(
    "positions",
    [
        np.ma.array(np.ones((4, 2)), mask=[[True, False]] * 4),
        np.full((4, 2), None),
        np.zeros((4, 2), "M8[s]"),
        np.zeros((4, 2), "m8[s]"),
        np.ones((4, 2), complex),
        np.full((4, 2), "1"),
    ],
    ids=["masked", "objects", "dates", "durations", "complex", "texts"],
)
def test_arrays_that_are_no_numbers_are_refused(positions):
    with pytest.raises(TypeError, match="positions must be numbers"):
        lp.Points(positions, np.ones(4))
