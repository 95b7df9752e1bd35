"""What is built for one processor level says so where it is loaded on a lesser processor."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import lapilli._core as core

ROOT = Path(__file__).parents[2]
BUILD = Path(os.environ.get("LAPILLI_BUILD", ROOT / "build" / "release"))
LEVEL = re.search(r"^kernel set: (.*)$", core.version_text(), re.MULTILINE)[1]  # type: ignore[index]
LOADED = [Path(core.__file__), BUILD / "cpp" / "lapilli-run"]

pytestmark = pytest.mark.skipif(
    not re.fullmatch("x86-64-v[34]", LEVEL), reason=f"built for {LEVEL}, which most have"
)


@pytest.mark.parametrize("loaded", LOADED, ids=["module", "executable"])
def test_the_level_is_marked(loaded: Path) -> None:
    """The loader of the C library refuses what is marked so; without the mark it is SIGILL."""
    if not shutil.which("readelf"):
        pytest.skip("needs readelf")
    notes = subprocess.run(["readelf", "-n", loaded], capture_output=True, text=True, check=True)
    (needed,) = re.findall("x86 ISA needed: (.*)", notes.stdout)
    assert LEVEL in needed.split(", ")


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("qemu-x86_64"), reason="needs qemu-user")
def test_a_lesser_processor_is_told() -> None:
    emulated = ["qemu-x86_64", "-cpu", "Nehalem"]
    done = subprocess.run([*emulated, LOADED[1]], capture_output=True, text=True)
    assert done.returncode > 0
    assert "ISA level is lower than required" in done.stderr
    command = [*emulated, os.path.realpath(sys.executable), "-c", "import lapilli"]
    paths = os.pathsep.join([str(ROOT / "python"), *sys.path])
    environment = {**os.environ, "PYTHONPATH": paths}
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert done.returncode == 1
    assert "ImportError: lapilli was built for a processor of a higher level" in done.stderr
