"""The package as it is shipped: stubs, names, dependencies of the command line."""

import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

import pytest

import lapilli as lp

ROOT = Path(__file__).parents[2]


def test_every_name_is_there() -> None:
    assert sorted(lp.__all__, key=str.casefold) == sorted(set(lp.__all__), key=str.casefold)
    for name in lp.__all__:
        assert getattr(lp, name) is not None


def test_stubs_are_current() -> None:
    sys.path.insert(0, str(ROOT / "tools"))
    try:
        from write_stubs import TARGET, stubs
    finally:
        sys.path.pop(0)
    assert TARGET.read_text() == stubs(), "run `make stubs` and commit python/lapilli/_core.pyi"


def test_the_import_needs_only_what_is_declared() -> None:
    """scipy, matplotlib and trimesh are extras: a run must do without them."""
    code = (
        "import sys\n"
        "for name in ('scipy', 'matplotlib', 'trimesh', 'pyvista'): sys.modules[name] = None\n"
        "import lapilli, lapilli.cli, lapilli.study, lapilli.plot, lapilli.reproduce\n"
        "try: lapilli.plot.draw('x')\n"
        "except ValueError as error: print(error)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "pip install 'lapilli[plot]'" in done.stdout


@pytest.mark.slow
def test_a_repaired_wheel_runs_in_a_clean_environment(ring: lp.Scene, tmp_path: Path) -> None:
    """Built and repaired as `make wheel` does; no compiler and no -dev package is needed to run."""
    python = sys.executable
    raw, fixed = tmp_path / "raw", tmp_path / "fixed"
    subprocess.run([python, "-m", "build", "--wheel", "--outdir", raw, ROOT], check=True)
    wheel = next(raw.glob("*.whl"))
    path = {"PATH": f"{sysconfig.get_path('scripts')}:/usr/bin:/bin"}
    command = [python, "-m", "auditwheel", "repair", wheel, "--wheel-dir", fixed]
    subprocess.run(command, check=True, env=path)
    wheel = next(fixed.glob("*manylinux*.whl"))
    names = zipfile.ZipFile(wheel).namelist()
    assert "lapilli/_core.pyi" in names
    assert "lapilli/py.typed" in names
    assert sum(name.endswith(".so") and "/_core" in name for name in names) == 1
    subprocess.run([python, "-m", "venv", tmp_path / "venv"], check=True)
    bin_ = tmp_path / "venv" / "bin"
    subprocess.run([bin_ / "pip", "install", "--quiet", wheel], check=True)
    ring.save(str(tmp_path / "ring.toml"))
    subprocess.run([bin_ / "lapilli", "run", "ring.toml"], check=True, cwd=tmp_path, env={})
    assert len(lp.Frames(tmp_path / "ring.vtkhdf")) == 2
    # outside of the sources: the examples and the cases that use them
    command = [bin_ / "lapilli", "examples", "copy", "vhfm/fan", "--to", "copied"]
    subprocess.run(command, check=True, cwd=tmp_path, env={})
    assert (tmp_path / "copied" / "vhfm" / "fan.pgm").exists()
    command = [bin_ / "lapilli", "reproduce", "ib/block", "--quick"]
    subprocess.run([bin_ / "pip", "install", "--quiet", "scipy"], check=True)
    subprocess.run(command, check=True, cwd=tmp_path, env={})
