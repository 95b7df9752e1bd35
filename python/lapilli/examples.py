"""The example scenes that come with the package."""

from __future__ import annotations

import os
import shutil
from collections.abc import Sequence
from pathlib import Path

from lapilli import words
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
    """Copy examples and the files that they read; nothing is overwritten."""
    root, target = folder(), Path(to)
    files = [root / f"{name}.toml" for name in chosen(wanted)]
    for scene in list(files):
        text = scene.read_text()
        beside = (file for file in sorted(scene.parent.iterdir()) if file.suffix != ".toml")
        files += [file for file in beside if f'"{file.name}"' in text and file not in files]
    copied = [target / file.relative_to(root) for file in files]
    there = [str(path) for path in copied if path.exists()]
    if there:
        raise ValueError(f"{', '.join(there)} is there already: nothing was copied")
    for source, copy_of_it in zip(files, copied, strict=True):
        copy_of_it.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, copy_of_it)
    return copied
