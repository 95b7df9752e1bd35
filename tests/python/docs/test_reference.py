"""Pages of reference: every key of a scene, every field, every column of the history, with unit."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

import lapilli as lp
from lapilli import _core, examples
from lapilli.point_fields import FIELDS

sys.path.insert(0, str(Path(__file__).parent))
from tables import tables_of

sys.path.pop(0)


IN_PROGRAMS = "from a program only"  # the type of keys that a file cannot hold


def described(properties: dict[str, Any]) -> set[tuple[str, str]]:
    """Keys of the schema, with meaning and unit in one text."""
    return {(key, says.get("description", "")) for key, says in properties.items() if key != "kind"}


def test_every_key_is_there_with_its_meaning_and_unit(site: Path) -> None:
    """The schema of scene files is written from the same structs by other code."""
    pages = [page for page in (site / "reference").glob("*.html") if "history" not in page.name]
    shown = []
    for table in (table for page in pages for table in tables_of(page)):
        if table[0] == ["key", "type", "unit", "allowed", "default", "meaning"]:
            in_files = [row for row in table[1:] if row[0] != "kind" and row[1] != IN_PROGRAMS]
            shown.append({(row[0], ", ".join(filter(None, (row[5], row[2])))) for row in in_files})
    schema = json.loads(_core.scene_schema())
    wanted = {"top of the file": schema, **schema["definitions"]}
    missing = [name for name, one in wanted.items() if described(one["properties"]) not in shown]
    assert len(wanted) > 50
    assert missing == []


SCENES = {
    "vhfm/swirl": "time.end=0.001",
    "heat/casting": "time.end=0.01",
    "soil/slope": "time.end=0.001",
    "static/footing": "time.steps=1",
    "flow/plume": "time.end=0.001",
}


def test_every_field_is_there_with_its_unit(site: Path, tmp_path: Path) -> None:
    """What scenes of every method write; and nothing is on the page that none writes."""
    (table,) = tables_of(site / "reference" / "fields.html")
    shown = {row[0]: row[1] for row in table[1:]}
    assert shown == {field.name: field.unit for field in FIELDS}
    written = {"position": "m", "id": "", "body": ""}
    for name, change in SCENES.items():
        coarse = "grid.cell=0.5" if name == "static/footing" else change
        scene = examples.load(name).set(change).set(coarse)
        result = lp.run(scene, tmp_path / f"{name.replace('/', '_')}.vtkhdf", progress=False)
        written |= result.frames.units
    clay = examples.load("soil/collapse").set("grid.cell=0.25").set("time.end=0.01")
    clay.bodies[0].material = lp.ModifiedCamClay(
        density=1800,
        youngs_modulus=1e6,
        critical_state_slope=1.2,
        plastic_compressibility=0.04,
        preconsolidation_pressure=1e5,
    )
    written |= lp.run(clay, tmp_path / "clay.vtkhdf", progress=False).frames.units
    for name, units in {"volume": ("m", "m^2", "m^3"), "wall_area": ("", "m", "m^2")}.items():
        assert written.pop(name) in units  # of one, two or three dimensions
        assert shown.pop(name) == units[-1]
    assert written == shown


def test_every_column_of_the_history_is_there_with_its_unit(site: Path) -> None:
    wanted = [
        [cell.strip().strip("`") for cell in line.strip("|").split("|")]
        for line in _core.keys_as_markdown("history").splitlines()
        if line.startswith("| `")
    ]
    assert len(wanted) > 40
    table = tables_of(site / "reference" / "history.html")[0]
    assert table[1:] == wanted


def test_keys_prints_the_fields_too(capsys: pytest.CaptureFixture[str]) -> None:
    from lapilli.cli import main

    assert main(["keys", "fields", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert {row["field"]: row["unit"] for row in rows} == {one.name: one.unit for one in FIELDS}
