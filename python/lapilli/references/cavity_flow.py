"""The box of cavity.py and a steady flow in it: what it is, and the numbers taken from it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.interpolate import CubicSpline, RectBivariateSpline
from scipy.optimize import minimize_scalar

from lapilli.references.arrays import Array, as_array


@dataclass(frozen=True, kw_only=True)
class Box:
    """The problem. Lengths in units of the hot-to-cold distance."""

    rayleigh: float
    prandtl: float = 0.71
    heated: str = "left"  # hot wall: left (cold right) or bottom (cold top)
    aspect: float = 1.0  # heated left: height/width; heated bottom: width/height
    rolls: int = 1  # rolls side by side in the start, for the layer heated from below

    def __post_init__(self) -> None:
        if self.heated not in ("left", "bottom"):
            raise ValueError(f"heated must be 'left' or 'bottom', got {self.heated!r}")
        if self.rayleigh < 0 or self.prandtl <= 0 or self.aspect <= 0 or self.rolls < 1:
            raise ValueError(f"need rayleigh >= 0, prandtl, aspect > 0 and rolls >= 1, got {self}")

    @property
    def size(self) -> tuple[float, float]:
        """Width and height."""
        return (1.0, self.aspect) if self.heated == "left" else (self.aspect, 1.0)


@dataclass(frozen=True, kw_only=True)
class Flow:
    """A steady solution on nodes x (nx + 1), y (ny + 1); fields are (nx + 1, ny + 1)."""

    box: Box
    x: Array
    y: Array
    stream: Array
    vorticity: Array
    temperature: Array
    horizontal: Array  # u
    vertical: Array  # v
    residual: float  # largest, relative to the terms of its equation

    def nusselt(self) -> float:
        """Mean Nusselt number over the box: 1 + mean of u T (or v T), exact for the -dT/dx part."""
        carried = self.horizontal if self.box.heated == "left" else self.vertical
        flux = np.trapezoid(np.trapezoid(carried * self.temperature, self.y), self.x)
        return 1.0 + float(flux) / (self.box.size[0] * self.box.size[1])

    def local_nusselt(self) -> Array:
        """-dT/dn along the hot wall, (ny + 1) or (nx + 1); one-sided, second order."""
        field = self.temperature if self.box.heated == "left" else self.temperature.T
        h = self.x[1] if self.box.heated == "left" else self.y[1]
        return as_array((3 * field[0] - 4 * field[1] + field[2]) / (2 * h))

    def wall_nusselt(self) -> tuple[float, float]:
        """Means of -dT/dn over the hot and of the same over the cold wall."""
        field = self.temperature if self.box.heated == "left" else self.temperature.T
        along = self.y if self.box.heated == "left" else self.x
        h = self.x[1] if self.box.heated == "left" else self.y[1]
        hot = (3 * field[0] - 4 * field[1] + field[2]) / (2 * h)
        cold = (4 * field[-2] - 3 * field[-1] - field[-3]) / (2 * h)
        length = float(along[-1])
        return float(np.trapezoid(hot, along)) / length, float(np.trapezoid(cold, along)) / length

    def horizontal_peak(self) -> tuple[float, float]:
        """Largest u on the vertical mid-line, and its y."""
        return _peak(self.y, self.horizontal[len(self.x) // 2])

    def vertical_peak(self) -> tuple[float, float]:
        """Largest v on the horizontal mid-line, and its x."""
        return _peak(self.x, self.vertical[:, len(self.y) // 2])

    def at(self, points: npt.ArrayLike) -> Array:
        """(u, v, T) at points (n, 2) by cubic splines: (n, 3)."""
        points = as_array(points)
        fields = (self.horizontal, self.vertical, self.temperature)
        return np.stack([interpolate(self, field, points) for field in fields], axis=-1)


def interpolate(flow: Flow, field: Array, points: Array) -> Array:
    """A nodal field of a flow at points (n, 2) by the cubic spline through it: (n,)."""
    spline = RectBivariateSpline(flow.x, flow.y, field)
    return as_array(spline(points[:, 0], points[:, 1], grid=False))


def _peak(positions: Array, values: Array) -> tuple[float, float]:
    """Largest value of the cubic spline through a profile, and where it is."""
    spline = CubicSpline(positions, values)
    k = int(np.clip(np.argmax(values), 1, len(values) - 2))
    best = minimize_scalar(
        lambda s: -float(spline(s)),
        bounds=(positions[k - 1], positions[k + 1]),
        method="bounded",
        options={"xatol": 1e-10},
    )
    return float(spline(best.x)), float(best.x)
