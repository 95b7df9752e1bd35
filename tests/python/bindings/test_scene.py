"""Scenes as Python objects: nesting, files, functions, overrides."""

import copy
import inspect
import pickle
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp

SOLID = lp.Thermal(density=1, specific_heat=1, conductivity=1)


def linear(position, temperature, time):
    """A function at the top of a module, as pickling needs it."""
    return position[:, 0] + time


def test_what_is_given_stays_the_same_object(ring: lp.Scene) -> None:
    boundary = lp.Flux(value=1)
    ring.heat.boundaries.append(boundary)
    boundary.value = 2
    assert ring.heat.boundaries[-1].value == 2.0
    assert "value = 2.0" in ring.to_toml()


def test_lists_of_two_scenes_are_not_shared(ring: lp.Scene) -> None:
    boundaries = [lp.Flux(value=1)]
    heat = lp.Heat(boundaries=boundaries)
    boundaries.append(lp.Flux(value=2))
    assert len(heat.boundaries) == 1


def test_toml_gives_back_the_same_scene(ring: lp.Scene, tmp_path: Path) -> None:
    ring.heat.boundaries[0].ambient = ((0, 1), (2, 3))
    ring.bodies[0].motion = lp.Rotation(revolutions_per_second=0.25)
    ring.save(str(tmp_path / "ring.toml"))
    loaded = lp.Scene.load(str(tmp_path / "ring.toml"))
    assert loaded == ring
    assert pickle.loads(pickle.dumps(loaded)) == ring
    assert copy.deepcopy(loaded) == ring


def test_a_wrong_file_names_file_line_and_key(tmp_path: Path) -> None:
    path = tmp_path / "wrong.toml"
    path.write_text("[grid]\nlower = [0]\nupper = [1]\ncel = 0.1\n")
    with pytest.raises(ValueError, match=r"wrong\.toml:4:1: grid\.cel .*did you mean 'cell'"):
        lp.Scene.load(str(path))


def test_a_function_is_kept_but_not_written(ring: lp.Scene) -> None:
    ring.heat.boundaries[0].ambient = linear
    assert ring.heat.boundaries[0].ambient is linear
    with pytest.raises(ValueError, match=r"heat\.boundaries\[0\]\.ambient .* function"):
        ring.to_toml()
    changed = ring.set("grid.cell=0.5")
    assert changed.heat.boundaries[0].ambient is linear
    assert pickle.loads(pickle.dumps(changed)).heat.boundaries[0].ambient is linear


def test_set_gives_a_changed_copy(ring: lp.Scene) -> None:
    before = ring.grid.cell
    assert ring.set("grid.cell=0.25").grid.cell == 0.25
    assert ring.grid.cell == before
    with pytest.raises(ValueError, match=r"grid\.cel"):
        ring.set("grid.cel=0.25")
    with pytest.raises(ValueError, match="above 0"):
        ring.set("grid.cell=-1")


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (
            lambda: lp.Body(shape=3, material=SOLID),
            "shape must be a shape such as Box or Disk, got 3",
        ),
        (lambda: lp.Grid(lower=(1, 2, 3, 4), upper=(5,), cell=1), "lower must hold 1 to 3 entries"),
        (lambda: lp.Heat(transfer="flp"), "unknown Heat.transfer 'flp'; did you mean 'flip'"),
        (lambda: lp.Union(shapes=[lp.Disk(radius=1), 3]), r"Union.shapes\[1\] must be a shape"),
        (lambda: lp.Flux(value="x"), "value must be a number, a Table, a pair"),
        (lambda: lp.Flux(value=([1, 0], [1, 2])), "needs times that increase"),
        (lambda: lp.Time(end=1, step="automatic"), "step must be a number"),
        (lambda: lp.Heat(boundaries=[lp.Disk(radius=1)]), r"boundaries\[0\] must be Flux \| "),
    ],
)
def test_a_wrong_member_is_named(make, says: str) -> None:
    with pytest.raises((TypeError, ValueError), match=says):
        make()


def test_auto_is_the_word_for_an_automatic_step() -> None:
    assert lp.Time(end=1).step == "auto"
    assert lp.Time(end=1, step="auto") == lp.Time(end=1)
    assert lp.Time(end=1, step=0.1).step == 0.1


def test_points_come_from_arrays() -> None:
    body = lp.Body(points=(np.zeros((3, 2)), np.ones(3)), material=SOLID)
    assert len(body.points) == 3
    assert body.points == lp.Points(np.zeros((3, 2)), np.ones(3))
    with pytest.raises(ValueError, match="one number a point"):
        lp.Points(np.zeros((3, 2)), np.ones(2))


def test_shapes_nest_and_tell_distances() -> None:
    washer = lp.Difference(shape=lp.Disk(radius=2), minus=lp.Disk(radius=1))
    assert isinstance(washer, lp.Shape)
    distances = washer.distance(np.array([[0.0, 0.0], [1.5, 0.0], [3.0, 0.0]]))
    np.testing.assert_allclose(distances, [1.0, -0.5, 1.0])


def test_set_takes_python_values_by_path(ring: lp.Scene) -> None:
    changed = ring.set("grid.cell", 0.25).set("bodies[0].points_per_cell", 9)
    assert (changed.grid.cell, changed.bodies[0].points_per_cell) == (0.25, 9)
    assert (ring.grid.cell, ring.bodies[0].points_per_cell) == (0.5, 4)
    assert changed.set("bodies.0.shape", lp.Disk(radius=2)).bodies[0].shape == lp.Disk(radius=2)
    assert ring.set("bodies[0].material.density", 3).bodies[0].material.density == 3
    table = lp.Table(times=[0, 1], values=[1, 2])
    assert ring.set("heat.boundaries[0].ambient", table).heat.boundaries[0].ambient == table
    assert ring.set("heat", None).heat is None
    assert ring.heat is not None
    for path, value, says in (
        ("grid.cell", -1, "above 0"),
        ("grid.cel", 1, "cell"),
        ("bodies[1].clip", True, "no entry 1"),
        ("dynamics.pic_fraction", 0.1, "absent"),
    ):
        with pytest.raises((ValueError, AttributeError), match=says):
            ring.set(path, value)


def test_files_are_named_by_paths_too(ring: lp.Scene, tmp_path: Path) -> None:
    ring.save(tmp_path / "ring.toml")
    assert lp.Scene.load(tmp_path / "ring.toml") == ring
    with pytest.raises(TypeError):
        lp.Scene.load(3)


def test_signatures_are_seen_by_inspect() -> None:
    signature = inspect.signature(lp.Grid)
    assert list(signature.parameters) == ["lower", "upper", "cell", "shape_function"]
    assert signature.parameters["cell"].default is inspect.Parameter.empty
    assert signature.parameters["shape_function"].default == "gimp"
    assert signature.parameters["cell"].kind is inspect.Parameter.KEYWORD_ONLY
    assert signature.parameters["cell"].annotation == "float"


def test_a_subclass_is_refused_not_sliced() -> None:
    class Sand(lp.MohrCoulomb):
        pass

    sand = Sand(
        density=1,
        youngs_modulus=1,
        poissons_ratio=0.3,
        friction_angle=30,
        dilatancy_angle=0,
        cohesion=0,
    )
    with pytest.raises(TypeError, match="must be"):
        lp.Body(shape=lp.Disk(radius=1), material=sand)


def test_all_mistakes_of_a_text_are_told_at_once() -> None:
    text = "[grid]\nlower = [0]\nupper = 1\ncell = -1\n[[bodies]]\n[time]\nend = 0\n"
    with pytest.raises(ValueError, match=r"four\.toml:3:9: grid\.upper") as caught:
        lp.Scene.parse(text, "four.toml")
    lines = str(caught.value).splitlines()
    assert len(lines) == 4
    assert all(line.startswith("four.toml:") for line in lines)


def test_reports_show_themselves(ring: lp.Scene) -> None:
    simulation = lp.Simulation(ring)
    assert repr(simulation.step()).startswith("<step of ")
    result = lp.run(ring, progress=False)
    assert repr(result.summary).startswith("<finished at 1 s after ")
    assert result.balance["heat"] == result.balance["heat"]
    assert result.balance["heat"] != 3
