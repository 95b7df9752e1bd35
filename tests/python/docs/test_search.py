"""Questions of users, typed into the search of the manual: the answer is among the first hits.

The index is the one that the site carries. It is searched by lunr, the library of the site's own
search, with the weights and the ranking of its worker; a slow test types into the real page.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

tomllib = pytest.importorskip("tomllib")

ROOT = Path(__file__).parents[3]
SHOWN = 10  # hits on the first page
QUESTIONS = tomllib.loads((Path(__file__).parent / "questions.toml").read_text())["questions"]

Search = Callable[[str], list[str]]


@pytest.fixture(scope="module")
def search(site: Path) -> Search:
    """The places of the hits for a question, the best first."""
    builder_of = pytest.importorskip("lunr.builder").Builder
    from lunr.stop_word_filter import WORDS, stop_word_filter

    carried = json.loads((site / "search" / "search_index.json").read_text())
    assert carried["config"]["pipeline"] == ["stopWordFilter"]
    builder = builder_of()
    builder.b(0)
    builder.ref("location")
    builder.pipeline.add(stop_word_filter)
    for name, says in carried["config"]["fields"].items():
        builder.field(name, says["boost"])
    for record in carried["docs"]:
        plain = {name: re.sub(r"<[^>]+>", " ", str(text)) for name, text in record.items()}
        builder.add({"tags": "", **plain}, {"boost": record.get("boost", 1)})
    index = builder.build()

    def places(question: str) -> list[str]:
        words = question.replace("?", "").lower().split()
        found = []
        for hit in index.search(" ".join(f"{word}*" for word in words)):
            terms = hit["match_data"].metadata.keys()
            met = {word for word in words if any(term.startswith(word) for term in terms)}
            counted = met | {word for word in words if word not in WORDS}
            is_page = "#" not in hit["ref"]
            rank = (is_page + len(met) / len(counted)) ** 2
            found.append((hit["score"] * (1 + rank), hit["ref"]))
        return [place for _, place in sorted(found, reverse=True)]

    return places


def is_answer(place: str, wanted: str) -> bool:
    """Whether a hit is the wanted section, or a section of the wanted page."""
    return place == wanted or ("#" not in wanted and place.split("#")[0] == wanted)


def test_twenty_questions_and_more_are_asked() -> None:
    assert len({one["asks"] for one in QUESTIONS}) == len(QUESTIONS) >= 40


def test_every_answer_exists(site: Path) -> None:
    for one in QUESTIONS:
        page, _, section = one["answer"].partition("#")
        text = (site / page).read_text()
        assert not section or f'id="{section}"' in text, one["answer"]


@pytest.mark.parametrize("one", QUESTIONS, ids=[one["asks"] for one in QUESTIONS])
def test_a_question_is_answered_on_the_first_page(one: dict[str, str], search: Search) -> None:
    hits = search(one["asks"])[:SHOWN]
    assert any(is_answer(hit, one["answer"]) for hit in hits), "\n".join(hits)


@pytest.fixture(scope="module")
def page(site: Path) -> Iterator[Any]:
    """The manual in Chromium without a window and without a server."""
    playwright = pytest.importorskip("playwright.sync_api")
    program = shutil.which("chromium") or shutil.which("google-chrome")
    if program is None:
        pytest.skip("needs chromium")
    with playwright.sync_playwright() as running:
        browser = running.chromium.launch(executable_path=program, args=["--no-sandbox"])
        shown = browser.new_page()
        shown.set_default_timeout(60_000)  # of a busy machine
        asked: list[str] = []
        shown.on("request", lambda request: asked.append(request.url))
        shown.goto((site / "index.html").as_uri())
        yield shown
        assert [url for url in asked if url.startswith("http")] == []
        browser.close()


@pytest.mark.slow
def test_the_page_itself_answers_from_a_file(page: Any, site: Path) -> None:
    """By pages, as it groups them: a page is shown with the best of its sections."""
    missed = {}
    line = page.locator(".md-search__input")
    for one in QUESTIONS:
        for text in ("", one["asks"].replace("?", "")):
            line.fill(text)
            line.press("End")  # the page looks when a key goes up
            state = "attached" if text else "detached"
            page.wait_for_selector(".md-search-result__item", state=state)
        shown = page.eval_on_selector_all(
            ".md-search-result__item > a:first-child", "links => links.map(link => link.pathname)"
        )
        wanted = f"/{one['answer'].split('#')[0]}"
        if not any(path.endswith(wanted) for path in shown[:SHOWN]):
            missed[one["asks"]] = shown[:SHOWN]
    assert missed == {}
