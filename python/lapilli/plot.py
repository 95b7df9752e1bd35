"""Pictures and animations of a run, with matplotlib."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from lapilli.frames import Frame, Frames
from lapilli.whole_file import whole_file

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def require_matplotlib() -> None:
    """Say how to install matplotlib where it is missing; draw without a display."""
    try:
        import matplotlib
    except ImportError as error:
        raise ValueError("pictures need matplotlib: pip install 'lapilli[plot]'") from error
    if not os.environ.get("DISPLAY") and not os.environ.get("MPLBACKEND"):
        matplotlib.use("Agg")


def drawn_field(frames: Frames, wanted: str | None) -> str:
    """The field asked for; if none was, temperature where there is one, else the first field."""
    if not frames.fields:
        raise ValueError(f"{frames.path} holds no fields")
    if wanted is not None:
        if wanted not in frames.fields:
            raise ValueError(
                f"no field {wanted!r} in {frames.path}; there is: {', '.join(frames.fields)}"
            )
        return wanted
    return "temperature" if "temperature" in frames.fields else frames.fields[0]


def scalar(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Vectors and tensors by their size."""
    return values if values.ndim == 1 else np.linalg.norm(values, axis=1)


def draw_frame(
    axes: Axes, frame: Frame, field: str, limits: tuple[float, float] | None = None
) -> Any:
    """Points coloured by a field: along x in one dimension, from the front in three."""
    position, values = frame.position, scalar(frame[field])
    span = np.ptp(position, axis=0)
    axes.set_title(f"{field}, t = {frame.time:.4g} s")
    axes.set_xlabel("x (m)")
    if span[1] == 0:
        order = np.argsort(position[:, 0])
        axes.set_ylabel(field)
        if limits is not None and limits[1] > limits[0]:
            axes.set_ylim(*limits)
        return axes.plot(position[order, 0], values[order], ".-", markersize=3)[0]
    if span[2] > 0:  # look along y at the half behind the middle
        far_first = np.argsort(-position[:, 1], kind="stable")  # the cut is painted last
        shown = far_first[: (len(far_first) + 1) // 2]
        spacing = np.cbrt(np.prod(span) / len(position))
        position, values = position[shown][:, [0, 2]], values[shown]
        axes.set_ylabel("z (m)")
    else:
        axes.set_ylabel("y (m)")
        spacing = np.sqrt(span[0] * span[1] / len(position))
    low, high = limits if limits is not None else (None, None)
    drawn = axes.scatter(
        position[:, 0],
        position[:, 1],
        c=values,
        s=_dot_size(axes, position, spacing),
        vmin=low,
        vmax=high,
        cmap="inferno",
        linewidths=0,
        marker="s",
    )
    axes.set_aspect("equal")
    return drawn


def draw(
    source: str | os.PathLike[str] | Frames,
    field: str | None = None,
    time: float | None = None,
    save: str | os.PathLike[str] | None = None,
) -> Figure:
    """A picture of one frame (the last unless `time` is given); written to `save`."""
    require_matplotlib()
    import matplotlib.pyplot as plt

    frames = source if isinstance(source, Frames) else Frames(source)
    field = drawn_field(frames, field)
    figure, axes = plt.subplots(figsize=(6.4, 5.2), layout="compressed")
    drawn = draw_frame(axes, frames[-1] if time is None else frames.at(time), field)
    if hasattr(drawn, "cmap"):
        figure.colorbar(drawn, ax=axes)
    if save is not None:
        with whole_file(save) as written:
            figure.savefig(written, dpi=150)
    plt.close(figure)
    return figure


def animate(
    source: str | os.PathLike[str] | Frames,
    save: str | os.PathLike[str],
    field: str | None = None,
    frames_per_second: int = 10,
) -> None:
    """All frames as an animation: GIF, or any other kind that matplotlib can write."""
    require_matplotlib()
    import matplotlib.pyplot as plt
    from matplotlib.animation import FuncAnimation, PillowWriter

    save = Path(save)
    frames = source if isinstance(source, Frames) else Frames(source)
    field = drawn_field(frames, field)
    ends = [scalar(frame[field]) for frame in (frames[0], frames[len(frames) // 2], frames[-1])]
    limits = (min(v.min() for v in ends), max(v.max() for v in ends))
    figure, axes = plt.subplots(figsize=(6.4, 5.2), layout="compressed")
    drawn = draw_frame(axes, frames[0], field, limits)
    if hasattr(drawn, "cmap"):
        figure.colorbar(drawn, ax=axes)

    def show(number: int) -> list[Any]:
        axes.clear()
        return [draw_frame(axes, frames[number], field, limits)]

    animation = FuncAnimation(figure, show, frames=len(frames))
    with whole_file(save) as written:
        if save.suffix.lower() == ".gif":
            animation.save(written, writer=PillowWriter(fps=frames_per_second))
        else:
            animation.save(written, fps=frames_per_second)
    plt.close(figure)


def _dot_size(axes: Axes, position: np.ndarray[Any, Any], spacing: float) -> float:
    """Area of a dot (points^2) such that a filled body shows no gaps."""
    span = np.ptp(position[:, :2], axis=0)
    figure = axes.get_figure(root=True)
    assert figure is not None
    width, height = figure.get_size_inches()
    per_metre = 72 * 0.75 * min(width / max(span[0], 1e-300), height / max(span[1], 1e-300))
    return float(np.clip((1.1 * spacing * per_metre) ** 2, 0.3, 400.0))
