"""Heat of bodies that melt and do not fit the grid, against closed forms and drawn at random."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import erf, erfc

import lapilli as lp
from lapilli import _core

sys.path.insert(0, str(Path(__file__).parent))
from heat_bars import Bar, solved

sys.path.pop(0)


def melted(
    bar: Bar, stefan: float, start: float, end: float, slurry: float = 0.0
) -> tuple[float, lp.Simulation]:
    """How far a bar at `start` <= 0 has melted from its end at 1, latent heat 1/stefan."""
    material = lp.Thermal(
        density=1,
        specific_heat=1,
        conductivity=1,
        latent_heat=1 / stefan,
        solidus=-slurry / 2,
        liquidus=slurry / 2,
    )
    body = lp.Body(name="bar", shape=bar.piece(0, bar.length), material=material, temperature=start)
    held = [lp.PrescribedTemperature(value=1.0, region=bar.end(0.0))]
    _, _, simulation = solved(bar.scene([body], end=end, boundaries=held))
    return simulation.diagnostics()["heat/liquid_volume"] / bar.width, simulation


def front_factor(stefan: float, start: float) -> float:
    """lambda of the front 2 lambda sqrt(t): Stefan's for start = 0, Neumann's below (both phases
    alike)."""

    def residual(x: float) -> float:
        return float(
            np.exp(-x * x) / erf(x) + start * np.exp(-x * x) / erfc(x) - x * np.sqrt(np.pi) / stefan
        )

    return float(brentq(residual, 1e-3, 3.0))


@pytest.mark.parametrize(
    ("stefan", "start", "degrees"),
    [(0.5, 0.0, 0.0), (0.5, 0.0, 33.0), (2.0, -0.5, 0.0), (0.5, -0.5, 33.0), (0.02, 0.0, 33.0)],
)
def test_a_front_that_melts_is_stefans_and_neumanns(
    stefan: float, start: float, degrees: float
) -> None:
    # The front at two thirds of a bar 40 cells long, within 1 % of it.
    bar = Bar(1.0, 0.1, degrees, 1.0 / 40)
    factor = front_factor(stefan, start)
    # In a bar that is cold the far end must not feel the front yet.
    reach = 0.66 if start == 0.0 else 0.4
    end = (reach / (2 * factor)) ** 2
    found, simulation = melted(bar, stefan, start, end)
    assert found == pytest.approx(reach, rel=0.01)
    liquid = simulation["liquid_fraction"]
    assert liquid.min() >= 0
    assert liquid.max() <= 1 + 1e-12
    temperature = simulation["temperature"]
    assert temperature.max() <= 1 + 1e-3
    assert temperature.min() >= start - 1e-3


def lump(seed: int) -> lp.Scene:
    """A body at random that melts or freezes, its properties tables."""
    rng = np.random.default_rng(seed)
    cell = 10 ** rng.uniform(-4, 2)
    low, high = np.sort(rng.uniform(200, 2000, 2))
    melts = rng.uniform(low, high)
    slurry = 0.0 if seed % 2 else rng.uniform(0, high - melts)
    latent = 10 ** rng.uniform(-1.5, 2) * 700 * (high - low)
    points = np.sort(rng.uniform(low - 100, high + 100, 4))
    conductivity = 10 ** rng.uniform(-1, 2)
    material = lp.Thermal(
        density=7800,
        specific_heat=(points, rng.uniform(300, 900, 4)),
        conductivity=(points, conductivity * rng.uniform(0.3, 3, 4)),
        latent_heat=latent,
        solidus=melts,
        liquidus=melts + slurry,
    )
    shape: lp.Disk | lp.Rotated = lp.Disk(center=rng.uniform(-1, 1, 2) * cell, radius=4.3 * cell)
    if seed % 3 == 0:
        box = lp.Box(lower=(-4 * cell, -2.3 * cell), upper=(4.1 * cell, 2.2 * cell))
        shape = lp.Rotated(shape=box, degrees=rng.uniform(0, 90), center=(0, 0))
    start, outside = (low, high) if seed % 4 < 2 else (high, low)
    strength = 10 ** rng.uniform(-2, 3) * conductivity / cell
    law: lp.Convection | lp.PrescribedTemperature | lp.Radiation = (
        lp.Convection(coefficient=strength, ambient=outside),
        lp.PrescribedTemperature(value=outside),
        lp.Radiation(ambient=outside, stefan_boltzmann=strength / high**3),
    )[seed % 3]
    time = (4 * cell) ** 2 * 7800 * 600 / conductivity
    return lp.Scene(
        grid=lp.Grid(lower=(-8 * cell,) * 2, upper=(8 * cell,) * 2, cell=cell),
        bodies=[lp.Body(name="lump", shape=shape, material=material, temperature=start)],
        heat=lp.Heat(boundaries=[law]),
        time=lp.Time(end=time),
    )


@pytest.mark.parametrize("seed", range(12))
def test_drawn_bodies_that_melt_keep_heat_and_range(seed: int) -> None:
    scene = lump(seed)
    law = scene.heat.boundaries[0]
    outside = law.value if isinstance(law, lp.PrescribedTemperature) else law.ambient
    low, high = sorted((float(outside), float(scene.bodies[0].temperature)))
    _, temperature, simulation = solved(scene)
    slack = 1e-9 * (high - low)
    assert simulation.diagnostics()["heat/nodal_stray"] <= slack
    assert temperature.min() >= low - slack
    assert temperature.max() <= high + slack
    assert simulation["liquid_fraction"].min() >= 0
    assert simulation["liquid_fraction"].max() <= 1 + 1e-12


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_melting_has_the_same_bytes_resumed_and_for_any_threads(seed: int, tmp_path: Path) -> None:
    scene = lump(seed)
    whole = lp.run(scene, threads=1, progress=False)
    path = tmp_path / "cut.vtkhdf"
    lp.run(
        scene,
        path,
        threads=2,
        progress=False,
        callback=lambda s: s.time < 0.4 * scene.time.end,
    )
    resumed = lp.run(scene, path, threads=3, progress=False, resume=True)
    for field in ("temperature", "liquid_fraction", "heat_flux"):
        assert resumed[field].tobytes() == whole[field].tobytes()


def test_a_start_at_a_single_melting_point_says_that_it_is_solid() -> None:
    def notes(temperature: float, **melting: float) -> list[str]:
        scene = lp.Scene(
            grid=lp.Grid(lower=(-0.2, -0.2), upper=(1.2, 1.2), cell=0.2),
            bodies=[
                lp.Body(
                    shape=lp.Box(lower=(0, 0), upper=(1, 1)),
                    material=lp.Thermal(
                        density=1, specific_heat=1, conductivity=1, latent_heat=10, **melting
                    ),
                    temperature=temperature,
                )
            ],
            heat=lp.Heat(),
            time=lp.Time(end=1e-3),
        )
        found = json.loads(_core.check_json(scene))["notes"]
        return [note for note in found if "starts solid" in note]

    assert len(notes(273.15, solidus=273.15)) == 1
    assert len(notes(273.15, liquidus=273.15)) == 1
    assert len(notes(273.15, solidus=273.15, liquidus=273.15)) == 1
    assert notes(273.16, solidus=273.15) == []
    assert notes(273.15, solidus=273.15, liquidus=274.0) == []
