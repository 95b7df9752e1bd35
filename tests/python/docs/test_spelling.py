"""Prose, docstrings and messages are spelt as `make lint` wants it: British, without slips."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]


def lint_lines() -> list[list[str]]:
    """The words of the spelling lines of `make lint`."""
    text = (ROOT / "Makefile").read_text()
    texts = re.search(r"^TEXTS := (.+)$", text, re.MULTILINE)
    assert texts
    lines = re.findall(r"^\t@codespell (.+)$", text, re.MULTILINE)
    return [line.replace("$(TEXTS)", texts[1]).split() for line in lines]


@pytest.mark.parametrize("words", lint_lines(), ids=["slips", "British"])
def test_spelling(words: list[str]) -> None:
    pytest.importorskip("codespell_lib")
    command = [sys.executable, "-m", "codespell_lib", *words]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(
    ("words", "slip"), list(zip(lint_lines(), ["teh", "behavior"], strict=True))
)
def test_a_slip_is_seen(words: list[str], slip: str, tmp_path: Path) -> None:
    pytest.importorskip("codespell_lib")
    (tmp_path / "text.md").write_text(f"A word such as {slip} here.\n")
    options = [word for word in words if word.startswith("--") or word.endswith(".txt")]
    command = [sys.executable, "-m", "codespell_lib", *options, str(tmp_path / "text.md")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode != 0
    assert slip in done.stdout
