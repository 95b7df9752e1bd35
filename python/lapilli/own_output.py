"""Pictures and pages that take their names from the frames: written over their like only."""

from __future__ import annotations

from pathlib import Path

MARK_OF_PAGES = b'<meta name="generator" content="lapilli">'


def require_own_picture(target: Path) -> None:
    """Refuse a name that nobody gave where a picture of another origin lies: that may be the image
    of a scene."""
    _require(target, b"Matplotlib", "no picture that lapilli drew")


def require_own_page(target: Path) -> None:
    """Refuse a name that nobody gave where a page of another origin lies."""
    _require(target, MARK_OF_PAGES, "no page that lapilli wrote")


def _require(target: Path, mark: bytes, said: str) -> None:
    if not target.is_file():
        return
    with target.open("rb") as file:
        beginning = file.read(4096)
    if beginning and mark not in beginning:
        raise ValueError(f"{target} is {said}: it is not overwritten; give another name")
