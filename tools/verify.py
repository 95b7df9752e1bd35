"""Run what takes too long for every change, part after part, whatever fails on the way.

Prints one line a part at the end, with its minutes; the exit code is 1 when any part failed.
LAPILLI_BUILD names the build folder.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PARTS = ("lint", "tidy", "cpp", "python", "torture", "sanitize", "papers")


def test_programs(build: Path) -> list[Path]:
    """The C++ tests of a build folder; CMake leaves files with like names beside them."""
    return sorted(
        path
        for path in (build / "tests" / "cpp").glob("test_*")
        if path.is_file() and os.access(path, os.X_OK)
    )


def commands(part: str, build: Path, jobs: int) -> dict[str, list[str]]:
    """What a part runs, by the name in the table."""
    if part == "cpp":
        return {f"slow {path.name}": [str(path), "[slow]"] for path in test_programs(build)}
    python = sys.executable
    words = {
        "lint": ["make", "lint"],
        "tidy": ["make", "tidy", f"JOBS={jobs}"],
        "python": [python, "-m", "pytest", "-m", "slow"],
        "torture": [python, "tools/torture.py"],
        "sanitize": [python, "tools/sanitize.py", "--jobs", str(jobs)],
        "papers": [python, "-m", "lapilli", "reproduce"],
    }
    return {part: words[part]}


def run_all(wanted: dict[str, list[str]]) -> bool:
    """Run every command, then print the table; whether all ended well."""
    lines, good = [], True
    for name, words in wanted.items():
        begun = time.monotonic()
        well = subprocess.run(words, cwd=ROOT).returncode == 0
        good = good and well
        minutes = (time.monotonic() - begun) / 60
        lines.append(f"{'ok    ' if well else 'FAILED'}  {minutes:6.1f} min  {name}")
    print("\n".join(["", *lines]), flush=True)
    return good


def main() -> int:
    """Run the parts that were asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("parts", nargs="*", help=", ".join(PARTS) + "; all unless given")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args()
    unknown = set(given.parts) - set(PARTS)
    if unknown:
        parser.error(f"unknown part: {', '.join(sorted(unknown))}")
    build = Path(os.environ.get("LAPILLI_BUILD", ROOT / "build" / "release")).resolve()
    wanted: dict[str, list[str]] = {}
    for part in given.parts or PARTS:
        found = commands(part, build, given.jobs)
        if not found:
            parser.error(f"no C++ tests in {build}")
        wanted |= found
    return 0 if run_all(wanted) else 1


if __name__ == "__main__":
    sys.exit(main())
