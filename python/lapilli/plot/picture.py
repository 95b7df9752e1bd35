"""Pictures of single frames, of one run or of several beside each other."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from lapilli.frames import Frame, Frames
from lapilli.plot.canvas import dot_areas, ends_of, panels_for, require_matplotlib
from lapilli.plot.overlays import draw_contours, draw_vectors, place_keys
from lapilli.plot.solids import draw_solids
from lapilli.plot.style import Style
from lapilli.plot.view import NAMES, View, drawn_field, view_of
from lapilli.whole_file import whole_file

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Source = str | os.PathLike[str] | Frames
Limits = tuple[float, float]
LOW = 3.2  # inches: of a figure beside which a long label has no room


def draw(
    source: Source | Sequence[Source],
    field: str | None = None,
    time: float | None = None,
    save: str | os.PathLike[str] | None = None,
    style: Style | None = None,
) -> Figure:
    """A picture of one frame, written to `save`; of several runs beside each other, coloured alike.

    Parameters
    ----------
    field
        "temperature", "velocity.x", "stress.xy", "velocity" (its magnitude).
    time
        The last frame unless given, s; the nearest frame is taken. Times before the first or after
        the last frame are a ``ValueError``.
    style
        Arrows, contours, cuts, colours.
    """
    require_matplotlib()
    import matplotlib.pyplot as plt

    style = style or Style()
    runs = frames_of(source)
    field = drawn_field(runs[0], field)
    shown = [run[-1] if time is None else run.at(time) for run in runs]
    views = [view_of(frame, field, style) for frame in shown]
    figure, axes = panels_for([[view] for view in views])
    paint(figure, axes, shown, views, style, limits_of(views, style))
    if len(runs) > 1:
        for panel, run in zip(axes, runs, strict=True):
            panel.set_title(f"{run.path.stem}, {panel.get_title()}")
    if save is not None:
        with whole_file(save) as written:
            figure.savefig(written, dpi=150)
    plt.close(figure)
    return figure


def frames_of(source: Source | Sequence[Source]) -> list[Frames]:
    """The frames of each run that was named."""
    several: Sequence[Source] = (
        [source] if isinstance(source, (str, os.PathLike, Frames)) else source
    )
    return [one if isinstance(one, Frames) else Frames(one) for one in several]


def limits_of(views: Sequence[View], style: Style) -> Limits:
    """The ends of the colours: those of all values that are shown."""
    if style.limits is not None:
        return style.limits
    low = min(float(np.nanmin(view.values[view.rows])) for view in views)
    high = max(float(np.nanmax(view.values[view.rows])) for view in views)
    return low, high


def scale_of(limits: Limits, style: Style) -> tuple[Limits, str]:
    """Ends and map of the colours: with zero in the middle where values of both signs are large,
    else from dark to light."""
    low, high = limits
    end = max(abs(low), abs(high))
    if style.limits is None and low < -0.1 * end and high > 0.1 * end:
        return (-end, end), style.colours or "coolwarm"
    return limits, style.colours or "inferno"


def paint(
    figure: Figure,
    axes: Sequence[Axes],
    frames: Sequence[Frame],
    views: Sequence[View],
    style: Style,
    limits: Limits,
    held: Sequence[Sequence[View]] | None = None,
) -> list[Any]:
    """One panel for each view, with room for the views of each that are `held`; returns what is
    coloured."""
    if views[0].is_plane:
        limits, colours = scale_of(limits, style)
    else:
        colours = ""
    drawn = [
        draw_view(panel, view, limits, colours) for panel, view in zip(axes, views, strict=True)
    ]
    for panel, frame, view in zip(axes, frames, views, strict=True):
        if view.is_plane and style.contours:
            draw_contours(panel, view, style.contours)
        if view.is_plane and style.vectors:
            draw_vectors(panel, frame, view, style.vectors)
    if views[0].is_plane:
        for panel, room in zip(axes, held or [[view] for view in views], strict=True):
            low, high = ends_of(room)
            panel.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        painted = [draw_solids(panel, frame.frames, frame.time)
                   for panel, frame in zip(axes, frames, strict=True)]  # fmt: skip
        label = views[0].label
        if figure.get_figheight() < LOW:  # room for a word beside the colours
            label = label.replace(", ", ",\n")
        figure.colorbar(drawn[0], ax=list(axes), label=label, shrink=0.9, aspect=30)
    figure.draw_without_rendering()  # lays out the panels, so that metres have a size
    for k, (panel, view, dots) in enumerate(zip(axes, views, drawn, strict=True)):
        if view.is_plane:
            fit_dots(panel, view, dots, painted[k])
            place_keys(panel)
    return drawn


def draw_view(axes: Axes, view: View, limits: Limits, colours: str) -> Any:
    """Points coloured by their values; in one dimension a curve."""
    axes.set_title(view.title, fontsize=10)
    axes.locator_params(axis="x", nbins=6)  # numbers of many digits side by side
    axes.set_xlabel(NAMES[view.axes[0]])
    if not view.is_plane:
        order = view.rows[np.argsort(view.position[view.rows, 0])]
        axes.set_ylabel(view.label)
        room = 0.05 * (limits[1] - limits[0])
        if room > 0:
            axes.set_ylim(limits[0] - room, limits[1] + room)
        axes.grid(alpha=0.3)
        return axes.plot(view.position[order, 0], view.values[order], ".-", markersize=3)[0]
    axes.set_ylabel(NAMES[view.axes[1]])
    first, second = view.axes
    if len(view.walls):
        walls = view.position[view.walls]
        axes.scatter(
            walls[:, first], walls[:, second], c="0.8", marker="s", linewidths=0, zorder=1.2
        )
    dots = axes.scatter(
        view.position[view.rows, first],
        view.position[view.rows, second],
        c=view.values[view.rows],
        vmin=limits[0],
        vmax=limits[1],
        cmap=colours,
        linewidths=0,
        marker="s",
    )
    axes.set_aspect("equal")
    return dots


def fit_dots(axes: Axes, view: View, dots: Any, painted: bool) -> None:
    """Give dots the size of the points' boxes, now that the axes are laid out. Walls that are
    `painted` need no dots, and hide what of those of the fluid reaches into them."""
    # Points of a fluid lie in no rows: wider dots leave no gaps between them.
    wider = 1.12 if not len(view.walls) else 1.8 if painted else 1.5
    dots.set_sizes(dot_areas(axes, view.spacing[view.rows], wider))
    if len(view.walls):
        walls: Any = axes.collections[0]
        walls.set_sizes(dot_areas(axes, view.spacing[view.walls]))
        walls.set_visible(not painted)
