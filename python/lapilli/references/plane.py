"""Heat conduction in any union of equal rectangular cells in the plane (L-shape, square, ...).

    rho c dT/dt = div(kappa grad T),   kappa dT/dn by one of the four thermal boundaries per side

Method: finite volumes around the nodes (corners of the cells). Each cell gives a quarter of its
capacity to each of its nodes and conducts along its four edges; each side of the outline takes in
heat at its two nodes. Second order in the cell size, where a re-entrant corner of 270 degrees
leaves h^(4/3) in its neighbourhood; heat is conserved to rounding. In time TR-BDF2.

Serves the corner tests: L-shape of side 10 with convection. Not handled: curved outlines, several
materials, boundary data that vary in time.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array, csc_array

from lapilli.references.arrays import Array, as_array
from lapilli.references.implicit_steps import integrate
from lapilli.references.thermal import (
    INSULATED,
    UNIT_MEDIUM,
    Boundary,
    Convection,
    Flux,
    Medium,
    Prescribed,
)

# sides of a cell: neighbour in the mask, and the two nodes, as offsets
SIDES = {
    "left": ((-1, 0), ((0, 0), (0, 1))),
    "right": ((1, 0), ((1, 0), (1, 1))),
    "bottom": ((0, -1), ((0, 0), (1, 0))),
    "top": ((0, 1), ((0, 1), (1, 1))),
}


@dataclass(frozen=True, kw_only=True)
class PlaneProblem:
    """Cells, outline and start."""

    cells: npt.NDArray[np.bool_]  # (nx, ny), True where there is material
    cell: tuple[float, float]  # m
    lower: tuple[float, float] = (0.0, 0.0)  # m, corner of cell (0, 0)
    boundary: Boundary = INSULATED  # on every side of the outline not named in `sides`
    sides: dict[str, Boundary] = field(default_factory=dict)  # left, right, bottom, top: facing it
    initial: float = 0.0  # K
    medium: Medium = UNIT_MEDIUM

    def __post_init__(self) -> None:
        if self.cells.ndim != 2 or not self.cells.any():
            raise ValueError(f"cells must be a 2D mask with material, got shape {self.cells.shape}")
        unknown = set(self.sides) - set(SIDES)
        if unknown:
            raise ValueError(f"sides must be among {sorted(SIDES)}, got {sorted(unknown)}")


class PlaneSolution:
    """Nodal temperatures of a PlaneProblem at given times.

    times: ascending, s. step: largest time step, s; default the last time / 100.
    temperature: (m, nx + 1, ny + 1), K, NaN at nodes without material. nodes: their positions,
    (nx + 1, ny + 1, 2), m. capacity: heat capacity of each node, J/(K m).
    """

    def __init__(
        self, problem: PlaneProblem, times: npt.ArrayLike, step: float | None = None
    ) -> None:
        self.problem = problem
        self.times = np.atleast_1d(as_array(times))
        shape = (problem.cells.shape[0] + 1, problem.cells.shape[1] + 1)
        self.nodes = np.stack(
            np.meshgrid(
                *(problem.lower[k] + problem.cell[k] * np.arange(shape[k]) for k in range(2)),
                indexing="ij",
            ),
            axis=-1,
        )
        capacity, stiffness, load, held = _assemble(problem, shape)
        self.capacity = capacity.reshape(shape)

        values = np.where(np.isnan(held), problem.initial, held)
        free = np.flatnonzero((capacity > 0) & np.isnan(held))
        coupling = stiffness @ np.where(np.isnan(held), 0.0, held)
        steps = integrate(
            capacity[free],
            csc_array(stiffness[free][:, free]),
            (load - coupling)[free],
            values[free],
            self.times,
            step or float(self.times[-1]) / 100,
        )
        result = np.tile(np.where(capacity > 0, values, np.nan), (len(self.times), 1))
        result[:, free] = steps
        self.temperature = result.reshape(len(self.times), *shape)

    def at(self, points: npt.ArrayLike) -> Array:
        """Bilinear interpolation at points (n, 2) inside the material: (m, n), K."""
        points = as_array(points)
        place = (points - self.problem.lower) / self.problem.cell
        corner = np.clip(np.floor(place).astype(int), 0, np.array(self.problem.cells.shape) - 1)
        s = place - corner
        result = np.zeros((len(self.times), len(points)))
        for i in (0, 1):
            for j in (0, 1):
                weight = np.abs(1 - i - s[:, 0]) * np.abs(1 - j - s[:, 1])
                value = self.temperature[:, corner[:, 0] + i, corner[:, 1] + j]
                result += np.where(weight > 1e-9, weight * value, 0.0)
        if np.any(np.isnan(result)) or np.any(s < -1e-9) or np.any(s > 1 + 1e-9):
            raise ValueError("points must lie inside the material")
        return result

    def heat_content(self) -> Array:
        """Integral of rho c T per metre of depth, (m,), J/m."""
        return as_array(np.nansum(self.capacity * self.temperature, axis=(1, 2)))


def l_shape(cells_per_side: int = 200, side: float = 10.0) -> PlaneProblem:
    """The L of the corner tests: a square centred at the origin less its quadrant x > 0, y > 0.

    Convection of 1 W/(m^2 K) to 1 K on the whole outline, start 0 K, unit medium. At t = 5 s and
    200 cells the error is about 1e-5 rms and 2e-4 at the re-entrant corner (100 against 200 cells:
    3.5e-5 and 3.1e-4; 0.14 from that corner 9e-5 and less beyond).
    """
    if cells_per_side % 2:
        raise ValueError(f"cells_per_side must be even, got {cells_per_side}")
    cells = np.ones((cells_per_side, cells_per_side), dtype=np.bool_)
    cells[cells_per_side // 2 :, cells_per_side // 2 :] = False
    h = side / cells_per_side
    return PlaneProblem(
        cells=cells,
        cell=(h, h),
        lower=(-side / 2, -side / 2),
        boundary=Convection(coefficient=1.0, ambient=1.0),
    )


def _assemble(
    problem: PlaneProblem, shape: tuple[int, int]
) -> tuple[Array, csc_array, Array, Array]:
    """Capacity (n,), stiffness with convection (n, n), load (n,), prescribed values (n,) or NaN."""
    size = shape[0] * shape[1]
    number = np.arange(size).reshape(shape)
    hx, hy = problem.cell
    i, j = np.nonzero(problem.cells)
    corners = {(a, b): number[i + a, j + b] for a in (0, 1) for b in (0, 1)}

    capacity = np.zeros(size)
    for nodes in corners.values():
        np.add.at(capacity, nodes, problem.medium.capacity * hx * hy / 4)

    rows: list[npt.NDArray[np.int_]] = []
    columns: list[npt.NDArray[np.int_]] = []
    values: list[Array] = []

    def add(a: npt.NDArray[np.int_], b: npt.NDArray[np.int_], value: float) -> None:
        rows.append(a)
        columns.append(b)
        values.append(np.full(a.shape, value))

    along = {(1, 0): hy / (2 * hx), (0, 1): hx / (2 * hy)}
    for (da, db), ratio in along.items():
        conductance = problem.medium.conductivity * ratio
        for a, b in ((0, 0), (1 - da, 1 - db)):
            first, second = corners[a, b], corners[a + da, b + db]
            add(first, first, conductance)
            add(second, second, conductance)
            add(first, second, -conductance)
            add(second, first, -conductance)

    load, held = np.zeros(size), np.full(size, np.nan)
    padded = np.pad(problem.cells, 1)
    for side, ((di, dj), ends) in SIDES.items():
        open_side = ~padded[i + 1 + di, j + 1 + dj]
        law = problem.sides.get(side, problem.boundary)
        half = (hy if di else hx) / 2
        for end in ends:
            nodes = corners[end][open_side]
            if isinstance(law, Flux):
                np.add.at(load, nodes, half * law.inward)
            elif isinstance(law, Convection):
                add(nodes, nodes, half * law.coefficient)
                np.add.at(load, nodes, half * law.coefficient * law.ambient)
            elif isinstance(law, Prescribed):
                held[nodes] = law.temperature
    entries = (np.concatenate(rows), np.concatenate(columns))
    stiffness = coo_array((np.concatenate(values), entries), shape=(size, size))
    return capacity, csc_array(stiffness), load, held
