"""Section 5.4: a cantilever held at an end that is inclined to the grid."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene
from lapilli.reproduce.case import Case, Row, example, quotient_within, within
from lapilli.reproduce.ib.balance import Balance, balance, balances, in_form, section
from lapilli.reproduce.ib.frame import Frame, grid_around, ramp
from lapilli.reproduce.rows import at_least, between, near, rows_of
from lapilli.reproduce.states import changed, order

NAME = "ib/cantilever"
LENGTH, HEIGHT = 0.1, 0.02  # m
SMALL, LARGE = 1e5, 2e8  # N/m^3, body force of the linear problem and of the 20 steps
ANGLES = (5, 15, 30, 45)  # degree, of the linear problem
CELLS = (0.008, 0.004, 0.002, 0.001)  # m
COMPLIANCE = 2.905869e-3  # J/m at SMALL: finite elements at 0.5 and 0.25 mm, extrapolated
BARS = {0.002: 0.016, 0.001: 0.005}
RATE = 1.5
# Error of the compliance by cell (an independent implementation).
REFERENCE = {
    ("mean-gap", 45): (-0.169, -0.049, -0.0141, -0.0041),
    ("mean-gap", 30): (-0.144, -0.045, -0.0114, -0.0033),
    ("mean-gap", 15): (-0.102, -0.027, -0.0079, -0.0024),
    ("mean-gap", 5): (-0.058, -0.020, -0.0056, -0.0017),
    ("pointwise", 45): (-0.25, -0.155, -0.101, -0.042),
    ("nitsche", 45): (-0.159, -0.047, -0.0132, -0.0039),
}
# Deflection (mm) of the free 4 mm at these shares of the load, aligned, by cell.
SHARES = (0.25, 0.5, 1.0)
DEFLECTION = {0.002: (-17.104, -32.919, -56.178), 0.001: (-17.159, -33.065, -56.412)}
TURNED_SHARE = 0.01  # 45 degrees against 90
FINAL = (-56.7, -55.7)  # mm

row = rows_of(NAME)


def beam_frame(degrees: float) -> Frame:
    """Local x from the free end, y from the lower side; the middle of that end at the origin."""
    corner = -0.5 * HEIGHT * Frame(degrees).e2
    return Frame(degrees, (float(corner[0]), float(corner[1])))


def cantilever_scene(
    degrees: float, cell: float, per_axis: int, force: float, steps: int = 1
) -> Scene:
    """The example turned by another angle, on another grid, under another load."""
    scene = changed(example(NAME), f"bodies.0.points_per_cell={per_axis**2}", f"time.steps={steps}")
    frame = beam_frame(degrees)
    corners = np.array(frame.line((0, 0), (LENGTH, 0), (LENGTH, HEIGHT), (0, HEIGHT)))
    room = np.concatenate([corners, corners - (0.11 if steps > 1 else 0.0) * frame.e2])
    scene.grid = grid_around(room, cell, 4.0 if steps > 1 else 1.0)
    scene.bodies[0].shape = frame.box(LENGTH, HEIGHT)
    section(scene).supports[0].line = frame.line((LENGTH, 0), (LENGTH, HEIGHT))
    section(scene).body_force = ramp(-force * frame.e2)
    return scene


@cache
def compliance(form: str, degrees: float, cell: float) -> float:
    """Work of the load on the linear displacement, J/m. The paper's walls are 1e-6 cells stiff; the
    independent implementation's gaps have 0.05 cells."""
    scene = changed(cantilever_scene(degrees, cell, 3, SMALL), "quasi_static.gap_bandwidth=0.05")
    state = balance(in_form(scene, form, 1e-6 if form == "pointwise" else None))
    work = state.displacement @ (-SMALL * Frame(degrees).e2)
    return float(state.volume @ work)


def linear_rows(form: str, degrees: int, cells: Sequence[float]) -> list[Row]:
    """Compliance on several grids, and its rate."""
    rows = []
    found = [compliance(form, degrees, cell) / COMPLIANCE - 1 for cell in cells]
    for k, cell in enumerate(cells):
        reference = REFERENCE[form, degrees][CELLS.index(cell)]
        if form == "mean-gap" and cell in BARS:
            bar = within(found[k], BARS[cell])
        else:
            bar = near(found[k], reference, 0.1 * abs(reference))
        setting = f"linear, {degrees} degrees, {form}, h = {1e3 * cell:g} mm"
        rows.append(row(setting, "error of the compliance", found[k], bar, reference=reference))
        if k and cell == 0.001 and form == "mean-gap":
            rate = order(abs(found[k - 1]), abs(found[k]), 2)
            rows.append(row(setting, "rate", rate, at_least(rate, RATE)))
    return rows


@cache
def bending(degrees: float, cell: float, per_axis: int = 4) -> tuple[Balance, ...]:
    """The 20 load steps of the default mode."""
    return tuple(balances(cantilever_scene(degrees, cell, per_axis, LARGE, 20)))


def deflection(state: Balance, degrees: float) -> float:
    """Mean deflection of the free 4 mm across the beam, mm."""
    free = beam_frame(degrees).local(state.start)[:, 0] < 0.004
    across = state.displacement[free] @ Frame(degrees).e2
    return 1e3 * float(np.average(across, weights=state.volume[free]))


def bending_rows(cell: float) -> list[Row]:
    """Deflection at quarters of the load; 90 degrees against 0 and 45 against 90; the reaction."""
    paths = {
        degrees: [deflection(s, degrees) for s in bending(degrees, cell)] for degrees in (0, 45, 90)
    }
    rows = []
    for share, reference in zip(SHARES, DEFLECTION[cell], strict=True):
        at = round(20 * share) - 1
        flat, turned, upright = (paths[degrees][at] for degrees in (0, 45, 90))
        setting = f"20 steps, h = {1e3 * cell:g} mm, {100 * share:g} % of the load"
        bar = between(flat, *FINAL) if share == 1.0 else quotient_within(flat, reference, 0.005)
        apart = upright / flat - 1
        inclined = turned / upright - 1
        rows += [
            row(setting, "deflection, 0 degrees", flat, bar, unit="mm", reference=reference),
            row(setting, "90 against 0 degrees", apart, within(apart, 1e-10)),
            row(setting, "45 against 90 degrees", inclined, within(inclined, TURNED_SHARE)),
        ]
    weight = LARGE * LENGTH * HEIGHT
    force = float(bending(45, cell)[-1].wall_force("end") @ Frame(45).e2)
    bar = near(force / weight, 1, 1e-6)
    setting = f"20 steps, h = {1e3 * cell:g} mm, 45 degrees"
    return [*rows, row(setting, "force of the wall", force, bar, unit="N/m", reference=weight)]


def run(quick: bool) -> list[Row]:
    """The linear problem at four angles, then 20 load steps at 0, 45 and 90 degrees."""
    cells = CELLS[:3] if quick else CELLS
    forms = [key for key in REFERENCE if not quick or key[1] == 45]
    rows = [r for form, degrees in forms for r in linear_rows(form, degrees, cells)]
    for cell in (0.002,) if quick else (0.002, 0.001):
        rows += bending_rows(cell)
    return rows


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 18, 19 and 21: load against deflection, refinement, and stresses along the beam."""
    from lapilli.reproduce.figures import new_figure, save

    cells = (0.004, 0.002) if quick else (0.004, 0.002, 0.001)
    figure, axes = new_figure(1, 3, width=4.6)
    load = np.linspace(0.05, 1, 20) * 0.2
    for degrees, style in ((0, "-"), (45, "o"), (90, "--")):
        path = [-deflection(s, degrees) for s in bending(degrees, 0.002)]
        axes[0, 0].plot(path, load, style, ms=4, label=f"{degrees} degrees")
    axes[0, 0].set(xlabel="deflection (mm)", ylabel="body force (N/mm³)", title="h = 2 mm")
    for cell in cells:
        path = [-deflection(s, 45) for s in bending(45, cell)]
        axes[0, 1].plot(path, load, label=f"h = {1e3 * cell:g} mm")
    axes[0, 1].set(xlabel="deflection (mm)", title="45 degrees")
    for panel in axes[0, :2]:
        panel.grid(alpha=0.2)
        panel.legend()
    for degrees, offset in ((90, 0.0), (45, 0.05)):
        state, frame = bending(degrees, 0.002)[-1], beam_frame(degrees)
        place = frame.local(state.position)
        stress = state.along(frame.e1, frame.e1) / 1e6
        drawn = axes[0, 2].scatter(
            1e3 * place[:, 0],
            1e3 * (place[:, 1] - offset),
            c=stress,
            s=1,
            vmin=-150,
            vmax=150,
            cmap="RdBu",
        )
    axes[0, 2].set_aspect("equal")
    axes[0, 2].set_title("stress along it (MPa): 90°, below 45°", fontsize=10)
    figure.colorbar(drawn, ax=axes[0, 2])
    return [save(figure, folder / "ib_cantilever.png")]


CASE = Case(name=NAME, title="cantilever held at an inclined end", run=run, plot=plot)
