"""Scenes that try implicit boundaries: slivers, thin and wide bands, walls on nodes and faces."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

import lapilli as lp
from lapilli.extremes.steps import Outcome
from lapilli.reproduce.ib.frame import Frame, grid_around, ramp

FORMS = ("mean-gap", "pointwise", "nitsche", "penalty", "literal")
SIDE = 10.0  # cells of 1 m
STRAIN = 0.01
SLIVERS = (1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13)  # cells
BANDWIDTHS = (1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)  # cells
MATERIAL = lp.Elastic(density=1000, youngs_modulus=1e9, poissons_ratio=0.3)
# What a stable error may be: rounding over the bandwidth of the stiff constraint, which small cuts
# enlarge; the penalty form leaves a gap as wide as its bandwidth.
ROUNDING, STRETCH = 1e-13, 3e-15
SLIVER_BAR = 2e-8  # the digits that coordinates lose in a sliver; the paper reaches 2e-8 in shear


@dataclass(frozen=True)
class SupportCase:
    """A square in uniform stress between three rollers, the fourth moved."""

    name: str
    form: str
    scene: lp.Scene
    degrees: float
    corner: tuple[float, float]
    bandwidth: float  # cells


@dataclass(frozen=True)
class SupportRow:
    """What came of one case: mean error of the displacement over the largest one."""

    case: SupportCase
    outcome: Outcome
    error: float | None
    bar: float
    condition: float | None
    reason: str


def support_cases(forms: Sequence[str] = FORMS) -> Iterator[SupportCase]:
    """Every case with every form of the walls."""
    for form in forms:
        for sliver in SLIVERS:
            yield square(f"sliver of {sliver:g} cells", form, 0.0, (1 - sliver, 0.5))
        yield square("walls on faces", form, 0.0, (0.0, 0.0))
        yield square("walls through nodes, 45 degrees", form, 45.0, (0.0, 0.0))
        for angle in (1e-6, 1.0, 30.0):
            yield square(f"turned by {angle:g} degrees", form, angle, (0.3, 0.1))
        for bandwidth in BANDWIDTHS:
            if form not in ("nitsche", "literal"):
                name = f"bandwidth of {bandwidth:g} cells, 30 degrees"
                yield square(name, form, 30.0, (0.3, 0.1), bandwidth)


def square(
    name: str,
    form: str,
    degrees: float,
    corner: tuple[float, float],
    bandwidth: float | None = None,
) -> SupportCase:
    """The square turned about its corner."""
    frame = Frame(degrees, corner)
    walls = [
        frame.roller("left", (0, 0), (1, 0)),
        frame.roller("base", (0, 0), (0, 1)),
        frame.roller("top", (0, SIDE), (0, -1)),
        frame.roller("right", (SIDE, 0), (-1, 0)),
    ]
    walls[-1].displacement = ramp(STRAIN * SIDE * frame.e1)
    body = lp.Body(shape=frame.box(SIDE, SIDE), material=[MATERIAL], points_per_cell=4)
    corners = frame.line((0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE))
    settings = lp.QuasiStatic(supports=walls)
    if bandwidth is not None:
        settings.bandwidth = bandwidth
    scene = lp.Scene(
        grid=grid_around(corners, 1.0),
        bodies=[body],
        quasi_static=settings,
        time=lp.Time(end=1.0, steps=1),
    )
    scene = scene.set(f"quasi_static.enforcement={form}")
    default = 1e-6 if form == "literal" else 1e-3
    return SupportCase(name, form, scene, degrees, corner, bandwidth or default)


def measure_support(case: SupportCase) -> SupportRow:
    """Solve it. What is refused is a result."""
    bar = ROUNDING + STRETCH / case.bandwidth
    if case.form == "penalty":
        bar += 2 * case.bandwidth
    if case.name.startswith("sliver"):
        bar = max(bar, SLIVER_BAR)
    try:
        simulation = lp.Simulation(case.scene)
        start = simulation.by_id("position").copy()
        simulation.step()
    except (ValueError, lp.RunError) as error:
        return SupportRow(case, Outcome.REFUSED, None, bar, None, str(error))
    frame = Frame(case.degrees, case.corner)
    there = STRAIN * frame.local(start)[:, :1] * frame.e1
    apart = np.linalg.norm(simulation.by_id("displacement") - there, axis=1)
    found = float(np.average(apart, weights=simulation.by_id("volume"))) / (STRAIN * SIDE)
    condition = simulation.diagnostics()["quasi_static/condition_estimate"]
    outcome = Outcome.STABLE if found <= bar else Outcome.INACCURATE
    return SupportRow(case, outcome, found, bar, condition, "")


def is_astray(row: SupportRow) -> bool:
    """Whether it is worse than it should be. Nitsche's form is not coercive in slivers, and refused
    there."""
    refusal_is_right = row.case.form == "nitsche" and row.case.name.startswith("sliver")
    return row.outcome is Outcome.INACCURATE or (
        row.outcome is Outcome.REFUSED and not refusal_is_right
    )


def print_supports(rows: Sequence[SupportRow]) -> None:
    """One line a case, one column a form: the error, or that it was refused."""
    found = {(row.case.name, row.case.form): row for row in rows}
    names = list(dict.fromkeys(row.case.name for row in rows))
    forms = list(dict.fromkeys(row.case.form for row in rows))
    width = max(map(len, names), default=0)
    print(f"{'error of the displacement':{width}}  " + " ".join(f"{form:>12}" for form in forms))
    for name in names:
        cells = [_mark(found.get((name, form))) for form in forms]
        print(f"{name:{width}}  " + " ".join(f"{cell:>12}" for cell in cells))
    print("! above its bar, refused: no result")


def _mark(row: SupportRow | None) -> str:
    if row is None:
        return ""
    if row.error is None:
        return "refused"
    return f"{row.error:.1e}" + ("!" if row.outcome is Outcome.INACCURATE else "")
