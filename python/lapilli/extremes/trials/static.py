"""Equilibrium: Poisson's ratio to its end, thin parts, contrasts, any angle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

import lapilli as lp
from lapilli.extremes.trials.trial import Mark, Trial
from lapilli.reproduce.ib.frame import Frame, grid_around, ramp

# Cell and, but where it is varied, Young's modulus are 1; strains are small.
LENGTH = 20.0
STRESS = 1e-4
CORNER = (0.37, 0.21)
BAR = 0.03  # of the displacement of the end


def static_trials() -> Iterator[Trial]:
    """Bars pulled at one end, closed forms."""
    for degrees in (0.0, 22.5, 67.0):
        for ratio in (0.0, 0.3, 0.49, 0.4999, 0.49999):
            yield pulled(degrees, ratio)
        for width in (1.0, 2.0):
            yield pulled(degrees, 0.3, width)
        for contrast in (1e-6, 1e-3, 1e3, 1e6):
            yield pulled(degrees, 0.3, contrast=contrast)
    for layout in ({"points_per_cell": 1}, {"points_per_cell": 16}, {"jitter": 0.5}):
        yield pulled(22.5, 0.3, **layout)
    for modulus in (1e-9, 1e12):
        yield pulled(22.5, 0.3, modulus=modulus)


def pulled(
    degrees: float,
    ratio: float,
    width: float = 4.0,
    contrast: float = 1.0,
    modulus: float = 1.0,
    **layout: Any,
) -> Trial:
    """A bar between a roller and a traction, in halves of different stiffness."""
    frame = Frame(degrees, CORNER)
    half = 0.5 * LENGTH + 0.31
    moduli = [modulus, contrast * modulus]
    ends = [0.0, half, LENGTH] if contrast != 1.0 else [0.0, LENGTH]
    bodies = [
        lp.Body(
            name=f"part{k}",
            shape=_box(frame, ends[k], ends[k + 1], width),
            material=[lp.Elastic(density=1.0, youngs_modulus=moduli[k], poissons_ratio=ratio)],
            **layout,
        )
        for k in range(len(ends) - 1)
    ]
    stress = STRESS * min(moduli)
    pull = lp.SurfaceTraction(
        line=frame.line((LENGTH, 0.0), (LENGTH, width)), traction=ramp(stress * frame.e1)
    )
    supports = [
        frame.roller("left", (0, 0), (1, 0)),
        frame.roller("base", (0, 0), (0, 1)),
    ]
    corners = frame.line((0, 0), (LENGTH, 0), (LENGTH, width), (0, width))
    scene = lp.Scene(
        grid=grid_around(corners, 1.0),
        bodies=bodies,
        quasi_static=lp.QuasiStatic(supports=supports, tractions=[pull]),
        time=lp.Time(end=1.0, steps=1),
    )
    name = f"bar at {degrees:g} degrees, Poisson {ratio:g}, {width:g} cells, x {contrast:g}"
    name += "".join(f", {key} {value:g}" for key, value in layout.items())
    name += f", modulus {modulus:g}" if modulus != 1.0 else ""
    flexible = (1.0 - ratio**2) * stress
    stretch = [flexible / one for one in moduli]
    end = (
        stretch[0] * half + stretch[1] * (LENGTH - half) if contrast != 1.0 else stretch[0] * LENGTH
    )
    return Trial("static", name, scene, partial(judge_bar, frame, end))


def judge_bar(frame: Frame, end: float, scene: lp.Scene) -> Sequence[Mark]:
    """The mean displacement near the end against stress over stiffness, plane strain."""
    simulation = lp.Simulation(scene)
    start = frame.local(simulation.by_id("position"))[:, 0]
    simulation.run_until(scene.time.end)
    moved = simulation.by_id("displacement") @ np.asarray(frame.e1)
    near = start > LENGTH - 2.0
    weight = simulation.by_id("volume")[near]
    # Extrapolated to the end with the stretch of the last part, which is uniform.
    slope = np.polyfit(start[near], moved[near], 1)[0]
    at_end = np.average(moved[near] + slope * (LENGTH - start[near]), weights=weight)
    return [Mark("error of the displacement", abs(float(at_end) / end - 1.0), BAR)]


def _box(frame: Frame, begin: float, end: float, width: float) -> Any:
    return lp.Polygon(vertices=frame.line((begin, 0.0), (end, 0.0), (end, width), (begin, width)))
