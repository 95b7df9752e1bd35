"""A disc that heats while it swirls: every circle turns at its own speed, so the disc stays a disc.

    u_theta = r Omega(r),   Omega(r) = speed (1 + shear (1 - r^2/R^2))

A point of radius r turns by exactly Omega(r) t: trajectories, velocity gradient and deformation
gradient are closed forms, volume is kept, and a temperature that depends on r alone obeys plain
radial conduction. A lattice of points is sheared without end meanwhile, which is what the case
tests: transfer of heat between moving points and a fixed grid (see the notes on small steps).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import numpy.typing as npt

from lapilli.references.arrays import Array, Times, as_array
from lapilli.references.radial import RadialProblem, RadialSolution
from lapilli.references.thermal import UNIT_MEDIUM, Boundary, Convection, Medium


@dataclass(frozen=True, kw_only=True)
class Swirl:
    """Motion of the disc |x - centre| <= radius and its temperature. Points are (n, 2), m."""

    radius: float = 1.0  # m
    speed: float = 2 * np.pi  # rad/s, of the rim
    shear: float = 0.4  # the centre turns faster than the rim by this share
    centre: tuple[float, float] = (0.0, 0.0)  # m
    boundary: Boundary = field(default_factory=lambda: Convection(coefficient=1.0, ambient=1.0))
    initial: float = 0.0  # K
    medium: Medium = UNIT_MEDIUM

    def angular_velocity(self, r: npt.ArrayLike) -> Array:
        """Omega at radii r, rad/s."""
        r = as_array(r)
        return as_array(self.speed * (1 + self.shear * (1 - (r / self.radius) ** 2)))

    def velocity(self, points: npt.ArrayLike) -> Array:
        """Velocity field at points: (n, 2), m/s. Steady."""
        arm = as_array(points) - self.centre
        return self._turned(arm) * self._speed_of(arm)[:, None]

    def velocity_gradient(self, points: npt.ArrayLike) -> Array:
        """L[a, b] = du_a/dx_b at points: (n, 2, 2), 1/s. Its trace is zero."""
        arm = as_array(points) - self.centre
        spin = np.array([[0.0, -1.0], [1.0, 0.0]])
        slope = -2 * self.shear * self.speed / self.radius**2 * arm
        return as_array(
            self._speed_of(arm)[:, None, None] * spin
            + self._turned(arm)[:, :, None] * slope[:, None, :]
        )

    def positions(self, start: npt.ArrayLike, t: float) -> Array:
        """Where points that started at start (n, 2) are at time t (which may be negative)."""
        arm = as_array(start) - self.centre
        angle = self._speed_of(arm) * t
        return _rotate(arm, angle) + as_array(self.centre)

    def deformation_gradient(self, start: npt.ArrayLike, t: float) -> Array:
        """F = dx/dX of points that started at start: (n, 2, 2). Its determinant is one."""
        arm = as_array(start) - self.centre
        angle = self._speed_of(arm) * t
        cosine, sine = np.cos(angle), np.sin(angle)
        rotation = np.stack(
            [np.stack([cosine, -sine], axis=-1), np.stack([sine, cosine], axis=-1)], axis=-2
        )
        slope = -2 * self.shear * self.speed * t / self.radius**2 * arm
        return as_array(
            rotation + self._turned(_rotate(arm, angle))[:, :, None] * slope[:, None, :]
        )

    def temperature(self, points: npt.ArrayLike, t: Times) -> Array:
        """Temperature at present positions (n, 2): (n,) or (m, n), K."""
        arm = as_array(points) - self.centre
        return self.radial.temperature(np.hypot(arm[:, 0], arm[:, 1]), t)

    @cached_property
    def radial(self) -> RadialSolution:
        """The radial solution (solved once), for heat contents and mean values."""
        return RadialSolution(
            RadialProblem(
                inner=0.0,
                outer=self.radius,
                dimension=2,
                at_outer=self.boundary,
                initial=self.initial,
                medium=self.medium,
            )
        )

    def _speed_of(self, arm: Array) -> Array:
        return self.angular_velocity(np.hypot(arm[:, 0], arm[:, 1]))

    @staticmethod
    def _turned(arm: Array) -> Array:
        return np.stack([-arm[:, 1], arm[:, 0]], axis=-1)


def _rotate(arm: Array, angle: Array) -> Array:
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.stack(
        [cosine * arm[:, 0] - sine * arm[:, 1], sine * arm[:, 0] + cosine * arm[:, 1]], axis=-1
    )
