"""What every heat reference shares: the medium, and the four kinds of thermal boundary.

Signs: a flux is counted INWARD (positive heats the body), a convective boundary takes in
coefficient (ambient - T). The paper of the virtual heat flux method prints the opposite sign
in Eq. 5, B3 (inner side) and D2 (x = 0, y = 0), which would let heat flow in when the body is
hotter than its surroundings; Eq. A3, A9 and the results follow the sign used here.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Medium:
    """A uniform, isotropic conductor."""

    density: float = 1.0  # kg/m^3
    specific_heat: float = 1.0  # J/(kg K)
    conductivity: float = 1.0  # W/(m K)

    def __post_init__(self) -> None:
        for name in ("density", "specific_heat", "conductivity"):
            value = getattr(self, name)
            if not 0 < value < float("inf"):
                raise ValueError(f"{name} must be positive and finite, got {value}")

    @property
    def capacity(self) -> float:
        """Heat capacity per volume rho c, J/(m^3 K)."""
        return self.density * self.specific_heat

    @property
    def diffusivity(self) -> float:
        """alpha = kappa / (rho c), m^2/s."""
        return self.conductivity / self.capacity


@dataclass(frozen=True)
class Insulated:
    """No heat crosses the boundary."""


@dataclass(frozen=True, kw_only=True)
class Flux:
    """A constant heat flux."""

    inward: float  # W/m^2, positive heats the body


@dataclass(frozen=True, kw_only=True)
class Convection:
    """A flux coefficient (ambient - T) into the body."""

    coefficient: float  # W/(m^2 K)
    ambient: float  # K

    def __post_init__(self) -> None:
        if not 0 <= self.coefficient < float("inf"):
            raise ValueError(f"coefficient must be finite and >= 0, got {self.coefficient}")


@dataclass(frozen=True, kw_only=True)
class Prescribed:
    """A constant temperature of the boundary itself."""

    temperature: float  # K


Boundary = Insulated | Flux | Convection | Prescribed

INSULATED = Insulated()
UNIT_MEDIUM = Medium()
