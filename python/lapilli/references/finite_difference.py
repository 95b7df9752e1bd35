"""The paper's own finite-difference schemes: ring, sphere and square, with its misprints undone.

Source: Yu & Zhao 2026 (virtual heat flux method), appendices B (ring), C (sphere), D (square).
Central differences in space, forward Euler in time, three-point one-sided differences at walls.
These fill a "paper's own finite differences" column; radial and slab are the better references.

Corrected against the print:
B1  the annulus runs from the inner to the outer radius (text and appendix swap R1 and R2);
B3, D2  at a wall facing -r, -x or -y the flux has the other sign: q.n = coefficient (T - ambient);
B6, D5  the one-sided slope at the lower end is (-3 T0 + 4 T1 - T2)/(2 h), printed in reverse order;
B7  kappa dT/dr = -coefficient (T - ambient) at the outer radius: sign and kappa were missing;
C5  the centre of the sphere cools with 6 alpha dt/dr^2 (T1 - T0), printed with factor 3;
D5  the slope is divided by 2 dx, printed dx; it is of second, not first, order.
Also undone: outputs one step late, which the paper's tables show. Here step k is time k dt.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from lapilli.references.arrays import Array, as_array
from lapilli.references.thermal import UNIT_MEDIUM, Convection, Flux, Medium

Wall = Flux | Convection


@dataclass(frozen=True, kw_only=True)
class FiniteDifferences:
    """Result of one of the schemes."""

    positions: Array  # (n,), m: radii, or the coordinates of each axis of the square
    times: Array  # (m,), s
    temperature: Array  # (m, n) or (m, n, n), K


def ring(
    times: npt.ArrayLike,
    *,
    inner: float = 1.0,
    outer: float = 5.0,
    intervals: int = 80,
    step: float | None = None,
    wall: Wall,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> FiniteDifferences:
    """Ring with the same law on both circles (appendix B).

    times: ascending, each a multiple of the step. step: default a quarter of dr^2/alpha.
    """
    r = np.linspace(inner, outer, intervals + 1)
    dr = (outer - inner) / intervals
    step = step or dr**2 / (4 * medium.diffusivity)
    _require_stable(step, dr, 1, medium)
    number = medium.diffusivity * step

    def advance(field: Array) -> None:
        # Eq. B5, then B6 and B7
        curve = (field[2:] - 2 * field[1:-1] + field[:-2]) / dr**2
        slope = (field[2:] - field[:-2]) / (2 * dr)
        field[1:-1] += number * (curve + slope / r[1:-1])
        _set_walls(field)

    def _set_walls(field: Array) -> None:
        field[0] = _wall_value(field[1], field[2], dr, wall, medium)
        field[-1] = _wall_value(field[-2], field[-3], dr, wall, medium)

    field = np.full(r.shape, initial)
    _set_walls(field)
    return _march(field, advance, r, times, step)


def sphere(
    times: npt.ArrayLike,
    *,
    radius: float = 5.0,
    intervals: int = 80,
    step: float | None = None,
    wall: Wall,
    initial: float = 100.0,
    medium: Medium = UNIT_MEDIUM,
) -> FiniteDifferences:
    """Ball with a law on its surface (appendix C).

    times: ascending, each a multiple of the step. step: default an eighth of dr^2/alpha (the
    centre allows a sixth).
    """
    r = np.linspace(0, radius, intervals + 1)
    dr = radius / intervals
    step = step or dr**2 / (8 * medium.diffusivity)
    _require_stable(step, dr, 3, medium)
    number = medium.diffusivity * step

    def advance(field: Array) -> None:
        # Eq. C4, C5 (with 6), C6
        centre = field[0] + 6 * number / dr**2 * (field[1] - field[0])
        curve = (field[2:] - 2 * field[1:-1] + field[:-2]) / dr**2
        slope = (field[2:] - field[:-2]) / (2 * dr)
        field[1:-1] += number * (curve + 2 * slope / r[1:-1])
        field[0] = centre
        field[-1] = _wall_value(field[-2], field[-3], dr, wall, medium)

    field = np.full(r.shape, initial)
    field[-1] = _wall_value(field[-2], field[-3], dr, wall, medium)
    return _march(field, advance, r, times, step)


def square(
    times: npt.ArrayLike,
    *,
    side: float = 10.0,
    intervals: int = 50,
    step: float | None = None,
    wall: Wall,
    initial: float = 0.0,
    medium: Medium = UNIT_MEDIUM,
) -> FiniteDifferences:
    """Square [0, side]^2 with the same law on all sides (appendix D).

    times: ascending, each a multiple of the step. step: default an eighth of dx^2/alpha. The
    corners, which the paper leaves open, follow from their neighbours along x by the same law; no
    interior node sees them. The default side is 10: the paper's "5 m" is the half side.
    """
    x = np.linspace(0, side, intervals + 1)
    dx = side / intervals
    step = step or dx**2 / (8 * medium.diffusivity)
    _require_stable(step, dx, 2, medium)
    number = medium.diffusivity * step / dx**2

    def _set_walls(field: Array) -> None:
        field[:, 0] = _wall_value(field[:, 1], field[:, 2], dx, wall, medium)
        field[:, -1] = _wall_value(field[:, -2], field[:, -3], dx, wall, medium)
        field[0] = _wall_value(field[1], field[2], dx, wall, medium)
        field[-1] = _wall_value(field[-2], field[-3], dx, wall, medium)

    def advance(field: Array) -> None:
        # Eq. D4, then D5
        inside = field[1:-1, 1:-1]
        around = field[2:, 1:-1] + field[:-2, 1:-1] + field[1:-1, 2:] + field[1:-1, :-2]
        field[1:-1, 1:-1] = inside + number * (around - 4 * inside)
        _set_walls(field)

    field = np.full((intervals + 1, intervals + 1), initial)
    _set_walls(field)
    return _march(field, advance, x, times, step)


def _wall_value(first: Array, second: Array, h: float, wall: Wall, medium: Medium) -> Array:
    """Wall temperature from its two neighbours: kappa (3 T - 4 T1 + T2)/(2 h) = inward flux."""
    if isinstance(wall, Flux):
        return as_array((4 * first - second + 2 * h * wall.inward / medium.conductivity) / 3)
    biot = 2 * h * wall.coefficient / medium.conductivity
    return as_array((4 * first - second + biot * wall.ambient) / (3 + biot))


def _require_stable(step: float, h: float, dimension: int, medium: Medium) -> None:
    limit = h**2 / (2 * dimension * medium.diffusivity)
    if not 0 < step <= limit:
        raise ValueError(f"step must lie in (0, h^2/(2 d alpha)] = (0, {limit:g}], got {step:g}")


def _march(
    field: Array,
    advance: Callable[[Array], None],
    positions: Array,
    times: npt.ArrayLike,
    step: float,
) -> FiniteDifferences:
    times = np.atleast_1d(as_array(times))
    counts = np.rint(times / step).astype(int)
    if np.any(np.abs(counts * step - times) > 1e-6 * step) or np.any(
        np.diff(counts, prepend=0) < 0
    ):
        raise ValueError(f"times must ascend and be multiples of the step {step:g}, got {times}")
    frames, done = [], 0
    for count in counts:
        for _ in range(int(count) - done):
            advance(field)
        done = int(count)
        frames.append(field.copy())
    return FiniteDifferences(positions=positions, times=times, temperature=np.stack(frames))
