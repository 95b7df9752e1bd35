"""Everything that is measured: throughput, then error against cost.

    python bench/run.py [--quick]

Throughput is in million point-steps per second ("Mps/s"), one and two threads, with the processor
time over the wall time beside it: below the number of threads, something else was running.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from pathlib import Path

from rich.console import Console
from rich.table import Table

ROOT = Path(__file__).resolve().parents[1]
COUNTERS = ("Mps/s", "Mps/s/core", "cpu/wall")


def throughput(program: Path) -> None:
    """Run one benchmark program and print its counters."""
    command = [program, "--benchmark_format=json"]
    done = subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True)
    table = Table(title=program.name, title_justify="left")
    table.add_column("case", no_wrap=True)
    for counter in COUNTERS:
        table.add_column(counter, justify="right")
    for row in json.loads(done.stdout)["benchmarks"]:
        table.add_row(row["name"], *(f"{row[counter]:.3g}" for counter in COUNTERS))
    Console(width=None if sys.stdout.isatty() else 140).print(table)


def main() -> None:
    """All benchmark programs, then the studies."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "release")
    parser.add_argument("--quick", action="store_true", help="two grids, one repeat")
    given = parser.parse_args()
    for program in sorted((given.build / "bench").glob("*_throughput")):
        throughput(program)
    print("load_step: processor seconds of one load step by cells a side", flush=True)
    sizes = ["100", "200"] if given.quick else []
    subprocess.run([given.build / "bench" / "load_step", *sizes], check=True)
    command = [sys.executable, str(ROOT / "bench" / "tradeoff.py")]
    subprocess.run(command + ["--quick"] * given.quick, check=True)


if __name__ == "__main__":
    main()
