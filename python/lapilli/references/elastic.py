"""Closed-form states of linear elasticity in plane strain, small strains, for quasi-static tests.

Pressurised cylinder and annulus (Lame; Timoshenko & Goodier, Theory of Elasticity, 3rd ed.,
section 28), a column under its own weight between frictionless walls, and the contained block of
Cortis et al. 2018 (implicit boundaries), section 5.1. Stresses are positive in tension.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from lapilli.references.arrays import Array, as_array


@dataclass(frozen=True, kw_only=True)
class Elastic:
    """An isotropic linear elastic solid."""

    young: float = 1000.0  # Pa (any consistent unit)
    poisson: float = 0.3  # 1

    def __post_init__(self) -> None:
        if not self.young > 0 or not -1 < self.poisson < 0.5:
            raise ValueError(
                f"need young > 0 and -1 < poisson < 0.5, got {self.young} and {self.poisson}"
            )

    @property
    def shear(self) -> float:
        """Shear modulus G."""
        return self.young / (2 * (1 + self.poisson))

    @property
    def lame(self) -> float:
        """First Lame constant lambda."""
        return self.young * self.poisson / ((1 + self.poisson) * (1 - 2 * self.poisson))

    @property
    def confined(self) -> float:
        """Modulus of uniaxial strain M = lambda + 2 G."""
        return self.lame + 2 * self.shear

    def plane_strain(self) -> Array:
        """Matrix (3, 3) from (e_xx, e_yy, 2 e_xy) to (s_xx, s_yy, s_xy)."""
        m, k, g = self.confined, self.lame, self.shear
        return np.array([[m, k, 0.0], [k, m, 0.0], [0.0, 0.0, g]])


@dataclass(frozen=True, kw_only=True)
class RadialState:
    """Axisymmetric plane-strain state at radii r; all arrays have the shape of r."""

    displacement: Array  # m, positive outward
    radial: Array  # Pa
    hoop: Array  # Pa
    axial: Array  # Pa, out of plane


@dataclass(frozen=True, kw_only=True)
class Annulus:
    """Ring inner <= r <= outer with the Lame field u = stretch r + ring/r, no load in between."""

    inner: float  # m
    outer: float  # m
    material: Elastic
    stretch: float  # 1
    ring: float  # m^2

    @classmethod
    def under_pressure(
        cls,
        inner: float,
        outer: float,
        *,
        inner_pressure: float = 0.0,
        outer_pressure: float = 0.0,
        material: Elastic,
    ) -> Annulus:
        """Thick cylinder: pressures (Pa, positive pushes on the wall) inside and outside."""
        wall = outer**2 - inner**2
        uniform = (inner_pressure * inner**2 - outer_pressure * outer**2) / wall
        varying = (inner_pressure - outer_pressure) * inner**2 * outer**2 / wall
        return cls(
            inner=inner,
            outer=outer,
            material=material,
            stretch=uniform / (2 * (material.lame + material.shear)),
            ring=varying / (2 * material.shear),
        )

    @classmethod
    def under_displacement(
        cls,
        inner: float,
        outer: float,
        *,
        inner_displacement: float,
        outer_displacement: float = 0.0,
        material: Elastic,
    ) -> Annulus:
        """Radial displacements (m, outward) given on both circles; zero is a roller."""
        stretch, ring = np.linalg.solve(
            np.array([[inner, 1 / inner], [outer, 1 / outer]]),
            np.array([inner_displacement, outer_displacement]),
        )
        return cls(
            inner=inner, outer=outer, material=material, stretch=float(stretch), ring=float(ring)
        )

    def at(self, r: npt.ArrayLike) -> RadialState:
        """Displacement and stresses at radii r."""
        r = as_array(r)
        uniform = 2 * (self.material.lame + self.material.shear) * self.stretch
        varying = 2 * self.material.shear * self.ring / r**2
        return RadialState(
            displacement=self.stretch * r + self.ring / r,
            radial=uniform - varying,
            hoop=uniform + varying,
            axial=np.full(r.shape, 2 * self.material.lame * self.stretch),
        )

    def strain_energy(self) -> float:
        """Elastic energy of the full ring per metre of depth, J/m.

        Half the work of the wall tractions: pi (outer s_r u - inner s_r u).
        """
        ends = np.array([self.inner, self.outer])
        state = self.at(ends)
        work = ends * state.radial * state.displacement
        return float(np.pi * (work[1] - work[0]))


@dataclass(frozen=True, kw_only=True)
class SelfWeightColumn:
    """Column 0 <= y <= height between frictionless walls, base held in y, top free.

    One-dimensional strain: M u'' = weight, u(0) = 0, u'(height) = 0.
    """

    height: float  # m
    weight: float  # N/m^3, positive pulls down
    material: Elastic

    def displacement(self, y: npt.ArrayLike) -> Array:
        """Upward displacement at heights y (negative), m."""
        y = as_array(y)
        return -(self.weight / self.material.confined) * (self.height * y - y**2 / 2)

    def vertical_stress(self, y: npt.ArrayLike) -> Array:
        """s_yy at heights y, Pa (compression is negative)."""
        return -self.weight * (self.height - as_array(y))

    def lateral_stress(self, y: npt.ArrayLike) -> Array:
        """s_xx at heights y, Pa: s_yy lambda/M, the walls' reaction."""
        return self.vertical_stress(y) * (self.material.lame / self.material.confined)

    def compliance(self, width: float = 1.0) -> float:
        """Work of the weight on its displacement, weight^2 height^3 width/(3 M), J/m."""
        return self.weight**2 * self.height**3 * width / (3 * self.material.confined)


def contained_block(
    displacement: float, size: float, material: Elastic
) -> tuple[float, float, float]:
    """Stresses (normal, transverse, shear) of a block stretched uniaxially between three rollers.

    displacement: of the fourth side along its outward normal, m; size: of the block along it, m.
    Cortis et al. 2018, section 5.1, call 1 mm outward a compression; only magnitudes are compared.
    """
    strain = displacement / size
    return material.confined * strain, material.lame * strain, 0.0
