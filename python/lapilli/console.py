"""What is said to users: results on standard output, the rest on standard error."""

from __future__ import annotations

import contextlib
import io
import json
import math
import os
import sys
from collections.abc import Iterator
from typing import Any, TextIO, cast


def say(text: str, quiet: bool = False, file: TextIO | None = None) -> None:
    """Tell the user something that is no result, on standard error unless told otherwise."""
    if not quiet:
        print(text, file=file or sys.stderr, flush=True)


def beside(json: bool) -> TextIO:
    """Where text goes that must not mix with JSON."""
    return sys.stderr if json else sys.stdout


def print_json(value: Any) -> None:
    """Print plain values; numbers that are not finite, which JSON lacks, as null."""
    print(json.dumps(finite(value), indent=1))


def finite(value: Any) -> Any:
    """The value with None in place of infinities and NaN."""
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


class _Unheard(io.FileIO):
    """A stream that swallows what cannot be written: nobody reads on, or nothing does."""

    def __init__(self, number: int, swallowed: type[OSError]) -> None:
        super().__init__(number, "w", closefd=False)
        self._swallowed = swallowed

    def write(self, data: Any, /) -> int:
        try:
            return super().write(data)
        except self._swallowed:
            return memoryview(data).nbytes


@contextlib.contextmanager
def unheard_streams() -> Iterator[None]:
    """What is said to nobody ends no work: neither a reader of the results that goes away (a full
    disk is an error of theirs) nor anything that befalls the words beside them."""
    before = sys.stdout, sys.stderr
    _occupy(0)
    sys.stdout = _forgiving(sys.stdout, 1, BrokenPipeError)
    sys.stderr = _forgiving(sys.stderr, 2, OSError)
    try:
        yield
    finally:
        with contextlib.suppress(OSError, ValueError):
            sys.stderr.flush()
        sys.stdout, sys.stderr = before


def _forgiving(stream: TextIO | None, number: int, swallowed: type[OSError]) -> TextIO:
    if stream is None:  # closed: no file that is opened later may take its number
        _occupy(number)
        return cast("TextIO", open(os.devnull, "w"))
    buffer = getattr(stream, "buffer", None)
    raw = getattr(buffer, "raw", buffer)  # with PYTHONUNBUFFERED there is no other
    if not isinstance(stream, io.TextIOWrapper) or not isinstance(raw, io.FileIO):
        return stream  # a test's, a notebook's
    stream.flush()
    unheard: Any = _Unheard(raw.fileno(), swallowed)
    return io.TextIOWrapper(
        unheard if raw is buffer else io.BufferedWriter(unheard),
        encoding=stream.encoding,
        errors=stream.errors,
        line_buffering=stream.line_buffering,
        write_through=stream.write_through,
    )


def _occupy(number: int) -> None:
    try:
        os.fstat(number)
    except OSError:
        descriptor = os.open(os.devnull, os.O_RDWR)
        if descriptor != number:
            os.dup2(descriptor, number)
            os.close(descriptor)
