"""What is shipped beside the code: licences of the libraries in a wheel, the recipe of conda."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LICENCES = ROOT / "packaging" / "licences"
# Libraries as CMake names them, and the text of each.
TEXTS = {
    "Eigen": "eigen.txt",
    "HDF5": "hdf5.txt",
    "libpng": "libpng.txt",
    "zlib": "zlib.txt",
    "toml++": "tomlplusplus.txt",
    "CLI11": "cli11.txt",
    "hdf5": "hdf5.txt",
    "sz": "libaec.txt",
    "aec": "libaec.txt",
    "png": "libpng.txt",
    "pybind11": "pybind11.txt",
    "OpenMP": "libgomp.txt",
}


def libraries() -> set[str]:
    """Whatever the build looks for."""
    text = (ROOT / "cmake" / "dependencies.cmake").read_text()
    bundled = (ROOT / "cmake" / "bundle.cmake").read_text()
    archives = re.search(r"foreach\(archive ([^)]+)\)", bundled)
    assert archives
    return {
        *re.findall(r'lapilli_missing\("?([^")]+?)(?: [\d.]+)?"? (?:lib|zlib)', text),
        *archives[1].split(),
        "pybind11",
        "OpenMP",
    }


def test_every_library_in_a_wheel_has_its_licence() -> None:
    assert len(libraries()) >= 10
    assert libraries() == set(TEXTS)
    notice = (LICENCES / "NOTICE.txt").read_text()
    for name in set(TEXTS.values()):
        assert len((LICENCES / name).read_text()) > 1000, name
        assert name in notice
    there = {path.name for path in LICENCES.iterdir()}
    assert there == {*TEXTS.values(), "NOTICE.txt"}
    assert '"packaging/licences/*.txt"' in (ROOT / "pyproject.toml").read_text()


def named(section: str, text: str) -> set[str]:
    """Packages that a section of the recipe requires, with their versions."""
    found = re.search(rf"^  {section}:\n((?:    - .*\n)+)", text, re.MULTILINE)
    assert found, section
    return {line.removeprefix("    - ").replace(" ", "") for line in found[1].splitlines()}


def test_the_recipe_of_conda_asks_for_what_the_package_asks_for() -> None:
    tomllib = pytest.importorskip("tomllib")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    recipe = (ROOT / "packaging" / "conda" / "recipe.yaml").read_text()
    python = "python" + project["project"]["requires-python"]
    assert named("run", recipe) == {*project["project"]["dependencies"], python}
    built_with = {need for need in project["build-system"]["requires"] if "cmeel" not in need}
    assert built_with <= named("host", recipe)
    cmake = (ROOT / "CMakeLists.txt").read_text()
    (version,) = re.findall(r"project\(lapilli VERSION ([0-9.]+)", cmake)
    assert f'version: "{version}"' in recipe
