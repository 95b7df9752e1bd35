"""Quantities with units, and surfaces of other packages, where scene classes take plain values."""

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core
from lapilli.accept import _unit

pint = pytest.importorskip("pint")
units = pint.UnitRegistry()
BODY = {
    "shape": lp.Disk(radius=1),
    "material": lp.Thermal(density=1, specific_heat=1, conductivity=1),
}


def test_quantities_become_numbers_in_the_unit_of_the_key() -> None:
    steel = lp.Thermal(
        density=7.8 * units.g / units.cm**3,
        specific_heat=0.46 * units.kJ / units.kg / units.K,
        conductivity=50 * units.W / units.m / units.K,
    )
    assert steel.density == pytest.approx(7800)
    assert steel.specific_heat == pytest.approx(460)
    steel.conductivity = 0.4 * units.W / units.cm / units.K
    assert steel.conductivity == pytest.approx(40)
    body = lp.Body(
        shape=lp.Disk(radius=3 * units.inch),
        material=steel,
        temperature=units.Quantity(20, "degC"),
    )
    assert body.shape.radius == pytest.approx(0.0762)
    assert body.temperature == pytest.approx(293.15)
    assert lp.Time(end=2 * units.hour).end == 7200


def test_lists_arrays_and_tables_of_quantities() -> None:
    grid = lp.Grid(
        lower=[-5, -5] * units.cm, upper=(50 * units.mm, 0.05 * units.m), cell=1 * units.mm
    )
    np.testing.assert_allclose(grid.lower, [-0.05, -0.05])
    np.testing.assert_allclose(grid.upper, [0.05, 0.05])
    flux = lp.Flux(value=([0, 1] * units.minute, [0, 2] * units.kW / units.m**2))
    assert flux.value == lp.Table([0, 60], [0, 2000])
    assert lp.Table([0, 1] * units.hour, [1, 2]).times == (0, 3600)
    with pytest.raises(ValueError, match="unit of the key"):
        lp.Table([0, 1], [1, 2] * units.K)
    cloud = lp.Points(np.array([[0, 0], [10, 0]]) * units.mm, np.array([1, 1]) * units.cm**2)
    np.testing.assert_allclose(cloud.positions, [[0, 0], [0.01, 0]])
    np.testing.assert_allclose(cloud.volumes, 1e-4)


def test_set_takes_quantities_and_surfaces() -> None:
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1, 1), cell=0.1),
        bodies=[
            lp.Body(
                shape=lp.Disk(radius=0.2),
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
            )
        ],
        heat=lp.Heat(),
        time=lp.Time(end=1),
    )
    changed = scene.set("bodies[0].shape.radius", 10 * units.cm).set("grid.cell", 5 * units.cm)
    assert changed.bodies[0].shape.radius == pytest.approx(0.1)
    assert changed.grid.cell == pytest.approx(0.05)
    assert scene.grid.cell == 0.1


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: lp.Disk(radius=3 * units.kg), r"Disk: radius must be .* in m .*got 3 kilo"),
        (lambda: lp.Body(**BODY, points_per_cell=1 * units.m), "per_cell must be a number with"),
        (lambda: lp.Grid(lower=(1 * units.m, 2), upper=(2, 2), cell=1), "lower: 2 stands beside"),
        (lambda: lp.Disk(radius=-3 * units.cm), "radius must be above 0"),
    ],
)  # fmt: skip
def test_a_wrong_dimension_names_the_key(make, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        make()


def test_units_of_keys_are_found() -> None:
    """The units read from the documentation of the classes, against those of their properties."""
    assert _unit(lp.Thermal, "density") == "kg/m^3"
    assert _unit(lp.Thermal, "conductivity") == "W/(m K)"
    assert _unit(lp.Rotated, "degrees") == "degree"
    assert _unit(lp.Grid, "lower") == "m"
    assert _unit(lp.Flux, "value") == "W/m^2"
    assert _unit(lp.Body, "name") == _unit(lp.Elastic, "poissons_ratio") == ""
    known = {
        "", "1/K", "1/s", "J/(kg K)", "J/K", "J/kg", "K", "N/m^3", "Pa s", "Pa", "W/(m K)",
        "W/(m^2 K)", "W/(m^2 K^4)", "W/m^2", "W/m^3", "cells", "degree", "kg/m^3", "m", "m/s",
        "m/s^2", "s", "rad/s", "kg", "kg m^2", "N",
    }  # fmt: skip
    for made in vars(_core).values():
        if hasattr(made, "__signature__"):
            for name in made.__signature__.parameters:
                assert _unit(made, name) in known, (made, name)
                if unit := _unit(made, name):
                    text = getattr(made, name).__doc__
                    assert text.endswith(f", {unit}"), (made, name)


def test_a_closed_surface_of_trimesh_is_a_mesh() -> None:
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box(extents=(1, 2, 3))
    body = lp.Body(shape=box, material=BODY["material"])
    assert isinstance(body.shape, lp.Mesh)
    np.testing.assert_allclose(body.shape.distance([[0, 0, 0], [1, 0, 0]]), [-0.5, 0.5])
    both = lp.Difference(shape=lp.Sphere(radius=4), minus=box)
    assert both.distance([[0, 0, 0]]) > 0


@pytest.mark.parametrize("kind", ["tetra", "hexahedron", "wedge", "quad"])
def test_cells_of_meshio_have_an_outer_surface(kind: str) -> None:
    meshio = pytest.importorskip("meshio")
    corners = np.array(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
        float,
    )
    cells = {
        "hexahedron": [[0, 1, 2, 3, 4, 5, 6, 7]],
        "wedge": [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]],
        "tetra": [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6],
                  [0, 5, 1, 6]],
        "quad": [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6],
                 [3, 0, 4, 7]],
    }  # fmt: skip
    mesh = meshio.Mesh(
        corners, [(kind, cells[kind]), ("triangle", [[0, 1, 2]])][: 1 if kind == "quad" else 2]
    )
    shape = lp.Union(shapes=[mesh])
    far = shape.distance([[0.5, 0.5, 0.5], [0.5, 0.5, 1.25], [0.1, 0.5, 0.4]])
    np.testing.assert_allclose(far, [-0.5, 0.25, -0.1])


def test_a_plane_mesh_with_a_hole_is_polygons() -> None:
    meshio = pytest.importorskip("meshio")
    # a frame: a square of side 4 around a hole of side 2, with an island of side 1 in it
    outer = np.array([[0, 0], [4, 0], [4, 4], [0, 4]], float)
    points = np.concatenate([outer, 1 + outer / 2, 1.5 + outer / 4])
    triangles = []
    for k in range(4):
        n = (k + 1) % 4
        triangles += [[k, n, 4 + n], [k, 4 + n, 4 + k]]
    triangles += [[8, 10, 9], [8, 10, 11]]  # the first turns the other way
    shape = lp.Translated(shape=meshio.Mesh(points, [("triangle", triangles)]), by=(1, 0)).shape
    far = shape.distance([[0.5, 2], [1.2, 2], [2, 2], [-1, 2]])
    np.testing.assert_allclose(far, [-0.5, 0.2, -0.5, 1])


def test_pyvista_surfaces_and_grids() -> None:
    pyvista = pytest.importorskip("pyvista")
    for made in (
        pyvista.Cube(),
        pyvista.Cube().triangulate(),
        pyvista.ImageData(dimensions=(3, 3, 3)),
    ):
        shape = lp.Union(shapes=[made]).shapes[0]
        assert isinstance(shape, lp.Mesh)
        middle = np.mean(shape.vertices, axis=0)
        np.testing.assert_allclose(shape.distance([middle]), [-0.5 if made.n_cells != 8 else -1])


def test_what_has_no_surface_is_named() -> None:
    meshio = pytest.importorskip("meshio")
    lines = meshio.Mesh([[0, 0], [1, 0]], [("line", [[0, 1]])])
    with pytest.raises(ValueError, match="Body: shape: a Mesh of meshio is no surface"):
        lp.Body(shape=lines, material=BODY["material"])
    with pytest.raises(TypeError, match="shape must be a shape such as Box or Disk"):
        lp.Body(shape=object(), material=BODY["material"])
