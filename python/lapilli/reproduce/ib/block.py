"""Section 5.1: a contained block between rollers, turned against the grid."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from lapilli._core import Scene
from lapilli.references.elastic import Elastic, contained_block
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.ib.balance import MODES, Balance, balance, in_form, in_mode, section
from lapilli.reproduce.ib.frame import Frame, grid_around, ramp
from lapilli.reproduce.rows import near, rows_of

NAME = "ib/block"
SIZE = 0.1  # m
PUSH = 1e-3  # m
ANGLES = (0, 30, 45, 90)  # degree
BANDWIDTHS = (1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)  # cells
CELLS = (0.05, 0.025, 0.0125, 0.00625)  # m
MATERIAL = Elastic(young=1e9, poisson=0.3)
# Table 1: mean relative errors of displacement and of the stress along the motion.
PAPER = {
    0: (1.573e-9, 5.804e-9),
    90: (1.573e-9, 5.804e-9),
    45: (2.036e-9, 9.133e-9),
    30: (1.173e-8, 1.299e-8),
}
row = rows_of(NAME)
ALIGNED_BAR, INCLINED_BAR, DEFAULT_BAR = 1e-12, 1e-9, 1e-11


@dataclass(frozen=True)
class Errors:
    """Mean over the volume of the relative errors."""

    displacement: float
    stress: float
    along: float  # Pa, mean stress along the motion
    across: float  # Pa


def block_scene(degrees: float, cell: float = 0.01) -> Scene:
    """The example turned by another angle, on another grid."""
    scene = example(NAME)
    frame = Frame(degrees)
    scene.grid = grid_around(frame.line((0, 0), (SIZE, 0), (SIZE, SIZE), (0, SIZE)), cell)
    scene.bodies[0].shape = frame.box(SIZE, SIZE)
    section(scene).supports = [
        frame.roller("left", (0, 0), (1, 0)),
        frame.roller("base", (0, 0), (0, 1)),
        frame.roller("top", (0, SIZE), (0, -1)),
        frame.roller("right", (SIZE, 0), (-1, 0)),
    ]
    section(scene).supports[-1].displacement = ramp(PUSH * frame.e1)
    return scene


def errors(state: Balance, degrees: float) -> Errors:
    """How far the block is from its uniform stress."""
    frame = Frame(degrees)
    along = contained_block(PUSH, SIZE, MATERIAL)[0]
    there = PUSH * (frame.local(state.start)[:, :1] / SIZE) * frame.e1
    apart = np.linalg.norm(state.displacement - there, axis=1) / np.linalg.norm(there, axis=1)
    found = state.along(frame.e1, frame.e1)
    return Errors(
        state.mean(apart),
        state.mean(np.abs(found / along - 1)),
        state.mean(found),
        state.mean(state.along(frame.e2, frame.e2)),
    )


def solved(scene: Scene, degrees: float) -> Errors:
    """Errors of one scene."""
    return errors(balance(scene), degrees)


def run(quick: bool) -> list[Row]:
    """Angles in both modes, then the convergence in bandwidth and in cell size at 30 degrees."""
    rows = [row for degrees in ANGLES for mode in MODES for row in angle_rows(degrees, mode)]
    if not quick:
        rows += [bandwidth_row(bandwidth) for bandwidth in BANDWIDTHS]
        rows += [cell_row(cell) for cell in CELLS]
    return rows


def angle_rows(degrees: float, mode: str) -> list[Row]:
    """One angle in one mode: the stresses, and their errors beside Table 1."""
    found = solved(in_mode(block_scene(degrees), mode), degrees)
    along, across, _ = contained_block(PUSH, SIZE, MATERIAL)
    aligned = degrees % 90 == 0
    bar = ALIGNED_BAR if aligned else DEFAULT_BAR if mode == "default" else INCLINED_BAR
    setting = f"{degrees:g} degrees, {mode}"
    paper = PAPER[int(degrees)]
    rows = [
        row(
            setting,
            f"stress {name}",
            value / 1e6,
            near(value / exact, 1, 1e-9),
            unit="MPa",
            reference=exact / 1e6,
        )
        for name, exact, value in (("along", along, found.along), ("across", across, found.across))
    ]
    for k, name in enumerate(("displacement", "stress")):
        error = getattr(found, name)
        quantity = f"mean error of {name}"
        rows.append(row(setting, quantity, error, within(error, bar), paper=paper[k]))
    return rows


def bandwidth_row(bandwidth: float) -> Row:
    """Pointwise walls: rounding grows as the wall stiffens, and nothing else does."""
    scene = in_form(block_scene(30), "pointwise", bandwidth)
    bar = 1e-13 + 1e-15 / bandwidth
    found = solved(scene, 30).displacement
    setting = f"30 degrees, pointwise, bandwidth {bandwidth:g} cells"
    return row(setting, "mean error of displacement", found, within(found, bar))


def cell_row(cell: float) -> Row:
    """Default: the exact field is linear, so that no cell size is better than another."""
    found = solved(block_scene(30, cell), 30).displacement
    setting = f"30 degrees, default, h = {1e3 * cell:g} mm"
    return row(setting, "mean error of displacement", found, within(found, DEFAULT_BAR))


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 9 to 13: the displacement, and errors over bandwidth and cell size."""
    from lapilli.reproduce.figures import new_figure, save

    figure, axes = new_figure(1, 3)
    state = balance(block_scene(30))
    drawn = axes[0, 0].scatter(*state.position.T, c=1e3 * state.displacement[:, 0], s=30)
    axes[0, 0].set_aspect("equal")
    axes[0, 0].set_title("30 degrees, default: displacement along x (mm)")
    figure.colorbar(drawn, ax=axes[0, 0])
    bandwidths = BANDWIDTHS[1:5] if quick else BANDWIDTHS
    for form in ("pointwise", "mean-gap", "penalty"):
        found = [
            solved(in_form(block_scene(30), form, width), 30).displacement for width in bandwidths
        ]
        axes[0, 1].loglog(bandwidths, found, "o-", label=form)
    axes[0, 1].set(xlabel="bandwidth (cells)", ylabel="mean error of displacement")
    axes[0, 1].legend()
    cells = CELLS[:2] if quick else CELLS
    for form in ("pointwise", "mean-gap", "penalty"):
        found = [
            solved(in_form(block_scene(90, cell), form, 1e-6), 90).displacement for cell in cells
        ]
        axes[0, 2].loglog(1e3 * np.array(cells), np.maximum(found, 1e-17), "o-", label=form)
    axes[0, 2].set(xlabel="h (mm)", title="90 degrees, bandwidth 1e-6 cells")
    axes[0, 2].legend()
    for panel in axes[0, 1:]:
        panel.grid(which="both", alpha=0.2)
    return [save(figure, folder / "ib_block.png")]


CASE = Case(name=NAME, title="contained block between inclined rollers", run=run, plot=plot)
