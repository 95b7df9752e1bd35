"""What several commands share: the scene with its changes, how much is said."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from cyclopts.validators import Number

from lapilli._core import Scene

SceneFile = Annotated[Path, Parameter(help="scene file (TOML)")]
FramesFile = Annotated[Path, Parameter(help="frames (.vtkhdf)")]
Changes = Annotated[
    list[str] | None,
    Parameter(
        name="--set",
        negative=(),
        help="change one member of the scene, PATH=VALUE: grid.cell=0.05; may be repeated",
    ),
]
Json = Annotated[bool, Parameter(negative=(), help="results as JSON on standard output")]


def is_file(_: object, text: str | None) -> None:
    """What follows a word that needs a file is none where it is an option; - is standard output."""
    if text is not None and text.startswith("-") and text != "-":
        raise ValueError(f"a file is needed, not the option {text}")


JsonFile = Annotated[
    str | None,
    Parameter(
        allow_leading_hyphen=True, validator=is_file, help="file for the rows; - prints them alone"
    ),
]
Quiet = Annotated[
    bool, Parameter(name=("--quiet", "-q"), negative=(), help="say nothing but results")
]
Verbose = Annotated[
    bool,
    Parameter(name=("--verbose", "-v"), negative=(), help="say more, and where errors come from"),
]
Count = Annotated[int, Parameter(validator=Number(gte=1, lte=4096))]
Workers = Annotated[Count, Parameter(help="runs at once, each in a process")]
Scheduler = Annotated[
    str | None, Parameter(help="run on a Dask scheduler, tcp://host:8786, instead")
]


def load(path: Path, changes: list[str] | None) -> Scene:
    """The scene of a file with its changes."""
    scene = Scene.load(path)
    for change in changes or ():
        scene = scene.set(change)
    return scene
