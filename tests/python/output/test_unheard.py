"""Words nobody can read cost no run: a pipe that is closed, a full device, no stream at all."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = Path(os.environ.get("LAPILLI_BUILD", "build/release")) / "cpp" / "lapilli-run"
FRONT_ENDS = {"executable": [PROGRAM], "python": [sys.executable, "-m", "lapilli", "run"]}
STREAMS = {
    "reader gone": "{ WORDS 2>&1; echo $? >&3; } 3>code | head -c 1 >/dev/null",
    "full log": "WORDS >/dev/null 2>/dev/full; echo $? >code",
    "no log": "WORDS >/dev/null 2>&-; echo $? >code",
    "no output": "WORDS >&- 2>/dev/null; echo $? >code",
    "no streams": "WORDS <&- >&- 2>&-; echo $? >code",
}


@pytest.mark.parametrize("stream", STREAMS)
@pytest.mark.parametrize("front_end", FRONT_ENDS)
def test_a_run_is_finished_whoever_reads(ring, tmp_path, front_end, stream):
    words = FRONT_ENDS[front_end]
    if not Path(words[0]).exists():
        pytest.skip("no executable")
    ring.save(str(tmp_path / "ring.toml"))
    words = [str(Path(words[0]).absolute()), *words[1:], "ring.toml", "--set=time.step=2e-3"]
    command = STREAMS[stream].replace("WORDS", " ".join(words))
    subprocess.run(["bash", "-c", command], cwd=tmp_path, timeout=60)
    assert json.loads((tmp_path / "ring.json").read_text())["status"] == "finished"
    assert (tmp_path / "code").read_text().strip() == "0"
    verified = subprocess.run(
        [sys.executable, "-m", "lapilli", "verify", "ring.vtkhdf"], cwd=tmp_path
    )
    assert verified.returncode == 0


def test_a_failure_keeps_its_code_where_nobody_reads_it(tmp_path):
    (tmp_path / "wrong.toml").write_text("[grid]\n")
    check = [sys.executable, "-m", "lapilli", "check", "wrong.toml"]
    with open("/dev/full", "w") as full:
        assert subprocess.run(check, cwd=tmp_path, stderr=full).returncode == 2
