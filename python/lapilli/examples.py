"""The example scenes that come with the package, and the tutorials as notebooks."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from lapilli import notebooks, words
from lapilli._core import Scene

# Beside this file where the package is installed, at the top of the sources otherwise.
FOLDERS = (
    Path(__file__).parent / "example_scenes",
    Path(__file__).resolve().parents[2] / "examples",
)


def folder() -> Path:
    """The folder of the example scenes."""
    for candidate in FOLDERS:
        if candidate.is_dir():
            return candidate
    raise ValueError(f"the example scenes are missing: there is no {FOLDERS[0]}")


def names() -> list[str]:
    """The names of all examples: "vhfm/ring"."""
    root = folder()
    return sorted(str(path.relative_to(root).with_suffix("")) for path in root.rglob("*.toml"))


def path(name: str) -> Path:
    """The scene file of an example."""
    return folder() / f"{chosen([name])[0]}.toml"


def load(name: str) -> Scene:
    """The scene of an example."""
    return Scene.load(path(name))


def title(name: str) -> str:
    """The title of an example."""
    return load(name).title


def chosen(wanted: Sequence[str]) -> list[str]:
    """The examples of these names or groups ("vhfm"); all where none is named."""
    return words.chosen("example", wanted, names())


def copy(wanted: Sequence[str], to: str | os.PathLike[str]) -> list[Path]:
    """Copy examples and the files that they read, and tutorials; nothing is overwritten."""
    root, pages = folder(), notebooks.pages()
    named = words.chosen("example", wanted, [*names(), *pages])
    scenes = [root / f"{name}.toml" for name in named if name not in pages]
    files = dict.fromkeys(scenes)
    for scene in scenes:
        text = scene.read_text()
        beside = (file for file in sorted(scene.parent.iterdir()) if file.suffix != ".toml")
        files.update(dict.fromkeys(file for file in beside if f'"{file.name}"' in text))
    made = {Path(to) / file.relative_to(root): file.read_bytes() for file in files}
    for name in (name for name in named if name in pages):
        made[Path(to) / f"{name}.ipynb"] = notebooks.notebook(pages[name]).encode()
    there = [str(path) for path in made if path.exists()]
    if there:
        raise ValueError(f"{', '.join(there)} is there already: nothing was copied")
    for path, content in made.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return list(made)
