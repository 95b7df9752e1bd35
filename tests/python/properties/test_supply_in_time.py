"""Fluxes, walls and sources that vary in time, and sources that depend on the temperature, by every
solver of heat.

What a table supplies is its integral, however long the steps are: a pulse within one of them counts
whole. `[peridynamics]` and the theta scheme on points took what the table says at the ends of the
step, and lost it. A source that is linear in the temperature is an exponential, at rest as in
motion: steps followed it in motion only, and at rest one explicit step of three e-folds passed for
an answer.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import lapilli as lp

CELL = 0.2
END = 1.0
WALL = 0.5

IMPLICIT = {"time_integration": "implicit"}
MOTION = lp.Translation(velocity=(0.03, 0.02))
AT_REST = lp.Thermal(density=2.0, specific_heat=1.5, conductivity=0.7)
BY_TABLE = lp.Thermal(
    density=2.0, specific_heat=([0.0, 1.0], [1.5, 1.5]), conductivity=([0.0, 1.0], [0.7, 0.7])
)
CAPACITY = 3.0


def disk(**settings: object) -> lp.Body:
    material = settings.pop("material", AT_REST)
    return lp.Body(
        name="disk", shape=lp.Disk(center=(0.03, 0.07), radius=1.0), material=material, **settings
    )


def cloud(**settings: object) -> lp.Body:
    """The points of the disk without its shape."""
    filled = lp.Simulation(
        lp.Scene(grid=grid(), bodies=[disk()], heat=lp.Heat(), time=lp.Time(end=1.0))
    )
    points = lp.Points(positions=filled.position.copy(), volumes=filled["volume"].copy())
    return lp.Body(name="disk", points=points, material=AT_REST, **settings)


def grid(dimension: int = 2) -> lp.Grid:
    return lp.Grid(lower=(-2.0,) * dimension, upper=(2.0,) * dimension, cell=CELL)


def heated(
    body: lp.Body, flux: object = None, steps: int | None = None, end: float = END, **heat: object
) -> lp.Scene:
    laws = [] if flux is None else [lp.Flux(value=flux)]
    return lp.Scene(
        grid=grid(1 if isinstance(body.shape, lp.Box) else 2),
        bodies=[body],
        heat=lp.Heat(boundaries=laws, **heat),
        time=lp.Time(end=end, steps=steps),
    )


def by_bonds(flux: object = None, end: float = END, **settings: object) -> lp.Scene:
    """The disk of peridynamic points, heated by the wall around it."""
    walls = []
    if flux is not None:
        rim = lp.Annulus(center=(0.03, 0.07), inner=1.0, outer=1.0 + WALL)
        walls = [lp.FluidWall(name="rim", shape=rim, heat="flux", flux=flux)]
    return lp.Scene(
        grid=grid(),
        bodies=[disk(points_per_cell=1, **settings)],
        peridynamics=lp.Peridynamics(heat=lp.PeridynamicHeat(), walls=walls),
        time=lp.Time(end=end),
    )


Solver = Callable[..., lp.Scene]


def rod(**settings: object) -> lp.Body:
    return lp.Body(
        name="rod", shape=lp.Box(lower=(-1.03,), upper=(0.97,)), material=AT_REST, **settings
    )


SOLVERS: dict[str, Solver] = {
    "at rest": lambda flux=None, **s: heated(disk(**s), flux),
    "at rest, explicit": lambda flux=None, **s: heated(
        disk(**s), flux, time_integration="explicit"
    ),
    "at rest, implicit": lambda flux=None, **s: heated(disk(**s), flux, 7, **IMPLICIT),
    "tables of the temperature": lambda flux=None, **s: heated(disk(material=BY_TABLE, **s), flux),
    "rigid motion": lambda flux=None, **s: heated(disk(motion=MOTION, **s), flux),
    "points in motion": lambda flux=None, **s: heated(
        disk(motion=MOTION, **s), flux, transfer="affine"
    ),
    "cloud": lambda flux=None, **s: heated(cloud(**s), flux),
    "cloud, implicit": lambda flux=None, **s: heated(cloud(**s), flux, 7, **IMPLICIT),
    "rod, implicit": lambda flux=None, **s: heated(rod(**s), flux, 7, **IMPLICIT),
    "peridynamics": by_bonds,
}


def taken(scene: lp.Scene) -> float:
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    balance = simulation.balance()[0]
    assert abs(balance.residual) < 1e-11
    return balance.stored - balance.initial


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("by", ["flux", "source"])
@pytest.mark.parametrize("solver", SOLVERS)
def test_a_pulse_counts_whole(solver: str, by: str, seed: int) -> None:
    """Anywhere in a step, and shorter than it; beside the same heat spread over the run."""
    rng = np.random.default_rng(seed)
    begin, width = END * rng.uniform(0.1, 0.9), 10 ** rng.uniform(-6, -4)
    pulse = lp.Table(
        [0, begin, begin, begin + width, begin + width, END],
        [0, 0, END / width, END / width, 0, 0],
    )
    whole, spread = (taken(SOLVERS[solver](**{by: value})) for value in (pulse, 1.0))
    # The area that points in motion show changes by 2e-4 on their way.
    slack = 1e-3 if (solver, by) == ("points in motion", "flux") else 1e-9
    assert whole == pytest.approx(spread, rel=slack)


# Those that follow a source of the temperature by steps of their own.
STEPPING: dict[str, Callable[..., lp.Scene]] = {
    "at rest": lambda end, **s: heated(disk(**s), end=end),
    "tables of the temperature": lambda end, **s: heated(disk(material=BY_TABLE, **s), end=end),
    "rigid motion": lambda end, **s: heated(disk(motion=MOTION, **s), end=end),
    "points in motion": lambda end, **s: heated(
        disk(motion=MOTION, **s), end=end, transfer="affine"
    ),
    "cloud": lambda end, **s: heated(cloud(**s), end=end),
    "peridynamics": lambda end, **s: by_bonds(end=end, **s),
}


def mean_temperature(scene: lp.Scene) -> tuple[float, lp.Simulation]:
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    assert abs(simulation.balance()[0].residual) < 1e-11
    return float(simulation["temperature"].mean()), simulation


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("solver", STEPPING)
def test_a_source_linear_in_the_temperature_is_an_exponential(solver: str, seed: int) -> None:
    """It grows or falls by some e-folds over the run, faster than conduction or slower: to rounding
    of the difference that its slope is taken by, however long the steps."""
    rng = np.random.default_rng(seed)
    folds = rng.uniform(2.0, 5.0)
    rate = 10 ** rng.uniform(-1, 3)
    for sign in (1.0, -1.0):

        def source(
            _place: np.ndarray, temperature: np.ndarray, _time: float, grows: float = sign * rate
        ) -> np.ndarray:
            return CAPACITY * grows * np.asarray(temperature)

        found, _ = mean_temperature(STEPPING[solver](folds / rate, temperature=1.0, source=source))
        assert found == pytest.approx(np.exp(sign * folds), rel=1e-5)


@pytest.mark.parametrize("solver", STEPPING)
def test_a_source_that_runs_away_is_followed(solver: str) -> None:
    """From 0, r exp(T) rises to -log(1 - r t): 1.1 % off at nine tenths of the way to infinity."""
    rate = 40.0

    def source(_place: np.ndarray, temperature: np.ndarray, _time: float) -> np.ndarray:
        return CAPACITY * rate * np.exp(np.asarray(temperature))

    found, simulation = mean_temperature(STEPPING[solver](0.9 / rate, source=source))
    assert found == pytest.approx(-np.log(0.1), rel=0.015)
    assert simulation.step_index > 10


@pytest.mark.parametrize("solver", STEPPING)
def test_a_thermostat_is_not_passed(solver: str) -> None:
    """A source that restores a temperature within a hundredth of a step."""

    def source(_place: np.ndarray, temperature: np.ndarray, _time: float) -> np.ndarray:
        return CAPACITY * 1e5 * (2.0 - np.asarray(temperature))

    scene = STEPPING[solver](0.3, temperature=1.0, source=source)
    simulation = lp.Simulation(scene)
    for _ in range(5):
        simulation.step()
        temperature = simulation["temperature"]
        assert temperature.max() < 2.0 + 1e-6
    assert temperature.min() > 2.0 - 1e-6


@pytest.mark.parametrize("solver", STEPPING)
def test_a_given_step_that_cannot_follow_is_an_error(solver: str) -> None:
    def source(_place: np.ndarray, temperature: np.ndarray, _time: float) -> np.ndarray:
        return CAPACITY * 1e4 * np.asarray(temperature)

    scene = STEPPING[solver](1.0, temperature=1.0, source=source)
    scene.time = lp.Time(end=1.0, step=1e-3)
    with pytest.raises(lp.RunError, match="heats itself e-fold in"):
        lp.Simulation(scene).run_until(1.0)
