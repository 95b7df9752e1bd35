"""The value of a field at a position, from the points around it."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]


def fit_at(
    position: Array, volume: Array, body: Array, to: Array
) -> tuple[npt.NDArray[np.intp], Array] | None:
    """Rows and weights of the linear fit at `to` that probes of a run use too; None without
    material there.

    Parameters
    ----------
    position, volume, body
        (n, dimension), (n,), (n,): the points, m, m^dimension.
    to
        (dimension,), m.
    """
    dimension = len(to)
    square = ((position - to) ** 2).sum(axis=1)
    first = int(np.argmin(square))
    spacing = volume[first] ** (1 / dimension)
    if square[first] > (1.2 * spacing) ** 2 * max(1.0, 0.25 * dimension):
        return None
    own = np.flatnonzero(body == body[first])
    near = own[np.argsort(square[own], kind="stable")[: 3**dimension]]
    reach = 1.2 * np.sqrt(square[near[-1]])
    if reach == 0:
        return near, np.full(len(near), 1 / len(near))
    root = 1 - square[near] / reach**2
    basis = root[:, None] * np.column_stack([np.ones(len(near)), (position[near] - to) / reach])
    return near, np.linalg.pinv(basis)[0] * root


def value_at(values: Array, fit: tuple[npt.NDArray[np.intp], Array] | None) -> Array:
    """The components of a field by a fit; NaN without one."""
    rows = values.reshape(len(values), -1)
    if fit is None:
        return np.full(rows.shape[1], np.nan)
    near, weights = fit
    answer: Array = weights @ rows[near]
    return answer
