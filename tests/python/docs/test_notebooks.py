"""The tutorials as notebooks: every cell runs, and draws what it shows."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import types
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import lapilli as lp
from lapilli import notebooks
from lapilli.cli import main

PAGES = notebooks.pages()


@pytest.fixture
def program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The command `lapilli` of this tree."""
    folder = tmp_path / "bin"
    folder.mkdir()
    (folder / "lapilli").write_text(f'#!/bin/sh\nexec "{sys.executable}" -m lapilli "$@"\n')
    (folder / "lapilli").chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", str(Path(lp.__file__).parents[1]))


def copied(name: str) -> list[dict[str, Any]]:
    """The cells of the notebook that a user copies."""
    assert main(["examples", "copy", name]) == 0
    return json.loads(Path(f"{name}.ipynb").read_text())["cells"]


@pytest.fixture
def shown(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """The pictures that cells show, of a notebook that runs without IPython."""
    pictures: list[str] = []
    display = types.ModuleType("IPython.display")
    display.Image = str  # type: ignore[attr-defined]
    display.display = lambda *names: pictures.extend(names)  # type: ignore[attr-defined]
    shell = types.ModuleType("IPython")
    shell.get_ipython = lambda: None  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "IPython", shell)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    return pictures


def run(cell: dict[str, Any], names: dict[str, Any]) -> None:
    """What a kernel does with a cell of code."""
    text = "".join(cell["source"])
    if text.startswith("%%writefile "):
        head, _, content = text.partition("\n")
        Path(head.split()[1]).write_text(content)
        return
    for line in re.findall(r"^!(.*)$", text, re.MULTILINE):
        done = subprocess.run(["bash", "-ec", line], capture_output=True, text=True)
        assert done.returncode == 0, f"{line}\n{done.stdout}{done.stderr}"
    exec(re.sub(r"^!.*$", "", text, flags=re.MULTILINE), names)


@pytest.mark.usefixtures("program")
@pytest.mark.parametrize(
    "name", [pytest.param(one, marks=[pytest.mark.slow] * ("accuracy" in one)) for one in PAGES]
)
def test_a_notebook_runs_from_its_first_cell_to_its_last(name: str, shown: list[str]) -> None:
    names: dict[str, Any] = {"__name__": "__main__"}
    for cell in copied(name):
        if cell["cell_type"] == "code":
            run(cell, names)
    assert len(shown) >= 1
    for picture in shown:
        assert Path(picture).stat().st_size > 5000, picture


@pytest.mark.usefixtures("program")
def test_jupyter_runs_one() -> None:
    """What stands in for its kernel above is no more forgiving than it is."""
    nbformat = pytest.importorskip("nbformat")
    client = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    copied("tutorials/heat")
    notebook = nbformat.read("tutorials/heat.ipynb", 4)
    nbformat.validate(notebook)
    client.NotebookClient(notebook, timeout=300).execute()
    outputs = [one for cell in notebook.cells for one in cell.get("outputs", ())]
    assert sum("image/png" in one.get("data", ()) for one in outputs) == 1
    assert not any("command not found" in one.get("text", "") for one in outputs)


def test_a_notebook_has_all_that_its_page_has() -> None:
    assert len(PAGES) >= 5
    for name, page in PAGES.items():
        text = page.read_text()
        cells = list(notebooks.cells(text))
        blocks = list(notebooks.BLOCK.finditer(text))
        kept = [cell for cell in cells if cell.is_code or cell.text.startswith("```")]
        assert len(kept) == len(blocks) >= 2, name
        for word in re.findall(r"\w{12,}", re.sub(r"\]\([^)]*\)|!\[.*", "", text)):
            assert any(word in cell.text for cell in cells), (name, word)
        assert not re.search(r"\]\((?!https?:)", "".join(cell.text for cell in cells)), name


def test_the_site_offers_every_notebook(site: Path) -> None:
    for name, page in PAGES.items():
        assert (site / f"{name}.ipynb").read_text() == notebooks.notebook(page)
        link = f'<a download="{page.stem}.ipynb" href="{page.stem}.ipynb">'
        assert link in (site / f"{name}.html").read_text()


def test_examples_list_and_copy_know_them(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["examples", "list", "--json"]) == 0
    rows = {one["name"]: one["title"] for one in json.loads(capsys.readouterr().out)}
    assert rows["tutorials/heat"] == "Heat in ten minutes (notebook)"
    assert main(["examples", "copy", "tutorials", "--quiet"]) == 0
    assert sorted(Path("tutorials").iterdir()) == [Path(f"{name}.ipynb") for name in PAGES]
    assert main(["examples", "copy", "tutorials/heat"]) == 2
    assert main(["examples", "copy", "tutorials/heet"]) == 2
    assert "did you mean 'tutorials/heat'?" in capsys.readouterr().err
