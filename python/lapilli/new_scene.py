"""Commented scenes to start from, one for each method."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from string import Template

from lapilli.words import meant

TEMPLATES = Path(__file__).parent / "scene_templates"


@dataclass(frozen=True)
class Method:
    """A method with the scene that shows it: size of its body, cells across it, end."""

    title: str
    size: float  # m
    cells: int
    end: float  # s, for that size
    end_power: float  # with which the end grows with the size: 2 for diffusion, 1/2 for gravity


METHODS = {
    "heat": Method("heat in a solid: a disk in hot air", 0.1, 40, 120.0, 2.0),
    "soil": Method("large deformation: a column of sand that collapses", 1.0, 20, 1.0, 0.5),
    "static": Method("equilibrium: a cantilever under a load", 1.0, 80, 1.0, 0.0),
    "flow": Method("buoyant flow: air between a hot and a cold wall", 0.02, 25, 4.0, 2.0),
}


def text(
    method: str,
    file: str,
    size: float | None = None,
    cells: int | None = None,
    end: float | None = None,
) -> str:
    """The scene of a method as TOML.

    `size` (m) is the width of its body and `cells` how many cells lie across it; `end` (s) follows
    the size unless given.
    """
    if method not in METHODS:
        raise ValueError(f"no method {method!r}; {meant(method, METHODS)}")
    chosen = METHODS[method]
    size, cells = chosen.size if size is None else size, chosen.cells if cells is None else cells
    if not (math.isfinite(size) and size > 0):
        raise ValueError(f"the size must be above 0 m, got {size:g}")
    if not 4 <= cells <= 1000:
        raise ValueError(f"the cells across the body must be from 4 to 1000, got {cells}")
    end = chosen.end * (size / chosen.size) ** chosen.end_power if end is None else end
    if not (math.isfinite(end) and end > 0):
        raise ValueError(f"the end must be above 0 s, got {end:g}")
    numbers = {"size": size, "cell": size / cells, "end": end, "every": end / 20}
    numbers |= {name: count * size / cells for name, count in places(method, cells).items()}
    spelt = {name: repr(float(f"{value:.12g}")) for name, value in numbers.items()}
    spelt |= {"modulus": repr(float(f"{1e6 * size:.3g}")), "radius": repr(size / 2)}
    template = Template((TEMPLATES / f"{method}.toml").read_text())
    return template.substitute(spelt, file=on_one_line(file), stem=in_quotes(Path(file).stem))


def on_one_line(name: str) -> str:
    """The name of a file for a comment."""
    return "".join(letter if letter.isprintable() else "?" for letter in name)


def in_quotes(name: str) -> str:
    """A name as it stands between the quotes of TOML."""
    spelt = name.replace("\\", "\\\\").replace('"', '\\"')
    return "".join(one if one.isprintable() else f"\\u{ord(one):04x}" for one in spelt)


def places(method: str, cells: int) -> dict[str, float]:
    """Where things lie, in cells."""
    if method == "heat":
        return {"half": (cells + 1) // 2 + 2}
    if method == "soil":
        return {"right": 4 * cells, "top": cells + 4, "foot": cells - 0.5, "low": 0.5}
    if method == "static":
        high = max(4, round(cells / 5))
        return {"margin": 2, "right": cells + 2, "below": 4, "above": high + 4} | {
            "height": high,
            "middle": high / 2,
        }
    return {"wall": 4, "out": cells + 4}
