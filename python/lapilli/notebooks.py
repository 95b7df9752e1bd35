"""The tutorials of the manual as Jupyter notebooks, made from their pages: nothing stands twice."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

# Beside this file where the package is installed, in the manual otherwise.
FOLDERS = (
    Path(__file__).parent / "tutorials",
    Path(__file__).resolve().parents[2] / "docs" / "tutorials",
)
GROUP = "tutorials"  # "tutorials/heat" beside the names of the example scenes
BLOCK = re.compile(
    r"(?:<!-- (?P<mark>slow|shown: [^>]+?) -->\n+)?"
    r"^```(?P<language>\w+)(?: title=\"(?P<title>[^\"]+)\")?\n(?P<text>.*?)^```$",
    re.MULTILINE | re.DOTALL,
)
PICTURE = re.compile(r"^!\[[^\]]*\]\([^)]*\)\n*", re.MULTILINE)
LINK = re.compile(r"\[([^\]]+)\]\((?!https?:)[^)]*\)")  # to other pages, which do not come along


class Cell(NamedTuple):
    """A piece of a notebook: what it is made from, and its text."""

    language: str  # "markdown", "python", "sh", "toml"
    text: str
    mark: str = ""  # "slow", or why it is not run

    @property
    def is_code(self) -> bool:
        """Whether it is run."""
        return self.language != "markdown"


def pages() -> dict[str, Path]:
    """The page of every tutorial, by its name."""
    root = next((one for one in FOLDERS if one.is_dir()), None)
    found = sorted(root.glob("*.md")) if root else []
    return {f"{GROUP}/{page.stem}": page for page in found}


def title(page: Path) -> str:
    """What a page is called."""
    return page.read_text(encoding="utf-8").partition("\n")[0].removeprefix("# ")


def cells(text: str) -> Iterator[Cell]:
    """A page cut into prose, files, commands and Python."""
    end = 0
    for block in BLOCK.finditer(text):
        yield from prose(text[end : block.start()])
        end = block.end()
        language, inner = block["language"], block["text"].rstrip("\n")
        if language == "toml" and block["title"]:
            yield Cell("toml", f"%%writefile {block['title']}\n{inner}", block["mark"] or "")
        elif language == "sh":
            yield Cell("sh", commands(inner), block["mark"] or "")
        elif language == "python":
            yield Cell("python", inner, block["mark"] or "")
        else:
            yield Cell("markdown", f"```{language}\n{inner}\n```")
    yield from prose(text[end:])


def prose(text: str) -> Iterator[Cell]:
    """Words without pictures, which the cells draw themselves, and links to other pages."""
    text = LINK.sub(r"\1", PICTURE.sub("", text)).strip()
    if text:
        yield Cell("markdown", text)


def commands(text: str) -> str:
    """Lines of a shell, and the pictures that they draw."""
    lines = re.sub(r"\\\n\s*", "", text).splitlines()
    drawn = [f'Image("{name}")' for name in map(picture_of, lines) if name]
    shown = ["from IPython.display import Image, display", f"display({', '.join(drawn)})"]
    return "\n".join([*(f"!{line}" for line in lines), *(shown if drawn else [])])


def picture_of(command: str) -> str:
    """The picture that a command leaves, or nothing."""
    words = command.split()
    if words[:2] == ["lapilli", "plot"]:
        return words[words.index("--save") + 1] if "--save" in words else f"{words[2][:-7]}.png"
    return f"{words[words.index('--output') + 1]}.png" if words[1:2] == ["tradeoff"] else ""


def notebook(page: Path) -> str:
    """The notebook of a page, as the text of its file."""
    made: list[dict[str, Any]] = []
    for number, cell in enumerate(cells(page.read_text(encoding="utf-8"))):
        one: dict[str, Any] = {
            "id": f"{page.stem}-{number}",
            "cell_type": "code" if cell.is_code else "markdown",
            "metadata": {"tags": [cell.mark]} if cell.mark == "slow" else {},
            "source": cell.text.splitlines(keepends=True),
        }
        made.append({**one, "execution_count": None, "outputs": []} if cell.is_code else one)
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    whole = {
        "cells": made,
        "metadata": {"kernelspec": kernel, "language_info": {"name": "python"}},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(whole, indent=1, ensure_ascii=False) + "\n"
