"""A killed writer takes no acknowledged frame and no acknowledged checkpoint with it."""

import os
import random
import signal
import subprocess
import time

import pytest


def writer(drivers, path, frames, points, planned, **environment):
    command = [drivers.frames, path, str(frames), str(points), str(planned)]
    return subprocess.Popen(
        command, stdout=subprocess.PIPE, text=True, env={**os.environ, **environment}
    )


@pytest.mark.parametrize("half_way", [False, True], ids=["before", "half way through"])
def test_kill_at_every_write(drivers, check_killed, tmp_path, half_way):
    """Every call that changes a file, over a series that outgrows its first data file."""
    if not drivers.kill_at_write.exists():
        pytest.skip("a sanitizer build has no library that kills at a write")
    frames, points = 4, 6
    environment = {"LD_PRELOAD": str(drivers.kill_at_write)}
    if half_way:
        environment["KILL_HALF_WAY"] = "1"
    for position in range(1000):
        folder = tmp_path / str(position)
        folder.mkdir()
        path = folder / "run.vtkhdf"
        environment["KILL_AT_WRITE"] = str(position)
        process = writer(drivers, path, frames, points, 2, **environment)
        lines, _ = process.communicate()
        assert process.returncode in (0, -signal.SIGKILL)
        seen = check_killed(path, points, lines)
        if process.returncode == 0:
            assert seen == frames
            break
    assert position > 15 * frames  # the calls of that many frames were really met


@pytest.mark.parametrize("kills", [20, pytest.param(200, marks=pytest.mark.slow)])
def test_kill_at_random(drivers, check_killed, tmp_path, kills):
    choose = random.Random(kills)
    frames_seen = 0
    for attempt in range(kills):
        folder = tmp_path / str(attempt)
        folder.mkdir()
        path = folder / "run.vtkhdf"
        points = choose.choice([10, 3000])
        planned = choose.choice([0, 3, 1000])
        process = writer(drivers, path, 100_000, points, planned)
        lines = "".join(process.stdout.readline() for _ in range(choose.randrange(6)))
        time.sleep(choose.uniform(0.0, 0.02))
        process.kill()
        lines += process.communicate()[0]
        frames_seen += check_killed(path, points, lines)
        for file in folder.iterdir():
            file.unlink()
    assert frames_seen > kills  # 2.5 a kill on average, and those written during the sleep
