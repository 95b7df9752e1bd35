"""The gallery: every case of the papers and every example of a user has a picture that is small."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import pytest

import lapilli as lp
from lapilli import examples
from lapilli.reproduce import cases

pytest.importorskip("tomllib")
Image = pytest.importorskip("PIL.Image")

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "tools"))
import gallery  # noqa: E402

sys.path.remove(str(ROOT / "tools"))

ENTRIES = gallery.entries()


def test_every_case_of_the_papers_is_shown() -> None:
    told = " ".join(
        command for one in ENTRIES for command in [*one.get("also", []), one.get("reproduce", "")]
    )
    assert [name for name in cases.MODULES if name not in told.split()] == []


def test_every_scene_of_a_user_is_shown() -> None:
    shown = {entry["scene"] for entry in ENTRIES}
    users = {name for name in examples.names() if name.split("/")[0] not in ("vhfm", "ib", "pd")}
    assert len(users) >= 10
    assert users <= shown


@pytest.mark.parametrize("entry", ENTRIES, ids=map(gallery.name_of, ENTRIES))
def test_an_entry_has_its_picture_and_its_changes_are_known(
    entry: dict[str, Any], site: Path
) -> None:
    picture = gallery.picture_of(entry)
    assert picture.stat().st_size < gallery.LARGEST == 80_000
    with Image.open(picture) as image:
        assert image.width == entry.get("width", gallery.WIDTH)
    changes = entry.get("set", [])
    scene = examples.load(entry["scene"])
    for change in changes:
        scene = scene.set(change)
    assert not changes or lp._core.check_text(scene)
    page = (site / "gallery.html").read_text()
    assert f'src="pictures/gallery/{picture.name}"' in page
    assert gallery.commands(entry)[0] in re.sub("<[^>]+>", "", page)


@pytest.mark.slow
@pytest.mark.parametrize("entry", ENTRIES, ids=map(gallery.name_of, ENTRIES))
def test_the_commands_make_the_picture(
    entry: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gallery, "PICTURES", tmp_path)
    monkeypatch.setenv("PYTHONPATH", str(Path(lp.__file__).parents[1]))
    gallery.draw(entry)
    assert gallery.picture_of(entry).stat().st_size > 3000
