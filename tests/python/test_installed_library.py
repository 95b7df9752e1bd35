"""The C++ library as others link it: the program of the manual against an installation."""

import os
import re
import subprocess
from pathlib import Path

import pytest

import lapilli as lp

ROOT = Path(__file__).parents[2]
BUILD = Path(os.environ.get("LAPILLI_BUILD", ROOT / "build" / "release"))
FILE = re.compile(r'^```\w+ title="([^"]+)"\n(.*?)^```$', re.MULTILINE | re.DOTALL)


@pytest.mark.slow
def test_a_program_builds_against_an_installation(ring: lp.Scene, tmp_path: Path) -> None:
    page = (ROOT / "docs" / "how-to" / "cpp.md").read_text()
    files = dict(FILE.findall(page))
    assert set(files) == {"hottest.cpp", "CMakeLists.txt"}
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    prefix = tmp_path / "installed"
    subprocess.run(["cmake", "--install", BUILD, "--prefix", prefix], check=True)
    assert (prefix / "include" / "lapilli" / "core" / "simulation.hpp").exists()
    headers = set(re.findall(r"`(lapilli/\S+\.hpp)`", page))
    assert headers
    assert all((prefix / "include" / name).exists() for name in headers)
    configure = ["cmake", "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}"]
    subprocess.run([*configure, "-DCMAKE_BUILD_TYPE=Release"], check=True)
    subprocess.run(["cmake", "--build", "build"], check=True)
    ring.save("ring.toml")
    done = subprocess.run(
        ["build/hottest", "ring.toml"], capture_output=True, text=True, check=True
    )
    simulation = lp.Simulation(ring)
    simulation.run_until(simulation.end)
    hottest = float(done.stdout.removeprefix("hottest point: "))
    assert hottest == pytest.approx(simulation["temperature"].max(), rel=1e-5)
