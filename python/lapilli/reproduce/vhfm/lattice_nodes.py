"""Nodal temperatures from those of the points, as Table 3 compares them."""

from __future__ import annotations

import numpy as np

from lapilli.reproduce.states import Array


def nodal_values(
    position: Array, temperature: Array, cell: float, unit: float
) -> dict[tuple[int, int], float]:
    """The nodes of a plane grid through the origin whose linear interpolation gives the points'
    temperatures, by their place in multiples of `unit`.

    Every active node has a point in a cell beside it, and on a lattice the points determine the
    nodes: a sparse least-squares problem whose residual is rounding.
    """
    from scipy.sparse import csr_matrix
    from scipy.sparse.linalg import spsolve

    where = position / cell
    first = np.floor(where).astype(int)
    share = where - first
    rows, nodes, weights = [], [], []
    for corner in np.ndindex(2, 2):
        side = np.array(corner)
        rows.append(np.arange(len(position)))
        nodes.append(first + side)
        weights.append(np.prod(np.where(side, share, 1 - share), axis=1))
    places, column = np.unique(np.concatenate(nodes), axis=0, return_inverse=True)
    matrix = csr_matrix(
        (np.concatenate(weights), (np.concatenate(rows), column.ravel())),
        shape=(len(position), len(places)),
    )
    normal = (matrix.T @ matrix).tocsc()
    normal.setdiag(normal.diagonal() + 1e-12)
    values = spsolve(normal, matrix.T @ temperature)
    multiple = round(cell / unit)
    return {
        (int(i) * multiple, int(j) * multiple): float(value)
        for (i, j), value in zip(places, values, strict=True)
    }
