"""Displacements of the scenes in `examples/ib`, as functions of present positions and time.

For `lapilli tradeoff`: `--reference lapilli.references.supports:block --field displacement`. A
point that is now at x was at x - u(x); the fields are those of the scenes as they stand.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from scipy.interpolate import RegularGridInterpolator

from lapilli.references.arrays import Array
from lapilli.references.elastic import Annulus, Elastic
from lapilli.references.plane_strain import solve_rectangle

MATERIAL = Elastic(young=1e9, poisson=0.3)


def block(position: Array, time: float, degrees: float = 30.0) -> Array:
    """The contained block: stretched by 1 % along its first side."""
    e1 = np.array([np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))])
    strain = 0.01 * time
    field: Array = (position @ e1 * strain / (1 + strain))[:, None] * e1
    return field


def annulus(position: Array, time: float) -> Array:
    """Lame's ring, its hole widened by 0.01 mm."""
    ring = Annulus.under_displacement(0.012, 0.04, inner_displacement=1e-5, material=MATERIAL)
    now = np.linalg.norm(position, axis=1)
    start = now
    for _ in range(4):
        start = now - time * ring.at(start).displacement
    field: Array = (time * ring.at(start).displacement / now)[:, None] * position
    return field


def cantilever(position: Array, time: float, degrees: float = 45.0) -> Array:
    """The cantilever under 1e5 N/m^3, where it is linear; by finite elements of 0.25 mm."""
    e1 = np.array([np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))])
    axes = np.stack([e1, [-e1[1], e1[0]]])
    local = position @ axes.T + [0.0, 0.01]
    local = np.clip(local, [0.0, 0.0], [0.1, 0.02])
    moved: Array = time * _deflection()(local) @ axes
    return moved


@cache
def _deflection() -> RegularGridInterpolator:
    """Held at its right end."""
    cell = 0.00025
    found = solve_rectangle(
        (0.1, 0.02), cell, body_force=(0.0, -1e5), held="right", material=MATERIAL
    ).displacement
    axes = [cell * np.arange(count) for count in found.shape[:2]]
    return RegularGridInterpolator(tuple(axes), found)
