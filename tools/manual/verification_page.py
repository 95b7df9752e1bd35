"""A hook of mkdocs: the page `verification.md`, from the rows in docs/verification.json."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from mkdocs.structure.files import File

from lapilli.reproduce import cases
from lapilli.reproduce.case import Row
from lapilli.reproduce.show import text, verdict

DOCS = Path(__file__).resolve().parents[2] / "docs"
ROWS = DOCS / "verification.json"
LEAD = """# Verification

Every case of the three papers that is computed here, number by number: what the paper prints, what
an independent reference says, what lapilli finds, and the bar between them. `make verification`
computes the rows anew, in the small sizes of `lapilli reproduce --quick`; `lapilli reproduce CASE`
does one of them in full. A row without a bar is reported, not judged.

**{kept} of {judged} bars are kept.** {reported} numbers are reported beside them.
"""


def on_files(files: Any, config: Any) -> Any:
    """Add the page to the site."""
    files.append(File.generated(config, "verification.md", content=page(rows_in(ROWS))))
    return files


def rows_in(path: Path) -> list[Row]:
    """The rows that `lapilli reproduce --json` wrote."""
    return [Row(**row) for row in json.loads(path.read_text())]


def page(rows: Sequence[Row]) -> str:
    """The cases, in the order of `lapilli reproduce --list`."""
    verdicts = [verdict(row) for row in rows]
    judged = len(rows) - verdicts.count("reported")
    lead = LEAD.format(
        kept=verdicts.count("ok"), judged=judged, reported=verdicts.count("reported")
    )
    names = list(dict.fromkeys(row.case for row in rows))
    return "\n".join(
        [lead, *(part_of(name, [r for r in rows if r.case == name]) for name in names)]
    )


def part_of(name: str, rows: Sequence[Row]) -> str:
    """One case: title, picture, table."""
    picture = f"pictures/gallery/{name.replace('/', '_')}.png"
    title = cases.load(name).title
    shown = f"![{title}]({picture})\n\n" if (DOCS / picture).exists() else ""
    lines = [
        "| setting | quantity | paper | reference | lapilli | bar | |",
        "|---|---|--:|--:|--:|--:|---|",
        *(line_of(row) for row in rows),
    ]
    return f"## {title}\n\n`lapilli reproduce {name}`\n\n{shown}" + "\n".join(lines) + "\n"


def line_of(row: Row) -> str:
    """A number beside those it is judged by."""
    unit = f" ({row.unit})" if row.unit else ""
    found = [text(one) for one in (row.paper, row.reference, row.lapilli)]
    cells = [row.setting, row.quantity + unit, *found, row.bar, verdict(row)]
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"
