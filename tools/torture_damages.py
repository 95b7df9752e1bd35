"""Damage frames and index of a finished run."""

from __future__ import annotations

import collections
import random
import subprocess
from pathlib import Path

from torture_runs import Counts, command, written

import lapilli as lp
from lapilli import _core


def numbers(path: Path) -> dict[tuple[int, str], bytes]:
    """All that can be read, by frame and field."""
    found = {}
    try:
        frames = lp.Frames(path)
    except (ValueError, OSError):
        return found
    for frame in frames:
        for name in ["position", *frames.fields]:
            try:
                found[frame.number, name] = frame[name].tobytes()
            except OSError:
                continue
    return found


def damaged(content: bytes, choose: random.Random) -> bytes | None:
    """The file with a flipped bit, a hole, a cut, or none at all."""
    kind = choose.randrange(5)
    if kind == 0 or not content:
        return None
    at = choose.randrange(len(content))
    if kind == 1:
        return content[:at]
    if kind == 2:
        return content[:at] + bytes(min(64, len(content) - at)) + content[at + 64 :]
    return content[:at] + bytes([content[at] ^ 1 << choose.randrange(8)]) + content[at + 1 :]


def damages(folder: Path, trials: int, choose: random.Random) -> Counts:
    """Damage a file of a run: no wrong number, no crash, whole frames still readable."""
    counts: Counts = collections.Counter()
    scene = written(folder, "heat")
    output = folder / "run.vtkhdf"
    subprocess.run(command("executable", scene, output, "--every=0.01"), check=True)
    files = sorted(file for file in folder.iterdir() if file.name.startswith("run."))
    right = numbers(output)
    # What rests is stored once, for all frames: with it go they all.
    resting = {name for frame, name in right if right.get((frame + 1, name)) == right[frame, name]}
    for _ in range(trials):
        file = choose.choice(files)
        content = file.read_bytes()
        changed = damaged(content, choose)
        file.unlink() if changed is None else file.write_bytes(changed)
        counts["damages"] += 1
        read = numbers(output)
        counts["wrong numbers"] += any(right[key] != value for key, value in read.items())
        try:
            _, _, found = _core.verify(str(output))
        except (ValueError, OSError):
            found = ["index"]
        lost = [key for key in right if key not in read]
        counts["not told by verify"] += bool(lost) and not found
        if file == output:
            counts["index not made anew"] += _core.rebuild_index(str(output)) != 51
        elif ".data" in file.name and changed is not None and len(changed) == len(content):
            moving = {frame for frame, name in lost if name not in resting}
            counts["more than two frames lost"] += len(moving) > 2
        file.write_bytes(content)
    return counts
