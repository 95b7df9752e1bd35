"""A hook of mkdocs: pages of reference, written from the program's own tables.

One page for each part of a scene below `reference/`, `reference/fields.md`,
`reference/history.md`, `reference/notes.md`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from mkdocs.structure.files import File

from lapilli import _core
from lapilli.note import kinds_as_markdown
from lapilli.point_fields import fields_as_markdown


class Page(NamedTuple):
    """A page of keys: its title, what it says first, and how the headings of its tables begin."""

    title: str
    lead: str
    headings: tuple[str, ...]


PAGES = {
    "scene": Page(
        "Top of a scene, time, output, probes, stages",
        "What every scene has, what it writes, and what may follow in the same run.",
        ("top of the file", "[time]", "[output]", "[[probes]]", "[[stages]]"),
    ),
    "bodies": Page(
        "Grid and bodies",
        "Where the points are, how they move and in which stress they start.",
        ("[grid]", "[[bodies]]", "motion", "[bodies."),
    ),
    "shapes": Page(
        "Shapes",
        "For bodies, regions of boundary conditions, supports, obstacles and walls alike.",
        ("shape",),
    ),
    "materials": Page(
        "Materials",
        "A body has one, or a list of those that act together (`[[bodies.material]]`).",
        ("material",),
    ),
    "heat": Page("Heat", "Settings, boundary conditions and contacts.", ("[heat]", "[[heat.")),
    "dynamics": Page(
        "Explicit dynamics",
        "Settings, walls, obstacles, contacts and loads.",
        ("[dynamics]", "[[dynamics."),
    ),
    "quasi-static": Page(
        "Equilibrium", "Settings, supports and loads.", ("[quasi_static]", "[[quasi_static.")
    ),
    "peridynamics": Page(
        "Buoyant flow", "Heat, flow and walls.", ("[peridynamics", "[[peridynamics")
    ),
}


def on_files(files: Any, config: Any) -> Any:
    """Add the pages to the site."""
    for path, text in pages():
        files.append(File.generated(config, path, content=text))
    return files


def pages() -> Iterator[tuple[str, str]]:
    """Path and text of every page."""
    tables = key_tables()
    for name, page in PAGES.items():
        own = {head: tables.pop(head) for head in list(tables) if head.startswith(page.headings)}
        parts = [f"## `{head}`\n\n{table}" for head, table in own.items()]
        lead = f"{page.lead} Keys without a default, `required` apart, may be left out."
        yield f"reference/{name}.md", "\n".join([f"# {page.title}: keys\n\n{lead}\n", *parts])
    if tables:
        raise ValueError(f"no page of reference takes the keys of {', '.join(tables)}")
    yield "reference/fields.md", fields_page()
    yield "reference/history.md", history_page()
    yield "reference/notes.md", notes_page()


def key_tables() -> dict[str, str]:
    """The tables of `lapilli keys` by their headings."""
    parts = re.split(r"^## `(.+)`\n", _core.keys_as_markdown(""), flags=re.MULTILINE)
    return {head: text.strip() + "\n" for head, text in zip(parts[1::2], parts[2::2], strict=True)}


def fields_page() -> str:
    """Every field of frames and results."""
    return fields_as_markdown().replace("\n\n", """

In frames (`ring.vtkhdf`), in ParaView and in Python (`result["temperature"]`,
`frame["stress.xy"]`); `lapilli keys fields` prints the same. Components are named `velocity.x`,
`stress.xy`; `stress.magnitude` is the size. With `temperature_unit = "celsius"` temperatures are
degrees Celsius. State variables of a solid of your own are fields of their names.

""", 1)  # fmt: skip


def notes_page() -> str:
    """Every note, by its code."""
    return f"""# Notes and their codes

What is allowed and seldom meant, and what a run found of itself, is said as a note: by `lapilli
check`, at the end of a run, in the run record, in reports and to the logger `lapilli`. Each kind
has a code that stays the same while its words change. Text has it behind the words,
`[heat.bridged-gap]`; `check --json` and the record have `note_codes` beside `notes` and
`warning_codes` beside `warnings`; in Python every note of `result.summary.notes` and
`result.warnings` has its `code`. `lapilli keys notes` prints this table, `lapilli keys
heat.bridged-gap` one line of it.

{kinds_as_markdown()}"""


def history_page() -> str:
    """Every column of the history."""
    table = _core.keys_as_markdown("history").split("\n\n", 1)[1]
    return f"""# Columns of the history

What a run records in time: `ring.csv` beside the frames, `result.history` in Python, and the run
record (`history_columns` has the columns of that run with unit and meaning). `lapilli keys history`
prints the same table. Columns of a physics begin with its name, `heat/surface_area`,
`dynamics/kinetic_energy`; probes and fields have their own names. Forces, energies and areas are
per metre of depth in two dimensions (N/m, J/m, m).

{table}
Obstacles and contacts of `[dynamics]` are recorded by their names: `dynamics/NAME_force_x` (N, per
metre in the plane; on the obstacle), `NAME_torque_z` (N m), `NAME_work` (J), `NAME_contacts`, and
`dynamics/A_on_B_force_x` between bodies.

## Probes

A probe of the scene (`[[probes]]`) is a column of its name, `mid`, or `mid_x` and `mid_xy` for
components, in the unit of its field.
"""
