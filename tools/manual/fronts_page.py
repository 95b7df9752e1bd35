"""A hook of mkdocs: the page `fronts.md`, from docs/fronts.json and the pictures beside it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from mkdocs.structure.files import File

DOCS = Path(__file__).resolve().parents[2] / "docs"
FRONTS = DOCS / "fronts.json"
LEAD = """# Where the defaults lie

Each scene is run with its defaults and with every other setting that `lapilli suggest` tries, on
the same cells. *Over the front* is what the default costs over the cheapest setting of the same
error, between its cells on logarithms; beyond {bar:g} a default would be changed. `make fronts`
measures it anew; for a scene of your own, `lapilli tradeoff` and `lapilli suggest`
([Accuracy, cost and studies](study.md)).

| scene | cell | error | CPU s | over the front | cheapest |
|---|--:|--:|--:|--:|---|
{rows}

Costs are those of one processor ({processor}), building and output included.
"""


def on_files(files: Any, config: Any) -> Any:
    """Add the page to the site."""
    files.append(File.generated(config, "fronts.md", content=page(json.loads(FRONTS.read_text()))))
    return files


def page(measured: dict[str, Any]) -> str:
    """A table of all scenes, then each with its picture and what to choose."""
    rows = "\n".join(
        line_of(one["title"], row) for one in measured["scenes"] for row in one["rows"]
    )
    lead = LEAD.format(bar=measured["bar"], processor=measured["processor"], rows=rows)
    return "\n".join([lead, *map(part_of, measured["scenes"])])


def line_of(title: str, row: dict[str, Any]) -> str:
    """One cell of a scene."""
    best = "the default" if row["best"] == "default" else f"`{row['best']}`"
    return (
        f"| {title} | {row['cell']:.3g} | {row['error']:.2g} | {row['cpu_seconds']:.2g} "
        f"| {row['over_front']:.2f} | {best} |"
    )


def part_of(one: dict[str, Any]) -> str:
    """The picture of a scene, and what to choose."""
    picture = f"![Error against cost: {one['title']}](pictures/fronts/{one['name']}.png)"
    return f"## {one['title']}\n\n{one['choose']}\n\n{picture}\n"
