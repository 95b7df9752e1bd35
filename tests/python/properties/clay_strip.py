"""A strip pressed into clay, half of it beside its plane of symmetry: where it lies on the grid."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

import lapilli as lp

PRANDTL = np.pi + 2  # times the cohesion, the load that clay bears


@dataclass
class ClayStrip:
    cells: int = 8  # of the grid, over its width
    edge: float = 0.0  # cells, by which its half width is larger than a half
    degrees: float = 0.0
    by: tuple[float, float] = (0.0, 0.0)  # cells
    settlement: float = 0.015  # over its width
    stiffness: float = 1000.0  # Young's modulus over the cohesion
    material: str = "von_mises"
    metre: float = 1.0  # width of the strip
    pascal: float = 1.0  # cohesion

    def at(self, places: Any) -> np.ndarray:
        angle = np.radians(self.degrees)
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        there = np.asarray(places, dtype=float) @ turn.T + np.array(self.by) / self.cells
        return np.asarray(self.metre * there)

    @property
    def half(self) -> float:
        return 0.5 + self.edge / self.cells

    def clay(self) -> lp.VonMises | lp.MohrCoulomb:
        common = {
            "density": 1.0,
            "youngs_modulus": self.stiffness * self.pascal,
            "poissons_ratio": 0.45,
        }
        if self.material == "von_mises":
            return lp.VonMises(**common, yield_stress=float(np.sqrt(3) * self.pascal))
        return lp.MohrCoulomb(**common, friction_angle=0.0, cohesion=self.pascal)
