"""Heat at rest: every condition, body, integration and layout, from weak to strong exchange."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

import lapilli as lp
from lapilli.extremes.trials.numbers import balance_of, in_spans
from lapilli.extremes.trials.trial import Mark, Trial
from lapilli.references.radial import RadialProblem, RadialSolution
from lapilli.references.thermal import Convection, Prescribed

# Cell, conductivity, density and heat capacity are 1; bodies lie off the lattice.
RADII = {2: 6.3, 3: 5.2}  # m, of the disk and the ball
CENTER = (0.37, 0.21, 0.13)
FOURIER = 0.2  # at the end
STRAY_BAR = 1e-9  # of the span: rounding, since nodes keep to the range by construction
HEAT_BAR = 0.01  # at 12 cells across; 2 % from Biot 10 on
STEFAN_BOLTZMANN = 5.670374419e-8
INTEGRATIONS: dict[str, dict[str, Any]] = {
    "explicit": {"heat.time_integration": "explicit"},
    "implicit": {"heat.time_integration": "implicit", "time.steps": 50},
    "auto": {},
}
LAYOUTS: dict[str, dict[str, Any]] = {
    "1 point per cell": {"points_per_cell": 1},
    "25 points per cell": {"points_per_cell": 25},
    "jittered by 0.5": {"jitter": 0.5},
    "random": {"random": True},
}


def heat_trials() -> Iterator[Trial]:
    """Disks and balls against series, plates one cell thick, radiation against its equation."""
    for dim in (2, 3):
        for biot in (1e-6, 1.0, 100.0, 1e6, np.inf):
            for how in INTEGRATIONS:
                yield ball(dim, biot, how)
    for name, layout in LAYOUTS.items():
        yield ball(2, np.inf, "auto", name, layout)
    for how in INTEGRATIONS:
        for law in ("prescribed temperature", "convection", "radiation"):
            yield plate(law, how)
        for start, around in ((3.0, 1800.0), (5000.0, 3.0)):
            yield lump(start, around, how)


def ball(
    dim: int, biot: float, how: str, where: str = "", layout: dict[str, Any] | None = None
) -> Trial:
    """A disk or ball at 0 in surroundings at 1."""
    radius = RADII[dim]
    law: lp.Convection | lp.PrescribedTemperature = lp.PrescribedTemperature(value=1.0)
    if np.isfinite(biot):
        law = lp.Convection(coefficient=biot / radius, ambient=1.0)
    shape = (lp.Disk if dim == 2 else lp.Sphere)(center=CENTER[:dim], radius=radius)
    scene = _scene(dim, shape, law, FOURIER * radius**2, how, **(layout or {}))
    kind = "disk" if dim == 2 else "ball"
    name = f"{kind}, {'held' if np.isinf(biot) else f'Biot {biot:g}'}, {where or how}"
    boundary: Convection | Prescribed = Prescribed(temperature=1.0)
    if np.isfinite(biot):
        boundary = Convection(coefficient=biot / radius, ambient=1.0)
    return Trial("heat", name, scene, partial(judge_ball, dim, biot, boundary), ("stray",))


def judge_ball(
    dim: int, biot: float, boundary: Convection | Prescribed, scene: lp.Scene
) -> Sequence[Mark]:
    """The heat taken up against the exact solution, and the range at all times."""
    simulation, stray = watched(scene, 0.0, 1.0)
    problem = RadialProblem(inner=0.0, outer=RADII[dim], dimension=dim, at_outer=boundary)
    exact = float(RadialSolution(problem).heat_content(scene.time.end))
    found = balance_of(simulation, "heat")
    return [
        Mark("stray", stray, STRAY_BAR),
        Mark("error of the heat", abs(found.stored / exact - 1.0), (1 + (biot >= 10)) * HEAT_BAR),
        Mark("balance", abs(found.residual), 1e-9),
    ]


def plate(law: str, how: str) -> Trial:
    """A plate one cell thick, turned by 20 degrees, from 300 K to surroundings at 1800 K."""
    laws = {
        "prescribed temperature": lp.PrescribedTemperature(value=1800.0),
        "convection": lp.Convection(coefficient=10.0, ambient=1800.0),
        "radiation": lp.Radiation(emissivity=1.0, ambient=1800.0),
    }
    shape = lp.Rotated(shape=lp.Box(lower=(-6.0, -0.5), upper=(6.0, 0.5)), degrees=20.0)
    end = 0.05 if law != "radiation" else 0.002
    scene = _scene(2, shape, laws[law], end, how, temperature=300.0)
    return Trial("heat", f"thin plate, {law}, {how}", scene, judge_plate, ("stray",))


def judge_plate(scene: lp.Scene) -> Sequence[Mark]:
    """Temperatures stay between start and surroundings, and heat adds up."""
    simulation, stray = watched(scene, 300.0, 1800.0)
    found = balance_of(simulation, "heat")
    return [Mark("stray", stray, STRAY_BAR), Mark("balance", abs(found.residual), 1e-9)]


def lump(start: float, around: float, how: str) -> Trial:
    """A disk that conducts so well that it has one temperature, and radiates."""
    hottest = max(start, around)
    conductivity = 1e4 * STEFAN_BOLTZMANN * hottest**3 * RADII[2]
    end = 0.5 * RADII[2] / (STEFAN_BOLTZMANN * hottest**3)
    law = lp.Radiation(emissivity=0.9, ambient=around)
    shape = lp.Disk(center=CENTER[:2], radius=RADII[2])
    # Few steps of conduction: a capacity as large makes the exchange as slow.
    scene = _scene(2, shape, law, end, how, temperature=start, conductivity=conductivity)
    if how == "explicit":
        scene.time.end = end / 50
    name = f"radiating disk, {start:g} K in {around:g} K, {how}"
    return Trial("heat", name, scene, partial(judge_lump, start, around), ("stray",))


def judge_lump(start: float, around: float, scene: lp.Scene) -> Sequence[Mark]:
    """The mean temperature against dT/dt = 2 eps sigma (Ta^4 - T^4) / (rho c R)."""
    simulation, stray = watched(scene, min(start, around), max(start, around))
    rate = 2.0 * 0.9 * STEFAN_BOLTZMANN / RADII[2]
    solved = solve_ivp(
        lambda _, t: rate * (around**4 - t**4),
        (0.0, scene.time.end),
        [start],
        rtol=1e-10,
        method="LSODA",
    )
    mean = float(np.average(simulation["temperature"], weights=simulation["volume"]))
    error = abs(mean - solved.y[0, -1]) / abs(start - around)
    return [Mark("stray", stray, STRAY_BAR), Mark("error of the temperature", error, 5e-3)]


def watched(scene: lp.Scene, low: float, high: float) -> tuple[lp.Simulation, float]:
    """Run a scene; how far temperatures were ever beyond a range, over the range."""
    simulation = lp.Simulation(scene)
    stray = 0.0
    for _ in in_spans(simulation, scene.time.end / 40):
        values = simulation["temperature"]
        stray = max(stray, low - values.min(), values.max() - high)
    return simulation, float(stray) / (high - low)


def _scene(
    dim: int,
    shape: Any,
    law: Any,
    end: float,
    how: str,
    *,
    temperature: float = 0.0,
    conductivity: float = 1.0,
    **layout: Any,
) -> lp.Scene:
    reach = 9.0 if dim == 2 else 7.0
    material = lp.Thermal(density=1.0, specific_heat=1.0, conductivity=conductivity)
    scene = lp.Scene(
        grid=lp.Grid(lower=[-reach] * dim, upper=[reach] * dim, cell=1.0),
        bodies=[lp.Body(shape=shape, material=[material], temperature=temperature, **layout)],
        heat=lp.Heat(boundaries=[law]),
        time=lp.Time(end=end),
    )
    for path, value in INTEGRATIONS[how].items():
        scene = scene.set(path, value)
    return scene
