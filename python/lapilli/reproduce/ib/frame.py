"""Geometry of turned scenes: a frame, lines and half-spaces in it, and the grid that holds them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lapilli._core import Grid, HalfSpace, Polygon, Support
from lapilli.reproduce.states import Array

Place = tuple[float, float]


@dataclass(frozen=True)
class Frame:
    """Axes e1, e2 turned by `degrees` counter-clockwise about a corner; exact at quarters.

    Local coordinates (x, y) are along e1 and e2 from `corner`, m.
    """

    degrees: float = 0.0
    corner: Place = (0.0, 0.0)

    @property
    def e1(self) -> Array:
        """First side."""
        angle = math.radians(self.degrees)
        return np.array([_exact(math.cos(angle)), _exact(math.sin(angle))])

    @property
    def e2(self) -> Array:
        """Second side: e1 turned by 90 degrees."""
        return np.array([-self.e1[1], self.e1[0]])

    def at(self, x: float, y: float) -> Array:
        """The place of local coordinates."""
        place: Array = np.asarray(self.corner) + x * self.e1 + y * self.e2
        return place

    def local(self, positions: Array) -> Array:
        """Local coordinates (n, 2) of places (n, 2)."""
        apart = positions - np.asarray(self.corner)
        return np.stack([apart @ self.e1, apart @ self.e2], axis=1)

    def box(self, length: float, height: float) -> Polygon:
        """The rectangle [0, length] x [0, height]."""
        return Polygon(vertices=self.line((0, 0), (length, 0), (length, height), (0, height)))

    def line(self, *places: Place) -> list[list[float]]:
        """Places of local coordinates, as a scene writes them."""
        return [[float(v) for v in self.at(*place)] for place in places]

    def half_space(self, at: Place, into: Place) -> HalfSpace:
        """A solid whose face passes `at`; the material lies on the side `into`."""
        normal = into[0] * self.e1 + into[1] * self.e2
        return HalfSpace(point=list(self.at(*at)), normal=list(normal))

    def roller(self, name: str, at: Place, into: Place) -> Support:
        """A solid that stops motion across its face."""
        return Support(name=name, kind="roller", shape=self.half_space(at, into))


def _exact(value: float) -> float:
    return 0.0 if abs(value) < 1e-15 else value


def ramp(
    vector: Sequence[float] | Array, end: float = 1.0
) -> list[tuple[list[float], list[float]]]:
    """Components that grow from 0 at time 0 to these at `end`."""
    return [([0.0, end], [0.0, float(component)]) for component in vector]


def grid_around(
    places: Sequence[Sequence[float]] | Array, cell: float, margin: float = 1.0
) -> Grid:
    """Linear cells on multiples of `cell` that hold all places and `margin` cells around them."""
    known = np.asarray(places, float)
    lower = cell * (np.floor(known.min(axis=0) / cell + 1e-9) - margin)
    upper = cell * (np.ceil(known.max(axis=0) / cell - 1e-9) + margin)
    return Grid(lower=list(lower), upper=list(upper), cell=cell, shape_function="linear")
