"""Plane-strain finite elements fitted to one mapped patch: quadratic quadrilaterals (nine nodes).

A patch is the image of the unit square, so that its four sides are sides of the body: any convex
quadrilateral, a sector of a ring. Sides carry supports, tractions or pressures. At Poisson ratios
near 1/2 the volume strain of each element is its least-squares projection on linear functions
(Q2/P1, Taylor-Hood like), which does not lock. Independent of the compiled module.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
import numpy.typing as npt
from scipy.interpolate import CloughTocher2DInterpolator
from scipy.sparse import coo_array, csc_array
from scipy.sparse.linalg import splu

from lapilli.references.arrays import Array
from lapilli.references.elastic import Elastic

SIDES = ("bottom", "right", "top", "left")
Mapping2D = Callable[[Array, Array], Array]


def quadrilateral(corners: npt.ArrayLike) -> Mapping2D:
    """Bilinear map of the unit square to four corners (4, 2), counter-clockwise."""
    a, b, c, d = np.asarray(corners, dtype=float)

    def place(s: Array, t: Array) -> Array:
        s, t = s[..., None], t[..., None]
        there: Array = (1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d
        return there

    return place


@dataclass(frozen=True, kw_only=True)
class Patch:
    """Displacements at the nodes of the patch and their places, both (count, 2), m."""

    position: Array
    displacement: Array

    def at(self, places: Array) -> Array:
        """Displacement at places (rows, 2) in the patch; the nearest node's outside by rounding."""
        found = CloughTocher2DInterpolator(self.position, self.displacement)(places)
        for row in np.flatnonzero(~np.isfinite(found[:, 0])):
            near = np.argmin(np.linalg.norm(self.position - places[row], axis=1))
            found[row] = self.displacement[near]
        return np.asarray(found)


def solve_patch(
    place: Mapping2D,
    *,
    material: Elastic,
    elements: tuple[int, int],
    fixed: tuple[str, ...] = (),
    rollers: tuple[str, ...] = (),
    tractions: Mapping[str, npt.ArrayLike] | None = None,
    pressures: Mapping[str, float] | None = None,
    displaced: Mapping[str, npt.ArrayLike] | None = None,
    body_force: npt.ArrayLike = (0.0, 0.0),
) -> Patch:
    """Equilibrium of the patch. Sides are named bottom, right, top, left of the unit square;
    rollers must be straight. tractions: Pa, by side; pressures: Pa, pushing on the material;
    displaced: m, sides that are moved and held there."""
    nx, ny = elements
    s, t = np.meshgrid(np.linspace(0, 1, 2 * nx + 1), np.linspace(0, 1, 2 * ny + 1), indexing="ij")
    number = np.arange(s.size).reshape(s.shape)
    nodes = place(s, t).reshape(-1, 2)
    element = np.stack(
        [
            number[i : i + 2 * nx - 1 : 2, j : j + 2 * ny - 1 : 2]
            for j in range(3)
            for i in range(3)
        ],
        axis=-1,
    ).reshape(-1, 9)
    stiffness, load = _assemble(nodes, element, material, np.asarray(body_force, dtype=float))
    sides = {
        "bottom": number[:, 0],
        "right": number[-1],
        "top": number[::-1, -1],
        "left": number[0, ::-1],
    }
    for side, traction in (tractions or {}).items():
        _push(load, nodes, sides[side], partial(_along, np.asarray(traction, dtype=float)))
    for side, pressure in (pressures or {}).items():
        _push(load, nodes, sides[side], partial(_across, pressure))
    held, normals, moves = [], [], []
    still = dict.fromkeys(fixed, np.zeros(2))
    for side, move in (still | dict(displaced or {})).items():
        for normal in np.eye(2):
            held += list(sides[side])
            normals += [normal] * len(sides[side])
            moves += [float(normal @ np.asarray(move))] * len(sides[side])
    for side in rollers:
        along = nodes[sides[side][-1]] - nodes[sides[side][0]]
        held += list(sides[side])
        normals += [np.array([-along[1], along[0]]) / np.linalg.norm(along)] * len(sides[side])
        moves += [0.0] * len(sides[side])
    # Stiff enough for 1e-7 of the displacement; more would lose the shear stiffness to rounding
    # where the bulk modulus is thousands of times larger.
    spring = 1e7 * max(material.shear, 1e-3 * material.lame)
    displacement = _solve(
        stiffness, load, np.array(held), np.array(normals), np.array(moves), spring
    )
    return Patch(position=nodes, displacement=displacement)


def _solve(
    stiffness: csc_array,
    load: Array,
    held: npt.NDArray[np.int_],
    normals: Array,
    moves: Array,
    spring: float,
) -> Array:
    """Springs along the held directions, moved by `moves` along them: corners may be held twice."""
    rows = np.concatenate([2 * held + i for i in range(2) for _ in range(2)])
    columns = np.concatenate([2 * held + j for _ in range(2) for j in range(2)])
    values = np.concatenate([normals[:, i] * normals[:, j] for i in range(2) for j in range(2)])
    total = stiffness + csc_array(
        coo_array((spring * values, (rows, columns)), shape=stiffness.shape)
    )
    force = load.copy()
    np.add.at(force, held, spring * moves[:, None] * normals)
    factor = splu(csc_array(total))
    found = factor.solve(force.ravel())
    found += factor.solve(force.ravel() - total @ found)
    return np.asarray(found).reshape(-1, 2)


def _along(traction: Array, arm: Array) -> Array:
    """A traction on a piece of a side with this tangent."""
    return np.asarray(np.linalg.norm(arm) * traction)


def _across(pressure: float, arm: Array) -> Array:
    """A pressure there. The sides run counter-clockwise: the material is on their left."""
    return pressure * np.array([-arm[1], arm[0]])


def _push(
    load: Array, nodes: Array, side: npt.NDArray[np.int_], force: Callable[[Array], Array]
) -> None:
    """Add a force per length, a function of the tangent, along the quadratic edges of a side."""
    points, weights = np.polynomial.legendre.leggauss(3)
    for k in range(0, len(side) - 2, 2):
        edge = side[k : k + 3]
        for x, w in zip(points, weights, strict=True):
            shape = np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])
            slope = np.array([x - 0.5, -2 * x, x + 0.5])
            load[edge] += w * np.outer(shape, force(slope @ nodes[edge]))


def _assemble(
    nodes: Array, element: npt.NDArray[np.int_], material: Elastic, body_force: Array
) -> tuple[csc_array, Array]:
    count = len(element)
    corner = nodes[element]
    points, weights = np.polynomial.legendre.leggauss(3)
    divergence, weight, linear = [], [], []
    matrix = np.zeros((count, 18, 18))
    load = np.zeros_like(nodes)
    for xi, wx in zip(points, weights, strict=True):
        for eta, wy in zip(points, weights, strict=True):
            shape, slope = _shape(xi, eta)
            jacobian = np.einsum("enk,na->eka", corner, slope)
            area = wx * wy * np.linalg.det(jacobian)
            gradient = np.einsum("na,eak->enk", slope, np.linalg.inv(jacobian))
            strain = np.zeros((count, 3, 18))
            strain[:, 0, 0::2] = gradient[:, :, 0]
            strain[:, 1, 1::2] = gradient[:, :, 1]
            strain[:, 2, 0::2] = gradient[:, :, 1]
            strain[:, 2, 1::2] = gradient[:, :, 0]
            shear = np.diag([2.0, 2.0, 1.0]) * material.shear
            matrix += np.einsum("e,eri,rs,esj->eij", area, strain, shear, strain)
            divergence.append(strain[:, 0] + strain[:, 1])
            weight.append(area)
            linear.append([1.0, xi, eta])
            np.add.at(load, element, area[:, None, None] * shape[None, :, None] * body_force)
    basis = np.array(linear)
    measure = np.array(weight)
    moments = np.einsum("qe,qei,qa->eai", measure, np.array(divergence), basis)
    gram = np.einsum("qe,qa,qb->eab", measure, basis, basis)
    matrix += material.lame * np.einsum("eai,eaj->eij", moments, np.linalg.solve(gram, moments))
    unknown = np.stack([2 * element, 2 * element + 1], axis=-1).reshape(count, 18)
    rows = np.repeat(unknown, 18, axis=1).ravel()
    columns = np.tile(unknown, (1, 18)).ravel()
    total = coo_array((matrix.ravel(), (rows, columns)), shape=(2 * len(nodes), 2 * len(nodes)))
    return csc_array(total), load


def _shape(xi: float, eta: float) -> tuple[Array, Array]:
    """Values (9) and slopes (9, 2) of the nine functions, first direction fastest."""
    line = [np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2]) for x in (xi, eta)]
    rise = [np.array([x - 0.5, -2 * x, x + 0.5]) for x in (xi, eta)]
    shape = np.outer(line[1], line[0]).ravel()
    slope = np.stack([np.outer(line[1], rise[0]).ravel(), np.outer(rise[1], line[0]).ravel()], -1)
    return shape, slope
