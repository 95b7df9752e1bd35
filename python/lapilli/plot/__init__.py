"""Pictures and animations of runs, with matplotlib."""

from lapilli.plot.animation import animate
from lapilli.plot.canvas import require_matplotlib
from lapilli.plot.curves import draw_history, draw_probe
from lapilli.plot.picture import draw
from lapilli.plot.style import Style
from lapilli.plot.view import drawn_field

__all__ = [
    "Style",
    "animate",
    "draw",
    "draw_history",
    "draw_probe",
    "drawn_field",
    "require_matplotlib",
]
