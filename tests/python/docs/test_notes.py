"""Notes and their codes: every one that can be said has a code of its own, which stands in the
manual, in `check`, in the record, in logging and in reports."""

from __future__ import annotations

import json
import logging
import pickle
import re
import sys
from pathlib import Path

import pytest

import lapilli as lp
from lapilli import _core
from lapilli.cli import main
from lapilli.note import KINDS, Note, note, notes_in
from lapilli.report import write_report
from lapilli.study import Setting
from lapilli.study.fitting import fitted

sys.path.insert(0, str(Path(__file__).parent))
from tables import tables_of

sys.path.pop(0)

ROOT = Path(__file__).parents[3]
# Said in several places, with one meaning and one cure.
SHARED = {"scene.no-effect", "heat.conductivity-axes", "peridynamics.comparison-laplacian"}


def places_of_codes() -> dict[str, list[str]]:
    """Where each code is said."""
    files = [*(ROOT / "cpp" / "lapilli").rglob("*.cpp"), *(ROOT / "python").rglob("*.py")]
    found: dict[str, list[str]] = {}
    for file in files:
        for code in re.findall(r"\b(?:note|say)\(\s*\"([\w.-]+\.[\w-]+)\"", file.read_text()):
            found.setdefault(code, []).append(str(file.relative_to(ROOT)))
    return found


def test_every_code_is_said_and_no_two_kinds_of_note_have_one() -> None:
    """That a code is in the list is what the compiler asks for."""
    places = places_of_codes()
    assert set(places) == set(KINDS)
    assert {code for code, where in places.items() if len(where) > 1} == SHARED
    for code, (when, advice) in KINDS.items():
        assert re.fullmatch(r"[a-z_]+\.[a-z0-9-]+", code)
        assert when.endswith(".")
        assert advice.endswith((".", "?"))


def test_every_code_stands_in_the_manual(site: Path) -> None:
    (table,) = tables_of(site / "reference" / "notes.html")
    assert table[0] == ["code", "said when", "what to do"]
    assert [row[0] for row in table[1:]] == list(KINDS)
    assert all(len(row[1]) > 15 and len(row[2]) > 5 for row in table[1:])


def test_keys_tells_of_all_and_of_one(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["keys", "notes", "--json"]) == 0
    assert {row["code"] for row in json.loads(capsys.readouterr().out)} == set(KINDS)
    assert main(["keys", "heat.bridged-gap"]) == 0
    shown = capsys.readouterr().out
    assert KINDS["heat.bridged-gap"][1] in shown
    assert "heat.drawn-gap" not in shown


@pytest.fixture
def noted(ring: lp.Scene) -> lp.Scene:
    """A scene with something to say of its settings."""
    ring.heat.theta = 1.0
    ring.bodies[0].fill = "lattice"
    return ring


def test_notes_have_codes_wherever_they_are_said(
    noted: lp.Scene, caplog: pytest.LogCaptureFixture, tmp_path: Path
) -> None:
    check = json.loads(_core.check_json(noted))
    said = notes_in(check, "notes", "note_codes")
    assert {one.code for one in said} == {"scene.no-effect", "bodies.volume"}
    for one in said:
        assert one.line in _core.check_text(noted)
    with caplog.at_level(logging.WARNING, "lapilli"):
        result = lp.run(noted, tmp_path / "ring.vtkhdf", progress=False)
    assert [(one, one.code) for one in result.summary.notes] == [
        (one, one.code) for one in notes_in(result.record, "notes", "note_codes")
    ]
    assert {one.code for one in result.summary.notes} == {"scene.no-effect", "bodies.volume"}
    assert {record.code for record in caplog.records} == {"scene.no-effect", "bodies.volume"}
    for one in result.summary.notes:
        assert f"note: {one.line}" in result.report()
        assert any(one.line in record.getMessage() for record in caplog.records)
    page = write_report(result.output, tmp_path / "ring.html", pictures=1).read_text()
    assert "[bodies.volume]" in page


def test_warnings_of_a_physics_have_codes(tmp_path: Path) -> None:
    body = lp.Body(
        shape=lp.Box(lower=(0, 0), upper=(1, 1)),
        material=lp.Elastic(density=1000, youngs_modulus=1e5, poissons_ratio=0.3),
    )
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1, 2), cell=0.25, shape_function="bspline"),
        bodies=[body],
        dynamics=lp.Dynamics(gravity=(0, -9.81), stress_update="usl"),
        time=lp.Time(end=0.01),
    )
    result = lp.run(scene, tmp_path / "block.vtkhdf", progress=False)
    codes = {one.code for one in result.warnings}
    assert codes == {"dynamics.damping-usl", "dynamics.damping-bspline"}
    assert main(["run", str(scene_file(scene, tmp_path)), "--json", "--output", "b.vtkhdf"]) == 0


def scene_file(scene: lp.Scene, folder: Path) -> Path:
    """The scene, saved."""
    scene.save(folder / "block.toml")
    return folder / "block.toml"


def test_the_command_line_prints_codes_beside_words(
    noted: lp.Scene, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    noted.save(tmp_path / "ring.toml")
    assert main(["run", str(tmp_path / "ring.toml"), "--json", "-q", "--output", "r.vtkhdf"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert len(printed["notes"]) == len(printed["note_codes"]) == 2
    assert "bodies.volume" in printed["note_codes"]


def test_what_python_says_has_a_code_too(ring: lp.Scene) -> None:
    _, notes = fitted([Setting((("grid.cell", "0.7"),))], ring)
    assert [one.code for one in notes] == ["study.cell-fitted"]
    with pytest.raises(KeyError, match="note_kinds"):
        note("study.unheard-of", "words")


def test_a_note_is_its_words_and_survives_a_copy() -> None:
    one = Note("a gap", "heat.bridged-gap")
    again = pickle.loads(pickle.dumps(one))
    assert again == one == "a gap"
    assert (again.code, again.line) == ("heat.bridged-gap", "a gap [heat.bridged-gap]")
    assert json.loads(json.dumps([one])) == ["a gap"]


def test_records_without_codes_are_read() -> None:
    (one,) = notes_in({"notes": ["of an earlier version"]}, "notes", "note_codes")
    assert one.code == ""
