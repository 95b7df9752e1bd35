"""Break the kernels in many small ways, one at a time, and see whether the tests of an area notice.

All mutants of tools/mutants/*.toml are built once, in a copy of the sources under build/mutants:
every mutated expression asks there whether it is the chosen one. The sources themselves hold
nothing of this.

A mutant names its file, the text that it replaces (which occurs once, or first after `near`) and
what it puts there: statements that end in ";" or an expression, of `type` where both sides differ.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from house import ALLOWED
from mutants.table import HEADER, ROOT, Mutant, all_mutants, mutated_sources, programs_of

WORK = ROOT / "build" / "mutants"
TREE = WORK / "source"
BUILD = TREE / "build" / "release"
RESULTS = WORK / "results.json"
LEAST_KILLED = 0.95
FIRST_SECONDS = 10.0  # tests that take so long in all are asked before the longer ones


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--area", action="append", help="only this area (a file of tools/mutants)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--resume", action="store_true", help="keep what was killed before")
    parser.add_argument("--list", action="store_true", help="print the mutants and stop")
    given = parser.parse_args()
    every = all_mutants()
    wanted = [mutant for mutant in every if not given.area or mutant.area in given.area]
    if given.list:
        for mutant in wanted:
            print(f"{mutant.number:4} {mutant.area:12} {mutant}")
        return 0
    write_tree(every, {mutant.area for mutant in wanted})
    programs = sorted({name for mutant in wanted for name in programs_of(mutant.area)})
    build(programs, given.jobs)
    suites = {name: Suite(name) for name in programs}
    results = json.loads(RESULTS.read_text()) if given.resume and RESULTS.exists() else {}
    left = [mutant for mutant in wanted if not results.get(mutant.key)]
    with ThreadPoolExecutor(given.jobs) as pool:
        for mutant, killer in pool.map(lambda one: (one, killed_by(one, suites)), left):
            results[mutant.key] = killer
            RESULTS.write_text(json.dumps(results, indent=1))
            print(f"{mutant.number:4} {killer or 'SURVIVED':50.50} {mutant}", flush=True)
    return report(wanted, results)


def write_tree(every: list[Mutant], areas: set[str]) -> None:
    """Copy what the test programs of some areas need, with all mutants in it.

    What is the same as before keeps its time. Folders that these programs do not stand on, as
    scenes and output, are left out: they take longest to compile.
    """
    tests = {name.removeprefix("test_") for area in areas for name in programs_of(area)}
    kernels = set().union(*(ALLOWED.get(name, ALLOWED["mpm"]) for name in tests))
    needed = ["CMakeLists.txt", "cmake", "tests/cpp/CMakeLists.txt", "cpp/CMakeLists.txt"]
    needed += ["tests/cpp/*.hpp", *(f"tests/cpp/{name}" for name in tests)]
    needed += [f"cpp/lapilli/{one}" for one in kernels]
    needed.append("cpp/lapilli/scene/toml_implementation.cpp")  # which CMake names
    sources = {path: path.read_text() for path in tracked(*needed)}
    mutated = mutated_sources(every)
    sources |= {path: text for path, text in mutated.items() if path in sources or path == HEADER}
    (TREE / "cpp").mkdir(parents=True, exist_ok=True)
    kept = {TREE / path.relative_to(ROOT) for path in sources}
    for old in (
        path for folder in ("cpp", "cmake", "tests") for path in (TREE / folder).rglob("*")
    ):
        if old.is_file() and old not in kept:
            old.unlink()
    for path, text in sources.items():
        target = TREE / path.relative_to(ROOT)
        if not target.exists() or target.read_text() != text:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text)
    if not (TREE / "examples").exists():
        (TREE / "examples").symlink_to(ROOT / "examples")


def tracked(*folders: str) -> list[Path]:
    listed = subprocess.run(
        ["git", "ls-files", *folders], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return [path for name in listed.stdout.split() if (path := ROOT / name).exists()]


def build(programs: list[str], jobs: int) -> None:
    environment = {**os.environ, "CCACHE_BASEDIR": str(TREE), "CCACHE_NOHASHDIR": "1"}
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DLAPILLI_APP=OFF"]
    if shutil.which("ccache"):
        options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    configure = ["cmake", "-S", TREE, "-B", BUILD, "-G", "Ninja", *options]
    subprocess.run(configure, check=True, env=environment, stdout=subprocess.DEVNULL)
    command = ["cmake", "--build", BUILD, "--parallel", str(jobs), "--target", *programs]
    subprocess.run(command, check=True, env=environment)


class Suite:
    """A test program: its tests by their time, short ones first."""

    def __init__(self, name: str) -> None:
        self.program = BUILD / "tests" / "cpp" / name
        done = self.run(0, ["--durations", "yes"], timeout=3600)
        if done.returncode != 0:
            raise SystemExit(f"{name} fails without a mutant:\n{done.stdout[-4000:]}")
        took = [
            (float(seconds), test)
            for line in done.stdout.splitlines()
            for seconds, found, test in [line.partition(" s: ")]
            if found and seconds.replace(".", "", 1).isdigit()
        ]
        self.batches: list[tuple[Path, float]] = []
        took.sort()
        sums = [sum(seconds for seconds, _ in took[: k + 1]) for k in range(len(took))]
        cut = sum(total <= FIRST_SECONDS for total in sums)
        for number, batch in enumerate((took[:cut], took[cut:])):
            if batch:
                names = WORK / f"{name}.{number}.txt"
                names.write_text("".join(f'"{escaped(test)}"\n' for _, test in batch))
                self.batches.append((names, sum(seconds for seconds, _ in batch)))
        print(f"{name}: {len(took)} tests in {sums[-1] if sums else 0:.1f} s", flush=True)

    def run(
        self, mutant: int, words: list[Any], timeout: float
    ) -> subprocess.CompletedProcess[str]:
        folder = WORK / "run" / f"{self.program.name}.{mutant}"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        environment = {
            **os.environ,
            "LAPILLI_MUTANT": str(mutant),
            "OMP_WAIT_POLICY": "passive",
            "TMPDIR": str(folder),
        }
        try:
            return subprocess.run(
                [self.program, *words],
                cwd=folder,
                env=environment,
                capture_output=True,
                text=True,
                errors="replace",
                timeout=timeout,
            )
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def killer(self, mutant: int) -> str:
        """The test that sees the mutant; empty where none does."""
        for names, seconds in self.batches:
            words = ["--input-file", names, "--abort", "--durations", "yes"]
            try:
                done = self.run(mutant, words, timeout=30.0 + 10.0 * seconds)
            except subprocess.TimeoutExpired:
                return f"{self.program.name}: no end"
            if done.returncode != 0:
                return f"{self.program.name}: {failed_test(done.stdout)}"
        return ""


def escaped(test: str) -> str:
    return test.replace("\\", "\\\\").replace('"', '\\"').replace(",", "\\,").replace("[", "\\[")


def failed_test(output: str) -> str:
    """The name between the rules that Catch2 draws above the first failure."""
    lines = output.splitlines()
    for number, line in enumerate(lines[:-1]):
        if line.startswith("-----") and not lines[number + 1].startswith((".", "-", "=")):
            return lines[number + 1].strip()
    return "crash"


def killed_by(mutant: Mutant, suites: dict[str, Suite]) -> str:
    for name in programs_of(mutant.area):
        if killer := suites[name].killer(mutant.number):
            return killer
    return ""


def report(wanted: list[Mutant], results: dict[str, str]) -> int:
    survivors = [mutant for mutant in wanted if not results[mutant.key]]
    for area in sorted({mutant.area for mutant in wanted}):
        of_area = [mutant for mutant in wanted if mutant.area == area]
        killed = sum(bool(results[mutant.key]) for mutant in of_area)
        print(f"{area:14} {killed:3} of {len(of_area):3} killed")
    for mutant in survivors:
        print(f"survived: {mutant}")
    share = 1.0 - len(survivors) / len(wanted)
    print(f"{len(wanted)} mutants, {100 * share:.1f} % killed")
    return 0 if share >= LEAST_KILLED else 1


if __name__ == "__main__":
    began = time.perf_counter()
    code = main()
    print(f"{time.perf_counter() - began:.0f} s")
    sys.exit(code)
