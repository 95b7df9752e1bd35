"""How far a result is from its reference, in several norms."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]

NORMS = {
    "rms": "root mean square over the volume; the largest of all times",
    "max": "largest of any point at any time",
    "mean": "mean size over the volume; the largest of all times",
    "relative": "rms over the spread of the reference (its size where it has none)",
}


def field_errors(
    values: Sequence[Array], truths: Sequence[Array], volumes: Sequence[Array]
) -> dict[str, float]:
    """Errors of a field, one array (points,) or (points, components) for each time."""
    rms, most, mean, spread = [], [], [], []
    for value, truth, volume in zip(values, truths, volumes, strict=True):
        size = sizes(np.asarray(value, float) - truth)
        rms.append(math.sqrt(np.average(size**2, weights=volume)))
        most.append(float(size.max()))
        mean.append(float(np.average(size, weights=volume)))
        spread.append(spread_of(truth, volume))
    return together(rms, most, mean, max(spread))


def scalar_errors(values: Sequence[float], truths: Sequence[float]) -> dict[str, float]:
    """Errors of a scalar, one number for each time; rms and mean are those over the times."""
    size = np.abs(np.asarray(values, float) - np.asarray(truths, float))
    rms = math.sqrt(float(np.mean(size**2)))
    scale = float(np.abs(np.asarray(truths, float)).max())
    return together([rms], [float(size.max())], [float(size.mean())], scale)


def together(
    rms: Sequence[float], most: Sequence[float], mean: Sequence[float], scale: float
) -> dict[str, float]:
    """The norms over all times."""
    relative = max(rms) / scale if scale > 0 else math.nan
    return {"rms": max(rms), "max": max(most), "mean": max(mean), "relative": relative}


def spread_of(truth: Array, volume: Array) -> float:
    """Standard deviation of the reference over the volume; its size where it is even."""
    flat = np.asarray(truth, float)
    centred = sizes(flat - np.average(flat, axis=0, weights=volume))
    spread = math.sqrt(np.average(centred**2, weights=volume))
    size = math.sqrt(np.average(sizes(flat) ** 2, weights=volume))
    return spread if spread > 1e-12 * size else size


def sizes(difference: Array) -> Array:
    """The size of each row."""
    size: Array = np.abs(difference) if difference.ndim == 1 else np.linalg.norm(difference, axis=1)
    return size
