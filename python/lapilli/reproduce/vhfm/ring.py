"""Section 4.2: a ring heated on both of its rims."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

import lapilli._core as lp
from lapilli._core import Scene, Simulation
from lapilli.references import thermal
from lapilli.references.radial import RadialProblem, RadialSolution
from lapilli.reproduce.case import Case, Row, example, quotient_within, within
from lapilli.reproduce.rows import Bar, rows_of
from lapilli.reproduce.states import Array, State, changed, rms, states
from lapilli.reproduce.vhfm.lattice_nodes import nodal_values
from lapilli.reproduce.vhfm.literal import literal
from lapilli.reproduce.vhfm.tables import (
    TABLE_3,
    TABLE_3_CELLS,
    TABLE_3_CORRECTED,
    TABLE_3_MISPRINT,
)

NAME = "vhfm/ring"
row = rows_of(NAME)
INNER, OUTER = 1.0, 5.0  # m
LAWS = ("flux", "convection")
FINEST = 0.025  # m, the reference of Table 3

# Largest RMSE (K) of the default settings against the exact field at 1 s, by cell; and that of the
# paper's algorithm in an independent implementation.
BARS = {
    "flux": {0.4: 2.0e-2, 0.2: 3.5e-3, 0.1: 1.4e-3, 0.05: 6.5e-4},
    "convection": {0.4: 8e-3, 0.2: 2.6e-3, 0.1: 1.2e-3, 0.05: 3.2e-4},
}
LITERAL_ERROR = {
    "flux": {0.4: 8.2e-2, 0.2: 3.0e-2, 0.1: 2.0e-2, 0.05: 1.6e-2},
    "convection": {0.4: 3.1e-2, 0.2: 9.6e-3, 0.1: 6.3e-3, 0.05: 4.6e-3},
}
LITERAL_AREA = {  # outer and inner rim, over their length
    0.4: (0.922, 1.367),
    0.2: (0.961, 1.107),
    0.1: (0.974, 1.067),
    0.05: (0.975, 1.020),
}
NORMAL_BARS = {2: 2.2, 4: 1.5}  # degree, by passes of smoothing
SMOOTHED_4_BAR = 3e-4  # K, constant flux, h = 0.05 m, four passes of smoothing


def ring_scene(law: str, cell: float) -> Scene:
    """The example of this law on a grid of this cell."""
    name = "vhfm/ring" + ("_flux" if law == "flux" else "")
    return changed(example(name), f"grid.cell={cell!r}")


@cache
def exact_solution(law: str) -> RadialSolution:
    """The same ring in r alone."""
    rim: thermal.Boundary
    if law == "flux":
        rim = thermal.Flux(inward=1.0)
    else:
        rim = thermal.Convection(coefficient=1.0, ambient=1.0)
    return RadialSolution(
        RadialProblem(inner=INNER, outer=OUTER, dimension=2, at_inner=rim, at_outer=rim)
    )


def radius_of(state: State) -> Array:
    """Distance of the points from the centre."""
    return np.asarray(np.hypot(state.position[:, 0], state.position[:, 1]))


def error_of(law: str, state: State) -> float:
    """RMSE over the points, K."""
    return rms(state.temperature - exact_solution(law).temperature(radius_of(state), state.time))


def default_scene(law: str, cell: float) -> Scene:
    """lapilli's defaults at the paper's step."""
    return changed(ring_scene(law, cell), f"time.step={cell**2 / 10!r}")


@cache
def literal_error(law: str, cell: float) -> float:
    """RMSE of the paper's algorithm at 1 s, K."""
    step = cell**2 / 10
    return error_of(law, next(states(literal(ring_scene(law, cell), step), [1.0], late=step)))


@cache
def default_error(law: str, cell: float, smoothing: int = 2) -> float:
    """RMSE of the defaults at 1 s, K."""
    scene = changed(default_scene(law, cell), f"heat.normal_smoothing={smoothing}")
    return error_of(law, next(states(scene, [1.0])))


def rim_lengths(scene: Scene) -> tuple[float, float]:
    """Area that a unit flux finds on the outer and on the inner rim, over the length of the rim."""
    assert scene.heat is not None
    scene.heat.boundaries = [
        lp.Flux(name="inner", value=1.0, region=lp.Disk(radius=0.5 * (INNER + OUTER))),
        lp.Flux(name="outer", value=1.0),
    ]
    simulation = Simulation(scene)
    simulation.step()
    heat = simulation.balance()[0].entries
    per_length = 1 / (2 * np.pi * simulation.time)
    return heat["outer"] * per_length / OUTER, heat["inner"] * per_length / INNER


def history(law: str, cell: float, times: Array) -> Array:
    """Temperature at r = 3 m, the mean over the circle, K (Fig. 12). On steps chosen by itself."""
    values = []
    for state in states(ring_scene(law, cell), list(times)):
        radius = radius_of(state)
        near = np.abs(radius - 3.0) <= cell
        values.append(np.polyfit(radius[near] - 3.0, state.temperature[near], 2)[-1])
    return np.array(values)


def normal_errors(cell: float, smoothing: int = 2) -> tuple[Array, Array]:
    """Angle of the place and angle between computed and radial normal of each node of the surface,
    degree (Fig. 9)."""
    scene = changed(ring_scene("convection", cell), f"heat.normal_smoothing={smoothing}")
    surface = Simulation(scene).surface()
    place, normal = surface["position"], surface["normal"]
    outward = place / np.linalg.norm(place, axis=1)[:, None]
    outward[np.linalg.norm(place, axis=1) < 0.5 * (INNER + OUTER)] *= -1.0
    cross = outward[:, 0] * normal[:, 1] - outward[:, 1] * normal[:, 0]
    turned = np.degrees(np.arctan2(cross, np.sum(outward * normal, axis=1)))
    return np.degrees(np.arctan2(place[:, 1], place[:, 0])), turned


@cache
def literal_nodes(law: str, cell: float) -> dict[float, dict[tuple[int, int], float]]:
    """Nodal temperatures of the paper's algorithm at 1 and 2.5 s, by multiples of FINEST."""
    step = cell**2 / 10
    scene = literal(ring_scene(law, cell), step)
    return {
        state.time: nodal_values(state.position, state.temperature, cell, FINEST)
        for state in states(scene, list(TABLE_3[law]), late=step)
    }


def run(quick: bool) -> list[Row]:
    """The defaults against the exact solution; without `quick` also h = 0.05 m and Table 3."""
    cells = TABLE_3_CELLS[:3] if quick else TABLE_3_CELLS
    rows = []
    for law in LAWS:
        rows += [literal_row(law, cell) for cell in cells]
        rows += [default_row(law, cell) for cell in cells]
    rows += [row for cell in cells for row in area_rows(cell)]
    rows += [normal_row(smoothing) for smoothing in NORMAL_BARS]
    rows += [history_row(law) for law in LAWS]
    rows += [row for cell in cells for row in literal_area_rows(cell)]
    if quick:
        return rows
    found = default_error("flux", 0.05, 4)
    bar = within(found, SMOOTHED_4_BAR)
    rows.append(error_row("normals smoothed 4 times, flux, h = 0.05 m", found, bar))
    return rows + table_3()


def literal_row(law: str, cell: float) -> Row:
    """The error of the paper's algorithm at 1 s."""
    found, reference = literal_error(law, cell), LITERAL_ERROR[law][cell]
    bar = quotient_within(found, reference, 0.05)
    return error_row(f"literal, {law}, h = {cell:g} m", found, bar, reference)


def default_row(law: str, cell: float) -> Row:
    """The error of the defaults at 1 s."""
    found = default_error(law, cell)
    return error_row(f"default, {law}, h = {cell:g} m", found, within(found, BARS[law][cell]))


def error_row(setting: str, found: float, bar: Bar, reference: float | None = None) -> Row:
    """An error at 1 s. The paper compares with its own finest grid only: see Table 3."""
    return row(
        setting, "RMSE against the exact field at 1 s", found, bar, unit="K", reference=reference
    )


def area_rows(cell: float) -> list[Row]:
    """Lengths of the rims."""
    rows = []
    found = rim_lengths(ring_scene("flux", cell))
    for k, rim in enumerate(("outer", "inner")):
        share = 0.003 if rim == "outer" and cell <= 0.1 else 0.005
        bar = quotient_within(found[k], 1.0, share) if cell <= 0.2 else ("none", True)
        rows.append(rim_row(f"default, h = {cell:g} m", rim, found[k], bar, 1.0))
    return rows


def rim_row(setting: str, rim: str, found: float, bar: Bar, reference: float) -> Row:
    """The length of a rim."""
    quantity = f"length of the {rim} rim over its true length"
    return row(setting, quantity, found, bar, reference=reference)


def literal_area_rows(cell: float) -> list[Row]:
    """What the paper's operator makes of the rims: it loses heat on the outer one."""
    found = rim_lengths(literal(ring_scene("flux", cell), cell**2 / 10))
    rows = []
    for k, rim in enumerate(("outer", "inner")):
        reference = LITERAL_AREA[cell][k]
        bar = quotient_within(found[k], reference, 0.005)
        rows.append(rim_row(f"literal, h = {cell:g} m", rim, found[k], bar, reference))
    return rows


def normal_row(smoothing: int) -> Row:
    """RMSE of the nodal normals. The paper prints the spread of its own as a figure."""
    found = rms(normal_errors(0.1, smoothing)[1])
    return row(
        f"h = 0.1 m, normals smoothed {smoothing} times",
        "RMSE of the normals",
        found,
        within(found, NORMAL_BARS[smoothing]),
        unit="degree",
    )


def history_row(law: str) -> Row:
    """The temperature half way between the rims at 10 s (Fig. 12)."""
    found = float(history(law, 0.1, np.array([10.0]))[0])
    reference = float(exact_solution(law).temperature(3.0, 10.0))
    return row(
        f"default, {law}, h = 0.1 m, automatic step",
        "temperature at r = 3 m, 10 s",
        found,
        quotient_within(found, reference, 0.005),
        unit="K",
        reference=reference,
    )


def table_3() -> list[Row]:
    """Table 3: the paper's algorithm against itself on its finest grid."""
    rows = []
    for law, by_time in TABLE_3.items():
        finest = literal_nodes(law, FINEST)
        for time, printed in by_time.items():
            for cell, value in zip(TABLE_3_CELLS, printed, strict=True):
                coarse = literal_nodes(law, cell)[time]
                shared = coarse.keys() & finest[time].keys()
                found = rms([coarse[node] - finest[time][node] for node in shared])
                misprint = (law, time, cell) == TABLE_3_MISPRINT
                reference = TABLE_3_CORRECTED if misprint else value
                rows.append(
                    row(
                        f"Table 3, {law}, h = {cell:g} m",
                        f"RMSE of the nodes against h = {FINEST:g} m at {time:g} s",
                        found,
                        quotient_within(found, reference, 0.05),
                        unit="K",
                        paper=value,
                        reference=reference,
                    )
                )
    return rows


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figures 9 to 14."""
    from lapilli.reproduce.vhfm.ring_figures import draw

    return draw(folder, quick)


CASE = Case(name=NAME, title="ring heated on both rims", run=run, plot=plot)
