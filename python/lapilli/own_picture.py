"""Pictures and pages that take their names from the frames: written over their like only."""

from __future__ import annotations

from pathlib import Path


def require_own_picture(target: Path) -> None:
    """Refuse a name that nobody gave where a picture of another origin lies: that may be the image
    of a scene."""
    if not target.is_file():
        return
    with target.open("rb") as file:
        beginning = file.read(4096)
    if beginning and b"Matplotlib" not in beginning:
        raise ValueError(
            f"{target} is no picture that lapilli drew: it is not overwritten; give another name"
        )
