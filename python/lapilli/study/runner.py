"""Where the runs of a study happen."""

from __future__ import annotations

import multiprocessing
import pickle
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from multiprocessing.connection import Connection
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
    """Do a task in a process of its own and wait for what comes of it."""
    fresh = multiprocessing.get_context("spawn")
    receive, send = fresh.Pipe(duplex=False)
    process = fresh.Process(target=work, args=(task, send))
    process.start()
    send.close()
    try:
        outcome = receive.recv()
    except EOFError:
        process.join()
        outcome = task.without_error(
            f"failed: its process died (exit code {process.exitcode}), perhaps for lack of memory"
        )
    finally:
        receive.close()
        process.join()
    if isinstance(outcome, BaseException):
        raise outcome
    assert isinstance(outcome, Measurement)
    return outcome


def work(task: Task, send: Connection) -> None:
    """What the process does: errors of the program go back to the caller."""
    try:
        outcome: Measurement | BaseException = task()
    except KeyboardInterrupt:
        return
    except Exception as error:
        outcome = error
    send.send(outcome)


class InProcess:
    """One run after the other in this process; peak memory is that of all together."""

    def run(self, tasks: Sequence[Task]) -> Iterator[Measurement]:
        """Every task once, in order."""
        for task in tasks:
            yield task()


def require_picklable(task: Task) -> None:
    """Worker processes get their task as bytes."""
    try:
        pickle.dumps(task)
    except Exception as error:
        raise ValueError(
            "the scene or the reference cannot be sent to worker processes (functions must be "
            f"defined at the top of a module): {error}"
        ) from error
