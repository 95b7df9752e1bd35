"""Figures that fit what they show."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from lapilli.extras import required
from lapilli.plot.view import View

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WIDTH, LEAST, MOST = 6.4, 2.4, 7.0  # inches: width of one panel, heights of its drawing
ROOM = 1.1  # inches above and below for title and labels


def require_matplotlib() -> None:
    """Say how to install matplotlib where it is missing; draw without a display."""
    matplotlib = required("matplotlib", "a picture", "plot")
    if not os.environ.get("DISPLAY") and not os.environ.get("MPLBACKEND"):
        matplotlib.use("Agg")


def panels_for(views: Sequence[Sequence[View]]) -> tuple[Figure, list[Axes]]:
    """A figure with a panel for the views (in time) of each run, beside each other, or below each
    other if they are wide."""
    import matplotlib.pyplot as plt

    aspect = max(_aspect(run) for run in views)
    stacked = len(views) > 1 and aspect < 0.45
    width = WIDTH if len(views) == 1 or stacked else 4.6 * min(len(views), 3)
    columns = 1 if stacked else min(len(views), 3)
    rows = -(-len(views) // columns)
    room = 1.4 if len(views) == 1 else 0.9  # inches beside the drawing: colour bar and labels
    height = float(np.clip((width / columns - room) * aspect + ROOM, LEAST, MOST))
    figure, axes = plt.subplots(
        rows, columns, figsize=(width, rows * height), layout="compressed", squeeze=False
    )
    flat = list(axes.flat)
    for spare in flat[len(views) :]:
        spare.remove()
    return figure, flat[: len(views)]


def _aspect(views: Sequence[View]) -> float:
    if not views[0].is_plane:
        return 0.7
    low, high = ends_of(views)
    return float((high[1] - low[1]) / (high[0] - low[0]))


def ends_of(views: Sequence[View]) -> tuple[np.ndarray, np.ndarray]:
    """The lower and upper corner that hold all points of some views, walls included, with a little
    room."""
    low, high = (
        end([end(view.position[view.seen][:, view.axes], axis=0) for view in views], axis=0)
        for end in (np.min, np.max)
    )
    room = max(float(view.spacing.max()) for view in views) + 0.01 * float(np.max(high - low))
    return low - room, high + room


def dot_areas(axes: Axes, spacing: np.ndarray, wider: float = 1.12) -> np.ndarray:
    """Areas of dots (points^2) whose sides are `spacing` (m) as the axes are laid out now."""
    figure = axes.get_figure(root=True)
    assert figure is not None
    ends = axes.transData.transform([(0, 0), (1, 0)])
    side = 72 / figure.dpi * (ends[1, 0] - ends[0, 0]) * wider * spacing
    areas: np.ndarray = np.maximum(side, 0.4) ** 2
    return areas
