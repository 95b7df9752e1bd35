"""Where the runs of a study happen."""

from __future__ import annotations

import contextlib
import os
import pickle
import subprocess
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import Protocol

from lapilli.study.measure import Measurement, Task


class Runner(Protocol):
    """Does tasks anywhere and yields each measurement as it comes."""

    def run(self, tasks: Sequence[Task]) -> Iterator[Measurement]:
        """Every task once, started in order, finished in any."""


class LocalPool:
    """Processes on this machine, a fresh one for each task, so that peak memory is its own."""

    def __init__(self, workers: int = 1) -> None:
        if not 1 <= workers <= 1024:
            raise ValueError(f"workers must be from 1 to 1024, got {workers}")
        self.workers = workers

    def run(self, tasks: Sequence[Task]) -> Iterator[Measurement]:
        """Every task once; a process that dies is a failed setting."""
        if tasks:
            require_picklable(tasks[0])
        with ThreadPoolExecutor(self.workers) as threads:
            waiting = [threads.submit(in_fresh_process, task) for task in tasks]
            try:
                for done in as_completed(waiting):
                    yield done.result()
            finally:
                for future in waiting:
                    future.cancel()


def in_fresh_process(task: Task) -> Measurement:
    """Do a task in a process of its own and wait for what comes of it.

    The process starts from `lapilli.study.worker`, never from the script that asks for the study:
    that one need not guard its main part.
    """
    receive, send = os.pipe()
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    process = subprocess.Popen(
        [sys.executable, "-m", "lapilli.study.worker", str(send)],
        stdin=subprocess.PIPE,
        pass_fds=[send],
        env=environment,
    )
    os.close(send)
    with os.fdopen(receive, "rb") as answers:
        with contextlib.suppress(BrokenPipeError):
            process.communicate(pickle.dumps(task))
        answer = answers.read()
    process.wait()
    if not answer:
        return task.without_error(
            f"failed: its process died (exit code {process.returncode}), perhaps for lack of memory"
        )
    outcome = pickle.loads(answer)
    if isinstance(outcome, BaseException):
        raise outcome
    assert isinstance(outcome, Measurement)
    return outcome


class InProcess:
    """One run after the other in this process; peak memory is that of all together."""

    def run(self, tasks: Sequence[Task]) -> Iterator[Measurement]:
        """Every task once, in order."""
        for task in tasks:
            yield task()


def require_picklable(task: Task) -> None:
    """Worker processes get their task as bytes, and know nothing of the script that was run."""
    try:
        form = pickle.dumps(task)
    except Exception as error:
        raise ValueError(
            "the scene or the reference cannot be sent to worker processes (functions must be "
            f"defined at the top of a module): {error}"
        ) from error
    if b"__main__" in form:
        raise ValueError(
            "the scene or the reference holds a function of the script that is being run, which "
            "worker processes do not know: define it in a module of its own, or give "
            "runner=lapilli.study.InProcess()"
        )
