"""A reference that shares code with the solver proves nothing: only NumPy, SciPy and each other."""

import ast
import sys
from pathlib import Path

import pytest

import lapilli.references

FILES = sorted(Path(lapilli.references.__file__).parent.glob("*.py"))


def imported(source):
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield "." * node.level + (node.module or "")


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_imports(file):
    allowed = {"numpy", "scipy"} | set(sys.stdlib_module_names)
    for name in imported(file.read_text(encoding="utf-8")):
        inside = name.startswith("lapilli.references")
        assert inside or name.split(".")[0] in allowed, f"{file.name} imports {name}"


def test_the_check_sees_imports():
    source = "import lapilli\nfrom lapilli._core import x\nfrom . import y\nimport numpy as np"
    assert list(imported(source)) == ["lapilli", "lapilli._core", ".", "numpy"]
    assert len(FILES) > 10
