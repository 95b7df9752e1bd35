"""Stages that cannot be are refused, with the place and the name."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

import lapilli as lp

sys.path.insert(0, str(Path(__file__).parent))
from stage_scenes import STEP, cut, soil

sys.path.pop(0)


def stage(**changes: object) -> lp.Stage:
    return lp.Stage(**{"name": "next", "end": 1.0, **changes})


@pytest.mark.parametrize(
    ("stages", "message"),
    [
        ([stage(end=0.1)], r"stages\[0\].end must be after 0.125 s.*time.end"),
        ([stage(), stage(name="b", end=0.5)], r"stages\[1\].end must be after 1 s, the end of the"),
        ([stage(), stage(end=2)], r"stages\[1\].name is 'next' as that of an earlier stage"),
        ([stage(remove=["ballats"])], r"names 'ballats'.*did you mean 'ballast'"),
        ([stage(remove=["slope", "ballast"])], r"leaves no body"),
        (
            [stage(remove=["ballast"]), stage(name="b", end=2, remove=["ballast"])],
            "names 'ballast'",
        ),
        ([stage(set={"dynamics.dampening": 1})], r"dynamics.dampening is no known key"),
        ([stage(set={"bodies.slop.material.cohesion": 1})], r"slop does not exist.*slope, ballast"),
        ([stage(set={"bodies.slope.material.cohesion": -1})], r"cohesion must be at least 0"),
        ([stage(set={"bodies.slope.material.cohesion": "a"})], r"cohesion must be a number"),
        ([stage(set={"bodies.slope.material.density": 1})], r"keep their mass"),
        (
            [
                stage(
                    set={
                        "bodies.slope.material": {
                            "kind": "elastic",
                            "density": 1000,
                            "youngs_modulus": 1e7,
                            "poissons_ratio": 0.3,
                        }
                    }
                )
            ],
            r"makes body slope of a density of 1000 kg/m\^3, it was 2000",
        ),
        ([stage(set={"bodies.slope.velocity": [1, 0]})], r"bodies go on as they are"),
        ([stage(set={"time.end": 3})], r"the end of a stage is its own key"),
        ([stage(set={"output.every": 3})], r"stages set keys of grid, bodies, dynamics"),
        ([stage(set={"heat.theta": 0.5})], r"the scene has no \[heat\]"),
        ([stage(set={"dynamics.courant": 7})], r"stages\[0\].set: dynamics.courant must"),
        ([stage(add_bodies=[lp.Body(name="slope", material=[soil()])])], r"name is 'slope'"),
        (
            [stage(add_bodies=[lp.Body(name="air", material=[soil()])])],
            r"stages\[0\] 'next': bodies",
        ),
    ],
)
def test_a_stage_that_cannot_be_is_refused_by_name(stages: list[lp.Stage], message: str) -> None:
    scene = cut()
    scene.stages = stages
    with pytest.raises(ValueError, match=message):
        lp.Simulation(scene)


def test_mistakes_in_stages_name_line_and_column() -> None:
    text = cut().to_toml() + '\n[[stages]]\nname = "weak"\nend = 2.0\n'
    line = text.count("\n") + 1
    with pytest.raises(ValueError, match=rf"cut:{line}:1: stages\[0\].remove names 'x'"):
        lp.Simulation(lp.Scene.parse(text + 'remove = ["x"]', "cut"))
    with pytest.raises(ValueError, match=rf"cut:{line}:1: stages\[0\].set: grid.cells is no known"):
        lp.Simulation(lp.Scene.parse(text + 'set = {"grid.cells" = 1.0}', "cut"))
    with pytest.raises(ValueError, match=r"stages\[0\].end is missing"):
        lp.Scene.parse(cut().to_toml() + '\n[[stages]]\nname = "weak"\n', "cut")


def test_other_physics_refuse_stages() -> None:
    scene = lp.Scene.load(Path(__file__).parents[3] / "examples" / "static" / "beam.toml")
    scene.stages = [stage(end=1e6)]
    with pytest.raises(ValueError, match=r"stages need \[dynamics\]"):
        lp.Simulation(scene)


def test_a_body_added_into_another_one_stops_the_run(tmp_path: Path) -> None:
    scene = cut()
    slab = lp.Body(name="slab", shape=lp.Box(lower=(0, 2), upper=(2, 3)), material=[soil()])
    scene.stages = [stage(add_bodies=[slab])]
    with pytest.raises(lp.RunError, match=r"stage 'next' cannot begin: .*overlaps"):
        lp.run(scene, tmp_path / "run.vtkhdf", progress=False)
    assert lp.Frames(tmp_path / "run.vtkhdf").times[-1] == 64 * STEP
