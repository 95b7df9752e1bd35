"""The process that does one task of a study; `LocalPool` starts it."""

from __future__ import annotations

import os
import pickle
import sys

from lapilli.study.measure import Measurement, Task


def main(descriptor: int) -> None:
    """Read a task from standard input and write what comes of it; errors go back to the caller."""
    outcome: Measurement | BaseException
    try:
        task: Task = pickle.load(sys.stdin.buffer)
        outcome = task()
    except KeyboardInterrupt:
        return
    except Exception as error:
        outcome = error
    with os.fdopen(descriptor, "wb") as answer:
        pickle.dump(outcome, answer)


if __name__ == "__main__":
    main(int(sys.argv[1]))
