"""Waves in an elastic bar 0 <= x <= length by d'Alembert's solution, with reflections.

    rho du^2/dt^2 = E d^2u/dx^2,   c = sqrt(E/rho)

In the Riemann variables v -+ c e (e = du/dx) every start travels unchanged; a fixed end reflects
the strain with its sign and turns the velocity, a free end does the opposite. So velocity and
strain at any time are two look-ups of the start, extended beyond the ends by reflection.
Large strains, damping and dispersion are not in it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from lapilli.references.arrays import Array, as_array

Profile = Callable[[Array], Array]


def at_rest(x: Array) -> Array:
    """The start that is zero everywhere."""
    return np.zeros_like(x)


@dataclass(frozen=True, kw_only=True)
class Bar:
    """A bar with fixed or free ends and a start given as profiles over [0, length].

    velocity: at t = 0, m/s; strain: du/dx at t = 0. `end_stress` (Pa, tension positive) acts on
    the right end from t = 0 on, if that end is free: the bar then swings about its static state.
    """

    length: float = 1.0  # m
    young: float = 1.0  # Pa
    density: float = 1.0  # kg/m^3
    left_fixed: bool = True
    right_fixed: bool = False
    velocity: Profile = at_rest
    strain: Profile = at_rest
    end_stress: float = 0.0  # Pa

    def __post_init__(self) -> None:
        if self.end_stress and (self.right_fixed or not self.left_fixed):
            raise ValueError("end_stress needs a fixed left and a free right end")

    @property
    def speed(self) -> float:
        """Wave speed c = sqrt(E/rho), m/s."""
        return float(np.sqrt(self.young / self.density))

    def state(self, x: npt.ArrayLike, t: float) -> tuple[Array, Array]:
        """Velocity (m/s) and stress (Pa) at positions x (any shape) and time t."""
        x = as_array(x)
        ahead, behind = self._start(x + self.speed * t), self._start(x - self.speed * t)
        c = self.speed
        velocity = 0.5 * (ahead[0] + behind[0]) + 0.5 * c * (ahead[1] - behind[1])
        strain = 0.5 * (ahead[1] + behind[1]) + 0.5 / c * (ahead[0] - behind[0])
        return velocity, self.young * strain + self.end_stress

    def _start(self, x: Array) -> tuple[Array, Array]:
        """Start (velocity, strain) extended to all x by reflection at both ends."""
        turns = np.floor(x / self.length).astype(int)
        inside = x - turns * self.length
        odd = turns % 2 == 1
        inside = np.where(odd, self.length - inside, inside)
        right_hits = np.where(turns >= 0, (turns + 1) // 2, -turns // 2)
        left_hits = np.where(turns >= 0, turns // 2, (-turns + 1) // 2)
        fixed_hits = self.right_fixed * right_hits + self.left_fixed * left_hits
        free_hits = right_hits + left_hits - fixed_hits
        # a fixed end turns the velocity, a free end the strain
        velocity = self.velocity(inside) * (-1.0) ** fixed_hits
        strain = self.strain(inside) - self.end_stress / self.young
        return as_array(velocity), as_array(strain * (-1.0) ** free_hits)


def standing_wave(bar: Bar, mode: int, amplitude: float) -> Bar:
    """The bar started with the velocity amplitude sin(beta x) of its mode 1, 2, ... (left fixed).

    beta = (mode - 1/2) pi/length for a free right end, mode pi/length for a fixed one. Then
    v = amplitude sin(beta x) cos(beta c t) and stress = E amplitude/c cos(beta x) sin(beta c t).
    """
    if not bar.left_fixed or mode < 1:
        raise ValueError(f"standing waves here have a fixed left end and mode >= 1, got {mode}")
    beta = (mode if bar.right_fixed else mode - 0.5) * np.pi / bar.length
    return Bar(
        length=bar.length,
        young=bar.young,
        density=bar.density,
        right_fixed=bar.right_fixed,
        velocity=lambda x: amplitude * np.sin(beta * x),
    )
