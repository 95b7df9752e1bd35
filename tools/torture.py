"""Try to lose or falsify results: kills, damages, full disks, pairs of runs, threads, bad scenes.

Prints what was tried and what broke; the exit code is 1 when anything did. Every number of trials
is that of the long form; --short takes a small part of each. LAPILLI_BUILD names the build folder.
"""

from __future__ import annotations

import argparse
import collections
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from torture_damages import damages
from torture_runs import SHIM, Counts, command, results, written
from torture_scenes import SCENES, mutated

import lapilli as lp
from lapilli import _core


def kills(folder: Path, trials: int, choose: random.Random) -> Counts:
    """Kill a run, resume it, until it ends: the same bytes as one that was left alone."""
    counts: Counts = collections.Counter()
    whole: dict[tuple[str, str], tuple[dict[str, bytes], float]] = {}
    pairs = [(name, front) for name in SCENES for front in ("executable", "python")]
    while counts["kills"] < trials:
        pair = pairs[counts["runs"] % len(pairs)]
        scene = written(folder, pair[0])
        if pair not in whole:
            alone = folder / "_".join(pair)
            begun = time.monotonic()
            subprocess.run(command(pair[1], scene, alone / "run.vtkhdf"), check=True)
            whole[pair] = (results(alone), time.monotonic() - begun)
        counts["runs"] += 1
        place = folder / "killed"
        output = place / "run.vtkhdf"
        while True:
            resume = ["--resume"] if (place / "run.checkpoint").exists() else []
            process = subprocess.Popen(
                command(pair[1], scene, output, *resume), stderr=subprocess.DEVNULL
            )
            how = choose.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
            try:
                process.wait(choose.uniform(0.0, 1.1 * whole[pair][1]))
            except subprocess.TimeoutExpired:
                process.send_signal(how)
                counts["kills"] += 1
                process.wait()
            if process.returncode == 0:
                break
        counts["not the same bytes"] += results(place) != whole[pair][0]
        shutil.rmtree(place)
    return counts


def full_disks(folder: Path, trials: int, _: random.Random) -> Counts:
    """Make every write of a run fail in turn."""
    counts: Counts = collections.Counter()
    scene = written(folder, "heat")
    for position in range(trials):
        output = folder / str(position) / "run.vtkhdf"
        environment = os.environ | {"LD_PRELOAD": str(SHIM), "FAIL_AT_WRITE": str(position)}
        run = subprocess.run(
            command("executable", scene, output), env=environment, capture_output=True
        )
        if run.returncode == 0:
            break
        counts["full disks"] += 1
        counts["not exit 3"] += run.returncode != 3
        if output.exists():
            frames, whole, found = _core.verify(str(output))
            counts["half files"] += whole != frames or bool(found)
        counts["left unfinished"] += bool(list(output.parent.glob("*.tmp")))
        shutil.rmtree(output.parent, ignore_errors=True)
    return counts


def pairs(folder: Path, trials: int, choose: random.Random) -> Counts:
    """Two runs of one output at a time."""
    counts: Counts = collections.Counter()
    scene = written(folder, "heat")
    alone = {}
    for number in (0, 5):
        output = folder / str(number) / "run.vtkhdf"
        more = [f"--set=bodies.0.temperature={number}"]
        subprocess.run(command("executable", scene, output, *more), check=True)
        alone[number] = results(output.parent)
    for trial in range(trials):
        output = folder / f"pair{trial}" / "run.vtkhdf"
        processes = []
        for number in (0, 5):
            more = [f"--set=bodies.0.temperature={number}"]
            processes.append(
                subprocess.Popen(
                    command("executable", scene, output, *more), stderr=subprocess.DEVNULL
                )
            )
            time.sleep(choose.choice([0, 0, 0.01, 0.05]))
        codes = [process.wait() for process in processes]
        counts["pairs"] += 1
        counts["refused"] += 3 in codes
        counts["wrong"] += results(output.parent) not in alone.values() or not {0, 3} >= set(codes)
        shutil.rmtree(output.parent)
    return counts


def threads(folder: Path, trials: int, _: random.Random) -> Counts:
    """Eight threads of one process, each with runs and outputs of its own."""
    counts: Counts = collections.Counter()
    scene = lp.Scene.load(written(folder, "heat"))
    _core.set_thread_count(1)
    lp.run(scene, folder / "alone" / "run.vtkhdf", progress=False)
    right = results(folder / "alone")

    def work(number: int) -> None:
        for turn in range(trials):
            place = folder / f"{number}_{turn}"
            try:
                lp.run(scene, place / "run.vtkhdf", progress=False)
                counts["not the same bytes"] += results(place) != right
                shutil.rmtree(place)
            except Exception as error:
                counts[f"errors: {error}"[:100]] += 1
            counts["runs"] += 1

    workers = [threading.Thread(target=work, args=(number,)) for number in range(8)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    _core.set_thread_count(0)
    return counts


WORKER = """
import resource, sys
import lapilli as lp
from lapilli import _core
resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
_core.set_thread_count(1)
def used():
    now = resource.getrusage(resource.RUSAGE_SELF)
    return now.ru_utime + now.ru_stime, now.ru_maxrss  # s, kB
for line in sys.stdin.buffer:
    text = bytes.fromhex(line.decode())
    begun, _ = used()
    try:
        _core.check_text(lp.Scene.parse(text.decode("utf-8", "surrogateescape")))
        told = "accepted"
    except (ValueError, lp.RunError, TypeError) as error:
        told = "refused"
    except MemoryError:
        told = "out of memory"
    seconds, held = used()
    if seconds - begun > 2:
        told = "over two seconds"
    elif held > 1e6:
        told = "over a gigabyte"
    print(told, flush=True)
"""


def scenes(folder: Path, trials: int, choose: random.Random) -> Counts:
    """Mutated scenes: an error or a report, within two seconds of a processor and a gigabyte."""
    counts: Counts = collections.Counter()
    worker = None
    for _ in range(trials):
        if worker is None:
            words = [sys.executable, "-c", WORKER]
            worker = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        text = mutated(choose)
        assert worker.stdin is not None
        assert worker.stdout is not None
        worker.stdin.write(text.encode("utf-8", "surrogatepass").hex().encode() + b"\n")
        worker.stdin.flush()
        told = worker.stdout.readline().decode().strip()
        counts["scenes"] += 1
        counts[told or "crashes"] += 1
        if told not in {"accepted", "refused"}:
            (folder.parent / f"found_{counts['scenes']}.toml").write_text(text, errors="replace")
            worker.kill()
            worker.wait()
            worker = None
    if worker is not None and worker.stdin is not None:
        worker.stdin.close()
        worker.wait()
    return counts


def growth(folder: Path, trials: int, _: random.Random) -> Counts:
    """Runs one after the other take no more and more memory."""
    scene = lp.Scene.load(written(folder, "heat"))

    def held() -> int:
        return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()

    sizes = []
    for _ in range(trials):
        lp.run(scene, folder / "run.vtkhdf", progress=False)
        sizes.append(held())
    half = len(sizes) // 2
    grown = np.median(sizes[half:]) - np.median(sizes[half // 2 : half])
    return collections.Counter({"runs": trials, "grows by a megabyte": int(grown > 1e6)})


Attack = Callable[[Path, int, random.Random], Counts]
ATTACKS: dict[str, tuple[Attack, int, int]] = {  # trials of the short and the long form
    "kills": (kills, 3, 1000),
    "damages": (damages, 40, 2000),
    "full_disks": (full_disks, 12, 500),
    "pairs": (pairs, 3, 200),
    "threads": (threads, 1, 100),
    "scenes": (scenes, 40, 100_000),
    "growth": (growth, 8, 1000),
}
GOOD = {"kills", "runs", "damages", "full disks", "pairs", "refused", "scenes", "accepted"}


def main() -> int:
    """Run the attacks that were asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("attack", nargs="*", help=", ".join(ATTACKS) + "; all unless given")
    parser.add_argument("--short", action="store_true", help="a small part of each")
    parser.add_argument("--trials", type=int, help="of each, instead")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    sys.setrecursionlimit(20_000)  # mutated scenes are nested as deep as 400 shapes, and twice
    broken = 0
    for name in given.attack or ATTACKS:
        attack, short, long = ATTACKS[name]
        trials = given.trials or (short if given.short else long)
        with tempfile.TemporaryDirectory(prefix="torture-") as folder:
            counts = attack(Path(folder), trials, random.Random(given.seed))
        broken += sum(count for what, count in counts.items() if what not in GOOD)
        print(
            f"{name}: " + ", ".join(f"{count} {what}" for what, count in counts.items()), flush=True
        )
    print("nothing broke" if broken == 0 else f"{broken} broke")
    return int(broken > 0)


if __name__ == "__main__":
    sys.exit(main())
