"""The manual as a folder of files: it needs no network, and its formulas and pictures are there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

# What a browser loads by itself; a link is followed by a click.
LOADED = re.compile(
    r"<(?:script|img|iframe|source|video|audio|embed|object)\b[^>]*?\b(?:src|srcset|data)=\"([^\"]+)"
    r"|<link\b[^>]*?\bhref=\"([^\"]+)"
)
FOREIGN = re.compile(r"^(?:https?:)?//", re.IGNORECASE)


def loaded_by(page: Path) -> list[str]:
    return [src or href for src, href in LOADED.findall(page.read_text())]


def test_no_page_loads_anything_from_the_network(site: Path) -> None:
    pages = list(site.rglob("*.html"))
    assert len(pages) > 40
    for page in pages:
        assert [one for one in loaded_by(page) if FOREIGN.match(one)] == [], page
    for sheet in site.rglob("*.css"):
        urls = re.findall(r"url\([\"']?([^)\"']+)|@import\s+[\"']([^\"']+)", sheet.read_text())
        assert [one for pair in urls for one in pair if FOREIGN.match(one)] == [], sheet


def test_what_pages_load_is_there(site: Path) -> None:
    for page in site.rglob("*.html"):
        for one in loaded_by(page):
            if page.name != "404.html" and not one.startswith("data:"):
                assert (page.parent / one.split("?")[0].split("#")[0]).exists(), (page, one)


def test_search_and_worker_run_from_a_file(site: Path) -> None:
    """The index is a script too, and a page brings what stands for a worker."""
    assert (site / "search" / "search_index.js").read_text().startswith("var __index = {")
    assert any("iframe-worker" in one for one in loaded_by(site / "index.html"))


@pytest.mark.parametrize("page", ["heat", "soil", "supports", "flow"])
def test_formulas_are_set(site: Path, page: str) -> None:
    """As MathML: nothing of LaTeX is left, nor would a script have to set it."""
    text = (site / f"{page}.html").read_text()
    assert text.count('display="block"') >= 3
    assert "arithmatex" not in text
    said = re.sub(r"<(pre|code|script|style)\b.*?</\1>", "", text, flags=re.DOTALL)
    assert not re.search(r"\$\$|\\(frac|mathbf|sum|text|nabla)", said)


def test_every_picture_says_what_it_shows(site: Path) -> None:
    for page in site.rglob("*.html"):
        for picture in re.findall(r"<img[^>]+>", page.read_text()):
            assert re.search(r'alt="[^"]{8,}"', picture) or "logo" in picture, (page, picture)
