"""The package as it is shipped: stubs, names, dependencies of the command line."""

import json
import platform
import re
import resource
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
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
    assert "lapilli/tutorials/heat.md" in names
    assert sum(name.endswith(".so") and "/_core" in name for name in names) == 1
    assert any(name.endswith("/lapilli-run") for name in names)
    assert any(name.endswith("licences/hdf5.txt") for name in names)
    kernels = [name for name in sorted(names) if name.endswith("/liblapilli_kernels.so")]
    assert kernels == [
        "lapilli/glibc-hwcaps/x86-64-v3/liblapilli_kernels.so",
        "lapilli/liblapilli_kernels.so",
    ]
    # HDF5 and libpng are in the library, so that next to nothing is put beside it
    libraries = [name for name in names if re.fullmatch("lapilli.libs/.+", name)]
    assert all("libgomp" in name for name in libraries), libraries


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("nm"), reason="needs nm")
def test_only_kernels_hand_over_vectors(wheel: Path, tmp_path: Path) -> None:
    """Four numbers at once go by registers where there is AVX, else by memory: none may pass
    between the library, which is of the least level, and its kernels."""
    zipfile.ZipFile(wheel).extractall(tmp_path)

    def names(library: str) -> list[str]:
        command = ["nm", "-D", tmp_path / "lapilli" / library]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()

    vector = "Dv4_d"  # as the compiler spells it
    assert any(vector in name for name in names("liblapilli_kernels.so"))
    assert not [name for name in names("liblapilli.so") if vector in name]


@pytest.mark.slow
@pytest.mark.xfail(
    reason="7.4 MB: 1.8 of kernels for AVX2, 1.1 for any processor, 3.4 of the rest with HDF5"
)
def test_the_wheel_is_small(wheel: Path) -> None:
    assert wheel.stat().st_size < 6e6


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The programs of a new environment that holds the wheel and what pip installs with it."""
    venv = tmp_path_factory.mktemp("venv")
    subprocess.run([sys.executable, "-m", "venv", venv], check=True)
    subprocess.run([venv / "bin" / "pip", "install", "--quiet", wheel], check=True)
    return venv / "bin"


def told_by(program: Path, environment: dict[str, str], folder: Path) -> str:
    """What the installed executable and the installed module say of themselves: the same."""
    texts = [
        subprocess.run(
            [program / name, "--version"],
            env=environment,
            cwd=folder,
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for name in ("lapilli-run", "lapilli")
    ]
    assert texts[0] == texts[1]
    return texts[0]


@pytest.mark.slow
@pytest.mark.skipif(platform.machine() != "x86_64", reason="levels of x86-64")
def test_every_processor_gets_its_kernels(installed: Path, ring: lp.Scene, tmp_path: Path) -> None:
    """The loader takes the best set there is; without AVX2 it takes the least one."""
    without_avx2 = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2"}
    assert "kernel set: x86-64\n" in told_by(installed, without_avx2, tmp_path)
    if "avx2" in Path("/proc/cpuinfo").read_text():
        assert "kernel set: x86-64-v3\n" in told_by(installed, {}, tmp_path)
    ring.save(str(tmp_path / "ring.toml"))
    temperatures = {}
    for name, environment in {"least": without_avx2, "best": {}}.items():
        for threads in ("1", "2"):
            output = f"{name}{threads}.vtkhdf"
            command = [installed / "lapilli-run", "ring.toml", "--output", output]
            subprocess.run(
                [*command, "--threads", threads], env=environment, cwd=tmp_path, check=True
            )
            frames = lp.Frames(tmp_path / output)
            temperatures[name, threads] = frames[-1]["temperature"]
        record = json.loads((tmp_path / f"{name}1.json").read_text())
        assert record["kernel_set"] in told_by(installed, environment, tmp_path)
        assert np.array_equal(temperatures[name, "1"], temperatures[name, "2"])
    np.testing.assert_allclose(temperatures["least", "1"], temperatures["best", "1"], rtol=1e-12)


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("qemu-x86_64"), reason="needs qemu-user")
def test_a_processor_without_avx_runs(installed: Path, ring: lp.Scene, tmp_path: Path) -> None:
    """Of 2008, emulated: any instruction that it lacks would end the run."""
    ring.save(str(tmp_path / "ring.toml"))
    program = next(installed.parent.glob("lib/python*/site-packages/lapilli/bin/lapilli-run"))
    emulated = [shutil.which("qemu-x86_64"), "-cpu", "Nehalem", program]
    command = [*emulated, "ring.toml", "--output", "ring.vtkhdf"]
    environment = {"OMP_WAIT_POLICY": "passive"}  # without it the program starts itself anew, here
    subprocess.run(command, env=environment, cwd=tmp_path, check=True)
    record = json.loads((tmp_path / "ring.json").read_text())
    assert record["status"] == "finished"
    assert record["kernel_set"] == "x86-64"


@pytest.mark.slow
def test_the_wheel_runs_in_a_clean_environment(
    wheel: Path, installed: Path, ring: lp.Scene, tmp_path: Path
) -> None:
    """Outside of the sources, with what pip installs: no compiler, no -dev package."""

    def run(*words: str) -> str:
        command = [installed / words[0], *words[1:]]
        done = subprocess.run(command, cwd=tmp_path, env={}, capture_output=True, text=True)
        assert done.returncode == 0, f"{words}\n{done.stdout}{done.stderr}"
        return done.stdout

    ring.save(str(tmp_path / "ring.toml"))
    assert "kernel set: " in run("lapilli", "--version")
    run("lapilli", "run", "ring.toml")
    assert len(lp.Frames(tmp_path / "ring.vtkhdf")) == 2
    run("lapilli-run", "ring.toml", "--output", "same.vtkhdf")
    assert len(lp.Frames(tmp_path / "same.vtkhdf")) == 2
    assert "vhfm/fan" in run("lapilli", "examples", "list")
    run("lapilli", "examples", "copy", "vhfm/fan", "--to", "copied")
    run("lapilli", "examples", "copy", "tutorials/heat", "--to", "copied")
    assert (tmp_path / "copied" / "vhfm" / "fan.pgm").exists()
    run("pip", "install", "--quiet", f"{wheel}[plot,references]")
    run("lapilli", "plot", "ring.vtkhdf", "--save", "ring.png")
    assert (tmp_path / "ring.png").stat().st_size > 1000
    run("lapilli", "reproduce", "vhfm/ring", "--quick")
