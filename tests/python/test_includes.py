"""Holds the table of who may include whom: folders of the library know only what they stand on."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LIBRARY = ROOT / "cpp" / "lapilli"

ALLOWED = {
    "core": {"core"},
    "materials": {"materials", "core"},
    "geometry": {"geometry", "core"},
    "output": {"output", "core"},
    "algebra": {"algebra", "geometry", "core"},
    "mpm": {"mpm", "algebra", "materials", "geometry", "core"},
    "peridynamics": {"peridynamics", "materials", "geometry", "core"},
    "scene": {"scene", "output", "algebra", "mpm", "peridynamics", "materials", "geometry", "core"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s+"lapilli/([a-z_0-9]+)/', re.MULTILINE)
SYSTEM = re.compile(r"^\s*#\s*include\s+<([^>]+)>", re.MULTILINE)


def sources(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.suffix in {".hpp", ".cpp"})


def folders_included(path: Path) -> set[str]:
    return set(INCLUDE.findall(path.read_text()))


def test_every_folder_is_in_the_table() -> None:
    assert {path.name for path in LIBRARY.iterdir() if path.is_dir()} <= ALLOWED.keys()


@pytest.mark.parametrize("folder", ALLOWED)
def test_folder_includes_only_what_it_may(folder: str) -> None:
    strangers = {
        f"{path.relative_to(ROOT)} includes {other}"
        for path in sources(LIBRARY / folder)
        for other in folders_included(path) - ALLOWED[folder]
    }
    assert not strangers


def test_the_executable_adds_nothing_else() -> None:
    app = {other for path in sources(ROOT / "cpp" / "app") for other in folders_included(path)}
    assert app <= {"scene", "output", "core"}


def test_the_bindings_include_scene_output_core_and_plain_structs() -> None:
    """Of the other folders only what scenes are described with: no solver, no transfer."""
    included = {
        header
        for path in sources(ROOT / "python" / "bindings")
        for header in re.findall(r'#\s*include\s+"lapilli/([^"]+)"', path.read_text())
    }
    assert included, "the pattern sees nothing"
    solvers = {
        header
        for header in included
        if header.split("/")[0] in {"mpm", "peridynamics"}
        and not header.endswith(("settings.hpp", "surface_view.hpp"))
    }
    assert not solvers


@pytest.mark.parametrize(
    ("header", "homes"),
    [
        ("omp.h", {"core/parallel.hpp"}),
        ("toml++/toml.h", {"scene/toml_source.cpp", "scene/toml_implementation.cpp"}),
    ],
)
def test_libraries_stay_in_one_place(header: str, homes: set[str]) -> None:
    users = {
        str(path.relative_to(LIBRARY))
        for path in sources(LIBRARY)
        if header in SYSTEM.findall(path.read_text())
    }
    assert users == homes


def test_hdf5_stays_in_output() -> None:
    users = {
        path.relative_to(LIBRARY).parts[0]
        for path in sources(LIBRARY)
        if "hdf5.h" in SYSTEM.findall(path.read_text())
    }
    assert users <= {"output"}


def test_the_pattern_sees_includes() -> None:
    """A table that matches nothing would hold nothing."""
    assert {"mpm", "scene"} <= folders_included(LIBRARY / "scene" / "build.cpp")
