"""Section 5.3: simple shear between walls that stand anywhere inside their cells."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from lapilli._core import Box, Scene
from lapilli.references.elastic import Elastic
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.ib.balance import MODES, balance, in_mode, section
from lapilli.reproduce.rows import rows_of

NAME = "ib/shear"
SIZE = 0.1  # m
SHEAR = 0.1  # displacement of the right wall over the width
# Places of the left wall in its cell, mm: slivers of 1e-6 mm on either side included.
PLACES = (0.0, 1e-6, 1e-3, 0.1, 1.0, 2.5, 5.0, 20.0, 50.0, 80.0, 95.0, 99.0, 99.9, 99.999, 100.0)
PAPER = 2e-8  # largest error in Fig. 16
MATERIAL = Elastic(young=1e9, poisson=0.3)

row = rows_of(NAME)


def shear_scene(place: float, per_axis: int = 20) -> Scene:
    """The example with its left wall at another place, mm."""
    scene = example(NAME)
    left, right = 1e-3 * place, 1e-3 * place + SIZE
    scene.bodies[0].shape = Box(lower=[left, 0.0], upper=[right, SIZE])
    scene.bodies[0].points_per_cell = per_axis**2
    lines = (
        [[left, SIZE], [left, 0.0]],
        [[right, 0.0], [right, SIZE]],
        [[left, 0.0], [right, 0.0]],
        [[right, SIZE], [left, SIZE]],
    )
    for wall, line in zip(section(scene).supports, lines, strict=True):
        wall.line = line
    return scene


def error(scene: Scene) -> float:
    """Mean relative error of the shear stress."""
    state = balance(scene)
    return state.mean(np.abs(state.stress[:, 3] / (SHEAR * MATERIAL.shear) - 1))


def place_row(place: float, mode: str) -> Row:
    """One place of the wall in one mode, beside the paper's largest error."""
    found = error(in_mode(shear_scene(place), mode))
    setting = f"wall {place:g} mm inside its cell, {mode}"
    return row(setting, "mean error of the shear stress", found, within(found, PAPER), paper=PAPER)


def run(quick: bool) -> list[Row]:
    """The sweep of Fig. 16 in both modes."""
    places = PLACES[::3] if quick else PLACES
    return [place_row(place, mode) for mode in MODES for place in places]


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figure 16."""
    from lapilli.reproduce.figures import new_figure, save

    places = PLACES[::3] if quick else PLACES
    figure, axes = new_figure(1, 1, width=6)
    panel = axes[0, 0]
    for mode in MODES:
        found = [error(in_mode(shear_scene(place), mode)) for place in places]
        panel.semilogy(places, np.maximum(found, 1e-17), "o-", label=mode)
    panel.axhline(PAPER, color="0.5", ls="--", label="largest in the paper")
    panel.set(xlabel="place of the wall in its cell (mm)", ylabel="error of the shear stress")
    panel.grid(alpha=0.2)
    panel.legend()
    return [save(figure, folder / "ib_shear.png")]


CASE = Case(name=NAME, title="simple shear between walls inside cells", run=run, plot=plot)
