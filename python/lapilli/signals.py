"""Signals that ask a process to end, as exceptions."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator
from types import FrameType
from typing import Any, NoReturn


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


@contextlib.contextmanager
def held_back() -> Iterator[Callable[[], None] | None]:
    """While a run steps, the first signal that asks for its end waits until the run asks for it.

    Yields the function by which it does so, which calls the handler of before. Raised by whichever
    line of Python is next, a function of the scene or the progress, it would leave a step half
    done. A second signal of the kind is not held back.
    """
    if threading.current_thread() is not threading.main_thread():
        yield None
        return
    before: dict[int, Callable[[int, FrameType | None], Any]] = {}
    came: dict[int, FrameType | None] = {}

    def hold(number: int, frame: FrameType | None) -> None:
        if number in came:
            before[number](number, frame)
        else:
            came[number] = frame

    def hand_on() -> None:
        for number in list(came):
            before[number](number, came.pop(number))

    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        handler = signal.getsignal(number)
        if callable(handler):
            before[number] = handler
            signal.signal(number, hold)
    try:
        yield hand_on
    finally:
        for heeded, former in before.items():
            if signal.getsignal(heeded) is hold:
                signal.signal(heeded, former)
        hand_on()
