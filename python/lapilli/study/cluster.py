"""Runs on a Dask scheduler: on this machine or on a cluster."""

from __future__ import annotations

import gc
import time
from collections.abc import Iterator, Sequence
from typing import Any

from lapilli.study.runner import Found, Work, do

PATIENCE = 60.0  # s without any worker, after which a study gives up


class DaskCluster:
    """The workers of a Dask scheduler ("tcp://host:8786").

    Each should take one task at a time (``dask worker --nthreads 1``), or costs are those of
    several runs together. Tasks of a worker that is lost are done again by others.
    """

    def __init__(self, address: str, *, timeout: float = 10.0, patience: float = PATIENCE) -> None:
        self.address = address
        self.timeout = timeout
        self.patience = patience

    def run(self, tasks: Sequence[Work[Found]]) -> Iterator[Found]:
        """Every task once; one that takes its workers with it comes back without an error."""
        import distributed
        from distributed.scheduler import KilledWorker

        client = self._connect()
        try:
            running = {client.submit(do, task, pure=False): task for task in tasks}
            seen = time.monotonic()
            while running:
                try:
                    with client.as_current():
                        distributed.wait(list(running), timeout=2.0, return_when="FIRST_COMPLETED")
                except TimeoutError:
                    seen = self._last_seen(client, seen)
                    continue
                seen = time.monotonic()
                for future in [one for one in running if one.done()]:
                    task = running.pop(future)
                    if isinstance(future.exception(), KilledWorker):
                        yield task.without_error("failed: its workers died, one after the other")
                    else:
                        yield future.result()
        finally:
            client.close()

    def _connect(self) -> Any:
        try:
            import distributed
        except ImportError as error:
            raise ValueError("a scheduler needs Dask: pip install 'lapilli[study]'") from error
        try:
            return distributed.Client(self.address, timeout=self.timeout, set_as_default=False)
        except (OSError, ValueError) as error:
            reason = str(error)
        # A client that did not start must close here: found by the garbage collector while another
        # one starts, it would wait for the lock that the other holds.
        gc.collect()
        raise ValueError(
            f"no Dask scheduler answers at {self.address} within {self.timeout:g} s: {reason}"
        )

    def _last_seen(self, client: Any, seen: float) -> float:
        """When there was a worker last; a ValueError after too long without any."""
        if client.scheduler_info()["workers"]:
            return time.monotonic()
        if time.monotonic() - seen > self.patience:
            raise ValueError(
                f"the scheduler at {self.address} has had no worker for {self.patience:g} s"
            )
        return seen
