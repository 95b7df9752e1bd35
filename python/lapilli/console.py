"""What is said to users: results on standard output, the rest on standard error."""

from __future__ import annotations

import json
import math
import sys
from typing import Any, TextIO


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
