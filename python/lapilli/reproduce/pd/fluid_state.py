"""What the points of a peridynamic fluid hold at one time, and numbers taken from it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from lapilli._core import Simulation
from lapilli.reproduce.states import Array

WALL_BODIES_FROM = 1  # the scenes of this paper have one fluid body


@dataclass(frozen=True)
class FluidState:
    """Copies of what the fluid points hold; walls are left out."""

    time: float  # s
    position: Array  # (points, dimension), m
    volume: Array  # (points,), m^dimension
    temperature: Array  # (points,), K
    wall_heat_flux: Array  # (points,), W/m^2, into the fluid
    wall_area: Array  # (points,), m^(dimension - 1)
    velocity: Array  # (points, dimension), m/s; zero without flow


def fluid_state(simulation: Simulation) -> FluidState:
    """The fluid as it is now, by ids."""
    rows = len(simulation)
    fluid = simulation.by_id("body") < WALL_BODIES_FROM

    def values(name: str) -> Array:
        return simulation.by_id(name)[fluid]

    position = simulation.by_id("position").reshape(rows, -1)[fluid]
    flows = "velocity" in simulation.fields
    return FluidState(
        simulation.time,
        position,
        values("volume"),
        values("temperature"),
        values("wall_heat_flux"),
        values("wall_area"),
        simulation.by_id("velocity").reshape(rows, -1)[fluid] if flows else np.zeros_like(position),
    )


def sample(position: Array, values: Array, places: npt.ArrayLike, reach: float) -> Array:
    """Values (points, ...) at places (n, dimension): the quadratic functions that fit the points
    within `reach` (m) best, weighted by a Gaussian. NaN where too few are near. Linear ones cut
    peaks: the upflow of a cavity at Ra 1e5 by 1 % with 80 points across, by 5 % with 40."""
    at = np.atleast_2d(np.asarray(places, dtype=float))
    found = np.full((len(at), *values.shape[1:]), np.nan)
    first, second = np.triu_indices(position.shape[1])
    for k, near in enumerate(cKDTree(position).query_ball_point(at, reach)):
        if len(near) > len(first) + first.size:
            offset = (position[near] - at[k]) / reach
            weight = np.exp(-3.0 * np.sum(offset**2, axis=1))
            square = offset[:, first] * offset[:, second]
            basis = np.column_stack([np.ones(len(near)), offset, square]) * weight[:, None]
            rows = (weight * values[near].T).T
            found[k] = np.linalg.lstsq(basis, rows, rcond=None)[0][0]
    return found


def carried_nusselt(state: FluidState, axis: int, length: float = 1.0) -> float:
    """Volume mean of the heat flow along `axis` over conduction alone, for unit diffusivity and
    temperature difference: 1 + <u T> length."""
    carried = state.velocity[:, axis] * state.temperature
    return 1.0 + length * float(np.average(carried, weights=state.volume))


def wall_flux(state: FluidState, places: npt.ArrayLike, reach: float) -> Array:
    """Heat flux (W/m^2) from the walls near places (n, dimension): the mean over the points that
    meet them, weighted by area and a Gaussian of `reach` (m)."""
    met = state.wall_area > 0
    distance = np.asarray(places)[:, None, :] - state.position[met][None, :, :]
    weight = state.wall_area[met] * np.exp(-np.sum(distance**2, axis=2) / reach**2)
    means: Array = weight @ state.wall_heat_flux[met] / weight.sum(axis=1)
    return means
