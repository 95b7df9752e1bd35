"""A hook of mkdocs: the page `gallery.md`, from tools/manual/gallery.toml."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from mkdocs.structure.files import File

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from gallery import ENTRIES, commands, picture_of, tomllib

sys.path.pop(0)

LEAD = """# Gallery

Each picture is made by the commands below it; `lapilli examples copy` copies the scene with the
files that it reads. Most run for some seconds.
"""


def on_files(files: Any, config: Any) -> Any:
    """Add the page to the site."""
    files.append(File.generated(config, "gallery.md", content=page()))
    return files


def page() -> str:
    """The gallery, group by group."""
    parts = [LEAD]
    for group in tomllib.loads(ENTRIES.read_text())["groups"]:
        parts.append(f"## {group['title']}\n")
        parts += [part_of(entry) for entry in group["entries"]]
    return "\n".join(parts)


def part_of(entry: dict[str, Any]) -> str:
    """One scene: picture, text, commands."""
    shown = "\n".join([*commands(entry), *entry.get("also", [])])
    picture = f"pictures/gallery/{picture_of(entry).name}"
    return (
        f"### {entry['title']}\n\n{entry['text']}\n\n"
        f"![{entry['title']}]({picture})\n\n```sh\n{shown}\n```\n"
    )
