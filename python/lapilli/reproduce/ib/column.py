"""A turned column under its own weight: the convergence test that a patch test cannot be."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene
from lapilli.references.elastic import Elastic, SelfWeightColumn
from lapilli.reproduce.case import Case, Row, example
from lapilli.reproduce.ib.balance import balance, in_form, section
from lapilli.reproduce.ib.frame import Frame, grid_around, ramp
from lapilli.reproduce.rows import at_least, rows_of
from lapilli.reproduce.states import order

NAME = "ib/column"
SIZE = 0.1  # m
WEIGHT = 1e6  # N/m^3
CELLS = (0.02, 0.01, 0.005, 0.0025)  # m
ANGLES = (0, 20, 45)  # degree
COLUMN = SelfWeightColumn(height=SIZE, weight=WEIGHT, material=Elastic(young=1e9, poisson=0.3))
# Relative L2 errors of displacement and stress by cell of an independent implementation.
REFERENCE = {
    ("mean-gap", 0): ((9.3e-3, 8.8e-2), (2.4e-3, 4.6e-2), (6.2e-4, 2.3e-2), (1.6e-4, 1.2e-2)),
    ("mean-gap", 20): ((8.2e-3, 7.3e-2), (2.1e-3, 3.8e-2), (5.2e-4, 1.9e-2), (1.3e-4, 9.7e-3)),
    ("mean-gap", 45): ((3.9e-3, 4.2e-2), (9.6e-4, 2.2e-2), (2.4e-4, 1.1e-2), (5.9e-5, 5.8e-3)),
    ("pointwise", 45): ((6.0e-3, 5.6e-2), (1.3e-3, 2.6e-2), (2.9e-4, 1.2e-2), (6.5e-5, 6.1e-3)),
}
RATES = (1.9, 0.9)  # of displacement and stress, from 10 mm down

row = rows_of(NAME)


def column_scene(degrees: float, cell: float) -> Scene:
    """The example turned by another angle, on another grid, its corner at (0.13, 0.29) cells."""
    scene = example(NAME)
    frame = Frame(degrees, (0.13 * cell, 0.29 * cell))
    scene.grid = grid_around(frame.line((0, 0), (SIZE, 0), (SIZE, SIZE), (0, SIZE)), cell)
    scene.bodies[0].shape = frame.box(SIZE, SIZE)
    section(scene).body_force = ramp(-WEIGHT * frame.e2)
    section(scene).supports = [
        frame.roller("left", (0, 0), (1, 0)),
        frame.roller("right", (SIZE, 0), (-1, 0)),
        frame.roller("base", (0, 0), (0, 1)),
    ]
    return scene


@cache
def errors(form: str, degrees: float, cell: float) -> tuple[float, float]:
    """Relative L2 errors of displacement and of the stress along gravity. Stiff pointwise walls are
    those of the paper, 1e-6 cells."""
    scene = in_form(column_scene(degrees, cell), form, 1e-6 if form == "pointwise" else None)
    state = balance(scene)
    frame = Frame(degrees, (0.13 * cell, 0.29 * cell))
    y = frame.local(state.start)[:, 1]
    there = COLUMN.displacement(y)[:, None] * frame.e2
    stress = COLUMN.vertical_stress(y)
    found = state.along(frame.e2, frame.e2)
    return (
        np.sqrt(
            state.mean(((state.displacement - there) ** 2).sum(axis=1))
            / state.mean((there**2).sum(axis=1))
        ),
        np.sqrt(state.mean((found - stress) ** 2) / state.mean(stress**2)),
    )


def run(quick: bool) -> list[Row]:
    """Errors and rates at three angles; the paper's pointwise walls at 45 degrees."""
    cells = CELLS[:3] if quick else CELLS
    return [r for form, degrees in REFERENCE for r in rate_rows(form, degrees, cells)]


def rate_rows(form: str, degrees: int, cells: tuple[float, ...]) -> list[Row]:
    """The errors of the cells, and the rates between neighbours from 10 mm down."""
    rows = []
    found = [errors(form, degrees, cell) for cell in cells]
    for which, name in enumerate(("displacement", "stress")):
        for k, cell in enumerate(cells):
            reference = REFERENCE[form, degrees][k][which]
            value = found[k][which]
            bar = f"<= 1.05 x {reference:g}", bool(value <= 1.05 * reference)
            setting = f"{degrees} degrees, {form}, h = {1e3 * cell:g} mm"
            rows.append(row(setting, f"error of {name} (L2)", value, bar, reference=reference))
            if k >= 2:
                rate = order(found[k - 1][which], value, 2)
                bar = at_least(rate, RATES[which])
                rows.append(row(setting, f"rate of {name}", rate, bar, reference=2 - which))
    return rows


def plot(folder: Path, quick: bool) -> list[Path]:
    """Errors over cell size."""
    from lapilli.reproduce.figures import new_figure, save

    cells = CELLS[:3] if quick else CELLS
    figure, axes = new_figure(1, 2)
    for form, degrees in REFERENCE:
        found = np.array([errors(form, degrees, cell) for cell in cells])
        for which, name in enumerate(("displacement", "stress")):
            panel = axes[0, which]
            panel.loglog(1e3 * np.array(cells), found[:, which], "o-", label=f"{degrees}°, {form}")
            panel.set(xlabel="h (mm)", title=f"L2 error of {name}")
    for panel in axes[0]:
        panel.grid(which="both", alpha=0.2)
        panel.legend(fontsize=8)
    return [save(figure, folder / "ib_column.png")]


CASE = Case(name=NAME, title="turned column under its own weight", run=run, plot=plot)
