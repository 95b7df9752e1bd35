"""Section 4.3: a sphere cooled by convection."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation
from lapilli.references import thermal
from lapilli.references.radial import RadialProblem, RadialSolution
from lapilli.reproduce.case import Case, Row, example, quotient_within, within
from lapilli.reproduce.rows import rows_of
from lapilli.reproduce.states import Array, State, changed, rms, states
from lapilli.reproduce.vhfm.literal import literal

NAME = "vhfm/sphere"
row = rows_of(NAME)
RADIUS = 5.0  # m
STEP = 1e-2  # s
TIMES = (0.5, 1.0, 2.0, 5.0, 10.0)  # s
BARS = (
    0.30,
    0.28,
    0.25,
    0.14,
    0.05,
)  # K, RMSE of the defaults at these times, 8 or 27 points per cell
# RMSE and area over the true one of the paper's algorithm in an independent implementation.
LITERAL_ERRORS = {8: (1.46, 1.83, 2.02, 1.74, 0.88), 27: (1.87, 2.34, 2.59, 2.23, 1.13)}
LITERAL_AREA = {8: 0.912, 27: 0.892}


def sphere_scene(points_per_cell: int, cell: float = 0.2) -> Scene:
    """The example at the paper's step, or at the automatic one on another grid."""
    scene = changed(
        example("vhfm/sphere"), f"grid.cell={cell!r}", f"bodies.0.points_per_cell={points_per_cell}"
    )
    return changed(scene, f"time.step={STEP!r}") if cell == 0.2 else scene


@cache
def exact_solution() -> RadialSolution:
    """The same sphere in r alone."""
    cooled = thermal.Convection(coefficient=1.0, ambient=0.0)
    return RadialSolution(
        RadialProblem(inner=0.0, outer=RADIUS, dimension=3, at_outer=cooled, initial=100.0)
    )


def error_of(state: State) -> float:
    """RMSE over the points, K."""
    radius = np.linalg.norm(state.position, axis=1)
    return rms(state.temperature - exact_solution().temperature(radius, state.time))


def errors(scene: Scene, times: tuple[float, ...]) -> list[float]:
    """RMSE at these times, K."""
    return [error_of(state) for state in states(scene, times)]


def area_share(scene: Scene) -> float:
    """Area of the surface over that of the sphere."""
    area = Simulation(scene).diagnostics()["heat/surface_area"]
    return float(area / (4 * np.pi * RADIUS**2))


def run(quick: bool) -> list[Row]:
    """The defaults with 8 points per cell; without `quick` also 27, later times, and the paper's
    algorithm, which takes minutes."""
    times = TIMES[:2] if quick else TIMES
    rows = [row for ppc in ((8,) if quick else (8, 27)) for row in default_rows(ppc, times)]
    if quick:
        return rows
    return rows + [row for ppc in (8, 27) for row in literal_rows(ppc)]


def default_rows(points_per_cell: int, times: tuple[float, ...]) -> list[Row]:
    """lapilli's defaults against the exact field."""
    scene = sphere_scene(points_per_cell)
    found = errors(scene, times)
    setting = f"default, {points_per_cell} points per cell, h = 0.2 m"
    rows = [
        row(setting, f"RMSE at {time:g} s", found[k], within(found[k], BARS[k]), unit="K")
        for k, time in enumerate(times)
    ]
    return [*rows, area_row(setting, scene, 1.0)]


def literal_rows(points_per_cell: int) -> list[Row]:
    """The paper's algorithm. More points per cell make it worse, which the paper denies.

    Looked at in time: the paper has no table here that could show a late look, and the independent
    implementation has none either. One step of 0.01 s is a fifth of the error at 0.5 s.
    """
    scene = literal(sphere_scene(points_per_cell), STEP)
    setting = f"literal, {points_per_cell} points per cell, h = 0.2 m"
    rows = []
    for k, found in enumerate(errors(scene, TIMES)):
        reference = LITERAL_ERRORS[points_per_cell][k]
        rows.append(
            row(
                setting,
                f"RMSE at {TIMES[k]:g} s",
                found,
                quotient_within(found, reference, 0.01),
                unit="K",
                reference=reference,
            )
        )
    return [*rows, area_row(setting, scene, LITERAL_AREA[points_per_cell])]


def area_row(setting: str, scene: Scene, expected: float) -> Row:
    """How much of the sphere's area the points show."""
    found = area_share(scene)
    return row(
        setting,
        "area of the surface over its true area",
        found,
        quotient_within(found, expected, 0.005),
        reference=expected,
    )


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 16 and 17."""
    from lapilli.reproduce.figures import map_of, new_figure, save

    times = (0.5, 1.0, 2.0) if quick else TIMES
    found = list(states(sphere_scene(8), times))
    figure, axes = new_figure(1, 3, width=3.6)
    for panel, state in zip(
        axes[0], (found[0], found[1], found[-1] if quick else found[3]), strict=True
    ):
        slice_, values = middle_slice(state)
        drawn = map_of(panel, slice_, values, 0.1, levels=8, span=(0, 100))
        panel.set_title(f"z = 0, {state.time:g} s")
    figure.colorbar(drawn, ax=list(axes[0]), shrink=0.8, label="temperature (°C)")
    maps = save(figure, folder / "sphere_maps.png")

    figure, axes = new_figure(1, 1, width=5)
    r = np.linspace(0, RADIUS, 300)
    for state in found:
        radius = np.linalg.norm(state.position, axis=1)[::23]
        axes[0, 0].plot(radius, state.temperature[::23], ".", ms=3, label=f"{state.time:g} s")
        axes[0, 0].plot(r, exact_solution().temperature(r, state.time), "k", lw=1)
    axes[0, 0].set(
        xlabel="r (m)", ylabel="temperature (°C)", title="every 23rd point; lines: exact"
    )
    axes[0, 0].legend(fontsize=8)
    return [maps, save(figure, folder / "sphere_profiles.png")]


def middle_slice(state: State) -> tuple[Array, Array]:
    """The layer of points just above z = 0."""
    layer = (state.position[:, 2] > 0) & (state.position[:, 2] < 0.1)
    return state.position[layer], state.temperature[layer]


CASE = Case(name=NAME, title="sphere cooled by convection", run=run, plot=plot)
