"""What a study measures errors against."""

from __future__ import annotations

import importlib
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from lapilli._core import Scene, Simulation
from lapilli.frames import Frames
from lapilli.study.settings import Setting, parse_variation

Array = npt.NDArray[Any]
Function = Callable[[Array, float], npt.ArrayLike]

MOST_FAR = 0.1  # of the points, that may lie outside of the points of a reference


class Reference(Protocol):
    """The true values of a field: positions (n, dimension) and a time to values (n,) or (n, k)."""

    def __call__(self, position: Array, time: float, /) -> Array: ...


@dataclass(frozen=True)
class FunctionReference:
    """A callable of positions and time."""

    function: Function

    def __call__(self, position: Array, time: float) -> Array:
        values = np.asarray(self.function(position, time), float)
        return values if values.ndim == 2 else np.broadcast_to(values, len(position))


@dataclass(frozen=True)
class PointsReference:
    """States known at points, at some times; between points a local linear fit."""

    times: Array
    positions: list[Array]
    values: list[Array]

    def __call__(self, position: Array, time: float) -> Array:
        known = int(np.argmin(np.abs(self.times - time)))
        if abs(self.times[known] - time) > 1e-9 * max(abs(time), 1e-300):
            raise ValueError(f"the reference has no state at {time} s; it has {list(self.times)}")
        return interpolate(self.positions[known], self.values[known], position)


def interpolate(known: Array, values: Array, wanted: Array) -> Array:
    """Values at other places: a weighted linear fit to the 3^dimension nearest known points."""
    from scipy.spatial import cKDTree

    dimension = wanted.shape[1]
    known = known[:, :dimension]
    count = min(3**dimension, len(known))
    distances, neighbours = cKDTree(known).query(wanted, k=count)
    distances, neighbours = distances.reshape(-1, count), neighbours.reshape(-1, count)
    far = distances[:, 0] > 3 * np.median(distances[:, -1])
    if far.mean() > MOST_FAR:
        raise ValueError(
            f"{far.mean():.0%} of the points lie outside of the reference: it is of another scene"
        )
    reach = distances[:, -1:] * (1 + 1e-6) + 1e-300
    weights = (1 - (distances / reach) ** 2) ** 2 + 1e-3
    offsets = (known[neighbours] - wanted[:, None, :]) / reach[:, :, None]
    basis = np.concatenate([np.ones((*offsets.shape[:2], 1)), offsets], axis=2)
    normal = np.einsum("nki,nk,nkj->nij", basis, weights, basis)
    normal += 1e-12 * np.eye(dimension + 1)
    right = np.einsum("nki,nk,nk...->ni...", basis, weights, values[neighbours])
    right = right.reshape(len(wanted), dimension + 1, -1)
    fitted: Array = np.linalg.solve(normal, right)[:, 0, :]
    return fitted[:, 0] if values.ndim == 1 else fitted


def from_frames(path: str | os.PathLike[str], field: str) -> PointsReference:
    """The frames of an earlier run."""
    frames = Frames(path)
    return PointsReference(
        frames.times, [frame.position for frame in frames], [frame[field] for frame in frames]
    )


def from_finer_run(scene: Scene, finer: Setting, field: str, times: Sequence[float]) -> Reference:
    """The same scene, run once with better settings."""
    simulation = Simulation(finer.apply(scene))
    positions, values = [], []
    for time in times:
        simulation.run_until(time)
        own = simulation["body"] < len(scene.bodies)  # and no points of walls
        positions.append(simulation["position"][own])
        values.append(simulation[field][own])
    return PointsReference(np.asarray(times, float), positions, values)


def parse_finer(text: str) -> Setting:
    """The setting of "finer:grid.cell=0.05; time.steps=40"."""
    changes = [parse_variation(change) for change in text.removeprefix("finer:").split(";")]
    return Setting(tuple((path, ",".join(values)) for path, values in changes))


def named_function(text: str) -> FunctionReference:
    """The function of "module:function"."""
    module, _, name = text.partition(":")
    try:
        return FunctionReference(getattr(importlib.import_module(module), name))
    except (ImportError, AttributeError) as error:
        raise ValueError(f"reference {text}: {error}") from error


def reference_of(
    given: str | os.PathLike[str] | Function | Reference,
    scene: Scene,
    field: str,
    times: Sequence[float],
) -> Reference:
    """A reference from what a user may give.

    "radial", "rod" and "slab" are the package's own, set up from the scene; "finer:grid.cell=0.05"
    is a finer run (several changes with "; " between); "name.vtkhdf" the frames of a run;
    "module:function" or a callable maps (positions, time) to values.
    """
    from lapilli.study.shipped import SHIPPED, shipped

    if callable(given):
        return FunctionReference(given)
    text = os.fspath(given)
    if text in SHIPPED:
        truth: Reference = shipped(text, scene)
        return truth
    if text.startswith("finer:"):
        return from_finer_run(scene, parse_finer(text), field, times)
    if Path(text).suffix == ".vtkhdf":
        return from_frames(text, field)
    if ":" in text:
        return named_function(text)
    raise ValueError(
        f"reference {text!r}: expected one of {', '.join(SHIPPED)}, finer:path=value, a .vtkhdf "
        "file or module:function"
    )
