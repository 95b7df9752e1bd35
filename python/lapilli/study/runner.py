"""Where the runs of a study happen."""

from __future__ import annotations

import multiprocessing
import os
import pickle
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
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
        """Every task once; a worker that dies is a failed setting."""
        if not tasks:
            return
        require_picklable(tasks[0])
        fresh = multiprocessing.get_context("spawn")
        with ProcessPoolExecutor(self.workers, fresh, max_tasks_per_child=1) as pool:
            waiting = {pool.submit(task): task for task in tasks}
            try:
                for done in as_completed(waiting):
                    yield done.result()
            except BrokenProcessPool as error:
                raise RuntimeError(
                    "a worker process died, perhaps for lack of memory: use fewer workers; "
                    "what was measured so far is kept"
                ) from error
            finally:
                pool.shutdown(wait=False, cancel_futures=True)


class InProcess:
    """One run after the other in this process; peak memory is that of all together."""

    def run(self, tasks: Sequence[Task]) -> Iterator[Measurement]:
        """Every task once, in order."""
        for task in tasks:
            yield task()


def processors() -> int:
    """Processors this process may use."""
    return len(os.sched_getaffinity(0))


def require_picklable(task: Task) -> None:
    """Worker processes get their task as bytes."""
    try:
        pickle.dumps(task)
    except Exception as error:
        raise ValueError(
            "the scene or the reference cannot be sent to worker processes (functions must be "
            f"defined at the top of a module): {error}"
        ) from error
