"""Signals end a run after its step, with frame, checkpoint and record, by either front end."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

PROGRAM = Path(os.environ.get("LAPILLI_BUILD", "build/release")) / "cpp" / "lapilli-run"
FRONT_ENDS = {"executable": [PROGRAM], "python": [sys.executable, "-m", "lapilli", "run"]}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("front_end", FRONT_ENDS)
def test_a_signal_leaves_a_run_to_go_on_with(ring, tmp_path, front_end, number):
    words = FRONT_ENDS[front_end]
    if not Path(words[0]).exists():
        pytest.skip("no executable")
    ring.time.step = 1e-4
    ring.save(str(tmp_path / "ring.toml"))
    output = tmp_path / "run.vtkhdf"
    words = [*words, tmp_path / "ring.toml", "--quiet", "--every=0.1", f"--output={output}"]
    process = subprocess.Popen(words, stderr=subprocess.DEVNULL)
    while not (tmp_path / "run.checkpoint").exists():
        assert process.poll() is None
        time.sleep(0.005)
    process.send_signal(number)
    assert process.wait(timeout=20) == 128 + number
    assert json.loads((tmp_path / "run.json").read_text())["status"] == "stopped"
    assert not list(tmp_path.glob("*.lock"))
    assert subprocess.run([*words, "--resume"]).returncode == 0
    assert json.loads((tmp_path / "run.json").read_text())["status"] == "finished"


def test_an_ignored_hangup_stays_ignored(ring, tmp_path):
    ring.save(str(tmp_path / "ring.toml"))
    for front_end, words in FRONT_ENDS.items():
        if not Path(words[0]).exists():
            continue
        output = tmp_path / front_end / "run.vtkhdf"
        process = subprocess.Popen(
            ["nohup", *words, tmp_path / "ring.toml", "--quiet", f"--output={output}"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        while process.poll() is None and not output.with_suffix(".checkpoint").exists():
            time.sleep(0.005)
        process.send_signal(signal.SIGHUP)
        assert process.wait(timeout=20) == 0


def test_a_name_that_is_no_utf8_is_said_in_a_line(tmp_path):
    run = subprocess.run(
        [os.fsencode(sys.executable), b"-m", b"lapilli", b"check", b"ring\xff.toml"],
        capture_output=True,
        cwd=tmp_path,
    )
    assert run.returncode == 2
    assert b"Traceback" not in run.stderr
    assert b"UTF-8" in run.stderr
