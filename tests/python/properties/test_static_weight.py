"""Bodies under their own weight in statics: layers of their own densities, any lie, any units."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

WIDTH, LOWER, UPPER = 2.0, 1.1, 0.8  # m, of the column and of the heights of its layers
DENSITIES, MODULUS, G = (2000.0, 1600.0), 5e7, 9.81


def column(ratio: float, degrees: float, unit: float) -> tuple[lp.Simulation, np.ndarray]:
    """Two layers between smooth walls on a smooth floor; and the direction upwards. Lengths in
    `unit` of a metre."""
    angle = np.radians(degrees)
    up = np.array([-np.sin(angle), np.cos(angle)])

    def box(lower: tuple[float, float], upper: tuple[float, float]) -> lp.Shape:
        scaled = lp.Box(lower=tuple(np.array(lower) / unit), upper=tuple(np.array(upper) / unit))
        return lp.Rotated(shape=scaled, degrees=degrees, center=(0, 0))

    layers = ((0.0, LOWER), (LOWER, LOWER + UPPER))
    bodies = [
        lp.Body(
            name=f"layer {k}",
            shape=box((0.03, bottom + 0.04), (0.03 + WIDTH, top + 0.04)),
            material=lp.Elastic(
                density=density * unit**3, youngs_modulus=MODULUS * unit, poissons_ratio=ratio
            ),
        )
        for k, ((bottom, top), density) in enumerate(zip(layers, DENSITIES, strict=True))
    ]
    wide, tall = 0.03 + WIDTH, 4.0
    walls = {
        "floor": box((-3, -3), (6, 0.04)),
        "left": box((-3, -3), (0.03, tall)),
        "right": box((wide, -3), (6, tall)),
    }
    scene = lp.Scene(
        grid=lp.Grid(
            lower=tuple(np.array((-3.0, -3.0)) / unit),
            upper=tuple(np.array((5.0, 5.0)) / unit),
            cell=0.2 / unit,
        ),
        bodies=bodies,
        quasi_static=lp.QuasiStatic(
            gravity=tuple(-G / unit * up),
            supports=[
                lp.Support(name=name, kind="roller", shape=shape) for name, shape in walls.items()
            ],
        ),
        time=lp.Time(end=1.0, steps=1),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(1.0)
    return simulation, up


def across(simulation: lp.Simulation, up: np.ndarray) -> np.ndarray:
    """The stress on planes across the direction."""
    xx, yy, xy = (simulation["stress"][:, k] for k in (0, 1, 3))
    return xx * up[0] ** 2 + yy * up[1] ** 2 + 2 * xy * up[0] * up[1]


def settlement(height: np.ndarray, ratio: float) -> np.ndarray:
    """Downwards, of a column that strains along its height alone, m."""
    lame = MODULUS * (1 - ratio) / ((1 + ratio) * (1 - 2 * ratio))
    below = np.minimum(height, LOWER)
    deep = DENSITIES[1] * UPPER * below + DENSITIES[0] * (LOWER * below - below**2 / 2)
    up = np.maximum(height - LOWER, 0.0)
    return np.asarray(G / lame * (deep + DENSITIES[1] * (UPPER * up - up**2 / 2)))


@pytest.mark.parametrize(("degrees", "unit"), [(0.0, 1.0), (27.0, 1.0), (0.0, 1e-3)])
@pytest.mark.parametrize("ratio", [0.3, 0.4999])
def test_layers_bear_what_lies_above(ratio: float, degrees: float, unit: float) -> None:
    simulation, up = column(ratio, degrees, unit)
    height = simulation.position @ up * unit - 0.04
    above = np.where(
        height > LOWER,
        DENSITIES[1] * (LOWER + UPPER - height),
        DENSITIES[1] * UPPER + DENSITIES[0] * (LOWER - height),
    )
    largest = G * (DENSITIES[0] * LOWER + DENSITIES[1] * UPPER)
    # Stresses are even in a cell, a tenth of the height: 2.7 % of the largest, found and expected.
    found = across(simulation, up) / unit
    assert np.sqrt(np.mean((found + G * above) ** 2)) < 0.035 * largest
    numbers = simulation.diagnostics()
    force = [numbers[f"quasi_static/force_of_wall_floor_along_{axis}"] for axis in "xy"]
    assert np.dot(force, up) == pytest.approx(largest * WIDTH, rel=1e-9)
    down = -simulation["displacement"] @ up * unit
    top = height > LOWER + UPPER - 0.1
    exact = settlement(height[top] + down[top], ratio).mean()
    # Found .03 %; 3.2 % where 0.4 micrometres are left to settle.
    assert down[top].mean() == pytest.approx(exact, rel=1e-3 if ratio < 0.4 else 0.05)


def test_gravity_is_the_body_force_of_one_density() -> None:
    def lowest(**weight: object) -> float:
        body = lp.Body(
            shape=lp.Box(lower=(0.1, 0.13), upper=(1.1, 1.17)),
            material=lp.Elastic(density=1800.0, youngs_modulus=1e6, poissons_ratio=0.3),
        )
        floor = lp.Support(name="floor", line=[(0.0, 0.13), (1.2, 0.13)])
        scene = lp.Scene(
            grid=lp.Grid(lower=(0, 0), upper=(1.25, 1.25), cell=0.125),
            bodies=[body],
            quasi_static=lp.QuasiStatic(supports=[floor], **weight),
            time=lp.Time(end=1.0, steps=1),
        )
        simulation = lp.Simulation(scene)
        simulation.run_until(1.0)
        return float(simulation["displacement"][:, 1].min())

    forced = lowest(body_force=(0.0, -1800.0 * G))
    assert lowest(gravity=(0.0, -G)) == pytest.approx(forced, rel=1e-9)
    both = lowest(gravity=(0.0, -G / 2), body_force=(0.0, -900.0 * G))
    assert both == pytest.approx(forced, rel=1e-9)
