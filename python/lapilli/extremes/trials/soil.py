"""Soil at rest and in impact: stiffness over decades, every strength, points, transfers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

import lapilli as lp
from lapilli.extremes.trials.numbers import (
    energy_gained,
    energy_of,
    in_spans,
    momentum_residual,
)
from lapilli.extremes.trials.trial import Mark, Trial

# Cell, density and weight are 1.
HEIGHT, LENGTH = 8.0, 6.0
SECONDS = 10.0  # of falls through a cell


def soil_trials() -> Iterator[Trial]:
    """Blocks that rest, and blocks that hit the floor."""
    for modulus in (1e2, 1e4, 1e6):
        for ratio in (0.0, 0.3, 0.499):
            yield rest(f"modulus {modulus:g} weights, Poisson {ratio:g}", modulus, ratio)
    for points in (1, 25):
        yield rest(f"{points} points per cell", 1e4, 0.3, points_per_cell=points)
    yield rest("jittered by 0.5", 1e4, 0.3, jitter=0.5)
    for friction in (0.0, 5.0, 30.0, 60.0, 89.0):
        yield impact(f"friction {friction:g}", friction=friction)
    for dilatancy in (15.0, 30.0):
        yield impact(f"dilatancy {dilatancy:g}", friction=30.0, dilatancy=dilatancy)
    for transfer in ("flip", "apic", "tpic"):
        for update in ("usl", "musl"):
            yield impact(f"{transfer}, {update}", {"transfer": transfer, "stress_update": update})
    for shape in ("linear", "bspline"):
        yield impact(shape, shape=shape)
    for points in (1, 4, 25):
        yield impact(f"{points} points per cell", points_per_cell=points)
    yield impact("jittered by 0.5", jitter=0.5)
    yield impact("random", random=True)
    for ratio in (0.49, 0.4999):
        yield impact(f"Poisson {ratio:g}", ratio=ratio)
    for speed in (0.001, 0.3):
        yield impact(f"at {speed:g} of the wave speed", speed=speed)


def rest(name: str, modulus: float, ratio: float, **layout: Any) -> Trial:
    """A block in the stress of its weight, off the lattice sideways, between smooth walls."""
    soil = lp.Elastic(density=1.0, youngs_modulus=modulus * HEIGHT, poissons_ratio=ratio)
    stress = lp.Geostatic(surface=(0.0, HEIGHT), k0=ratio / (1.0 - ratio))
    body = lp.Body(
        shape=lp.Box(lower=(0.0, 0.0), upper=(LENGTH, HEIGHT)),
        material=[soil],
        geostatic=stress,
        **layout,
    )
    walls: list[Any] = [lp.RollerBoundary(face=face) for face in ("y_lower", "x_lower", "x_upper")]
    scene = lp.Scene(
        grid=lp.Grid(lower=(0.0, 0.0), upper=(LENGTH, 12.0), cell=1.0),
        bodies=[body],
        dynamics=lp.Dynamics(gravity=(0.0, -1.0), grid_boundaries=walls),
        time=lp.Time(end=SECONDS),
    )
    return Trial("rest", name, scene, partial(judge_rest, 1.0 / modulus))


def judge_rest(strain: float, scene: lp.Scene) -> Sequence[Mark]:
    """How far it moves, in what its weight would settle it, and in cells."""
    simulation = lp.Simulation(scene)
    start = simulation.by_id("position").copy()
    moved = 0.0
    for _ in in_spans(simulation, 1.0):
        moved = max(moved, float(np.abs(simulation.by_id("position") - start).max()))
    settling = 0.5 * strain * HEIGHT
    return [Mark("motion over the settlement", moved / settling, 0.05)]


def impact(
    name: str,
    settings: dict[str, Any] | None = None,
    *,
    shape: str = "gimp",
    friction: float = 30.0,
    dilatancy: float = 0.0,
    ratio: float = 0.3,
    speed: float = 0.03,
    **layout: Any,
) -> Trial:
    """A block thrown askew onto a rough floor, at a share of the wave speed."""
    modulus = 1e4
    soil = lp.MohrCoulomb(
        density=1.0,
        youngs_modulus=modulus,
        poissons_ratio=ratio,
        friction_angle=friction,
        dilatancy_angle=dilatancy,
        cohesion=2.0,
    )
    fast = speed * np.sqrt(modulus)
    body = lp.Body(
        shape=lp.Box(lower=(4.37, 1.21), upper=(4.37 + LENGTH, 1.21 + HEIGHT)),
        material=[soil],
        velocity=(0.5 * fast, -fast),
        **layout,
    )
    floor = lp.FrictionalBoundary(face="y_lower", coefficient=0.5)
    scene = lp.Scene(
        grid=lp.Grid(lower=(-40.0, 0.0), upper=(80.0, 40.0), cell=1.0),
        bodies=[body],
        dynamics=lp.Dynamics(gravity=(0.0, -1.0), grid_boundaries=[floor], outside="remove"),
        time=lp.Time(end=min(SECONDS, 20.0 / fast + 4.0)),
    ).set(f"grid.shape_function={shape}")
    for key, value in (settings or {}).items():
        scene = scene.set(f"dynamics.{key}={value}")
    return Trial("impact", name, scene, judge_impact, ("energy gained",))


def judge_impact(scene: lp.Scene) -> Sequence[Mark]:
    """Energy that nothing put in, over the largest turnover so far; the balance of momentum."""
    simulation = lp.Simulation(scene)
    largest = gained = 0.0
    for _ in in_spans(simulation, scene.time.end / 50):
        flow = simulation.diagnostics()["dynamics/plastic_dissipation"]
        largest = max(largest, energy_of(simulation) + max(0.0, flow))
        gained = max(gained, energy_gained(simulation))
    return [
        Mark("energy gained", gained / largest, 0.01),
        Mark("momentum", momentum_residual(simulation), 1e-10),
    ]
