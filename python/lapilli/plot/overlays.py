"""Arrows and lines of equal value over the points of a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from lapilli.components import typeset
from lapilli.frames import Frame
from lapilli.plot.view import View

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = npt.NDArray[Any]
ARROWS = 24  # along the longer side
KEY_ABOVE = 0.12  # inches between the frame and the key of arrows


def draw_vectors(axes: Axes, frame: Frame, view: View, field: str) -> Any:
    """Arrows of a vector field at points spread evenly over the picture; the longest is as long as
    the distance between arrows, and a key names its size."""
    if field not in frame.frames.readable:
        raise ValueError(f"no field {field!r} to draw as arrows")
    values = frame[field]
    if values.ndim != 2 or values.shape[1] != 3:
        raise ValueError(f"{field} is no vector field: it has no arrows")
    apart = float(np.ptp(view.shown, axis=0).max()) / ARROWS
    if apart == 0:
        return None
    rows = view.rows[_spread(view.shown, apart)]
    at, arrow = view.position[rows][:, view.axes], values[rows][:, view.axes]
    size = np.linalg.norm(arrow, axis=1)
    longest = float(size.max())
    if longest == 0:
        return None
    at, arrow = at[size > 0.03 * longest], arrow[size > 0.03 * longest]
    drawn = axes.quiver(
        at[:, 0],
        at[:, 1],
        arrow[:, 0],
        arrow[:, 1],
        angles="xy",
        scale_units="xy",
        scale=longest / (1.6 * apart),
        width=0.003,
        color="0.1",
        edgecolor="white",
        linewidth=0.4,
    )
    unit = typeset(frame.frames.unit(field))
    axes.set_title(f"{axes.get_title()}\n", fontsize=10)  # a line for the key
    axes.quiverkey(
        drawn,
        0.04,
        1.03,  # see place_keys
        longest,
        f"{field} {longest:.3g} {unit}",
        labelpos="E",
        coordinates="axes",
    )
    return drawn


def place_keys(axes: Axes) -> None:
    """Put the key of arrows just above the frame, now that the axes are laid out."""
    from matplotlib.quiver import QuiverKey

    figure = axes.get_figure(root=True)
    assert figure is not None
    height = axes.get_window_extent().height / figure.dpi  # inches
    for key in axes.findobj(QuiverKey):
        key.Y = 1 + KEY_ABOVE / height


def _spread(at: Array, apart: float) -> Array:
    """One row for each square of a mesh: the nearest to its middle."""
    square = np.floor((at - at.min(axis=0)) / apart)
    off = np.linalg.norm((at - at.min(axis=0)) / apart - square - 0.5, axis=1)
    order = np.lexsort((off, square[:, 1], square[:, 0]))
    first = np.ones(len(order), bool)
    first[1:] = np.any(np.diff(square[order], axis=0) != 0, axis=1)
    return order[first]


def draw_contours(axes: Axes, view: View, count: int) -> Any:
    """Lines of equal value with their numbers, over the triangles between neighbouring points."""
    from matplotlib.patheffects import withStroke
    from matplotlib.tri import Triangulation

    at, values = view.shown, view.values[view.rows]
    if len(at) < 3 or np.ptp(values) == 0:
        return None
    mesh = Triangulation(at[:, 0], at[:, 1])
    corners = at[mesh.triangles]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    mesh.set_mask(longest > 3 * view.spacing[view.rows].max())
    levels = np.linspace(values.min(), values.max(), count + 2)[1:-1]
    lines = axes.tricontour(mesh, values, levels=levels, colors="0.1", linewidths=0.8)
    halo: list[Any] = [withStroke(linewidth=1.8, foreground="1.0", alpha=0.6)]
    lines.set(path_effects=halo)
    for text in axes.clabel(lines, fontsize=7, fmt="%.3g"):
        text.set_path_effects(halo)
    return lines
