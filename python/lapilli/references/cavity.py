"""Steady buoyant flow in a closed box, Boussinesq: cavity heated from the side, layer from below.

In units of the distance l between the hot and the cold wall, alpha/l for velocity, l^2/alpha for
time and the temperature difference of the walls (hot 1, cold 0, the other two walls adiabatic, all
four at rest), with u = dpsi/dy, v = -dpsi/dx, omega = dv/dx - du/dy and y upward:

    laplace psi = -omega
    u domega/dx + v domega/dy = Pr laplace omega + Ra Pr dT/dx
    u dT/dx + v dT/dy = laplace T

Method: central differences on nodes, Thom's wall vorticity -2 psi_1/h^2, mirror values at
adiabatic walls; all of it second order with even powers of h, so that two grids extrapolate
(`extrapolated`). Solved by Newton's method with sparse LU, started by implicit pseudo-time steps
that grow as the residual falls. It shares nothing with a particle method: no compressibility, no
sound, no time.

Measured at 40 and 80 cells: within 0.09 % of de Vahl Davis (below) in all nine numbers. Conduction
alone (Ra = 0, or gravity off) is slab.prescribed_slab. Not handled: time
dependence, variable properties, the choice between several steady states (a start with `rolls`
decides).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from lapilli.references.cavity_equations import Equations
from lapilli.references.cavity_flow import Box, Flow

__all__ = ["DE_VAHL_DAVIS", "Benchmark", "Box", "Extrapolated", "Flow", "extrapolated", "solve"]

EASY = 1e4  # Rayleigh number up to which the plain guess leads to the solution


@dataclass(frozen=True, kw_only=True)
class Benchmark:
    """Published values for the square cavity heated from the side."""

    nusselt: float  # mean
    horizontal_peak: float  # largest u on the vertical mid-line, alpha/l
    horizontal_peak_at: float  # its y/l
    vertical_peak: float  # largest v on the horizontal mid-line, alpha/l
    vertical_peak_at: float  # its x/l


# de Vahl Davis, Int. J. Numer. Meth. Fluids 3 (1983) 249; Pr = 0.71; by Rayleigh number
DE_VAHL_DAVIS = {
    1e3: Benchmark(
        nusselt=1.118,
        horizontal_peak=3.649,
        horizontal_peak_at=0.813,
        vertical_peak=3.697,
        vertical_peak_at=0.178,
    ),
    1e4: Benchmark(
        nusselt=2.243,
        horizontal_peak=16.178,
        horizontal_peak_at=0.823,
        vertical_peak=19.617,
        vertical_peak_at=0.119,
    ),
    1e5: Benchmark(
        nusselt=4.519,
        horizontal_peak=34.73,
        horizontal_peak_at=0.855,
        vertical_peak=68.59,
        vertical_peak_at=0.066,
    ),
}


@dataclass(frozen=True, kw_only=True)
class Extrapolated:
    """Values for h -> 0 from two grids, and how far the finer grid is from them."""

    nusselt: float
    horizontal_peak: float
    vertical_peak: float
    correction: float  # largest relative difference between the finer grid and these


def extrapolated(box: Box, cells: int = 80) -> Extrapolated:
    """Richardson extrapolation from `cells`/2 and `cells` cells between the hot and cold wall."""
    coarse = solve(box, cells // 2)
    fine = solve(box, cells, start=coarse)
    values = [
        np.array([flow.nusselt(), flow.horizontal_peak()[0], flow.vertical_peak()[0]])
        for flow in (coarse, fine)
    ]
    limit = values[1] + (values[1] - values[0]) / 3
    return Extrapolated(
        nusselt=float(limit[0]),
        horizontal_peak=float(limit[1]),
        vertical_peak=float(limit[2]),
        correction=float(np.max(np.abs(values[1] - limit) / np.maximum(np.abs(limit), 1e-3))),
    )


def solve(box: Box, cells: int = 40, *, start: Flow | None = None) -> Flow:
    """The steady flow with square cells, `cells` (even) from the hot to the cold wall.

    start: another solution to begin with (other grid, other Rayleigh number); without it coarser
    grids and smaller Rayleigh numbers are solved first. Raises RuntimeError if the iteration does
    not converge.
    """
    if cells < 8 or cells % 2:
        raise ValueError(f"cells must be even and at least 8, got {cells}")
    counts = np.rint(np.array(box.size) * cells).astype(int)
    if np.any(np.abs(counts - np.array(box.size) * cells) > 1e-9) or np.any(counts % 2):
        raise ValueError(f"aspect {box.aspect} does not give an even number of cells for {cells}")
    if start is None and cells >= 40 and cells % 4 == 0:
        start = solve(box, cells // 2)
    elif start is None and box.rayleigh > EASY:
        start = solve(replace(box, rayleigh=max(EASY, box.rayleigh / 4)), cells)
    system = Equations(box, int(counts[0]), int(counts[1]))
    return system.solve(system.guess() if start is None else system.taken_from(start))
