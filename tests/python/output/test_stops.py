"""A stop is told between steps, wherever it comes: in the progress, in a function of the scene."""

import os
import signal

import pytest

import lapilli as lp
from lapilli.signals import Signalled, stopped_by_signals

STEPS = 40


@pytest.fixture
def heated(ring):
    ring.time.step = 1e-3
    ring.time.end = 10.0
    return ring


def stopped_run(scene, output, number):
    """The time at which the run stopped, with frame, checkpoint and record of that time."""
    with pytest.raises(KeyboardInterrupt) as raised, stopped_by_signals():
        lp.run(scene, output, every=5.0)
    assert isinstance(raised.value, Signalled) == (number != signal.SIGINT)
    frames = lp.Frames(output)
    assert frames.record["status"] == "stopped"
    assert frames.times[-1] == frames.record["time"] > 0
    scene.time.end = frames.times[-1] + 0.01
    scene.heat.boundaries = []
    return frames.times[-1]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_within_a_function_of_the_scene(heated, tmp_path, number):
    calls = [0]

    def ambient(position, state, time):
        calls[0] += 1
        if calls[0] == STEPS:
            os.kill(os.getpid(), number)
        return 1.0

    heated.heat = lp.Heat(boundaries=[lp.Convection(coefficient=1.0, ambient=ambient)])
    assert stopped_run(heated, tmp_path / "run.vtkhdf", number) >= 0.01


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_within_the_progress(heated, tmp_path, number, monkeypatch):
    from contextlib import contextmanager

    @contextmanager
    def bar(_wanted):
        yield lambda now: os.kill(os.getpid(), number) if now.steps_taken == 0 else None

    monkeypatch.setattr("lapilli.result.progress_bar", bar)
    stopped_run(heated, tmp_path / "run.vtkhdf", number)


def test_what_the_progress_raises_comes_after_the_files(heated, tmp_path, monkeypatch):
    from contextlib import contextmanager

    @contextmanager
    def bar(_wanted):
        def show(now):
            if now.steps_taken:
                raise RuntimeError("no bar")

        yield show

    monkeypatch.setattr("lapilli.result.progress_bar", bar)
    heated.time.end = 1000.0  # long enough for the progress to be told
    heated.heat.time_integration = "explicit"
    with pytest.raises(RuntimeError, match="no bar"):
        lp.run(heated, tmp_path / "run.vtkhdf", every=5.0)
    assert lp.Frames(tmp_path / "run.vtkhdf").record["status"] == "stopped"


def test_a_second_signal_is_not_held_back(heated, tmp_path):
    def ambient(position, state, time):
        os.kill(os.getpid(), signal.SIGINT)
        return 1.0

    heated.heat = lp.Heat(boundaries=[lp.Convection(coefficient=1.0, ambient=ambient)])
    with pytest.raises(KeyboardInterrupt):
        lp.run(heated, tmp_path / "run.vtkhdf", progress=False)
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
