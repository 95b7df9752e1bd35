"""Why a run of a study came to nothing: a result of it like any other."""

from __future__ import annotations

from lapilli._core import RunError

FAILURES = (ValueError, RunError, MemoryError, OSError)


def reason_of(error: BaseException) -> str:
    """Of one of `FAILURES`: refused, before its first step, or failed."""
    return f"{'refused' if isinstance(error, ValueError) else 'failed'}: {error}"


def is_passing(error: BaseException) -> bool:
    """Whether it was for want of memory or a file just now: another time it may work."""
    if isinstance(error, (ValueError, RunError)):
        return "memory" in str(error)
    return isinstance(error, (MemoryError, OSError))
