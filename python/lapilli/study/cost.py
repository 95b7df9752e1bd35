"""What a run costs: processor and wall time of its parts, and memory."""

from __future__ import annotations

import contextlib
import ctypes
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from lapilli import _core


@dataclass(frozen=True)
class Cost:
    """What a run took, all threads together.

    `cpu_seconds` and `wall_seconds` are those of the steps. Output is that of the frames and
    checkpoints which the scene asks for.
    """

    cpu_seconds: float
    build_seconds: float  # processor time before the first step
    wall_seconds: float
    steps: int
    points: int
    peak_memory: int  # bytes, of the process while it ran
    output_seconds: float = 0.0  # processor time
    build_wall_seconds: float = 0.0
    output_wall_seconds: float = 0.0

    @property
    def total_cpu_seconds(self) -> float:
        """Building, stepping and output."""
        return self.build_seconds + self.cpu_seconds + self.output_seconds

    @property
    def total_wall_seconds(self) -> float:
        """Building, stepping and output."""
        return self.build_wall_seconds + self.wall_seconds + self.output_wall_seconds


@dataclass
class Clock:
    """Adds up processor and wall time of named parts of the work."""

    cpu: dict[str, float] = field(default_factory=dict)
    wall: dict[str, float] = field(default_factory=dict)

    @contextlib.contextmanager
    def time(self, part: str) -> Iterator[None]:
        """Count what is done meanwhile."""
        cpu, wall = _core.cpu_seconds(), time.perf_counter()
        try:
            yield
        finally:
            self.cpu[part] = self.cpu.get(part, 0.0) + _core.cpu_seconds() - cpu
            self.wall[part] = self.wall.get(part, 0.0) + time.perf_counter() - wall


class PeakMemory:
    """Peak memory of the process from now on: workers do one run after another.

    Linux forgets the former peak when asked to; elsewhere it is that of the process so far.
    """

    def __init__(self) -> None:
        self.is_reset = False
        with contextlib.suppress(OSError, AttributeError):
            ctypes.CDLL(None).malloc_trim(0)  # what former runs have freed is no part of this one
        with contextlib.suppress(OSError):
            Path("/proc/self/clear_refs").write_text("5")
            self.is_reset = True

    def read(self) -> int:
        """Bytes."""
        if self.is_reset:
            with contextlib.suppress(OSError, ValueError, StopIteration):
                lines = Path("/proc/self/status").read_text().splitlines()
                return 1024 * int(next(one for one in lines if one.startswith("VmHWM")).split()[1])
        return _core.peak_memory()
