"""The short form of tools/torture.py."""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

import lapilli as lp
from lapilli import _core

TOOL = Path(__file__).resolve().parents[2] / "tools" / "torture.py"


@pytest.mark.parametrize(
    "attack", ["kills", "damages", "full_disks", "pairs", "threads", "scenes", "growth"]
)
def test_nothing_breaks(attack):
    if not os.environ.get("LAPILLI_BUILD"):
        pytest.skip("LAPILLI_BUILD does not name a build folder with the executable")
    run = subprocess.run([sys.executable, TOOL, "--short", attack], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "nothing broke" in run.stdout


def test_scenes_are_accepted_before_they_are_spoilt():
    spec = importlib.util.spec_from_file_location("scenes", TOOL.with_name("torture_scenes.py"))
    assert spec is not None
    assert spec.loader is not None
    scenes = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(scenes)
    for name, text in scenes.SCENES.items():
        assert _core.check_text(lp.Scene.parse(text, name)), name
