"""Long scenes are read and written while others work, and Ctrl-C ends it."""

import os
import signal
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

import lapilli as lp

NUMBERS = 500_000


@pytest.fixture(scope="module")
def long_text() -> str:
    """A table of half a million rows: a second of reading."""
    times = ", ".join(f"{k}.5" for k in range(NUMBERS))
    return f"""
[grid]
lower = [0.0]
upper = [1.0]
cell = 0.1
[[bodies]]
shape = {{kind = "box", lower = [0.0], upper = [1.0]}}
points_per_cell = 1
material = {{kind = "thermal", density = 1.0, specific_heat = 1.0, conductivity = 1.0}}
[[heat.boundaries]]
kind = "flux"
value = {{times = [{times}], values = [{times}]}}
[time]
end = 1.0
"""


@pytest.fixture(scope="module")
def long_scene(long_text: str) -> lp.Scene:
    return lp.Scene.parse(long_text)


def interrupted(work: Callable[[], Any], after: float) -> float:
    """Processor seconds between Ctrl-C and the end of the work."""
    asked = []

    def interrupt() -> None:
        asked.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    threading.Timer(after, interrupt).start()
    with pytest.raises(KeyboardInterrupt):
        work()
    return time.process_time() - asked[0]


@pytest.mark.parametrize("after", [0.05, 0.5])
def test_ctrl_c_is_answered_while_a_scene_is_read(long_text: str, after: float) -> None:
    assert interrupted(lambda: lp.Scene.parse(long_text), after) < 0.8


def test_ctrl_c_is_answered_while_a_scene_is_written(long_scene: lp.Scene) -> None:
    assert interrupted(long_scene.to_toml, 0.1) < 0.8


def test_others_work_while_a_scene_is_read(long_text: str) -> None:
    longest, last, stop = [0.0], [time.monotonic()], threading.Event()

    def watch() -> None:
        while not stop.is_set():
            time.sleep(0.002)
            now = time.monotonic()
            longest[0] = max(longest[0], now - last[0])
            last[0] = now

    thread = threading.Thread(target=watch)
    thread.start()
    lp.Scene.parse(long_text)
    stop.set()
    thread.join()
    assert longest[0] < 0.8  # making the objects of Python takes what it takes
