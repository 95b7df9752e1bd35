"""Volumes, centroids and counts of points of drawn shapes, poses, grids and units."""

import numpy as np
import pytest

import lapilli as lp

SOLID = lp.Elastic(density=1.0, youngs_modulus=1.0, poissons_ratio=0.3)
DRAWS = range(12)


def flat(draw: np.random.Generator) -> tuple[lp.Shape, float]:
    """A plane shape with straight sides and its area."""
    a, b = draw.uniform(0.8, 2.0, 2)
    low = lp.Box(lower=(0, 0), upper=(a, b))
    high = lp.Box(lower=(0.5 * a, 0.5 * b), upper=(1.5 * a, 2.0 * b))
    arrow = lp.Polygon(vertices=[(0, 0), (a, 0.5 * b), (0, b), (0.25 * a, 0.5 * b)])
    shapes = [
        (low, a * b),
        (lp.Union(shapes=[low, high]), 2.25 * a * b),
        (lp.Difference(shape=high, minus=low), 1.25 * a * b),
        (arrow, 0.375 * a * b),
        (lp.Intersection(shapes=[low, arrow]), 0.375 * a * b),
    ]
    return shapes[draw.integers(len(shapes))]


def curved(draw: np.random.Generator) -> tuple[lp.Shape, float]:
    """A plane shape with curved sides and its area."""
    a, b = draw.uniform(0.8, 2.0, 2)
    disk = lp.Disk(center=(0.2, 0.1), radius=a)
    shapes = [
        (disk, np.pi * a**2),
        (lp.Annulus(inner=0.6 * a, outer=a), 0.64 * np.pi * a**2),
        (lp.Ellipse(semi_axes=(a, b)), np.pi * a * b),
        (lp.Difference(shape=lp.Box(lower=(-3, -3), upper=(3, 3)), minus=disk), 36 - np.pi * a**2),
    ]
    return shapes[draw.integers(len(shapes))]


def solid(draw: np.random.Generator) -> tuple[lp.Shape, float]:
    """A shape in space with flat sides and its volume."""
    a, b, c = draw.uniform(0.8, 2.0, 3)
    low = lp.Box(lower=(0, 0, 0), upper=(a, b, c))
    high = lp.Box(lower=(0.5 * a, 0.5 * b, 0.5 * c), upper=(1.5 * a, 1.5 * b, 1.5 * c))
    corners = [(0, 0, 0), (a, 0, 0), (0, b, 0), (0, 0, c)]
    tip = lp.Mesh(vertices=corners, triangles=[(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    shapes = [
        (low, a * b * c),
        (lp.Union(shapes=[low, high]), 1.875 * a * b * c),
        (lp.Difference(shape=low, minus=high), 0.875 * a * b * c),
        (tip, a * b * c / 6),
    ]
    return shapes[draw.integers(len(shapes))]


def filled(
    shape: lp.Shape,
    cell: float,
    turn: float = 0.0,
    by: tuple[float, ...] = (0.0, 0.0),
    axis: tuple[float, ...] = (0.0, 0.0, 1.0),
    unit: float = 1.0,
) -> lp.Simulation:
    """The points of a shape that is turned and moved, in a large grid; lengths are times `unit`."""
    posed = lp.Translated(shape=lp.Rotated(shape=shape, degrees=turn, axis=axis), by=tuple(by))
    half = np.ceil(6.0 / cell) * cell * unit
    return lp.Simulation(
        lp.Scene(
            grid=lp.Grid(
                lower=(-half,) * len(by),
                upper=(half,) * len(by),
                cell=cell * unit,
            ),
            bodies=[lp.Body(shape=posed, material=SOLID, fill="exact")],
            dynamics=lp.Dynamics(),
            time=lp.Time(end=1e-9),
        )
    )


def centroid(points: lp.Simulation) -> np.ndarray:
    return points["volume"] @ points["position"] / points["volume"].sum()


@pytest.mark.parametrize("seed", DRAWS)
def test_flat_shapes_keep_their_area_in_any_pose(seed: int) -> None:
    draw = np.random.default_rng(seed)
    shape, area = flat(draw)
    by = draw.uniform(-1, 1, 2)
    points = filled(shape, draw.uniform(0.1, 0.3), turn=draw.uniform(-180, 180), by=by)
    assert points["volume"].sum() == pytest.approx(area, rel=1e-12)


@pytest.mark.parametrize("seed", DRAWS)
def test_curved_shapes_keep_their_area_in_any_pose(seed: int) -> None:
    draw = np.random.default_rng(100 + seed)
    shape, area = curved(draw)
    by = draw.uniform(-1, 1, 2)
    points = filled(shape, draw.uniform(0.1, 0.3), turn=draw.uniform(-180, 180), by=by)
    assert points["volume"].sum() == pytest.approx(area, rel=1e-7)


@pytest.mark.parametrize("seed", DRAWS)
def test_solids_keep_their_volume_in_any_pose(seed: int) -> None:
    draw = np.random.default_rng(200 + seed)
    shape, volume = solid(draw)
    axis, by = tuple(draw.uniform(0.1, 1.0, 3)), draw.uniform(-1, 1, 3)
    points = filled(shape, draw.uniform(0.3, 0.6), turn=draw.uniform(-180, 180), by=by, axis=axis)
    assert points["volume"].sum() == pytest.approx(volume, rel=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_points_follow_units_and_shifts_by_whole_cells(seed: int) -> None:
    draw = np.random.default_rng(300 + seed)
    cell = 0.25
    a, b = draw.uniform(1.0, 2.0, 2)

    def shape(unit: float, shift: float) -> lp.Shape:
        return lp.Ellipse(center=(shift * unit, 0.1 * unit), semi_axes=(a * unit, b * unit))

    here = filled(shape(1.0, 0.03), cell)
    small = filled(shape(1e-6, 0.03), cell, unit=1e-6)
    shifted = filled(shape(1.0, 0.03 + 4 * cell), cell)
    assert len(small) == len(shifted) == len(here)
    np.testing.assert_allclose(1e12 * small.by_id("volume"), here.by_id("volume"), rtol=1e-6)
    np.testing.assert_allclose(
        shifted.by_id("position") - (4 * cell, 0), here.by_id("position"), atol=1e-9
    )


@pytest.mark.parametrize("kind", [flat, curved])
@pytest.mark.parametrize("seed", range(4))
def test_the_centroid_turns_with_the_shape(kind: object, seed: int) -> None:
    draw = np.random.default_rng(400 + seed)
    shape, _ = kind(draw)
    turn = draw.uniform(-180, 180)
    before = centroid(filled(shape, 0.21))
    after = centroid(filled(shape, 0.19, turn=turn))
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    np.testing.assert_allclose(after, [[c, -s], [s, c]] @ before, atol=1e-7)


@pytest.mark.parametrize("seed", DRAWS)
def test_no_more_points_than_asked_for_and_a_third(seed: int) -> None:
    draw = np.random.default_rng(500 + seed)
    kind, dimension = [(flat, 2), (curved, 2), (solid, 3)][seed % 3]
    shape, volume = kind(draw)
    cell = volume ** (1 / dimension) / 12
    points = filled(shape, cell, by=draw.uniform(-1, 1, dimension))
    assert len(points) <= 1.3 * volume / (0.5 * cell) ** dimension


def test_lattice_fills_are_warned_of() -> None:
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(1, 1), cell=0.1),
        bodies=[
            lp.Body(
                name="plate",
                shape=lp.Box(lower=(0.12, 0.12), upper=(0.45, 0.45)),
                material=lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0),
                fill="lattice",
            )
        ],
        heat=lp.Heat(),
        time=lp.Time(end=1.0),
    )
    simulation = lp.Simulation(scene)
    of_points, of_shape = simulation.volumes()["plate"]
    assert of_points == pytest.approx(simulation["volume"].sum())
    assert of_shape == pytest.approx(0.33**2, rel=1e-12)
    assert "the points of plate hold" in lp._core.check_text(scene)
    scene.bodies[0].fill = "exact"
    assert lp.Simulation(scene)["volume"].sum() == pytest.approx(0.33**2, rel=1e-12)
    assert "the points of plate hold" not in lp._core.check_text(scene)


def test_operators_put_shapes_together() -> None:
    box, disk = lp.Box(lower=(0, 0), upper=(2, 1)), lp.Disk(center=(1, 0.5), radius=0.3)
    assert box - disk == lp.Difference(shape=box, minus=disk)
    assert box | disk == lp.Union(shapes=[box, disk])
    assert box & disk == lp.Intersection(shapes=[box, disk])
    assert box.translated((1, 2)) == lp.Translated(shape=box, by=(1, 2))
    assert box.rotated(30) == lp.Rotated(shape=box, degrees=30)
    turned = disk.rotated(30, center=(2, 0))
    assert turned == lp.Rotated(shape=disk, degrees=30, center=(2, 0))
    with pytest.raises(TypeError, match="unsupported operand"):
        box - 3  # type: ignore[operator]
    with pytest.raises(TypeError, match="unknown key 'centre'"):
        box.rotated(30, centre=(2, 0))
