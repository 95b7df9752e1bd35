"""Heat conduction in r alone: slab (d = 1), disc and ring (d = 2), ball and hollow sphere (d = 3).

    rho c dT/dt = r^(1-d) d/dr (r^(d-1) kappa dT/dr),   inner < r < outer

with any of the four thermal boundaries on either side and any initial field. Problems of this
kind: Yu & Zhao 2026, sections 4.2 (ring) and 4.3 (sphere), appendices B and C.

Method: Galerkin with polynomials up to a degree (default 96) and the weight r^(d-1), integrated
exactly; the semi-discrete system is linear with constant coefficients and is solved EXACTLY in
time in its eigenvectors, so there is no time step. Heat is conserved to rounding, because the
functions sum to one. This replaces a fine finite-volume grid with time stepping: the error falls
exponentially with the degree as soon as the thermal layer sqrt(alpha t) is resolved (the functions
crowd at the walls like 1/degree^2). `estimated_error` measures it for the case at hand.

Not handled: properties or boundary data that vary in time, sources, non-linear laws.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from numpy.polynomial import legendre
from scipy.linalg import eigh

from lapilli.references.arrays import Array, Times, as_array, at_times
from lapilli.references.thermal import (
    INSULATED,
    UNIT_MEDIUM,
    Boundary,
    Convection,
    Flux,
    Insulated,
    Medium,
    Prescribed,
)

InitialTemperature = float | Callable[[Array], Array]
UNIT_SPHERE = {1: 1.0, 2: 2 * np.pi, 3: 4 * np.pi}  # area = UNIT_SPHERE[d] r^(d-1)


@dataclass(frozen=True, kw_only=True)
class RadialProblem:
    """A layer inner <= r <= outer in d dimensions, its boundaries and its start."""

    inner: float  # m; 0 is the centre (or, for d = 1, a plane) and must be insulated if d > 1
    outer: float  # m
    dimension: int  # 1, 2 or 3
    at_inner: Boundary = INSULATED
    at_outer: Boundary = INSULATED
    initial: InitialTemperature = 0.0  # K; a function maps radii (n,) to temperatures (n,)
    medium: Medium = UNIT_MEDIUM

    def __post_init__(self) -> None:
        if self.dimension not in UNIT_SPHERE:
            raise ValueError(f"dimension must be 1, 2 or 3, got {self.dimension}")
        if not 0 <= self.inner < self.outer < float("inf"):
            raise ValueError(f"need 0 <= inner < outer, got inner {self.inner}, outer {self.outer}")
        if self.inner == 0 and self.dimension > 1 and not isinstance(self.at_inner, Insulated):
            raise ValueError(
                f"the centre r = 0 has no surface: at_inner must be Insulated(), got "
                f"{self.at_inner}"
            )

    def area(self, r: float) -> float:
        """Surface at radius r: m^2 (d = 3), m^2 per metre of depth (d = 2), 1 (d = 1)."""
        return float(UNIT_SPHERE[self.dimension] * r ** (self.dimension - 1))

    def initial_temperature(self, r: Array) -> Array:
        """The given start at radii r, same shape."""
        if callable(self.initial):
            return as_array(self.initial(r))
        return np.full(r.shape, float(self.initial))


class RadialSolution:
    """The solution of a RadialProblem; every quantity can be asked for at any time.

    A scalar time gives the plain shape, n times give a leading axis of length n.
    Heat is in J (d = 3), J per metre of depth (d = 2) or J per area (d = 1).
    """

    def __init__(self, problem: RadialProblem, degree: int = 96) -> None:
        if degree < 4:
            raise ValueError(f"degree must be at least 4, got {degree}")
        self.problem = problem
        self.degree = degree
        self._to_legendre = _integrated_legendre(degree)
        self._assemble()
        self._diagonalise()

    def temperature(self, r: npt.ArrayLike, t: Times) -> Array:
        """Temperature at radii r (any shape S): shape S or (n, *S), K. At t = 0 the given start."""
        r = as_array(r)
        slack = 1e-9 * self.problem.outer
        if np.any(r < self.problem.inner - slack) or np.any(r > self.problem.outer + slack):
            raise ValueError(
                f"radii must lie in [{self.problem.inner}, {self.problem.outer}], got "
                f"[{r.min()}, {r.max()}]"
            )

        def field(time: float) -> Array:
            if time == 0:
                return self.problem.initial_temperature(r)
            coefficients = self._to_legendre @ self._coefficients(time)
            return as_array(legendre.legval(self._reference(r), coefficients))

        return at_times(field, t)

    def flux(self, r: npt.ArrayLike, t: Times) -> Array:
        """Radial heat flux -kappa dT/dr (outward in r): shape S or (n, *S), W/m^2. For t > 0."""
        r = as_array(r)
        stretch = 2 / (self.problem.outer - self.problem.inner)

        def field(time: float) -> Array:
            slope = legendre.legder(self._to_legendre @ self._coefficients(time))
            gradient = stretch * legendre.legval(self._reference(r), slope)
            return as_array(-self.problem.medium.conductivity * gradient)

        return at_times(field, t)

    def heat_content(self, t: Times) -> Array:
        """Integral of rho c T over the layer."""

        def content(time: float) -> Array:
            if time == 0:
                return as_array(self._load_initial[:2].sum())
            return as_array(self._mass[:2].sum(axis=0) @ self._coefficients(time))

        return at_times(content, t)

    def heat_taken_in(self, t: Times) -> Array:
        """Heat that came in until t through (inner, outer): shape (2,) or (n, 2).

        For a prescribed temperature it is the consistent reaction of the Galerkin system, so that
        content(t) - content(0) equals the sum of both to rounding for every kind of boundary.
        """
        return at_times(self._intake, t)

    def mean_temperature(self, t: Times) -> Array:
        """Volume mean of the temperature, K."""
        return self.heat_content(t) / float(self._mass[:2, :2].sum())

    def estimated_error(self, t: Times, relative_degree: float = 0.75) -> float:
        """Largest difference to the solution of a lower degree, over the span of values.

        Compared at 200 radii and the given times. The span is the largest minus the smallest
        temperature among start, ambients, prescribed values and the solution.
        """
        coarse = RadialSolution(self.problem, max(4, int(relative_degree * self.degree)))
        r = np.linspace(self.problem.inner, self.problem.outer, 200)
        here, there = self.temperature(r, t), coarse.temperature(r, t)
        seen = np.concatenate([here.ravel(), self.problem.initial_temperature(r)])
        for boundary in (self.problem.at_inner, self.problem.at_outer):
            if isinstance(boundary, Convection):
                seen = np.append(seen, boundary.ambient)
            if isinstance(boundary, Prescribed):
                seen = np.append(seen, boundary.temperature)
        span = float(np.ptp(seen))
        difference = float(np.max(np.abs(here - there)))
        return difference / span if span > 0 else difference

    def _reference(self, r: Array) -> Array:
        """Radius to the interval [-1, 1]."""
        low, high = self.problem.inner, self.problem.outer
        return np.clip((2 * r - low - high) / (high - low), -1.0, 1.0)

    def _assemble(self) -> None:
        """Mass, stiffness (with convection) and load. Functions 0 and 1 are the two ends."""
        problem, medium = self.problem, self.problem.medium
        low, high = problem.inner, problem.outer
        xi, weight = legendre.leggauss(2 * self.degree + 4)
        r = 0.5 * (low + high) + 0.5 * (high - low) * xi
        volume = 0.5 * (high - low) * weight * UNIT_SPHERE[problem.dimension]
        volume = volume * r ** (problem.dimension - 1)
        values = legendre.legvander(xi, self.degree) @ self._to_legendre
        slopes = legendre.legval(xi, legendre.legder(self._to_legendre)).T * 2 / (high - low)

        self._mass = medium.capacity * (values.T * volume) @ values
        self._stiffness = medium.conductivity * (slopes.T * volume) @ slopes
        self._load = np.zeros(self.degree + 1)
        self._load_initial = medium.capacity * values.T @ (volume * problem.initial_temperature(r))
        self._prescribed: list[int] = []
        self._ends = np.zeros(self.degree + 1)
        for end, (boundary, radius) in enumerate(
            [(problem.at_inner, low), (problem.at_outer, high)]
        ):
            area = problem.area(radius)
            if isinstance(boundary, Flux):
                self._load[end] += area * boundary.inward
            elif isinstance(boundary, Convection):
                self._stiffness[end, end] += area * boundary.coefficient
                self._load[end] += area * boundary.coefficient * boundary.ambient
            elif isinstance(boundary, Prescribed):
                self._prescribed.append(end)
                self._ends[end] = boundary.temperature

    def _diagonalise(self) -> None:
        """K v = lambda M v on the free functions; start and load in eigenvectors."""
        free = np.setdiff1d(np.arange(self.degree + 1), self._prescribed)
        self._free = free
        self._rates, self._modes = eigh(
            self._stiffness[np.ix_(free, free)], self._mass[np.ix_(free, free)]
        )
        self._rates = np.maximum(self._rates, 0.0)
        sides = (self.problem.at_inner, self.problem.at_outer)
        if all(isinstance(side, Insulated | Flux) for side in sides):
            # the uniform field is a mode of rate exactly zero, so that heat adds up to rounding
            self._rates[0] = 0.0
            self._modes[:, 0] = 0.0
            self._modes[:2, 0] = 1 / np.sqrt(self._mass[:2, :2].sum())
        start = self._load_initial - self._mass @ self._ends
        drive = self._load - self._stiffness @ self._ends
        self._start = self._modes.T @ start[free]
        self._drive = self._modes.T @ drive[free]

    def _coefficients(self, time: float) -> Array:
        """Coefficients of all functions at a time."""
        phi_0, phi_1, _ = _exponential_integrals(-self._rates * time)
        result = self._ends.copy()
        result[self._free] = self._modes @ (phi_0 * self._start + time * phi_1 * self._drive)
        return result

    def _intake(self, time: float) -> Array:
        _, phi_1, phi_2 = _exponential_integrals(-self._rates * time)
        integral = self._ends * time
        integral[self._free] += self._modes @ (
            time * phi_1 * self._start + time**2 * phi_2 * self._drive
        )
        taken = np.zeros(2)
        ends = (
            (self.problem.at_inner, self.problem.inner),
            (self.problem.at_outer, self.problem.outer),
        )
        for end, (boundary, radius) in enumerate(ends):
            area = self.problem.area(radius)
            if isinstance(boundary, Flux):
                taken[end] = area * boundary.inward * time
            elif isinstance(boundary, Convection):
                taken[end] = area * boundary.coefficient * (boundary.ambient * time - integral[end])
            elif isinstance(boundary, Prescribed) and time > 0:
                stored = self._mass[end] @ self._coefficients(time) - self._load_initial[end]
                taken[end] = stored + self._stiffness[end] @ integral
        return taken


def _integrated_legendre(degree: int) -> Array:
    """Columns: the two end functions (1 -+ xi)/2 and the bubbles, in Legendre coefficients.

    Bubble k is (P_(k+1) - P_(k-1))/sqrt(4 k + 2): zero at both ends, slopes orthogonal for d = 1.
    """
    columns = np.zeros((degree + 1, degree + 1))
    columns[:2, 0] = (0.5, -0.5)
    columns[:2, 1] = (0.5, 0.5)
    for k in range(1, degree):
        columns[k + 1, k + 1] = 1 / np.sqrt(4 * k + 2)
        columns[k - 1, k + 1] = -1 / np.sqrt(4 * k + 2)
    return columns


def _exponential_integrals(z: Array) -> tuple[Array, Array, Array]:
    """phi_0 = exp z, phi_1 = (phi_0 - 1)/z, phi_2 = (phi_1 - 1)/z for z <= 0, limits 1 and 1/2."""
    small = np.abs(z) < 1e-2
    safe = np.where(small, -1.0, z)
    phi_1 = np.where(
        small, 1 + z / 2 * (1 + z / 3 * (1 + z / 4 * (1 + z / 5))), np.expm1(safe) / safe
    )
    series = 0.5 * (1 + z / 3 * (1 + z / 4 * (1 + z / 5 * (1 + z / 6))))
    return np.exp(z), phi_1, np.where(small, series, (phi_1 - 1) / safe)
