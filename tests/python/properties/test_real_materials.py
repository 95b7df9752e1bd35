"""Heat of materials that vary with temperature or touch with a resistance, in bodies that do not
fit the grid, against closed forms."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp

sys.path.insert(0, str(Path(__file__).parent))
from heat_bars import Bar, solved

sys.path.pop(0)


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
