"""Runs that are tortured: how they are started, and what they leave."""

from __future__ import annotations

import collections
import os
import sys
from pathlib import Path

from torture_scenes import SCENES

BUILD = Path(os.environ.get("LAPILLI_BUILD", "build/release")).resolve()
PROGRAM = BUILD / "cpp" / "lapilli-run"
SHIM = BUILD / "tests" / "cpp" / "output" / "libkill_at_write.so"
PYTHON = [sys.executable, "-m", "lapilli", "run"]
Counts = collections.Counter[str]


def command(front_end: str, scene: Path, output: Path, *more: str) -> list[str]:
    """A run of a scene with one thread by the executable or by Python."""
    program = [str(PROGRAM)] if front_end == "executable" else PYTHON
    return [*program, str(scene), "--quiet", "--threads=1", f"--output={output}", *more]


def results(folder: Path) -> dict[str, bytes]:
    """Everything but the record, which tells wall time."""
    return {
        file.name: file.read_bytes() for file in folder.iterdir() if file.name.startswith("run.vtk")
    }


def written(folder: Path, name: str) -> Path:
    """The scene as a file."""
    path = folder / f"{name}.toml"
    path.write_text(SCENES[name])
    return path
