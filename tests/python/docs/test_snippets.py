"""Every snippet of README and manual runs, page by page, as a reader would do it.

A comment before a block says what differs from that: `<!-- slow -->` runs with the slow tests,
`<!-- shown: WHY -->` is not run, for the reason given.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

import lapilli as lp
from lapilli import notebooks

ROOT = Path(__file__).parents[3]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
AS_NOTEBOOKS = set(notebooks.pages().values())  # which test_notebooks.py runs


@dataclass(frozen=True)
class Snippet:
    """One block: where it stands, its language, its text."""

    page: Path
    line: int
    language: str
    title: str  # the file that a reader is told to save it as
    text: str
    mark: str  # "", "slow" or "shown: WHY"

    @property
    def place(self) -> str:
        return f"{self.page.relative_to(ROOT)}:{self.line}"


def snippets_of(page: Path) -> list[Snippet]:
    """All marked blocks of a page."""
    text = page.read_text()
    return [
        Snippet(
            page,
            text.count("\n", 0, found.start("language")) + 1,
            found["language"],
            found["title"] or "",
            found["text"],
            found["mark"] or "",
        )
        for found in notebooks.BLOCK.finditer(text)
    ]


PROGRAMS = ("lapilli", "python")  # what is run of a shell block; the rest must be known:
OTHERS = {
    "make": "tested by itself",
    "cmake": "builds",
    "build/cpp/lapilli-run": "tested in C++",
    "pip": "installs",
    ".": "enters the environment",
    "git": "fetches",
    "cibuildwheel": "builds",
}
WITH_SHELL = [page for page in PAGES if snippets_of(page)]


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the examples and the command `lapilli`."""
    folder = tmp_path_factory.mktemp("reader")
    (folder / "bin").mkdir()
    program = folder / "bin" / "lapilli"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m lapilli "$@"\n')
    program.chmod(0o755)
    return folder


def run_shell(snippet: Snippet, folder: Path, bench: Path) -> None:
    """The commands of a block, as far as they are ours."""
    for command in snippet.text.replace("\\\n", " ").splitlines():
        words = command.split("#")[0].split()
        if not words:
            continue
        if words[0] not in PROGRAMS:
            assert words[0] in OTHERS, f"{snippet.place}: nobody runs {command!r}"
            continue
        environment = {
            **os.environ,
            "PATH": f"{bench / 'bin'}:{os.environ['PATH']}",
            "PYTHONPATH": str(Path(lp.__file__).parents[1]),
        }
        done = subprocess.run(
            ["bash", "-ec", command], cwd=folder, env=environment, capture_output=True, text=True
        )
        assert done.returncode == 0, f"{snippet.place}: {command}\n{done.stdout}{done.stderr}"


def run_python(snippet: Snippet, names: dict[str, Any]) -> None:
    """A block, with the names of those before it on its page."""
    code = compile("\n" * (snippet.line - 1) + snippet.text, str(snippet.page), "exec")
    exec(code, names)


def check_toml(snippet: Snippet, folder: Path) -> None:
    """A whole scene is saved under its name, and read; a part must fit into some scene."""
    if snippet.title:
        (folder / snippet.title).write_text(snippet.text)
    lp.Scene.parse(completed(snippet.text), snippet.place)


def completed(text: str) -> str:
    """A part of a scene with the sections around it that it needs."""
    given = set(re.findall(r"^\[+(\w+)", text, re.MULTILINE))
    shape = 'shape = {kind = "box", lower = [0, 0], upper = [1, 1]}'
    body = (
        f'[[bodies]]\nname = "ring"\n{shape}\n'
        'material = [{kind = "thermal", density = 1, specific_heat = 1, conductivity = 1}, '
        '{kind = "elastic", density = 1, youngs_modulus = 1, poissons_ratio = 0.3}]\n'
    )
    if "[bodies.shape]" in text and "[[bodies]]" not in text:  # of a body that is not shown
        text = body.replace(shape, "") + text
    elif "bodies" not in given:
        text += "\n" + body
    if "grid" not in given:
        text += "\n[grid]\nlower = [-9, -9]\nupper = [9, 9]\ncell = 1\n"
    if "time" not in given:
        text += "\n[time]\nend = 1\n"
    return text


@pytest.mark.parametrize("kind", ["quick", pytest.param("slow", marks=pytest.mark.slow)])
@pytest.mark.parametrize("page", WITH_SHELL, ids=lambda page: str(page.relative_to(ROOT)))
def test_snippets_run(
    page: Path, kind: str, bench: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = snippets_of(page)
    if kind == "slow" and not any(snippet.mark == "slow" for snippet in wanted):
        pytest.skip("nothing slow here")
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {"__name__": "__main__"}
    for snippet in wanted:
        if snippet.mark.startswith("shown") or (snippet.mark == "slow" and kind == "quick"):
            continue
        if page in AS_NOTEBOOKS and snippet.language != "toml":
            continue
        if snippet.language == "sh":
            run_shell(snippet, tmp_path, bench)
        elif snippet.language == "python":
            run_python(snippet, names)
        elif snippet.language == "toml":
            check_toml(snippet, tmp_path)
        else:
            assert snippet.language in ("text", "cpp", "cmake"), (
                f"{snippet.place}: nobody checks this"
            )


def test_most_snippets_are_run() -> None:
    """A page cannot get rid of its test by a remark alone."""
    every = [snippet for page in PAGES for snippet in snippets_of(page)]
    shown = [snippet.place for snippet in every if snippet.mark.startswith("shown")]
    assert len(every) > 60
    assert len(shown) <= 0.15 * len(every), shown
    fences = sum(len(re.findall(r"^```\w", page.read_text(), re.MULTILINE)) for page in PAGES)
    assert fences == len(every)  # none is written in a way that is not seen
