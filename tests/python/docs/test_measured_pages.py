"""Pages written from what was measured: verification, and where the defaults lie."""

from __future__ import annotations

import json
import re
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from lapilli.reproduce import cases
from lapilli.reproduce.case import Row

pytest.importorskip("tomllib")
pytest.importorskip("mkdocs")

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "tools" / "manual"))
import fronts_page  # noqa: E402
import verification_page  # noqa: E402

sys.path.remove(str(ROOT / "tools" / "manual"))

ROW = Row(
    case="vhfm/ring", setting="h = 0.1", quantity="error", unit="K", paper=2e-3,
    reference=None, lapilli=1.234e-3, bar="<= 0.01", ok=True,
)  # fmt: skip


def test_every_case_of_the_papers_is_verified(site: Path) -> None:
    rows = verification_page.rows_in(verification_page.ROWS)
    assert {row.case for row in rows} == set(cases.MODULES)
    text = (site / "verification.html").read_text()
    for name in cases.MODULES:
        assert f"lapilli reproduce {name}</code>" in text
    assert text.count("<tr>") >= len(rows)


def test_missed_bars_are_shown_and_counted() -> None:
    missed = replace(ROW, ok=False, lapilli=0.5)
    text = verification_page.page([ROW, missed, replace(ROW, bar="")])
    assert "**1 of 2 bars are kept.** 1 numbers are reported" in text
    assert "| h = 0.1 | error (K) | 0.002 |  | 0.001234 | <= 0.01 | ok |" in text
    assert "| 0.5 | <= 0.01 | MISSED |" in text


def test_every_scanned_scene_has_its_picture_and_advice(site: Path) -> None:
    measured = json.loads(fronts_page.FRONTS.read_text())
    text = (site / "fronts.html").read_text()
    assert len(measured["scenes"]) >= 16
    for one in measured["scenes"]:
        assert f"pictures/fronts/{one['name']}.png" in text
        assert one["choose"].replace("`", "")[:20] in re.sub(r"<[^>]+>", "", text)
        assert one["rows"], one["name"]


def test_defaults_lie_near_the_front() -> None:
    """At most 1.5 times its cost, at the median of the cells of each scene. The cavity alone lies
    further off: two fifths of the sound speed serve as well there, at half of the cost."""
    measured = json.loads(fronts_page.FRONTS.read_text())
    far = {
        one["name"]
        for one in measured["scenes"]
        if sorted(row["over_front"] for row in one["rows"])[len(one["rows"]) // 2] > 1.5
    }
    assert far <= {"cavity"}
