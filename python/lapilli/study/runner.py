"""Where the runs of a study happen: here, in processes of this machine, on a Dask scheduler."""

from __future__ import annotations

import os
import pickle
import re
import threading
import time
import weakref
from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Protocol, TypeVar

Found_co = TypeVar("Found_co", covariant=True)
Found = TypeVar("Found")


class Work(Protocol[Found_co]):
    """Something to do in any process."""

    def __call__(self) -> Found_co: ...

    def without_error(self, reason: str) -> Found_co:
        """What to say of it where it could not be done."""


class Runner(Protocol):
    """Does tasks anywhere and yields what comes of each as it comes."""

    def run(self, tasks: Sequence[Work[Found]]) -> Iterator[Found]:
        """Every task once, started in order, finished in any."""


Deaths = list[tuple[Work[Found], BaseException]]


class InProcess:
    """One run after the other in this process."""

    def run(self, tasks: Sequence[Work[Found]]) -> Iterator[Found]:
        """Every task once, in order."""
        for task in tasks:
            yield task()


class LocalPool:
    """Processes on this machine that take one task after another (loky).

    They start from nothing but what a task brings with it: a script needs no guard of its main
    part, and functions may be those of a script or a notebook. They stay for the next tasks until
    the pool is forgotten.
    """

    def __init__(self, workers: int = 1) -> None:
        if not 1 <= workers <= 1024:
            raise ValueError(f"workers must be from 1 to 1024, got {workers}")
        self.workers = workers
        self._processes = Processes(workers)

    def run(self, tasks: Sequence[Work[Found]]) -> Iterator[Found]:
        """Every task once; one that takes its process with it comes back without an error."""
        waiting = deque(tasks)
        while waiting:
            suspects: Deaths[Found] = []
            yield from self._processes.until_broken(waiting, suspects, 2 * self.workers)
            # Of those that ran when a process died, each alone shows which it was.
            alone = deque(task for task, _ in suspects)
            while alone:
                culprits: Deaths[Found] = []
                yield from Processes(1).until_broken(alone, culprits, 1)
                for task, error in culprits:
                    yield task.without_error(
                        f"failed: its process died ({exit_code(error)}), perhaps for lack of memory"
                    )


class Processes:
    """Some processes, started when first needed, and again after one has died."""

    def __init__(self, count: int) -> None:
        self.count = count
        self._executor: Any = None

    def until_broken(
        self, waiting: deque[Work[Found]], suspects: Deaths[Found], depth: int
    ) -> Iterator[Found]:
        """Do tasks, `depth` of them handed out at a time, until none is left or a process dies:
        then those that were handed out are suspects."""
        running: dict[Future[Found], Work[Found]] = {}
        unbroken = False
        try:
            while running or (waiting and not suspects):
                while waiting and len(running) < depth and not suspects:
                    task = waiting.popleft()
                    try:
                        running[self._started().submit(do, task)] = task
                    except BrokenProcessPool as broken:
                        suspects.append((task, broken))
                wait(running, return_when=FIRST_COMPLETED)
                for future in [one for one in running if one.done()]:
                    task = running.pop(future)
                    error = future.exception()
                    if isinstance(error, BrokenProcessPool):
                        suspects.append((task, error))
                    else:
                        yield result_of(future)
            unbroken = not suspects
        finally:
            if not unbroken:
                self.stop()

    def stop(self) -> None:
        """End the processes, whatever they do."""
        if self._executor is not None:
            self._executor.shutdown(wait=True, kill_workers=True)
            self._executor = None

    def _started(self) -> Any:
        if self._executor is None:
            try:
                from loky import ProcessPoolExecutor
            except ImportError as missing:
                raise ValueError(
                    "worker processes need loky: pip install 'lapilli[study]'"
                ) from missing
            self._executor = ProcessPoolExecutor(
                max_workers=self.count, initializer=end_with, initargs=(os.getpid(),)
            )
            weakref.finalize(self, self._executor.shutdown, wait=False, kill_workers=True)
        return self._executor


def runner_of(workers: int, scheduler: str | None = None) -> Runner:
    """Processes on this machine, or the workers of a Dask scheduler."""
    if scheduler is None:
        return LocalPool(workers)
    from lapilli.study.cluster import DaskCluster

    return DaskCluster(scheduler)


def exit_code(error: BaseException) -> str:
    """How a process ended, from what loky says of it."""
    found = re.search(r"(EXIT|SIG[A-Z]+)\((-?\d+)\)", str(error))
    if found is None:
        return "exit code unknown"
    return f"exit code {found[2]}" if found[1] == "EXIT" else found[1]


def end_with(parent: int) -> None:
    """In a worker: end when the study is gone, even if nobody could say so (kill -9)."""

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(1.0)
        os._exit(1)

    if os.getppid() == parent:
        threading.Thread(target=watch, daemon=True).start()


def do(task: Work[Found]) -> Found:
    """What a worker does."""
    return task()


def result_of(future: Future[Found]) -> Found:
    """What came of a task, or the error that it ended with."""
    error = future.exception()
    if isinstance(error, pickle.PicklingError):
        raise ValueError(
            f"the scene or the reference cannot be sent to worker processes: {error.__cause__}"
        ) from error
    return future.result()
