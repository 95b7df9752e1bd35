"""lapilli keys"""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from lapilli import _core
from lapilli.commands.codes import FINISHED
from lapilli.commands.options import Json, Quiet, Verbose
from lapilli.console import print_json
from lapilli.note import KINDS, kinds_as_markdown
from lapilli.point_fields import fields_as_markdown


def command(
    section: Annotated[
        str,
        Parameter(
            help="one section (heat, heat.boundaries, shape, annulus); history: what runs record "
            "in time; fields: what frames hold; notes: every note, or the code of one"
        ),
    ] = "",
    /,
    *,
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """List the keys of a scene file: unit, range, default, meaning."""
    del quiet, verbose
    if section in ("fields", "notes", *KINDS):
        text = fields_as_markdown() if section == "fields" else kinds_as_markdown(code_in(section))
    else:
        text = _core.keys_as_markdown(section)
    if json:
        print_json(tables(text))
    else:
        print(text, end="")
    return FINISHED


def code_in(section: str) -> str:
    """The note that is asked for; empty: all."""
    return "" if section == "notes" else section


def tables(markdown: str) -> list[dict[str, str]]:
    """The rows of the tables, each with the section it stands in."""
    rows: list[dict[str, str]] = []
    section, names = "", [""]
    for line in markdown.splitlines():
        cells = [cell.strip().strip("`") for cell in line.strip().strip("|").split("|")]
        if line.startswith("#"):
            section, names = line.strip("#` "), [""]
        elif line.startswith("|") and names == [""]:
            names = cells
        elif line.startswith("|") and set(line) - set("|- :"):
            rows.append({"section": section, **dict(zip(names, cells, strict=False))})
    return rows
