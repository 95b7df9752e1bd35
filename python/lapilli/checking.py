"""A scene before it is run."""

from __future__ import annotations

import os

from lapilli._core import Scene, check_text


def check(scene: Scene | str | os.PathLike[str]) -> str:
    """What a scene models and what it does not, its points, step, memory, estimated time and notes:
    the text of ``lapilli check``. Nothing is run; mistakes raise ``ValueError``."""
    return check_text(scene if isinstance(scene, Scene) else Scene.load(os.fspath(scene)))
