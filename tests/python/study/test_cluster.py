"""A study on a real Dask scheduler with two workers on this machine, one of which is killed."""

import gc
import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

import lapilli as lp
from lapilli.cli import main
from lapilli.study import InProcess, study
from lapilli.study.cluster import DaskCluster
from lapilli.study.survey import Outcome

CELLS = [1.0, 0.75, 0.6, 0.5, 0.4, 0.375, 0.3]


def free_port() -> int:
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        port: int = found.getsockname()[1]
        return port


def started(stack: ExitStack, *words: str) -> subprocess.Popen[bytes]:
    path = os.pathsep.join(one for one in sys.path if one)
    process = subprocess.Popen(
        [sys.executable, "-m", "distributed.cli.dask_" + words[0], *words[1:]],
        env={**os.environ, "PYTHONPATH": path},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    stack.callback(process.wait)
    stack.callback(process.kill)
    return process


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    """The address of a scheduler, and its two workers."""
    pytest.importorskip("distributed")
    address = f"tcp://127.0.0.1:{free_port()}"
    with ExitStack() as stack:
        started(
            stack, "scheduler", "--host", "127.0.0.1", "--port", address.rpartition(":")[2],
            "--no-dashboard",
        )  # fmt: skip
        workers = [
            started(
                stack, "worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard",
                "--local-directory", str(tmp_path / f"worker{k}"),
            )
            for k in range(2)
        ]  # fmt: skip
        yield address, workers


def test_a_killed_worker_costs_no_case_and_results_are_the_same(
    ring: lp.Scene, cluster: tuple[str, list[subprocess.Popen[bytes]]]
) -> None:
    address, workers = cluster
    ring.time.end = 2.0
    vary = {"grid.cell": CELLS, "heat.boundaries.0.coefficient": [1, 2]}
    killed = False

    def kill_one(outcome: Outcome, done: int, all_of_them: int) -> None:
        nonlocal killed
        if not killed and done >= 2:
            workers[0].send_signal(signal.SIGKILL)
            killed = True

    there = study(ring, vary, runner=DaskCluster(address), report=kill_one)
    assert killed
    here = study(ring, vary, runner=InProcess())
    assert there.failed == []
    assert [one.setting for one in there.outcomes] == [one.setting for one in here.outcomes]
    assert [one.numbers for one in there.outcomes] == [one.numbers for one in here.outcomes]


def test_a_scheduler_that_does_not_answer_is_named(
    ring: lp.Scene, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("distributed")
    address = f"tcp://127.0.0.1:{free_port()}"
    begun = time.perf_counter()
    with pytest.raises(ValueError, match=f"no Dask scheduler answers at {address}"):
        study(ring, {"grid.cell": [1.0]}, runner=DaskCluster(address, timeout=1))
    assert time.perf_counter() - begun < 10
    ring.save("ring.toml")
    words = ["study", "ring.toml", "--vary", "grid.cell=1", "--scheduler", "nonsense"]
    assert main(words) == 2
    assert "nonsense" in capsys.readouterr().err


def test_a_client_that_did_not_start_is_gone() -> None:
    """Found by the garbage collector while another one starts, it would wait for that one."""
    distributed = pytest.importorskip("distributed")

    def clients() -> int:
        return sum(isinstance(one, distributed.Client) for one in gc.get_objects())

    before = clients()
    for address in ("nonsense", f"tcp://127.0.0.1:{free_port()}"):
        with pytest.raises(ValueError, match="no Dask scheduler answers") as caught:
            DaskCluster(address, timeout=0.5)._connect()
        assert caught.value.__context__ is None
    assert clients() == before


def test_a_scheduler_without_workers_is_given_up(ring: lp.Scene) -> None:
    pytest.importorskip("distributed")
    address = f"tcp://127.0.0.1:{free_port()}"
    with ExitStack() as stack:
        started(
            stack, "scheduler", "--host", "127.0.0.1", "--port", address.rpartition(":")[2],
            "--no-dashboard",
        )  # fmt: skip
        with pytest.raises(ValueError, match="has had no worker for 1 s"):
            study(ring, {"grid.cell": [1.0]}, runner=DaskCluster(address, patience=1))
