"""Questions of users, typed into the search of the manual: the answer is among the first hits.

The index is the one that the site carries, scored by the same library (lunr) with the weights that
the site's search gives to titles and texts.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[3]
SHOWN = 10  # hits on the first page

QUESTIONS = {
    "what is the reaction at the support": "troubleshooting/#where-is-the-reaction-at-the-support",
    "where is the Nusselt number": "troubleshooting/#where-is-the-nusselt-number",
    "how do I continue with another load": "troubleshooting/#how-do-i-continue-with-another-load",
    "how do I put soil on a slope": "how-to/slopes/",
    "why does my run stop": "troubleshooting/#why-does-my-run-stop",
    "which unit has a key": "troubleshooting/#which-unit-has-a-key-a-field-a-column",
    "factor of safety": "how-to/slopes/#the-factor-of-safety",
    "use my own STL file": "how-to/shapes/#an-stl-file",
    "image as shape": "how-to/shapes/#an-image",
    "gmsh mesh": "how-to/shapes/#meshes-of-other-packages",
    "temperature at a point in time": "how-to/results/#in-time",
    "table in time": "how-to/varying/#a-table-in-time",
    "python function as boundary condition": "how-to/varying/#a-function-of-",
    "resume after a crash": "how-to/restart/",
    "pandas": "how-to/results/#in-time",
    "open in ParaView": "troubleshooting/#paraview-shows-only-one-time-or-nothing",
    "why is it so slow": "troubleshooting/#why-is-it-so-slow",
    "prescribed temperature": "how-to/varying/#a-prescribed-temperature",
    "mohr coulomb friction angle": "soil/#mohr-coulomb",
    "which cell size is accurate enough": "tutorials/accuracy/",
    "animation gif": "how-to/pictures/",
    "coming from CB-Geo": "coming-from/#cb-geo-mpm",
    "radiation celsius": "troubleshooting/#temperatures-are-wrong-under-radiation",
    "how to add a material": "developer/#where-to-add-what",
}


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The manual, built; warnings such as dead links are errors."""
    pytest.importorskip("material")
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", folder]
    environment = {**os.environ, "NO_MKDOCS_2_WARNING": "1"}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(scope="module")
def search(site: Path) -> Any:
    """A search of the site's index: the places of the hits, the best first."""
    lunr = pytest.importorskip("lunr")
    records = json.loads((site / "search" / "search_index.json").read_text())["docs"]
    index = lunr.lunr(
        ref="location",
        fields=[{"field_name": "title", "boost": 1000}, {"field_name": "text", "boost": 1}],
        documents=records,
    )
    return lambda words: [hit["ref"] for hit in index.search(words)]


@pytest.mark.slow
def test_every_question_is_answered_on_the_first_page(search: Any) -> None:
    missed = {}
    for question, place in QUESTIONS.items():
        hits = [hit.replace(".html", "/") for hit in search(question)[:SHOWN]]
        if not any(hit == place or hit.startswith(place) for hit in hits):
            missed[question] = hits
    assert len(QUESTIONS) >= 20
    assert missed == {}


@pytest.mark.slow
def test_the_site_asks_the_network_for_nothing(site: Path) -> None:
    """Fonts, scripts and search are part of it."""
    import re

    for page in site.rglob("*.html"):
        loaded = re.findall(
            r"<(?:script|link|img)[^>]+(?:src|href)=\"(https?://[^\"]+)", page.read_text()
        )
        assert [one for one in loaded if "/lapilli" not in one] == [], page
