"""Holds the table of who may include whom: folders of the library know only what they stand on."""

import collections
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from house import ALLOWED, LIBRARY, included, sources, upward_includes  # noqa: E402

sys.path.remove(str(ROOT / "tools"))

TYPE = re.compile(r"^(?:struct|class|enum class) (\w+)(?: final)?(?: :[^:].*)? \{", re.MULTILINE)
SYSTEM = re.compile(r"^\s*#\s*include\s+<([^>]+)>", re.MULTILINE)


def test_every_folder_is_in_the_table() -> None:
    assert {path.name for path in LIBRARY.iterdir() if path.is_dir()} <= ALLOWED.keys()


@pytest.mark.parametrize("folder", ALLOWED)
def test_folder_includes_only_what_it_may(folder: str) -> None:
    assert not upward_includes(folder)


def test_the_executable_adds_nothing_else() -> None:
    app = {
        header.split("/")[0] for path in sources(ROOT / "cpp" / "app") for header in included(path)
    }
    assert app <= {"scene", "output", "core"}


def test_the_bindings_include_scene_output_core_and_plain_structs() -> None:
    """Of the other folders only what scenes are described with: no solver, no transfer."""
    headers = {
        header for path in sources(ROOT / "python" / "bindings") for header in included(path)
    }
    assert headers, "the pattern sees nothing"
    solvers = {
        header
        for header in headers
        if header.split("/")[0] in {"mpm", "peridynamics"}
        and not header.endswith(("settings.hpp", "surface_view.hpp"))
    }
    assert not solvers


def test_no_two_headers_declare_one_name() -> None:
    """The linker would merge what templates make of them, without a word."""
    homes = collections.defaultdict(set)
    for path in sources(LIBRARY):
        if path.suffix == ".hpp":
            for name in TYPE.findall(path.read_text()):
                homes[name].add(str(path.relative_to(LIBRARY)))
    assert len(homes) > 200, "the pattern sees nothing"
    assert not {name: where for name, where in homes.items() if len(where) > 1}


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
    folders = {header.split("/")[0] for header in included(LIBRARY / "scene" / "build_parts.cpp")}
    assert {"mpm", "scene"} <= folders
