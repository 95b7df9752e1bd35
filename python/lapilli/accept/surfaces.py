"""Surfaces and meshes of trimesh, meshio and pyvista as shapes."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli._core import Difference, Mesh, Polygon, Shape, Union

Array = npt.NDArray[Any]
Faces = list[Array]  # arrays of rows of one length each

# Faces of cells, counter-clockwise seen from outside, in the order of vertices of meshio and VTK.
FACES: dict[str, list[tuple[int, ...]]] = {
    "tetra": [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)],
    "pyramid": [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
    "wedge": [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)],
    "hexahedron": [
        (0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)
    ],
}  # fmt: skip


def shape_of(value: Any, key: str) -> Any:
    """A surface of another package as a `Mesh`, or in the plane as polygons; lists entry by entry;
    anything else as it is. Raises ``ValueError`` naming the key where it has no surface."""
    if isinstance(value, (list, tuple)):
        return [shape_of(entry, key) for entry in value]
    package = type(value).__module__.partition(".")[0]
    readers = {"trimesh": _of_trimesh, "meshio": _of_meshio, "pyvista": _of_pyvista}
    if package not in readers:
        return value
    try:
        points, triangles = readers[package](value)
    except AttributeError as error:
        raise ValueError(f"{key}: a {type(value).__name__} of {package} is no surface") from error
    if not len(triangles):
        raise ValueError(
            f"{key}: the {type(value).__name__} of {package} holds no cells with a surface"
        )
    return _planar(points, triangles) if _is_planar(points) else _closed(points, triangles)


def _of_trimesh(mesh: Any) -> tuple[Array, Array]:
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


def _of_pyvista(mesh: Any) -> tuple[Array, Array]:
    surface = mesh.extract_surface(algorithm="dataset_surface").triangulate()
    return np.asarray(surface.points, dtype=float), surface.faces.reshape(-1, 4)[:, 1:]


def _of_meshio(mesh: Any) -> tuple[Array, Array]:
    cells = {block.type: np.asarray(block.data) for block in mesh.cells}
    solid = _linear(mesh, FACES)
    if solid:
        faces = _outer_faces(solid)
    else:
        faces = [rows for _, rows in _linear(mesh, {"triangle": (), "quad": ()})]
    if not faces:
        raise AttributeError(f"no triangles, quads or solid cells among {', '.join(cells)}")
    return np.asarray(mesh.points, dtype=float), np.concatenate(
        [_triangles(rows) for rows in faces]
    )


def _linear(mesh: Any, kinds: Any) -> list[tuple[str, Array]]:
    """Cells of these kinds, of higher order too ("tetra10"), by their corners."""
    corners = {"triangle": 3, "quad": 4, "tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8}
    found = []
    for block in mesh.cells:
        kind = block.type.rstrip("0123456789")
        if kind in kinds:
            found.append((kind, np.asarray(block.data)[:, : corners[kind]]))
    return found


def _outer_faces(solid: list[tuple[str, Array]]) -> Faces:
    """The faces that belong to one cell only."""
    outer = []
    for width in (3, 4):
        rows = [
            cells[:, face] for kind, cells in solid for face in FACES[kind] if len(face) == width
        ]
        if rows:
            faces = np.concatenate(rows)
            _, first, count = np.unique(
                np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True
            )
            outer.append(faces[first[count == 1]])
    return outer


def _triangles(faces: Array) -> Array:
    return (
        faces if faces.shape[1] == 3 else np.concatenate([faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]])
    )


def _is_planar(points: Array) -> bool:
    return points.shape[1] == 2 or bool(np.ptp(points[:, 2]) == 0)


def _welded(points: Array, triangles: Array) -> tuple[Array, Array]:
    """Corners at the same position made one; corners of no triangle left out."""
    unique, inverse = np.unique(points, axis=0, return_inverse=True)
    rows = inverse.reshape(-1)[triangles]
    used, renumbered = np.unique(rows, return_inverse=True)
    return unique[used], renumbered.reshape(rows.shape)


def _closed(points: Array, triangles: Array) -> Mesh:
    vertices, rows = _welded(points, triangles)
    return Mesh(vertices=vertices.tolist(), triangles=rows.tolist())


def _planar(points: Array, triangles: Array) -> Shape:
    """What triangles in the x-y plane cover: the polygons around it less those around its holes."""
    vertices, rows = _welded(points[:, :2], triangles)
    a, b, c = (vertices[rows[:, k]] for k in range(3))
    turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    rows = np.where((turn > 0)[:, None], rows, rows[:, ::-1])[turn != 0]
    loops = [vertices[loop] for loop in _loops(rows)]
    loops.sort(key=lambda loop: -abs(_area(loop)))
    shape: Shape | None = None
    for loop in loops:  # from the outside to the inside
        polygon = Polygon(vertices=loop.tolist())
        if shape is None:
            shape = polygon
        elif _area(loop) > 0:
            shape = Union(shapes=[shape, polygon])
        else:
            shape = Difference(shape=shape, minus=polygon)
    assert shape is not None
    return shape


def _area(loop: Array) -> float:
    x, y = loop.T
    return float(0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))


def _loops(rows: Array) -> list[list[int]]:
    """Closed chains of the edges that belong to one triangle, the material on their left."""
    edges = {(int(r[k]), int(r[k - 2])) for r in rows for k in range(3)}
    after: dict[int, list[int]] = {}
    for start, end in sorted(edges):
        if (end, start) not in edges:
            after.setdefault(start, []).append(end)
    loops = []
    while after:
        start, here = next(iter(after)), None
        loop: list[int] = []
        while here != start:
            here = start if here is None else here
            loop.append(here)
            ends = after[here]
            following = ends.pop()
            if not ends:
                del after[here]
            here = following
        loops.append(loop)
    return loops
