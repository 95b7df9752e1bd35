"""Run and draw the scenes of the gallery: docs/pictures/gallery/*.png, each below 80 kB.

`python tools/gallery.py [SCENE ...]`: all of tools/manual/gallery.toml unless scenes are named.
"""

from __future__ import annotations

import argparse
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import tomllib
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
ENTRIES = ROOT / "tools" / "manual" / "gallery.toml"
PICTURES = ROOT / "docs" / "pictures" / "gallery"
WIDTH, LARGEST = 640, 80_000  # pixels, bytes


def entries() -> list[dict[str, Any]]:
    """All entries of the gallery."""
    groups = tomllib.loads(ENTRIES.read_text())["groups"]
    return [entry for group in groups for entry in group["entries"]]


def commands(entry: dict[str, Any]) -> list[str]:
    """What a reader types, line by line."""
    if "reproduce" in entry:
        return [entry["reproduce"]]
    folder, name = entry["scene"].split("/")
    changes = "".join(f" --set {shlex.quote(change)}" for change in entry.get("set", []))
    return [
        f"lapilli examples copy {entry['scene']}",
        f"cd {folder}",
        f"lapilli run {name}.toml{changes}",
        f"lapilli plot {name}.vtkhdf {entry['plot']}".rstrip() + f" --save {name}.png",
    ]


def name_of(entry: dict[str, Any]) -> str:
    """The name of an entry: that of its scene, or of the case that draws it."""
    return str(entry.get("name", entry["scene"]))


def picture_of(entry: dict[str, Any]) -> Path:
    """Where the picture of an entry is."""
    return PICTURES / f"{name_of(entry).replace('/', '_')}.png"


def draw(entry: dict[str, Any]) -> None:
    """Run the commands of an entry in a folder of its own and keep the picture, small."""
    program = f'lapilli() {{ {shlex.quote(sys.executable)} -m lapilli "$@"; }}'
    with tempfile.TemporaryDirectory() as folder:
        script = "\n".join(["set -e", program, *commands(entry)])
        subprocess.run(["bash", "-c", script], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        drawn = next(Path(folder).rglob(entry.get("picture", "*.png")))
        shrink(drawn, picture_of(entry), entry.get("width", WIDTH))


def shrink(drawn: Path, kept: Path, width: int) -> None:
    """A picture of the given width with as many colours as its size allows."""
    kept.parent.mkdir(parents=True, exist_ok=True)
    with Image.open(drawn) as image:
        height = round(image.height * width / image.width)
        small = image.convert("RGB").resize((width, height), Image.Resampling.LANCZOS)
    for colours in (128, 64, 32, 16):
        small.quantize(colours, dither=Image.Dither.NONE).save(kept, optimize=True)
        if kept.stat().st_size < LARGEST:
            return
    raise SystemExit(f"{kept} has {kept.stat().st_size} bytes")


def main() -> None:
    """Draw what was asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*")
    wanted = parser.parse_args().scenes
    for entry in entries():
        if not wanted or name_of(entry) in wanted:
            begun = time.monotonic()
            draw(entry)
            size = picture_of(entry).stat().st_size
            print(
                f"{name_of(entry):24} {time.monotonic() - begun:6.1f} s {size / 1e3:6.1f} kB",
                flush=True,
            )


if __name__ == "__main__":
    main()
