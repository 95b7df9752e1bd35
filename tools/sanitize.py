"""Build with sanitizers, run every C++ test, slow ones too, the Python tests and the fuzzers.

Prints one line a part at the end; the exit code is 1 when any part failed. Reports are in
build/<preset>/report.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
READERS = ("scene", "stl", "npy", "csv", "image", "index", "checkpoint")


def run(words: list[str], report: Path, environment: dict[str, str]) -> bool:
    """Run with output into a file; whether it ended well."""
    report.parent.mkdir(parents=True, exist_ok=True)
    with report.open("ab") as file:
        done = subprocess.run(
            words, cwd=ROOT, stdout=file, stderr=file, env=os.environ | environment
        )
    return done.returncode == 0


def build(preset: str, jobs: int, *more: str) -> bool:
    """Configure and build a preset."""
    report = ROOT / "build" / preset / "report" / "build.txt"
    return run(["cmake", "--preset", preset, *more], report, {}) and run(
        ["cmake", "--build", "--preset", preset, "--parallel", str(jobs)], report, {}
    )


def cpp_tests(preset: str) -> dict[str, bool]:
    """Every program of C++ tests, the slow tests too."""
    environment = {
        "OMP_WAIT_POLICY": "passive",
        "ASAN_OPTIONS": "detect_leaks=1",
        "UBSAN_OPTIONS": "print_stacktrace=1",
        "TSAN_OPTIONS": "ignore_noninstrumented_modules=1",
    }
    folder = ROOT / "build" / preset
    return {
        f"{preset} {program.name}": run(
            [str(program), "[slow],~[slow]"], folder / "report" / f"{program.name}.txt", environment
        )
        for program in sorted((folder / "tests" / "cpp").glob("test_*"))
        if os.access(program, os.X_OK) and program.is_file()
    }


def python_tests() -> dict[str, bool]:
    """The Python tests with a module under the address sanitizer."""
    runtime = subprocess.run(
        ["g++", "-print-file-name=libasan.so"], capture_output=True, text=True, check=True
    ).stdout.strip()
    folder = ROOT / "build" / "address"
    environment = {
        "LD_PRELOAD": runtime,
        "ASAN_OPTIONS": "detect_leaks=0",  # Python itself never frees all
        "LAPILLI_BUILD": str(folder),
    }
    words = [sys.executable, "-m", "pytest", "-q", "-x", "-m", "not slow", "tests/python"]
    return {"address pytest": run(words, folder / "report" / "pytest.txt", environment)}


def fuzzers(seconds: int) -> dict[str, bool]:
    """Every fuzzer for some seconds, beginning with its corpus."""
    folder = ROOT / "build" / "fuzz"
    results = {}
    for reader in READERS:
        found = folder / "corpus" / reader
        found.mkdir(parents=True, exist_ok=True)
        words = [
            str(folder / "tests" / "fuzz" / f"fuzz_{reader}"),
            str(found),
            str(ROOT / "tests" / "fuzz" / "corpus" / reader),
            f"-max_total_time={seconds}",
            "-rss_limit_mb=3000",
            "-timeout=20",
            f"-artifact_prefix={folder}/found_{reader}_",
        ]
        results[f"fuzz {reader}"] = run(words, folder / "report" / f"{reader}.txt", {})
    return results


def main() -> int:
    """Run the parts that were asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parts = ("address", "thread", "python", "fuzz")
    parser.add_argument("parts", nargs="*", help=", ".join(parts) + "; all unless given")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--seconds", type=int, default=500, help="of each of seven fuzzers")
    given = parser.parse_args()
    wanted = given.parts or parts
    results: dict[str, bool] = {}
    begun = time.monotonic()
    for preset in ("address", "thread"):
        if preset in wanted:
            results[f"{preset} build"] = build(preset, given.jobs, "-DLAPILLI_APP=OFF")
            results |= cpp_tests(preset) if results[f"{preset} build"] else {}
    if "python" in wanted:
        more = ("-DLAPILLI_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}")
        results["address module"] = build("address", given.jobs, *more)
        results |= python_tests() if results["address module"] else {}
    if "fuzz" in wanted:
        results["fuzz build"] = build("fuzz", given.jobs)
        results |= fuzzers(given.seconds) if results["fuzz build"] else {}
    for name, good in results.items():
        print(f"{'ok    ' if good else 'FAILED'}  {name}")
    failed = [name for name, good in results.items() if not good]
    minutes = (time.monotonic() - begun) / 60
    print(f"{len(results) - len(failed)} of {len(results)} parts are clean, {minutes:.0f} minutes")
    return int(bool(failed))


if __name__ == "__main__":
    sys.exit(main())
