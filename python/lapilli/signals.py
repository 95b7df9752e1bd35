"""Signals that ask a process to end, as exceptions."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Iterator
from typing import NoReturn


class Signalled(KeyboardInterrupt):
    """The process was asked to end: a run leaves frame and checkpoint first, as on Ctrl-C."""

    def __init__(self, number: int) -> None:
        super().__init__(signal.Signals(number).name)
        self.number = number


@contextlib.contextmanager
def stopped_by_signals() -> Iterator[None]:
    """SIGTERM and SIGHUP stop what is being done; a second one ends the process at once."""

    def stop(number: int, _: object) -> NoReturn:
        signal.signal(number, signal.SIG_DFL)
        raise Signalled(number)

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    heeded = (signal.SIGTERM, signal.SIGHUP)
    before = {
        number: signal.signal(number, stop)
        for number in heeded
        if signal.getsignal(number) != signal.SIG_IGN  # nohup
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
