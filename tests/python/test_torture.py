"""The short form of tools/torture.py."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

TOOL = Path(__file__).resolve().parents[2] / "tools" / "torture.py"


@pytest.mark.parametrize(
    "attack", ["kills", "damages", "full_disks", "pairs", "threads", "scenes", "growth"]
)
@pytest.mark.slow
def test_nothing_breaks(attack):
    if not os.environ.get("LAPILLI_BUILD"):
        pytest.skip("LAPILLI_BUILD does not name a build folder with the executable")
    run = subprocess.run([sys.executable, TOOL, "--short", attack], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "nothing broke" in run.stdout
