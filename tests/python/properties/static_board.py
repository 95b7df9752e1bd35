"""Where drawn quasi-static scenes are laid out: a body, its frame, its sides and their loads."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

import lapilli as lp
from lapilli.references.elastic import Elastic
from lapilli.references.plane_patch import solve_patch

Array = npt.NDArray[np.float64]
Field = Callable[[Array], Array]


@dataclass
class Drawn:
    """A scene, its exact or fine displacement at places of the undeformed body, and the load on it
    without the weight (N, per metre of thickness in the plane)."""

    what: str
    scene: lp.Scene
    exact: Field
    load: Array


@dataclass
class Frame:
    """Where a body stands, how large it is and of what."""

    rng: np.random.Generator
    size: float = field(init=False)
    turn: Array = field(init=False)
    by: Array = field(init=False)
    elastic: Elastic = field(init=False)

    def __post_init__(self) -> None:
        rng = self.rng
        self.size = float(rng.choice([1.0, 1e-3, 1e3]) * rng.uniform(0.5, 5))
        angle = rng.choice([rng.uniform(0, 2 * np.pi), rng.choice([0.0, np.pi / 2])], p=[0.8, 0.2])
        self.turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        self.by = rng.uniform(-3, 3, 2) * self.size
        poisson = float(rng.choice([0.0, rng.uniform(0.0, 0.45), 0.3, 0.49, 0.499, 0.4999]))
        self.elastic = Elastic(young=float(10 ** rng.uniform(3, 12)), poisson=poisson)

    @property
    def material(self) -> lp.Elastic:
        return lp.Elastic(
            density=1000.0,
            youngs_modulus=self.elastic.young,
            poissons_ratio=self.elastic.poisson,
        )

    def at(self, places: Any) -> Array:
        """Places of the drawing board (the body is about 1 across) on the grid."""
        there: Array = self.size * np.asarray(places, dtype=float) @ self.turn.T + self.by
        return there

    def back(self, places: Array) -> Array:
        return (places - self.by) @ self.turn / self.size

    def vector(self, along: npt.ArrayLike) -> Array:
        turned: Array = self.turn @ np.asarray(along, dtype=float)
        return turned

    def any_direction(self) -> Array:
        angle = self.rng.uniform(0, 2 * np.pi)
        return np.array([np.cos(angle), np.sin(angle)])


def rows(places: npt.ArrayLike) -> list[list[float]]:
    return [[float(x) for x in place] for place in np.asarray(places)]


def numbers(vector: npt.ArrayLike) -> list[float]:
    return [float(x) for x in np.asarray(vector)]


def scene_of(
    frame: Frame, outline: Array, shape: lp.Shape, settings: lp.QuasiStatic, across: float
) -> lp.Scene:
    """A grid of 6 to 30 cells across the body (`across`, m), anywhere."""
    rng = frame.rng
    cell = across / np.exp(rng.uniform(np.log(6), np.log(30)))
    lower = outline.min(axis=0) - rng.uniform(1, 2, outline.shape[1]) * cell
    upper = lower + cell * np.ceil((outline.max(axis=0) + 1.5 * cell - lower) / cell)
    return lp.Scene(
        grid=lp.Grid(lower=lower, upper=upper, cell=cell),
        bodies=[lp.Body(shape=shape, material=[frame.material])],
        quasi_static=settings,
        time=lp.Time(end=1.0, steps=int(rng.integers(1, 4))),
    )


@dataclass
class Sides:
    """Four sides of a patch: the supports, tractions and loads on them, for both programs."""

    frame: Frame
    place: Callable[[Array, Array], Array]
    surface: dict[str, dict[str, object]]  # by side, as supports and tractions take it
    pieces: int = 4000  # of a side that tell its length
    settings: lp.QuasiStatic = field(default_factory=lp.QuasiStatic)
    given: dict[str, object] = field(default_factory=dict)
    load: Array = field(default_factory=lambda: np.zeros(2))

    def hold(self, side: str, kind: str = "fixed") -> None:
        wall = lp.Support(name=side, kind=kind, **self.surface[side])  # type: ignore[arg-type]
        self.settings.supports = [*self.settings.supports, wall]
        key = "fixed" if kind == "fixed" else "rollers"
        self.given[key] = (*self.given.get(key, ()), side)  # type: ignore[misc]

    def chords(self, side: str) -> Array:
        t = np.linspace(0, 1, self.pieces + 1)
        s, t = {
            "bottom": (t, 0 * t),
            "right": (0 * t + 1, t),
            "top": (1 - t, 0 * t + 1),
            "left": (0 * t, 1 - t),
        }[side]
        return np.diff(self.place(s, t), axis=0)

    def pull(self, side: str, traction: Array) -> None:
        self.settings.tractions = [
            *self.settings.tractions,
            lp.SurfaceTraction(name=side, traction=numbers(traction), **self.surface[side]),  # type: ignore[arg-type]
        ]
        self.given["tractions"] = {side: traction}
        self.load = self.load + traction * np.linalg.norm(self.chords(side), axis=1).sum()

    def press(self, side: str, pressure: float) -> None:
        self.settings.tractions = [
            *self.settings.tractions,
            lp.SurfaceTraction(name=side, pressure=pressure, **self.surface[side]),  # type: ignore[arg-type]
        ]
        self.given["pressures"] = {side: pressure}
        arm = self.chords(side).sum(axis=0)
        self.load = self.load + pressure * np.array([-arm[1], arm[0]])

    def weigh(self, weight: Array) -> None:
        self.settings.body_force = numbers(weight)
        self.given["body_force"] = weight

    def draw_load(self, side: str, kinds: tuple[str, ...] = ("pull", "press", "weight")) -> str:
        frame = self.frame
        size = 1e-5 * frame.elastic.shear
        kind = str(frame.rng.choice(kinds))
        if kind == "pull":
            self.pull(side, size * frame.any_direction())
        elif kind == "press":
            self.press(side, size * float(frame.rng.choice([-1, 1])))
        else:
            self.weigh(size / frame.size * frame.any_direction())
        return kind

    def solve(self, elements: tuple[int, int] = (24, 24)) -> Field:
        return solve_patch(
            lambda s, t: self.place(graded(s), graded(t)),
            material=self.frame.elastic,
            elements=elements,
            **self.given,  # type: ignore[arg-type]
        ).at


def graded(x: Array) -> Array:
    """Finer at both ends, where supports meet free sides; 1/2 stays."""
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * x))
