"""Elastic bars that vibrate for a hundred periods: energy is neither lost nor gained."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

import lapilli as lp
from lapilli.extremes.trials.numbers import energy_gained, energy_of, in_spans
from lapilli.extremes.trials.trial import Mark, Trial

# Cell and density are 1 and, but where it is varied, so is Young's modulus.
LENGTH, WIDTH = 10.0, 3.0
PERIODS = {2: 100, 3: 10}
STRAIN = 1e-4
# Of the energy when the load has gone, in all periods; blended_apic is measured at .94 to 1.006.
GAIN_BAR, LOSS_BAR = 0.01, 0.06
POISSON = (0.0, 0.3, 0.45, 0.49, 0.4999, 0.49999)
LAYOUTS: dict[str, dict[str, Any]] = {
    "1 point per cell": {"points_per_cell": 1},
    "25 points per cell": {"points_per_cell": 25},
    "jittered by 0.5": {"jitter": 0.5},
}


def vibration_trials() -> Iterator[Trial]:
    """Bars that stretch along their length."""
    for ratio in POISSON:
        for update in ("musl", "usl"):
            yield bar(f"Poisson {ratio:g}, {update}", ratio, {"stress_update": update})
    for transfer in ("flip", "apic", "tpic"):
        yield bar(transfer, 0.3, {"transfer": transfer})
    for shape in ("linear", "bspline"):
        yield bar(shape, 0.3, shape=shape)
    for name, layout in LAYOUTS.items():
        yield bar(name, 0.3, layout=layout)
    for courant in (0.05, 0.9):
        yield bar(f"courant {courant:g}", 0.3, {"courant": courant})
    for ratio in (0.3, 0.4999):
        yield bar(f"in space, Poisson {ratio:g}", ratio, dim=3)
    yield bar("one cell thin", 0.3, width=1.0)
    for modulus in (1e-6, 1e12):
        yield bar(f"modulus {modulus:g}", 0.3, modulus=modulus)


def bar(
    name: str,
    ratio: float,
    settings: dict[str, Any] | None = None,
    *,
    shape: str = "gimp",
    dim: int = 2,
    width: float = WIDTH,
    modulus: float = 1.0,
    layout: dict[str, Any] | None = None,
) -> Trial:
    """A bar on a smooth wall, off the lattice, that a pulse of weight along it makes swing."""
    speed = float(np.sqrt(modulus if dim == 3 else modulus / (1.0 - ratio**2)))
    period = 4.0 * LENGTH / speed
    lower = (0.0, 4.21, 4.13)[:dim]
    body = lp.Body(
        shape=lp.Box(lower=lower, upper=(LENGTH, *(side + width for side in lower[1:]))),
        material=[lp.Elastic(density=1.0, youngs_modulus=modulus, poissons_ratio=ratio)],
        **(layout or {}),
    )
    pulse = lp.Table(times=[0.0, 0.5 * period, period], values=[0.0, 1.0, 0.0])
    scene = lp.Scene(
        grid=lp.Grid(lower=[0.0] * dim, upper=[14.0, *[12.0] * (dim - 1)], cell=1.0),
        bodies=[body],
        dynamics=lp.Dynamics(
            gravity=(STRAIN * speed**2 / LENGTH, *[0.0] * (dim - 1)),
            gravity_factor=pulse,
            grid_boundaries=[lp.RollerBoundary(face="x_lower")],
        ),
        time=lp.Time(end=(1 + PERIODS[dim]) * period),
    )
    scene = scene.set(f"grid.shape_function={shape}")
    for key, value in (settings or {}).items():
        scene = scene.set(f"dynamics.{key}={value}")
    return Trial("vibration", name, scene, partial(judge_bar, period), ("energy gained",))


def judge_bar(period: float, scene: lp.Scene) -> Sequence[Mark]:
    """What the account of energy leaves over, from when the pulse has gone: strain and velocity are
    half a step apart, so that their sum swings."""
    simulation = lp.Simulation(scene)
    simulation.run_until(period)
    size, start, most = energy_of(simulation), energy_gained(simulation), 0.0
    for _ in in_spans(simulation, 5.3 * period):
        gained = (energy_gained(simulation) - start) / size
        most = max(most, gained)
    return [Mark("energy gained", most, GAIN_BAR), Mark("energy lost", -gained, LOSS_BAR)]
