"""Published laws for the collapse of a dry granular column onto a flat floor, plane flow.

A column of height H0 and half width (or width against a wall) L0, aspect a = H0/L0, comes to rest
with reach L:

    (L - L0)/L0 = linear a  for small a,  power a^(2/3)  for large a

Fits to experiments, so bands rather than laws: materials scatter by tens of per cent and the walls
of the channel matter (Balmforth & Kerswell, J. Fluid Mech. 538 (2005) 399, find run-out exponents
0.65 in narrow slots and 0.9 in wide channels, with factors that depend on the material).

Lube et al., Phys. Rev. E 72 (2005) 041301 (sand, rice, sugar); Lajeunesse et al., Phys. Fluids 17
(2005) 103302 (glass beads). The coefficients are second hand, as quoted from Lagree, Staron &
Popinet, J. Fluid Mech. 686 (2011) 378, Eq. 3.1 and 3.2; the originals were not at hand. A height
law of Lajeunesse is left out, since no coefficient for it could be confirmed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from lapilli.references.arrays import Array, as_array


@dataclass(frozen=True, kw_only=True)
class RunOutLaw:
    """One fit of the run-out; neither branch is claimed between `small` and `large`."""

    source: str
    linear: float
    power: float
    small: float  # aspect up to which the linear branch was fitted
    large: float  # aspect from which the power branch was fitted

    def run_out(self, aspect: npt.ArrayLike) -> Array:
        """(L - L0)/L0 at aspects a > 0, same shape; linear between the branches in the gap."""
        a = as_array(aspect)
        _require_positive(a)
        low, high = self.linear * a, self.power * a ** (2 / 3)
        if self.small == self.large:
            return np.where(a <= self.small, low, high)
        ends = np.array([self.linear * self.small, self.power * self.large ** (2 / 3)])
        gap = np.interp(a, [self.small, self.large], ends)
        return as_array(np.where(a <= self.small, low, np.where(a >= self.large, high, gap)))


LUBE_2005 = RunOutLaw(
    source="Lube et al. 2005",
    linear=1.2,
    power=1.9,
    small=1.8,
    large=2.8,
)
LAJEUNESSE_2005 = RunOutLaw(
    source="Lajeunesse et al. 2005",
    linear=1.8,
    power=2.3,
    small=3.0,
    large=3.0,
)


def run_out_band(aspect: npt.ArrayLike) -> tuple[Array, Array]:
    """Smallest and largest (L - L0)/L0 of both sources at aspects a > 0, each of that shape."""
    both = np.stack([law.run_out(aspect) for law in (LUBE_2005, LAJEUNESSE_2005)])
    return both.min(axis=0), both.max(axis=0)


def lube_final_height(aspect: npt.ArrayLike) -> Array:
    """Final height over L0 after Lube et al. 2005: a for a <= 1 (no change), a^(2/5) above."""
    a = as_array(aspect)
    _require_positive(a)
    return as_array(np.where(a <= 1, a, a**0.4))


def _require_positive(aspect: Array) -> None:
    if np.any(aspect <= 0):
        raise ValueError(f"the aspect ratio must be positive, got {aspect.min()}")
