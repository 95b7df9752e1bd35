"""What the figures of the cases share."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from lapilli.plot import require_matplotlib
from lapilli.reproduce.states import Array
from lapilli.whole_file import whole_file


def new_figure(rows: int, columns: int, width: float = 4.2, height: float = 3.4) -> Any:
    """A figure and its axes (rows, columns)."""
    require_matplotlib()
    import matplotlib.pyplot as plt

    return plt.subplots(
        rows,
        columns,
        figsize=(width * columns, height * rows),
        layout="constrained",
        squeeze=False,
    )


def save(figure: Any, path: Path) -> Path:
    """Write and forget a figure."""
    import matplotlib.pyplot as plt

    with whole_file(path) as written:
        figure.savefig(written, dpi=130)
    plt.close(figure)
    return path


def map_of(
    axes: Any,
    position: Array,
    values: Array,
    spacing: float,
    levels: Any = None,
    span: tuple[float, float] | None = None,
    colors: str = "inferno",
) -> Any:
    """A field of the plane in colours, with isolines; triangles longer than two spacings of the
    points are gaps."""
    from matplotlib.tri import Triangulation

    mesh = Triangulation(position[:, 0], position[:, 1])
    corners = position[mesh.triangles][:, :, :2]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    mesh.set_mask(sides.max(axis=1) > 2.2 * spacing)
    low, high = span if span is not None else (values.min(), values.max())
    drawn = axes.tripcolor(mesh, values, shading="gouraud", cmap=colors, vmin=low, vmax=high)
    if levels is not None:
        axes.tricontour(mesh, values, levels=levels, colors="k", linewidths=0.7)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    return drawn


def convergence(
    axes: Any, cells: Sequence[float], errors: Sequence[float], label: str, style: str = "o-"
) -> None:
    """Errors over 1/h, both logarithmic."""
    axes.loglog(1 / np.asarray(cells), errors, style, label=label)
    _ticks(axes, cells)
    axes.set_xlabel("1/h (1/m)")
    axes.set_ylabel("RMSE (K)")
    axes.grid(which="both", alpha=0.2)


def slope(axes: Any, cells: Sequence[float], at: float, power: int) -> None:
    """A grey line of this order through `at` on the coarsest grid."""
    h = np.asarray(cells)
    axes.loglog(1 / h, at * (h / h[0]) ** power, color="0.7", lw=1, label=f"order {power}")
    _ticks(axes, cells)


def _ticks(axes: Any, cells: Sequence[float]) -> None:
    axes.set_xticks([1 / cell for cell in cells], [f"{1 / cell:g}" for cell in cells])
    axes.set_xticks([], minor=True)
