"""Where runs happen: processes that die, scripts without a guard, every start method, notebooks."""

import os
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import cloudpickle
import pytest

from lapilli.study import InProcess, LocalPool

# Worker processes do not find the modules of tests.
cloudpickle.register_pickle_by_value(sys.modules[__name__])


@dataclass(frozen=True)
class Deed:
    """A task that does as it is told, and counts how often on disk."""

    name: str
    what: str = ""
    log: str = ""

    def __call__(self) -> str:
        if self.log:
            with Path(self.log).open("a") as file:
                file.write(f"{self.name} {os.getpid()}\n")
        if self.what == "exit":
            os._exit(7)
        if self.what == "kill":
            os.kill(os.getpid(), signal.SIGKILL)
        if self.what == "raise":
            raise KeyError(self.name)
        if self.what == "sleep":
            time.sleep(0.2)
        return self.name

    def without_error(self, reason: str) -> str:
        return reason


def test_processes_take_one_task_after_another(tmp_path: Path) -> None:
    log = str(tmp_path / "log")
    tasks = [Deed(f"{k}", "sleep", log=log) for k in range(6)]
    assert sorted(LocalPool(2).run(tasks)) == sorted(InProcess().run(tasks))
    workers = {line.split()[1] for line in Path(log).read_text().splitlines()} - {str(os.getpid())}
    assert len(workers) == 2


@pytest.mark.parametrize(("what", "code"), [("exit", "exit code 7"), ("kill", "SIGKILL")])
def test_a_process_that_dies_costs_its_task_only(tmp_path: Path, what: str, code: str) -> None:
    log = str(tmp_path / "log")
    tasks = [Deed(f"{k}", what if k == 4 else "", log) for k in range(10)]
    found = list(LocalPool(2).run(tasks))
    assert sum("process died" in one for one in found) == 1
    assert any(code in one for one in found)
    assert sorted(one for one in found if one.isdigit()) == sorted(set("0123456789") - {"4"})
    done = [line.split()[0] for line in Path(log).read_text().splitlines()]
    assert done.count("4") <= 2  # once among others, once alone
    assert all(done.count(str(k)) <= 2 for k in range(10))


def test_mistakes_in_a_task_come_back() -> None:
    with pytest.raises(KeyError, match="bad"):
        list(LocalPool(1).run([Deed("bad", "raise")]))


def test_workers_have_a_range() -> None:
    with pytest.raises(ValueError, match="from 1 to 1024"):
        LocalPool(0)


LONG = """
import os, time
from lapilli.study import LocalPool

class Nap:
    def __init__(self, log):
        self.log = log
    def __call__(self):
        with open(self.log, "a") as file:
            file.write(f"{os.getpid()}\\n")
        time.sleep(600)
    def without_error(self, reason):
        return reason

list(LocalPool(2).run([Nap("log"), Nap("log")]))
"""


def test_workers_end_with_a_study_that_was_killed(tmp_path: Path) -> None:
    study = subprocess.Popen([sys.executable, "-c", LONG], cwd=tmp_path)
    log = tmp_path / "log"
    workers: list[int] = []
    while len(workers) < 2:
        assert study.poll() is None
        time.sleep(0.05)
        workers = [int(line) for line in log.read_text().split()] if log.exists() else []
    study.kill()
    study.wait()
    waited = time.monotonic() + 30
    while any(is_running(worker) for worker in workers):
        assert time.monotonic() < waited, "workers are left behind"
        time.sleep(0.1)


def is_running(process: int) -> bool:
    """Whether it does anything still; who is dead waits for nobody but its parent."""
    try:
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state not in "ZX"


SCRIPT = """
import multiprocessing
import sys
{start}
import lapilli as lp
from lapilli.study import LocalPool, tradeoff

print("once")  # a worker that imports the script again prints again

def truth(position, time):
    return 0.5 + 0 * position[:, 0]

scene = lp.Scene.load("ring.toml")
table = tradeoff(scene, {{"grid.cell": [1.0]}}, truth, repeats=1, runner=LocalPool(2))
print(table.rows[0].error)
"""


@pytest.mark.parametrize("method", ["", "fork", "spawn", "forkserver"])
def test_a_script_needs_no_guard(ring, method: str) -> None:
    ring.save("ring.toml")
    start = f"multiprocessing.set_start_method({method!r})" if method else ""
    Path("script.py").write_text(SCRIPT.format(start=start))
    done = subprocess.run(
        [sys.executable, "script.py"], capture_output=True, text=True, check=True, timeout=120
    )
    printed = done.stdout.split()
    assert printed[:1] == ["once"]
    assert len(printed) == 2
    assert float(printed[1]) > 0


def test_from_standard_input_and_from_a_module(ring) -> None:
    """As a notebook or a console runs it, where there is no file; and as `python -m`."""
    ring.save("ring.toml")
    script = SCRIPT.format(start="")
    Path("studied.py").write_text(script)
    for words, fed in ((["-"], script), (["-m", "studied"], "")):
        done = subprocess.run(
            [sys.executable, *words], input=fed, capture_output=True, text=True, timeout=120
        )
        assert done.returncode == 0, done.stderr
        assert len(done.stdout.split()) == 2
