"""Tables of a page of the built manual."""

from __future__ import annotations

import html
import re
from pathlib import Path


def tables_of(page: Path) -> list[list[list[str]]]:
    """The tables of a page, as rows of the texts of their cells."""
    return [
        [
            [plain(cell) for cell in re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row, re.DOTALL)]
            for row in re.findall(r"<tr>(.*?)</tr>", table, re.DOTALL)
        ]
        for table in re.findall(r"<table>(.*?)</table>", page.read_text(), re.DOTALL)
    ]


def plain(cell: str) -> str:
    """The text of a cell without its tags."""
    return html.unescape(re.sub(r"<[^>]+>", "", cell)).strip()
