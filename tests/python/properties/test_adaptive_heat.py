"""Heat with time_integration = "auto" on long runs that nobody tuned: long steps come in, keep
the tolerance, say how large their error is, and lose neither heat nor a jump of a table."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

import lapilli as lp

Array = npt.NDArray[np.float64]
TOLERANCE = 1e-3


def drawn(seed: int) -> lp.Scene:
    """A body at 0 K in surroundings that warm, jump and cool; long against its own time."""
    rng = np.random.default_rng(seed)
    scale = 10 ** rng.uniform(-3, 3)
    diffusivity = 10 ** rng.uniform(-7, 1)
    time = scale**2 / diffusivity  # of the body
    cell = scale / rng.uniform(4, 7)
    centre = rng.uniform(-0.5, 0.5, 2) * cell
    shape: lp.Disk | lp.Rotated
    if seed % 2:
        shape = lp.Disk(center=list(centre), radius=scale)
    else:
        half = scale * np.array([1.0, rng.uniform(0.5, 1.0)])
        box = lp.Box(lower=list(centre - half), upper=list(centre + half))
        shape = lp.Rotated(shape=box, degrees=rng.uniform(0, 90))
    conductivity = 10 ** rng.uniform(-2, 2)
    strength = 10 ** rng.uniform(-1, 1) * conductivity / scale
    # Entries far apart, so that steps between them pay; one jump.
    end = 400 * time
    times = end * np.array([0.0, 0.3, 0.5, 0.5, 0.9, 1.0])
    ambient = lp.Table(list(times), [1.0, 1.0, *rng.uniform(1.0, 3.0, 3), 1.0])
    law: lp.Convection | lp.PrescribedTemperature | lp.Radiation = (
        lp.Convection(coefficient=strength, ambient=ambient),
        lp.PrescribedTemperature(value=ambient),
        lp.Radiation(emissivity=0.9, ambient=ambient, stefan_boltzmann=strength),
    )[seed % 3]
    reach = 1.5 * scale + 3 * cell
    cells = int(np.ceil(2 * reach / cell))
    lower = -reach - rng.uniform(0, 1, 2) * cell
    return lp.Scene(
        grid=lp.Grid(lower=list(lower), upper=list(lower + cells * cell), cell=cell),
        bodies=[
            lp.Body(
                shape=shape,
                material=lp.Thermal(
                    density=1.0,
                    specific_heat=conductivity / diffusivity,
                    conductivity=conductivity,
                ),
            )
        ],
        heat=lp.Heat(boundaries=[law], time_integration="auto", tolerance=TOLERANCE),
        time=lp.Time(end=float(end)),
    )


def states(scene: lp.Scene, times: Array) -> tuple[Array, list[float], lp.Simulation]:
    simulation = lp.Simulation(scene)
    fields, errors = [], []
    for time in times:
        simulation.run_until(time)
        fields.append(simulation.by_id("temperature").copy())
        errors.append(simulation.diagnostics().get("heat/time_error", 0.0))
    return np.array(fields), errors, simulation


def long_steps(simulation: lp.Simulation) -> float:
    numbers = simulation.diagnostics()
    return numbers["heat/implicit_steps"] + numbers["heat/staged_steps"]


@pytest.mark.parametrize("seed", range(6))
def test_long_runs_take_long_steps_and_stay_right(seed: int) -> None:
    scene = drawn(seed)
    times = scene.time.end * np.array([0.02, 0.1, 0.35, 0.5, 0.503, 0.52, 0.7, 0.95, 1.0])
    found, _, simulation = states(scene, times)
    explicit, _, steps = states(scene.set("heat.time_integration=explicit"), times)
    assert long_steps(simulation) > 10
    assert simulation.step_index < 0.7 * steps.step_index
    # Explicit steps take what varies in their middle and are late by that: 1.2e-4 at most.
    span = explicit.max()
    assert np.abs(found - explicit).max() < 3e-4 * span
    assert abs(simulation.balance()[0].residual) < 1e-11
    assert found.min() > -1e-9
    assert found.max() < 3 + 1e-9


@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 1e-4])
def test_the_error_is_as_said(tolerance: float) -> None:
    """A disk that warms slowly, so that implicit steps have something to follow; exact in time by
    extrapolation of explicit steps."""
    scene = drawn(3).set("heat.time_integration=explicit")
    material, shape = scene.bodies[0].material, scene.bodies[0].shape
    assert isinstance(material, lp.Thermal)
    assert isinstance(shape, lp.Disk)
    unit = shape.radius**2 * material.specific_heat / material.conductivity
    warm = lp.Convection(coefficient=0.05 * material.conductivity / shape.radius, ambient=1.0)
    scene.heat = lp.Heat(boundaries=[warm], time_integration="explicit", tolerance=tolerance)
    scene.time.end = 60 * unit
    times = unit * np.array([1.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0])
    step = lp.Simulation(scene).step_size
    coarse, fine = (states(scene.set(f"time.step={step / part!r}"), times)[0] for part in (2, 4))
    found, said, simulation = states(scene.set("heat.time_integration=auto"), times)
    errors = np.abs(found - (2 * fine - coarse)).max(axis=1)
    assert long_steps(simulation) > 5
    # Implicit steps are off by .2 to 3 times what is said, explicit ones by less than that.
    assert errors.max() < tolerance
    assert (errors < 3 * np.array(said) + 0.02 * tolerance).all(), (errors, said)
    # What is left of steps in stages and explicit ones is bounded, not followed.
    assert (np.array(said[-2:]) < 5 * errors[-2:] + 0.25 * tolerance).all(), (errors, said)


@pytest.mark.parametrize("seed", range(6))
def test_short_runs_under_ramps_are_not_late(seed: int) -> None:
    """A hundred steps and less, under surroundings that vary and jump; Euler steps are off by up to
    .03. Strong conditions take hold over a few steps, which leaves .0085."""
    rng = np.random.default_rng(100 + seed)
    cell = 1 / rng.uniform(8, 12)
    end = rng.uniform(0.1, 0.4)
    table = lp.Table([0.0, 0.6 * end, 0.6 * end, end], [0.0, rng.uniform(1, 2), 0.5, -1.0])
    law: lp.Convection | lp.PrescribedTemperature = (
        lp.PrescribedTemperature(value=table),
        lp.Convection(coefficient=10 ** rng.uniform(0, 2.5), ambient=table),
    )[seed % 2]
    scene = lp.Scene(
        grid=lp.Grid(lower=(-12 * cell,) * 2, upper=(13 * cell,) * 2, cell=cell),
        bodies=[
            lp.Body(
                shape=lp.Disk(center=(0.3 * cell, 0.1 * cell), radius=1.0),
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
            )
        ],
        heat=lp.Heat(boundaries=[law]),
        time=lp.Time(end=float(end)),
    )
    explicit = scene.set("heat.time_integration=explicit")
    settled = lp.Simulation(explicit)
    settled.run_until(0.5 * end)
    fine = explicit.set(f"time.step={settled.step_size / 40!r}")

    def means(one: lp.Scene) -> Array:
        simulation, found = lp.Simulation(one), []
        for time in end * np.array([0.3, 0.55, 0.8, 1.0]):
            simulation.run_until(time)
            found.append(np.average(simulation["temperature"], weights=simulation["volume"]))
        return np.array(found)

    exact, found, late = means(fine), means(scene), means(explicit)
    assert np.abs(found - exact).max() < 1e-2
    assert np.abs(found - exact).max() < 0.6 * np.abs(late - exact).max()


def test_a_given_step_and_points_that_move_stay_explicit() -> None:
    scene = drawn(1)
    step = lp.Simulation(scene).step_size
    given = lp.Simulation(scene.set(f"time.step={step!r}"))
    given.step()
    assert "heat/implicit_steps" not in given.diagnostics()


DAY = 86400.0


def cooling_block(value: object) -> lp.Scene:
    """It cools for a day; a heater of 1 W/m^2 is switched on for a while."""
    return lp.Scene(
        grid=lp.Grid(lower=(-0.02, -0.02), upper=(0.12, 0.07), cell=0.0025),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0, 0), upper=(0.1, 0.05)),
                material=lp.Thermal(density=2000, specific_heat=900, conductivity=1),
                temperature=350.0,
            )
        ],
        heat=lp.Heat(
            boundaries=[
                lp.Flux(
                    name="heater",
                    value=value,
                    region=lp.HalfSpace(point=(0, 0.0495), normal=(0, -1)),
                ),
                lp.Convection(name="air", coefficient=10.0, ambient=300.0),
            ]
        ),
        time=lp.Time(end=DAY),
    )


@pytest.mark.parametrize("minutes", [5.0, 20.0])
@pytest.mark.parametrize("share", [0.58])
def test_a_pulse_of_a_function_arrives(minutes: float, share: float) -> None:
    """Anywhere in a run of implicit steps, which without it are as long as hours."""
    begin, width = share * DAY, 60.0 * minutes

    def heater(place: Array, _temperature: Array, time: float) -> Array:
        return np.full(len(place), 1.0 if begin <= time < begin + width else 0.0)

    simulation = lp.Simulation(cooling_block(heater))
    simulation.run_until(DAY)
    given = simulation.balance()[0].entries["heater"]
    # Explicit steps of 20 s cut it to whole ones.
    assert given == pytest.approx(0.101 * width, rel=0.02 + 40.0 / width)


def test_functions_in_long_steps_say_what_may_be_missed(tmp_path: Path) -> None:
    def still(place: Array, _temperature: Array, _time: float) -> Array:
        return np.zeros(len(place))

    for value, says in ((still, True), (0.0, False)):
        result = lp.run(cooling_block(value), tmp_path / f"{says}.vtkhdf", progress=False)
        assert result.history["heat/staged_steps"][-1] > 0
        assert any("may miss what functions do" in note for note in result.warnings) is says
