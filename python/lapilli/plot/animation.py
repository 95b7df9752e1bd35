"""Animations: one figure, of which only the points change from frame to frame."""

from __future__ import annotations

import contextlib
import os
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from lapilli.extras import required
from lapilli.frames import Frame, Frames
from lapilli.plot.canvas import panels_for, require_matplotlib
from lapilli.plot.picture import (
    Source,
    frames_of,
    limits_of,
    paint,
)
from lapilli.plot.solids import solids_move
from lapilli.plot.style import Style
from lapilli.plot.view import View, drawn_field, view_of
from lapilli.whole_file import whole_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Image = npt.NDArray[np.uint8]
LOOKED_AT = 12  # frames that the range of colours and positions is taken from


def animate(
    source: Source | Sequence[Source],
    save: str | os.PathLike[str],
    field: str | None = None,
    frames_per_second: int = 10,
    style: Style | None = None,
) -> None:
    """All frames of a run, or of several beside each other, as GIF or MP4 by the ending of `save`.

    Several runs are shown at the times of the first. MP4 needs ffmpeg, or the package
    imageio-ffmpeg.
    """
    require_matplotlib()
    style = style or Style()
    runs = frames_of(source)
    field = drawn_field(runs[0], field)
    with whole_file(save) as written, _writer(written, frames_per_second) as write:
        for picture in pictures(runs, field, style):
            write(picture)


def pictures(
    runs: Sequence[Frames],
    field: str,
    style: Style,
    dpi: float = 100,
    numbers: Sequence[int] | None = None,
) -> Iterator[Image]:
    """The pixels (height, width, 4) of each frame, drawn alike: same limits, same axes."""
    import matplotlib.pyplot as plt

    numbers = range(len(runs[0])) if numbers is None else numbers
    every = np.unique(np.linspace(0, len(numbers) - 1, LOOKED_AT).astype(int))
    looked_at = [_views(_at(runs, numbers[k]), field, style) for k in every]
    ends = [limits_of(views, style) for views in looked_at]
    limits = min(low for low, _ in ends), max(high for _, high in ends)
    held = [[views[k] for views in looked_at] for k in range(len(runs))]
    figure, axes = panels_for(held)
    figure.set_dpi(dpi)
    is_moving = bool(style.vectors or style.contours) or not held[0][0].is_plane
    is_moving = is_moving or any(solids_move(run) for run in runs)
    drawn: list[Any] = []
    counts: list[int] = []
    for number in numbers:
        frames = _at(runs, number)
        views = _views(frames, field, style)
        before, counts = counts, [len(view.rows) for view in views]
        if counts != before or is_moving:
            _clear(figure, len(axes))
            figure.set_layout_engine("compressed")
            drawn = paint(figure, axes, frames, views, style, limits, held)
            figure.set_layout_engine("none")
        else:
            _move(axes, views, drawn)
        yield _pixels(figure)
    plt.close(figure)


def _at(runs: Sequence[Frames], number: int) -> list[Frame]:
    time = float(runs[0].times[number])
    others = [run[int(np.argmin(np.abs(run.times - time)))] for run in runs[1:]]
    return [runs[0][number], *others]


def _views(frames: Sequence[Frame], field: str, style: Style) -> list[View]:
    return [view_of(frame, field, style) for frame in frames]


def _clear(figure: Figure, panels: int) -> None:
    for spare in figure.axes[panels:]:  # colour bars
        spare.remove()
    for panel in figure.axes:
        panel.clear()


def _move(axes: Sequence[Any], views: Sequence[View], drawn: Sequence[Any]) -> None:
    for panel, view, dots in zip(axes, views, drawn, strict=True):
        dots.set_offsets(view.shown)
        dots.set_array(view.values[view.rows])
        panel.set_title(view.title, fontsize=10)


def _pixels(figure: Figure) -> Image:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas: Any = FigureCanvasAgg(figure)
    canvas.draw()
    return np.array(canvas.buffer_rgba())


@contextlib.contextmanager
def _writer(path: Path, frames_per_second: int) -> Iterator[Any]:
    ending = path.suffix.lower()
    if ending == ".gif":
        images: list[Any] = []
        yield lambda picture: images.append(_with_palette(picture))
        images[0].save(
            path,
            save_all=True,
            append_images=images[1:],
            loop=0,
            duration=1000 // frames_per_second,
        )
    elif ending in (".mp4", ".webm"):
        with _video(path, frames_per_second) as write:
            yield write
    else:
        raise ValueError(f"an animation is a .gif, .mp4 or .webm, got {path.name}")


def _with_palette(picture: Image) -> Any:
    from PIL import Image as Images

    return Images.fromarray(picture[..., :3]).quantize(255, method=Images.Quantize.FASTOCTREE)


@contextlib.contextmanager
def _video(path: Path, frames_per_second: int) -> Iterator[Any]:
    process: subprocess.Popen[bytes] | None = None

    def write(picture: Image) -> None:
        nonlocal process
        even = picture[: picture.shape[0] // 2 * 2, : picture.shape[1] // 2 * 2]
        if process is None:
            size = f"{even.shape[1]}x{even.shape[0]}"
            read = ["-f", "rawvideo", "-pix_fmt", "rgba", "-s", size, "-r", str(frames_per_second)]
            made = ["-pix_fmt", "yuv420p", "-threads", "1", str(path)]
            command = [_ffmpeg(), "-y", "-loglevel", "error", *read, "-i", "-", *made]
            process = subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE)
        assert process.stdin is not None
        process.stdin.write(even.tobytes())

    yield write
    if process is not None:
        _, said = process.communicate()
        if process.returncode:
            raise ValueError(f"ffmpeg could not write {path.name}: {said.decode()[-300:]}")


def _ffmpeg() -> str:
    found = shutil.which("ffmpeg")
    if found is None:
        found = str(required("imageio_ffmpeg", "a video", "video").get_ffmpeg_exe())
    return found
