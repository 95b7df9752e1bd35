"""Lame's ring between a widened hole and a round roller: walls that are curved."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Grid, Scene
from lapilli.references.elastic import Annulus, Elastic
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.ib.balance import Balance, balance, in_form, section
from lapilli.reproduce.rows import near, rows_of
from lapilli.reproduce.states import Array

NAME = "ib/annulus"
INNER, OUTER = 0.012, 0.04  # m
WIDENED = 1e-5  # m
TURN = 1e-3  # rad
MATERIAL = Elastic(young=1e9, poisson=0.3)
RING = Annulus.under_displacement(INNER, OUTER, inner_displacement=WIDENED, material=MATERIAL)
BARS = {0.004: 0.03, 0.002: 0.008}
# Energy error by form and cell (an independent implementation).
REFERENCE = {
    "mean-gap": {0.004: 0.020, 0.002: 0.0052},
    "nitsche": {0.004: 0.016, 0.002: 0.0042},
    "pointwise": {0.004: 1.66, 0.002: 0.66},
}
ROTATION_BAR = 1e-7  # MPa

row = rows_of(NAME)


def annulus_scene(cell: float) -> Scene:
    """The example on another grid, its centre (0.37, 0.21) cells off a node."""
    scene = example(NAME)
    reach = (np.ceil(OUTER / cell) + 2) * cell
    lower = np.array([0.37 * cell, 0.21 * cell]) - reach
    scene.grid = Grid(
        lower=list(lower), upper=list(lower + 2 * reach), cell=cell, shape_function="linear"
    )
    return scene


def energy_error(state: Balance) -> float:
    """Strain energy over the exact one at the same points, minus 1."""
    found = energy(*(state.stress[:, k] for k in (0, 1, 3)))
    radius = np.linalg.norm(state.start, axis=1)
    exact = RING.at(radius)
    return state.mean(found) / state.mean(energy(exact.radial, exact.hoop, 0 * radius)) - 1


def energy(sxx: Array, syy: Array, sxy: Array) -> Array:
    """Energy of a plane-strain stress, J/m^3."""
    lame, shear = MATERIAL.lame, MATERIAL.shear
    trace = (sxx + syy) / (2 * (lame + shear))
    exx, eyy = ((s - lame * trace) / (2 * shear) for s in (sxx, syy))
    density: Array = 0.5 * (sxx * exx + syy * eyy + sxy**2 / shear)
    return density


@cache
def widened(form: str, cell: float) -> Balance:
    """The ring with its hole widened; the paper's walls are 1e-6 cells stiff."""
    return balance(in_form(annulus_scene(cell), form, 1e-6 if form == "pointwise" else None))


def energy_row(form: str, cell: float) -> Row:
    """Energy error of one form on one grid."""
    found = energy_error(widened(form, cell))
    reference = REFERENCE[form][cell]
    if form == "mean-gap":
        bar = within(found, BARS[cell])
    else:
        bar = near(found, reference, 0.1 * reference)
    setting = f"hole widened, {form}, h = {1e3 * cell:g} mm"
    return row(setting, "error of the energy", found, bar, reference=reference)


def turned_hole(cell: float) -> Scene:
    """The hole turned rigidly instead of widened, as a function of place."""
    scene = annulus_scene(cell)
    hole = section(scene).supports[0]
    hole.advance = 0.0
    hole.displacement = [
        lambda place, _, time: -TURN * time * place[:, 1],
        lambda place, _, time: TURN * time * place[:, 0],
    ]
    return scene


def rotation_row(cell: float) -> Row:
    """Turning the hole turns the ring, and makes no stress."""
    found = 1e-6 * float(np.abs(balance(turned_hole(cell)).stress).max())
    setting = f"hole turned by {TURN:g} rad, h = {1e3 * cell:g} mm"
    return row(setting, "largest stress", found, within(found, ROTATION_BAR), unit="MPa")


def run(quick: bool) -> list[Row]:
    """Lame's solution with three forms of the walls, and the turned hole."""
    forms = ("mean-gap",) if quick else tuple(REFERENCE)
    rows = [energy_row(form, cell) for form in forms for cell in BARS]
    return rows + [rotation_row(cell) for cell in BARS]


def plot(folder: Path, quick: bool) -> list[Path]:
    """Radial stress in the plane, and over the radius with the exact one."""
    from lapilli.reproduce.figures import new_figure, save

    figure, axes = new_figure(1, 2, width=5)
    state = widened("mean-gap", 0.002)
    radius = np.linalg.norm(state.start, axis=1)
    out = state.start / radius[:, None]
    s = state.stress
    radial = s[:, 0] * out[:, 0] ** 2 + s[:, 1] * out[:, 1] ** 2 + 2 * s[:, 3] * out.prod(axis=1)
    drawn = axes[0, 0].scatter(*state.position.T, c=radial / 1e6, s=1)
    axes[0, 0].set_aspect("equal")
    axes[0, 0].set_title("radial stress (MPa), h = 2 mm")
    figure.colorbar(drawn, ax=axes[0, 0])
    r = np.linspace(INNER, OUTER, 200)
    axes[0, 1].plot(1e3 * radius, radial / 1e6, ".", ms=1, label="points")
    axes[0, 1].plot(1e3 * r, RING.at(r).radial / 1e6, "k", label="Lame")
    axes[0, 1].set(xlabel="radius (mm)", ylabel="radial stress (MPa)")
    axes[0, 1].legend()
    return [save(figure, folder / "ib_annulus.png")]


CASE = Case(name=NAME, title="ring with a widened hole", run=run, plot=plot)
