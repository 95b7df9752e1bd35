"""The points of one body or wall, taken out of a state."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli._core import Scene

Array = npt.NDArray[Any]


def names_of(scene: Scene) -> list[str]:
    """Names by body number: the bodies of a scene, those that stages add, then its fluid walls."""
    walls = scene.peridynamics.walls if scene.peridynamics is not None else []
    added = [body for stage in scene.stages for body in stage.add_bodies]
    return [body.name for body in [*scene.bodies, *added]] + [wall.name for wall in walls]


class Part:
    """The rows of one body: ``part["temperature"].mean()`` is a mean over that body alone.

    Arrays are copies in the order of the points' ids.
    """

    def __init__(
        self, read: Callable[[str], Array], which: int | str, names: Sequence[str]
    ) -> None:
        self._read = read
        self.number = _number(which, names)
        self.name = names[self.number]
        self.rows: npt.NDArray[np.bool_] = read("body") == self.number

    def __getitem__(self, name: str) -> Array:
        values: Array = self._read(name)[self.rows]
        return values

    def __len__(self) -> int:
        return int(self.rows.sum())

    def __repr__(self) -> str:
        return f"<body {self.name or self.number}, {len(self)} points>"

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Positions, one row per point, m."""
        return self["position"]


def _number(which: int | str, names: Sequence[str]) -> int:
    if isinstance(which, str):
        if names.count(which) != 1:
            found = "several" if which in names else "no"
            listed = ", ".join(f"{k}: {name!r}" for k, name in enumerate(names))
            raise KeyError(f"{found} bodies are called {which!r}; there are {listed}")
        return names.index(which)
    if not 0 <= which < len(names):
        raise KeyError(f"no body {which}; there are {len(names)}, counted from 0, walls last")
    return which
