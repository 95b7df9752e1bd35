"""The array type of this package, and how positions and times combine in its functions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Times = float | npt.ArrayLike


def as_array(values: npt.ArrayLike) -> Array:
    """Values as an array of doubles (a copy only if needed)."""
    return np.asarray(values, dtype=np.float64)


def at_times(field: Callable[[float], Array], times: Times) -> Array:
    """Evaluate field(t) at one time or at many.

    A scalar time gives the shape S of the field; n times (one-dimensional) give (n, *S).
    Negative times are refused: every reference of this package starts at t = 0.
    """
    given = as_array(times)
    if given.ndim > 1:
        raise ValueError(f"times must be a number or a one-dimensional array, got {given.ndim}D")
    if np.any(given < 0) or not np.all(np.isfinite(given)):
        raise ValueError(f"times must be finite and not negative, got {given}")
    if given.ndim == 0:
        return field(float(given))
    return np.stack([field(float(t)) for t in given])
