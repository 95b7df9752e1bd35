"""The package as it is shipped: stubs, names, dependencies of the command line."""

import resource
import subprocess
import sys
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


def processor_time(code: str) -> float:
    """Of a fresh interpreter, its own start included, s."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", code], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def test_the_import_is_light() -> None:
    """`import lapilli` beside the NumPy it needs, by turns: the quotient of the least is the same
    on a slow machine and beside other programs. 0.25 s where NumPy takes 0.14 s is 1.8."""
    numpy, own = zip(
        *((processor_time("import numpy"), processor_time("import lapilli")) for _ in range(7)),
        strict=True,
    )
    assert min(own) < 1.8 * min(numpy)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of `make wheel`."""
    folder = tmp_path_factory.mktemp("dist")
    # 1 where it is too large, which has a test of its own
    command = [sys.executable, ROOT / "tools" / "wheel.py", "--to", folder]
    assert subprocess.run(command).returncode in (0, 1)
    return next(folder.glob("*manylinux*.whl"))


@pytest.mark.slow
def test_the_wheel_holds_what_it_needs_and_no_more(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    assert "lapilli/_core.pyi" in names
    assert "lapilli/py.typed" in names
    assert "lapilli/example_scenes/vhfm/fan.pgm" in names
    assert sum(name.endswith(".so") and "/_core" in name for name in names) == 1
    assert any(name.endswith("/lapilli-run") for name in names)
    assert any(name.endswith("licences/hdf5.txt") for name in names)
    # HDF5 and libpng are in the module, so that next to nothing is put beside it
    libraries = [name for name in names if name.startswith("lapilli.libs/")]
    assert all("libgomp" in name for name in libraries), libraries


@pytest.mark.slow
@pytest.mark.xfail(
    reason="12.2 MB: executable and module hold the same library twice, 13 MB of code"
)
def test_the_wheel_is_small(wheel: Path) -> None:
    assert wheel.stat().st_size < 6e6


@pytest.mark.slow
def test_the_wheel_runs_in_a_clean_environment(wheel: Path, ring: lp.Scene, tmp_path: Path) -> None:
    """Outside of the sources, with what pip installs: no compiler, no -dev package."""
    subprocess.run([sys.executable, "-m", "venv", tmp_path / "venv"], check=True)
    bin_ = tmp_path / "venv" / "bin"

    def run(*words: str) -> str:
        command = [bin_ / words[0], *words[1:]]
        done = subprocess.run(command, cwd=tmp_path, env={}, capture_output=True, text=True)
        assert done.returncode == 0, f"{words}\n{done.stdout}{done.stderr}"
        return done.stdout

    run("pip", "install", "--quiet", str(wheel))
    ring.save(str(tmp_path / "ring.toml"))
    assert "kernel set: " in run("lapilli", "--version")
    run("lapilli", "run", "ring.toml")
    assert len(lp.Frames(tmp_path / "ring.vtkhdf")) == 2
    run("lapilli-run", "ring.toml", "--output", "same.vtkhdf")
    assert len(lp.Frames(tmp_path / "same.vtkhdf")) == 2
    assert "vhfm/fan" in run("lapilli", "examples", "list")
    run("lapilli", "examples", "copy", "vhfm/fan", "--to", "copied")
    assert (tmp_path / "copied" / "vhfm" / "fan.pgm").exists()
    run("pip", "install", "--quiet", f"{wheel}[plot,references]")
    run("lapilli", "plot", "ring.vtkhdf", "--save", "ring.png")
    assert (tmp_path / "ring.png").stat().st_size > 1000
    run("lapilli", "reproduce", "vhfm/ring", "--quick")
