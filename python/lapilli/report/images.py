"""Pictures of the frames of a run, as data that a page can hold."""

from __future__ import annotations

import base64
import io
from collections.abc import Sequence
from typing import Any

import numpy as np

from lapilli.components import parted, require_field
from lapilli.frames import Frames
from lapilli.plot.animation import pictures
from lapilli.plot.canvas import require_matplotlib
from lapilli.plot.style import Style
from lapilli.plot.view import QUIET, drawn_field

MOST_FIELDS = 3


def stepped_pictures(
    frames: Frames, fields: Sequence[str] | None, most: int, style: Style
) -> list[dict[str, Any]]:
    """For each field its name, the times and the pictures (data URLs), at most `most`."""
    if not frames.fields or most < 1:
        return []
    require_matplotlib()
    every = np.linspace(0, len(frames) - 1, min(most, len(frames)))
    numbers = [int(k) for k in np.unique(np.round(every).astype(int))]
    times = [float(frames.times[k]) for k in numbers]
    drawn = []
    for field in usual_fields(frames) if fields is None else fields:
        require_field(field, frames.readable, frames.path)
        images = [as_url(image) for image in pictures([frames], field, style, 110, numbers)]
        drawn.append({"field": field, "times": times, "images": images})
    return drawn


def usual_fields(frames: Frames) -> list[str]:
    """The field that is drawn by itself, and others of which something is to be seen."""
    first = drawn_field(frames, None)
    last = frames[-1]
    body = last["body"] < frames.body_count
    rest = [
        name
        for name in frames.fields
        if name not in (*QUIET, first) and np.ptp(last[parted(name)[0]][body]) > 0
    ]
    return [first, *rest][:MOST_FIELDS]


def as_url(image: Any) -> str:
    """An image as a PNG within a text."""
    from PIL import Image

    made = Image.fromarray(image[..., :3]).quantize(128, method=Image.Quantize.FASTOCTREE)
    buffer = io.BytesIO()
    made.save(buffer, "PNG")
    return "data:image/png;base64," + base64.b64encode(buffer.getvalue()).decode()
