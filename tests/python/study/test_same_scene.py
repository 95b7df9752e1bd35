"""Frames are a reference for the problem they were computed for, and for no other."""

import json
import re
from pathlib import Path

import pytest

import lapilli as lp
from lapilli import _core
from lapilli.study.same_scene import HOW, poses_problem, require_same_problem

# What poses the problem: all that HOW does not name. A new member belongs into one of the two.
POSES = {
    "": "initial_state bodies heat dynamics quasi_static peridynamics stages",
    "grid": "lower upper cell shape_function",  # of the grid none, as of the time
    "bodies": "shape rotation rotation_center rotation_axis translation material temperature "
              "source velocity spin spin_center geostatic motion",
    "bodies.geostatic": "surface normal k0 surcharge",
    "heat": "temperature_unit boundaries contacts",
    "heat.boundaries": "kind value coefficient ambient emissivity stefan_boltzmann region",
    "heat.contacts": "bodies conductance",
    "dynamics": "gravity gravity_factor local_damping damping_until grid_boundaries outside "
                "obstacles contacts boundaries",
    "dynamics.grid_boundaries": "kind face coefficient",
    "dynamics.obstacles": "shape contact friction adhesion velocity revolutions_per_second center "
                          "axis factor mass inertia force held separation temperature conductance "
                          "heat_capacity",
    "dynamics.contacts": "bodies contact friction adhesion",
    "dynamics.boundaries": "kind value factor region",
    "quasi_static": "gravity body_force supports tractions",
    "quasi_static.supports": "kind shape inside line within displacement advance",
    "quasi_static.tractions": "shape inside line within traction pressure",
    "peridynamics": "heat flow walls",
    "peridynamics.heat": "viscous_dissipation",
    "peridynamics.flow": "gravity buoyancy",
    "peridynamics.walls": "shape slip velocity moves heat temperature flux coefficient",
    "stages": "end remove set add_bodies add_obstacles add_boundaries reset_velocity",
}  # fmt: skip


def described() -> dict[str, set[str]]:
    """The keys of every section, as the library describes them."""
    found: dict[str, set[str]] = {}
    for table in _core.keys_as_markdown("").split("\n## `")[1:]:
        heading = table.partition("`")[0]
        section = "" if heading.startswith("top") else heading.partition(" ")[0].strip("[]")
        if section in ("shape", "material", "motion"):
            continue  # all of them pose the problem
        keys = re.findall(r"^\| `(\w+)`", table, re.MULTILINE)
        found.setdefault(section, set()).update(keys)
    return found


def test_every_member_poses_the_problem_or_says_how_it_is_solved() -> None:
    for section, keys in described().items():
        if section in HOW[""]:
            continue
        how, poses = set(HOW.get(section, ())), set(POSES.get(section, "").split())
        assert not how & poses
        assert how | poses == keys, section
        for key in keys:
            path = f"{section}.0.{key}" if section else key
            assert poses_problem(path) == (key in poses)
    assert set(HOW) <= set(described())


@pytest.mark.parametrize(
    ("path", "is_posed"),
    [
        ("grid.cell", False),
        ("grid.lower.0", False),
        ("time.end", False),
        ("output.fields.0", False),
        ("bodies.0.shape.semi_axes.1", True),
        ("bodies.1.spin", True),
        ("bodies.1.shape.shapes.0.radius", True),
        ("heat.contacts.0.conductance", True),
        ("heat.contacts.0.bodies.1", True),
        ("dynamics.gravity_factor.values.2", True),
        ("dynamics.courant", False),
        ("stages.0.end", True),
        ("stages.0.name", False),
        ("stages.0.set.dynamics.courant", False),
        ("stages.0.set.dynamics.local_damping", True),
        ("stages.1.add_bodies.0.jitter", False),
        ("stages.1.add_bodies.0.temperature", True),
    ],
)
def test_paths(path: str, is_posed: bool) -> None:
    assert poses_problem(path) == is_posed


def test_frames_of_another_conductance_are_refused(ring: lp.Scene, tmp_path: Path) -> None:
    settings = json.loads(ring.to_json())
    for changed, differs in (({"title": "other"}, False), ({"initial_state": "a"}, True)):
        (tmp_path / "run.json").write_text(json.dumps({"settings": {**settings, **changed}}))
        if differs:
            with pytest.raises(ValueError, match="another scene: initial_state = a there"):
                require_same_problem(tmp_path / "run.vtkhdf", ring)
        else:
            require_same_problem(tmp_path / "run.vtkhdf", ring)
