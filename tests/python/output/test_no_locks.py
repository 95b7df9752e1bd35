"""Where the file system knows no locks, whoever made the lock's file has the output."""

import os
import re
import subprocess
import sys

import pytest

FIRST = """
import sys, lapilli as lp
scene = lp.Scene.load("ring.toml")
told = []
def second(simulation):
    if simulation.step_index == 1:
        for attempt in (lambda: lp.run(scene, "run.vtkhdf", progress=False),
                        lambda: lp._core.rebuild_index("run.vtkhdf")):
            try:
                attempt()
            except lp.OutputError as error:
                told.append(str(error))
lp.run(scene, "run.vtkhdf", progress=False, callback=second)
print(len(told), told)
"""


@pytest.fixture
def without_locks(drivers, ring, tmp_path):
    """Runs a program of Python where there are no locks; what it says."""
    if not drivers.kill_at_write.exists():
        pytest.skip("a sanitizer build has no library that fails calls")
    ring.save(str(tmp_path / "ring.toml"))
    environment = {**os.environ, "LD_PRELOAD": str(drivers.kill_at_write), "NO_LOCKS": "1"}

    def work(*words):
        run = subprocess.run(
            [sys.executable, *words],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
        )
        return run.returncode, run.stdout + run.stderr

    return work


def test_a_second_run_is_refused(without_locks, tmp_path):
    code, said = without_locks("-c", FIRST)
    assert code == 0, said
    assert said.startswith("2 ")
    assert said.count("another run writes this output") == 2
    assert not (tmp_path / "run.vtkhdf.lock").exists()


def test_a_dead_owner_is_followed_and_one_elsewhere_is_not(without_locks, tmp_path):
    lock = tmp_path / "run.vtkhdf.lock"
    run = ("-m", "lapilli", "run", "ring.toml", "-q", "--output", "run.vtkhdf")
    dead = subprocess.Popen(["true"])
    dead.wait()
    text = "lapilli writes this output\nprocess {}\nhost {}\nsince 2026-11-30T02:00:00Z\n"
    lock.write_text(text.format(dead.pid, os.uname().nodename))
    assert without_locks(*run) == (0, "")
    lock.write_text(text.format(4711, "another-node"))
    code, said = without_locks(*run)
    assert code == 3
    assert re.search(r"process 4711 on another-node.*remove this file", said)
    assert lock.exists()
    lock.write_text("")
    code, said = without_locks(*run)
    assert code == 3
    assert "remove this file" in said
