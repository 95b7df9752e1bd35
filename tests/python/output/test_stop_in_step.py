"""A load step of seconds is left at once when the run is stopped, and is then as not begun."""

import os
import signal
import threading
import time
from pathlib import Path

import pytest

import lapilli as lp
from lapilli import _core

BEAM = Path(__file__).parents[3] / "examples" / "static" / "beam.toml"


@pytest.fixture
def beam():
    scene = lp.Scene.load(BEAM).set("grid.cell=0.01").set("time.steps=2")
    scene.output = lp.Output(every=0.5)
    return scene


def run_until_asked(scene, output, times):
    """Run until it has asked so many times for signals; whether it was stopped."""
    asked = [0]

    def signals():
        asked[0] += 1
        if asked[0] == times:
            raise KeyboardInterrupt

    scene.output.path = str(output)
    try:
        _core.run_simulation(lp.Simulation(scene), scene, False, None, None, signals)
    except KeyboardInterrupt:
        return True
    return False


def test_a_load_step_that_was_stopped_is_as_not_begun(beam, tmp_path):
    beam = beam.set("grid.cell=0.005")
    lp.run(beam, tmp_path / "whole.vtkhdf", progress=False)
    stopped = 0
    for times in (1, 2, 4):
        cut = tmp_path / f"{times}.vtkhdf"
        if not run_until_asked(beam, cut, times):
            break
        stopped += 1
        assert lp.Frames(cut).record["status"] == "stopped"
        lp.run(beam, cut, progress=False, resume=True)
        for ending in (".vtkhdf.data", ".csv"):
            whole = (tmp_path / f"whole{ending}").read_bytes()
            assert cut.with_suffix(ending).read_bytes() == whole
    assert stopped


def test_ctrl_c_ends_a_long_load_step_within_a_second(beam, tmp_path):
    beam = beam.set("grid.cell=0.0025")  # seconds a step
    asked = []

    _core.set_thread_count(1)
    output = tmp_path / "run.vtkhdf"

    def when_it_steps():
        while not output.with_suffix(".checkpoint").exists():
            time.sleep(0.01)
        time.sleep(0.3)
        asked.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=when_it_steps)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            lp.run(beam, output, progress=False)
    finally:
        thread.join()
        _core.set_thread_count(0)
    assert time.process_time() - asked[0] < 0.8
    frames = lp.Frames(output)
    assert frames.record["status"] == "stopped"
    assert frames.times[-1] < 1.0
