"""Heat of materials that vary with temperature, melt, or touch with a resistance, in bodies that
do not fit the grid, against closed forms."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from scipy.optimize import brentq
from scipy.special import erf, erfc

import lapilli as lp
from lapilli import _core

Array = npt.NDArray[np.float64]


class Bar:
    """A turned bar whose axis runs from `start`; its ends are regions of their own."""

    def __init__(self, length: float, width: float, degrees: float, cell: float) -> None:
        self.length, self.width, self.degrees, self.cell = length, width, degrees, cell
        self.shift = np.array([0.31, 0.17]) * cell
        angle = np.radians(degrees)
        self.axis = np.array([np.cos(angle), np.sin(angle)])

    def piece(self, begin: float, end: float, half: float | None = None) -> lp.Translated:
        half = self.width / 2 if half is None else half
        box = lp.Box(lower=(begin, -half), upper=(end, half))
        turned = lp.Rotated(shape=box, degrees=self.degrees, center=(0, 0))
        return lp.Translated(shape=turned, by=tuple(self.shift))

    def end(self, at: float) -> lp.Translated:
        """The face at one end, and next to nothing of the sides."""
        inside, outside = 1e-6 * self.cell, self.cell
        begin, end = (at - outside, at + inside) if at == 0 else (at - inside, at + outside)
        return self.piece(begin, end, half=self.width)

    def along(self, positions: Array) -> Array:
        return np.asarray((positions - self.shift) @ self.axis)

    def scene(self, bodies: list[lp.Body], end: float, **heat: object) -> lp.Scene:
        reach = self.cell * np.ceil((self.length + self.width) / self.cell + 3)
        return lp.Scene(
            grid=lp.Grid(lower=(-reach, -reach), upper=(reach, reach), cell=self.cell),
            bodies=bodies,
            heat=lp.Heat(**heat),
            time=lp.Time(end=end),
        )


def solved(scene: lp.Scene) -> tuple[Array, Array, lp.Simulation]:
    """Positions and temperatures at the end, by point."""
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    balance = simulation.balance()[0]
    assert abs(balance.residual) < 1e-9
    return simulation.position, simulation["temperature"], simulation


def kirchhoff_error(cells: int, degrees: float) -> float:
    """Of the temperature between held ends, conductivity 1 to 4 across the range."""
    bar = Bar(1.0, 0.3, degrees, 1.0 / cells)
    material = lp.Thermal(density=1, specific_heat=1, conductivity=([0.0, 1.0], [1.0, 4.0]))
    body = lp.Body(name="bar", shape=bar.piece(0, 1), material=material, temperature=0.5)
    held = [
        lp.PrescribedTemperature(value=value, region=bar.end(at))
        for value, at in ((0.0, 0.0), (1.0, 1.0))
    ]
    positions, temperature, _ = solved(bar.scene([body], end=1.2, boundaries=held))
    potential = 2.5 * bar.along(positions)  # T + 1.5 T^2
    exact = (np.sqrt(1 + 6 * potential) - 1) / 3
    return float(np.sqrt(np.mean((temperature - exact) ** 2)))


@pytest.mark.parametrize("degrees", [0.0, 27.0])
def test_a_slab_of_varying_conductivity_is_kirchhoffs(degrees: float) -> None:
    # Root mean squares 3.9e-4 and 3.2e-4 at 20 cells, 1.1e-4 and 8e-5 at 40.
    coarse, fine = (kirchhoff_error(cells, degrees) for cells in (20, 40))
    assert coarse < 1e-3
    assert np.log2(coarse / fine) > 1.8


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


def test_two_slabs_that_touch_with_a_resistance() -> None:
    # Steady: the flux over length/k + 1/conductance + length/k.
    bar = Bar(1.0, 0.3, 21.0, 1.0 / 12)
    unit = lp.Thermal(density=1, specific_heat=1, conductivity=1)
    fast = lp.Thermal(density=1, specific_heat=1, conductivity=3)
    hot = lp.Body(name="hot", shape=bar.piece(0, 0.4), material=unit, temperature=1.0)
    cold = lp.Body(name="cold", shape=bar.piece(0.4, 1.0), material=fast, temperature=0.0)
    held = [
        lp.PrescribedTemperature(value=1.0, region=bar.end(0.0)),
        lp.PrescribedTemperature(value=0.0, region=bar.end(1.0)),
    ]
    for conductance in (1e-2, 2.0, 1e5):
        contact = lp.HeatContact(bodies=["hot", "cold"], conductance=conductance)
        scene = bar.scene([hot, cold], end=2.0, boundaries=held, contacts=[contact])
        positions, temperature, simulation = solved(scene)
        flux = 1 / (0.4 + 1 / conductance + 0.2)
        along = bar.along(positions)
        exact = np.where(along < 0.4, 1 - flux * along, flux * (1 - along) / 3)
        assert np.abs(temperature - exact).max() < 5e-3
        flow = np.linalg.norm(simulation["heat_flux"], axis=1)
        assert np.median(flow) == pytest.approx(flux, rel=5e-3)


def test_two_rings_that_touch_with_a_resistance() -> None:
    inner, between, outer, conductance = 1.0, 2.0, 3.0, 0.7
    unit = lp.Thermal(density=1, specific_heat=1, conductivity=1)
    hot = lp.Body(
        name="hot", shape=lp.Annulus(inner=inner, outer=between), material=unit, temperature=0.5
    )
    cold = lp.Body(
        name="cold", shape=lp.Annulus(inner=between, outer=outer), material=unit, temperature=0.5
    )
    scene = lp.Scene(
        grid=lp.Grid(lower=(-3.3, -3.3), upper=(3.3, 3.3), cell=0.1),
        bodies=[hot, cold],
        heat=lp.Heat(
            boundaries=[
                lp.PrescribedTemperature(value=1.0, region=lp.Disk(radius=1.5)),
                lp.PrescribedTemperature(value=0.0),
            ],
            contacts=[lp.HeatContact(conductance=conductance)],
        ),
        time=lp.Time(end=8.0),
    )
    positions, temperature, _ = solved(scene)
    radius = np.linalg.norm(positions, axis=1)
    power = 1 / (
        np.log(between / inner) + 1 / (conductance * between) + np.log(outer / between)
    )  # over 2 pi
    exact = np.where(
        radius < between, 1 - power * np.log(radius / inner), power * np.log(outer / radius)
    )
    assert np.abs(temperature - exact).max() < 5e-3


def test_a_slab_with_a_varying_specific_heat_takes_up_its_heat() -> None:
    # Insulated but for a flux: heat in = integral of the enthalpy, evened out.
    bar = Bar(1.0, 0.3, 12.0, 0.1)
    material = lp.Thermal(
        density=2.0, specific_heat=([0.0, 10.0], [1.0, 3.0]), conductivity=([0.0, 10.0], [5.0, 2.0])
    )
    body = lp.Body(name="bar", shape=bar.piece(0, 1), material=material, temperature=1.0)
    pulse = lp.Table([0.0, 0.5, 0.5, 9.0], [8.0, 8.0, 0.0, 0.0])
    scene = bar.scene([body], end=4.0, boundaries=[lp.Flux(value=pulse, region=bar.end(0.0))])
    _, temperature, _ = solved(scene)
    stored = 8.0 * 0.5 / 2.0  # J/kg
    exact = float(np.roots([0.1, 1.0, -(1.0 + 0.1 + stored)]).max())  # T + T^2/10 from 1
    assert np.ptp(temperature) < 1e-3
    assert temperature.mean() == pytest.approx(exact, rel=2e-4)


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


def test_what_cannot_be_is_refused_by_name() -> None:
    unit = lp.Thermal(density=1, specific_heat=1, conductivity=1)
    with pytest.raises(ValueError, match="needs temperatures that rise"):
        lp.Thermal(density=1, specific_heat=([1, 1], [2, 3]), conductivity=1)
    with pytest.raises(ValueError, match="as many values as temperatures"):
        lp.Thermal(density=1, specific_heat=([1, 2, 3], [2, 3]), conductivity=1)
    bar = Bar(1.0, 0.3, 0.0, 0.1)
    one = lp.Body(name="one", shape=bar.piece(0, 0.4), material=unit)
    far = lp.Body(name="far", shape=bar.piece(0.7, 1.0), material=unit)
    contact = lp.HeatContact(bodies=["one", "far"], conductance=1.0)
    with pytest.raises(ValueError, match=r"heat\.contacts\.0: one and far do not touch"):
        lp.Simulation(bar.scene([one, far], end=1.0, contacts=[contact]))
    contact = lp.HeatContact(bodies=["one", "fat"], conductance=1.0)
    with pytest.raises(ValueError, match="did you mean 'far'"):
        lp.Simulation(bar.scene([one, far], end=1.0, contacts=[contact]))
    melting = lp.Thermal(density=1, specific_heat=1, conductivity=1, latent_heat=1, solidus=1)
    one = lp.Body(name="one", shape=bar.piece(0, 0.4), material=melting)
    with pytest.raises(ValueError, match="leave heat"):
        lp.Simulation(bar.scene([one], end=1.0, time_integration="implicit"))


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
