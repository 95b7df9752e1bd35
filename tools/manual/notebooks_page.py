"""A hook of mkdocs: the notebook of every tutorial beside its page, with a link to it."""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import Any

from mkdocs.structure.files import File

from lapilli import notebooks


def on_files(files: Any, config: Any) -> Any:
    """Add the notebooks to the site."""
    for name, page in notebooks.pages().items():
        made = File.generated(config, f"{name}.ipynb", content=notebooks.notebook(page))
        files.append(made)
    return files


def on_page_markdown(text: str, page: Any, **_: Any) -> str:
    """Say below the title of a tutorial how to get it."""
    name = str(PurePosixPath(page.file.src_path).with_suffix(""))
    if name not in notebooks.pages():
        return text
    file = f"{PurePosixPath(name).name}.ipynb"
    title, _, rest = text.partition("\n")
    link = f'[Download this page as a notebook]({file}){{download="{file}"}}'
    return f"{title}\n\n{link}, or `lapilli examples copy {name}`.\n{rest}"
