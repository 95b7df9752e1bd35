"""A uniform stress is one wherever a body lies on the grid and whatever its walls go on to, in the
plane and in space, elastic and flowing: on plain defaults."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pytest

import lapilli as lp

Array = npt.NDArray[np.float64]

YOUNG, POISSON = 1e7, 0.3
PAIRS = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]  # of the columns of a stress


def turn_of(axis: Array, degrees: float) -> Array:
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.radians(degrees)
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)


@dataclass
class Drawn:
    """A block or a simplex of size 1, at any place and angle, four cells across."""

    dimension: int
    seed: int
    simplex: bool = False
    cells: float = 4.0

    def __post_init__(self) -> None:
        rng = np.random.default_rng([self.dimension, self.seed])
        axis = rng.normal(size=3) if self.dimension == 3 else np.array([0.0, 0.0, 1.0])
        self.axis = axis / np.linalg.norm(axis)
        self.degrees = float(rng.uniform(0, 180))
        d = self.dimension
        self.turn = turn_of(self.axis, self.degrees)[:d, :d]
        self.corner = rng.uniform(-0.2, 0.2, d)
        self.pressure = rng.uniform(500, 2000, d)

    def at(self, places: object) -> Array:
        return np.asarray(self.corner + np.asarray(places) @ self.turn.T)

    def shape(self) -> lp.Shape:
        d = self.dimension
        if self.simplex:
            corners = self.at(np.vstack([np.zeros(d), np.eye(d)])).tolist()
            if d == 2:
                return lp.Polygon(vertices=corners)
            return lp.Mesh(vertices=corners, triangles=[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
        box = lp.Box(lower=self.corner.tolist(), upper=(self.corner + 1).tolist())
        about = {"axis": self.axis.tolist()} if d == 3 else {}
        return lp.Rotated(shape=box, degrees=self.degrees, center=self.corner.tolist(), **about)

    def plane(self, place: Array, out: Array) -> lp.HalfSpace:
        """Beyond a face whose outward normal is `out`; it goes on beyond the body."""
        return lp.HalfSpace(
            point=self.at(place).tolist(), normal=(-self.turn @ np.asarray(out)).tolist()
        )

    def scene(self, material: lp.Elastic | lp.VonMises, moved: float = 0.0) -> lp.Scene:
        """Rollers at the lower faces, pressures on the others; the last one may be moved."""
        d, h = self.dimension, 1 / self.cells
        unit = np.eye(d)
        supports = [
            lp.Support(name="xyz"[k], kind="roller", shape=self.plane(0 * unit[k], -unit[k]))
            for k in range(d)
        ]
        if self.simplex:
            self.pressure[:] = self.pressure[0]
            loaded = [(self.plane(unit[0], np.ones(d) / np.sqrt(d)), self.pressure[0])]
        else:
            loaded = [(self.plane(unit[k], unit[k]), self.pressure[k]) for k in range(d)]
        if moved:
            face = loaded.pop()[0]
            supports.append(
                lp.Support(
                    name="press",
                    kind="roller",
                    shape=face,
                    displacement=[
                        lp.Table([0, 1], [0, float(x)]) for x in -moved * self.turn[:, -1]
                    ],
                )
            )
        corners = self.at(np.stack(np.meshgrid(*[[0, 1]] * d), -1).reshape(-1, d))
        low = h * np.floor(corners.min(axis=0) / h) - h
        cells = np.ceil((corners.max(axis=0) + h - low) / h)
        return lp.Scene(
            grid=lp.Grid(lower=low.tolist(), upper=(low + h * cells).tolist(), cell=h),
            bodies=[lp.Body(shape=self.shape(), material=[material])],
            quasi_static=lp.QuasiStatic(
                supports=supports,
                tractions=[
                    lp.SurfaceTraction(
                        name=f"load {k}", shape=face, pressure=lp.Table([0, 1], [0, float(load)])
                    )
                    for k, (face, load) in enumerate(loaded)
                ],
            ),
            time=lp.Time(end=1.0, steps=4 if moved else 1),
        )

    def stresses(self, simulation: lp.Simulation) -> Array:
        """Along the axes of the body."""
        tensors = np.zeros((len(simulation), 3, 3))
        for k, (i, j) in enumerate(PAIRS[: simulation["stress"].shape[1]]):
            tensors[:, i, j] = tensors[:, j, i] = simulation["stress"][:, k]
        turn = np.eye(3)
        turn[: self.dimension, : self.dimension] = self.turn
        return np.asarray(np.einsum("ia,pij,jb->pab", turn, tensors, turn))


def rms(errors: Array, volumes: Array) -> float:
    return float(np.sqrt(np.average((errors**2).sum(axis=(1, 2)), weights=volumes)))


@pytest.mark.parametrize("simplex", [False, True], ids=["block", "simplex"])
@pytest.mark.parametrize(("dimension", "seed"), [(2, 1), (2, 2), (2, 3), (3, 1), (3, 2), (3, 3)])
def test_a_uniform_stress_is_uniform(dimension: int, seed: int, simplex: bool) -> None:
    """Domains of cut points reached into cells where they are not: stresses strayed by 3 % in the
    plane and 12 % in space (rms; single ones by 40 and 300 %), displacements by 1 and 6 %. Walls
    that went on beyond the body held the nodes beside it: 2 % of the stress in the plane."""
    drawn = Drawn(dimension, seed, simplex)
    scene = drawn.scene(lp.Elastic(density=1, youngs_modulus=YOUNG, poissons_ratio=POISSON))
    simulation = lp.Simulation(scene)
    simulation.run_until(1.0)
    stress = np.zeros(3)
    stress[:dimension] = -drawn.pressure
    if dimension == 2:
        stress[2] = POISSON * stress.sum()
    strain = ((1 + POISSON) * stress - POISSON * stress.sum()) / YOUNG
    errors = drawn.stresses(simulation) - np.diag(stress)
    size = np.linalg.norm(stress)
    moved = simulation["displacement"] @ drawn.turn
    places = (simulation.position - drawn.corner) @ drawn.turn - moved
    exact = places * strain[:dimension]
    volume = simulation["volume"]
    amiss = np.linalg.norm(moved - exact, axis=1)
    # In space ends of walls and loads are found to .1 %; tips of a tetrahedron are .001 of a cell.
    bar = 1e-6 if dimension == 2 else 0.015 if simplex else 0.003
    assert rms(errors, volume) < bar * size
    assert volume @ amiss**2 < bar**2 * (volume @ (exact**2).sum(axis=1))


@pytest.mark.parametrize("seed", [1, 2])
def test_so_is_one_that_flows(seed: int) -> None:
    """A cube of von Mises material pressed beyond its yield stress: the axial stress strayed by
    3,900 of 40,000 Pa."""
    drawn = Drawn(3, seed)
    lateral, strength = 1e4, 3e4
    drawn.pressure[:] = lateral
    clay = lp.VonMises(
        density=1, youngs_modulus=YOUNG, poissons_ratio=POISSON, yield_stress=[strength]
    )
    simulation = lp.Simulation(drawn.scene(clay, moved=0.01))
    simulation.run_until(1.0)
    errors = drawn.stresses(simulation) - np.diag([-lateral, -lateral, -lateral - strength])
    assert rms(errors, simulation["volume"]) < 0.01 * strength
