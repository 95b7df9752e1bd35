"""One self-contained page: what was modelled, pictures, histories, balances, settings, cost."""

from __future__ import annotations

import html
import json
import os
from collections.abc import Sequence
from pathlib import Path

from lapilli.frames import Frames
from lapilli.html import details, table
from lapilli.own_output import require_own_page
from lapilli.plot.style import Style
from lapilli.report.content import (
    balance_rows,
    charts,
    cost_rows,
    models,
    status_line,
    warnings_of,
)
from lapilli.report.images import stepped_pictures
from lapilli.whole_file import write_text

FOLDER = Path(__file__).parent


def write_report(
    source: str | os.PathLike[str] | Frames,
    save: str | os.PathLike[str] | None = None,
    fields: Sequence[str] | None = None,
    pictures: int = 30,
    style: Style | None = None,
) -> Path:
    """Write the report of a run to `save` (beside the frames, as .html, unless given).

    Parameters
    ----------
    source
        The frames, with the run record beside them.
    save
        The page; a file at the default name that no report wrote is refused (ValueError).
    fields
        What is drawn; up to three usual fields unless given.
    pictures
        The largest number of frames drawn of each field, spread evenly in time.
    """
    frames = source if isinstance(source, Frames) else Frames(source)
    if frames.record is None:
        raise ValueError(f"{frames.record_path} is missing: a report is made from the run record")
    target = Path(save) if save is not None else frames.path.with_suffix(".html")
    if save is None:
        require_own_page(target)
    write_text(target, page(frames, fields, pictures, style or Style()))
    return target


def page(frames: Frames, fields: Sequence[str] | None, pictures: int, style: Style) -> str:
    """The text of the page."""
    record = frames.record
    assert record is not None
    title = record["settings"].get("title") or frames.path.stem
    data = {
        "pictures": stepped_pictures(frames, fields, pictures, style),
        "charts": charts(record),
    }
    body = "".join(
        [
            f"<h1>{html.escape(title)}</h1>",
            f'<p class="status">{html.escape(status_line(record))}</p>',
            warnings_of(record),
            section("What was modelled", models(record)),
            section("Pictures", '<div id="pictures"></div>') if data["pictures"] else "",
            section(
                "In time",
                '<p class="hint">Drag across a chart to zoom, double-click to see all; '
                "click a name to hide its curve.</p>"
                '<div id="charts"></div>',
            ),
            section("Balances", balance_rows(record)),
            section("Cost", table(("", ""), cost_rows(record))),
            section("Settings", details("The scene with all defaults", record["scene"])),
        ]
    )
    written = (FOLDER / "page.html").read_text()
    parts = {
        "TITLE": html.escape(title),
        "STYLE": (FOLDER / "page.css").read_text(),
        "SCRIPT": (FOLDER / "page.js").read_text(),
        "DATA": json.dumps(data).replace("</", "<\\/"),
        "BODY": body,
    }
    for name, text in parts.items():
        written = written.replace(f"@{name}@", text)
    return written


def section(title: str, content: str) -> str:
    """A part of the page with a heading."""
    return f"<section><h2>{html.escape(title)}</h2>{content}</section>" if content else ""
