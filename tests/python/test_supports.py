"""[quasi_static] in scenes: files, overrides, check, runs that resume or fail, bad input."""

import json
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core
from lapilli.reproduce.ib import block, column, footing
from lapilli.reproduce.ib.balance import balance, section
from lapilli.reproduce.ib.frame import Frame, ramp

EXAMPLES = sorted((Path(__file__).parents[2] / "examples" / "ib").glob("*.toml"))


@pytest.fixture
def turned() -> lp.Scene:
    """The contained block, 30 degrees, on coarse cells."""
    return block.block_scene(30, 0.02)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example_is_as_its_case_says(path: Path) -> None:
    """Every example builds, and is the same after a round trip through TOML."""
    scene = lp.Scene.load(str(path))
    assert lp.Scene.parse(scene.to_toml()) == scene
    assert len(lp.Simulation(scene)) > 0


def test_check_says_what_is_modelled(turned: lp.Scene) -> None:
    text = _core.check_text(turned)
    assert "equilibrium under load steps, supports that need not fit the grid (mean-gap)" in text
    assert "inertia, large strains, friction, supports that let go" in text
    turned.bodies[0].fill = "lattice"
    assert "filled by a lattice" in _core.check_text(turned)


def test_the_paper_rule_is_warned_of() -> None:
    assert "lets go" in _core.check_text(footing.paper_rule(footing.footing_scene(17)))


def test_frames_hold_symmetric_stress(turned: lp.Scene, tmp_path: Path) -> None:
    """Six components become a full tensor, which ParaView takes invariants of."""
    result = lp.run(turned, tmp_path / "block.vtkhdf", progress=False)
    frame = list(result.frames)[-1]
    assert frame["stress"].shape == (len(result.simulation), 9)
    np.testing.assert_array_equal(frame["stress"][:, 1], frame["stress"][:, 3])
    np.testing.assert_array_equal(frame["stress"][:, [0, 4, 8]], result["stress"][:, :3])


def test_resumed_run_gives_the_same_bytes(tmp_path: Path) -> None:
    """Stopped after 7 of 12 load steps, between two resets of the grid."""
    scene = block.block_scene(30, 0.01).set("time.steps=12")
    section(scene).supports[-1].displacement = ramp(0.004 * Frame(30).e1)
    whole = lp.run(scene, tmp_path / "whole.vtkhdf", progress=False)
    lp.run(
        scene,
        tmp_path / "part.vtkhdf",
        progress=False,
        callback=lambda simulation: simulation.step_index < 7,
    )
    resumed = lp.run(scene, tmp_path / "part.vtkhdf", progress=False, resume=True)
    for name in ("position", "stress", "displacement"):
        np.testing.assert_array_equal(resumed[name], whole[name])
    assert resumed.simulation.diagnostics() == whole.simulation.diagnostics()


def test_same_bytes_for_any_number_of_threads() -> None:
    scene = footing.footing_scene(40).set("time.end=0.1").set("time.steps=4")
    found = [lp.run(scene, progress=False, threads=threads) for threads in (1, 2, 3)]
    for other in found[1:]:
        np.testing.assert_array_equal(found[0]["stress"], other["stress"])


def refusal(scene: lp.Scene) -> str:
    """What building the scene says."""
    with pytest.raises(ValueError, match=r"\w") as caught:
        lp.Simulation(scene)
    return str(caught.value)


def failure(scene: lp.Scene) -> str:
    """What its first load step says."""
    with pytest.raises(lp.RunError) as caught:
        lp.Simulation(scene).step()
    return str(caught.value)


def test_a_wall_that_cuts_nothing_is_named(turned: lp.Scene) -> None:
    far = Frame(30).roller("far", (0.14, 0.0), (-1, 0))
    section(turned).supports = [*section(turned).supports, far]
    assert "support 'far' cuts no material" in refusal(turned)


def test_walls_that_contradict_each_other_are_named(turned: lp.Scene) -> None:
    lines = [[0.0, 0.1], [0.0, 0.0]]
    for name, motion in (("one", 0.0), ("other", 1e-3)):
        line = Frame(30).line(*[tuple(place) for place in lines])
        wall = lp.Support(name=name, kind="fixed", line=line)
        if motion:
            wall.displacement = ramp([motion, 0.0])
        section(turned).supports = [*section(turned).supports, wall]
    said = failure(turned)
    assert "and 'other' contradict each other" in said
    assert "step 0" in said


def test_the_rigid_motion_that_is_left_is_named(turned: lp.Scene) -> None:
    section(turned).supports = [
        wall for wall in section(turned).supports if wall.name in ("base", "top")
    ]
    assert "held by nothing against translation along (0.866025, 0.5)" in failure(turned)


def test_a_step_that_pushes_points_through_a_wall_is_refused() -> None:
    """A soft penalty gives way: the message names the wall, and what to do."""
    scene = column.column_scene(0, 0.02)
    scene.grid.lower = [-0.02, -0.1]
    settings = section(scene)
    settings.enforcement, settings.bandwidth, settings.max_cutbacks = "penalty", 1.0, 1
    settings.max_penetration = 0.1
    settings.body_force = ramp([0.0, -2e10])
    said = failure(scene)
    assert "after 1 halvings" in said
    assert "through support 'base'" in said
    assert "the last converged state is kept" in said


def test_an_indefinite_matrix_is_refused(turned: lp.Scene) -> None:
    settings = section(turned)
    settings.enforcement, settings.gap_bandwidth, settings.ghost_penalty = "nitsche", 1.0, 0.0
    said = failure(turned)
    assert "not positive definite" in said
    assert "next to support" in said


def test_the_last_converged_state_is_written(tmp_path: Path) -> None:
    """A body torn apart until it leaves the grid, after half of the run: frame, record and
    checkpoint hold the state before that, though no frame was due then."""
    scene = block.block_scene(0, 0.02).set("time.steps=4")
    settings = section(scene)
    settings.reset = 0.0
    settings.supports[-1].kind = "roller"
    settings.supports[-1].displacement = [([0.0, 0.5, 1.0], [0.0, 0.0005, 0.5]), 0.0]
    output = tmp_path / "torn.vtkhdf"
    with pytest.raises(lp.RunError, match=r"last good frame is that of time 0\.5\d+ s"):
        lp.run(scene, output, progress=False)
    frames = lp.Frames(output)
    assert 0.5 <= frames.times[-1] < 0.75
    record = json.loads(output.with_suffix(".json").read_text())
    assert record["status"] == "failed"
    assert "leaves the grid" in record["message"]
    resumed = lp.Simulation(scene)
    resumed.run_until(0.5)
    assert output.with_suffix(".checkpoint").exists()
    assert len(frames[-1].position) == len(resumed)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ("quasi_static.bandwidth=0", "above 0"),
        ("quasi_static.enforcement=mean", "mean-gap"),
        ("quasi_static.supports.0.kind=slip", "roller"),
        ("quasi_static.supports.0.knd=roller", "kind"),
        ("quasi_static.tolerance=-1", "above 0"),
        ("grid.shape_function=bspline", "linear or gimp"),
    ],
)
def test_settings_out_of_range_are_refused(turned: lp.Scene, change: str, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        lp.Simulation(turned.set(change))


def test_sections_that_do_not_go_together_are_refused(turned: lp.Scene) -> None:
    heated = turned.set("time.steps=1")
    heated.heat = lp.Heat()
    heated.bodies[0].material = [
        heated.bodies[0].material,
        lp.Thermal(density=1, specific_heat=1, conductivity=1),
    ]
    assert "coupling is not modelled" in refusal(heated)
    moved = block.block_scene(30, 0.02)
    moved.bodies[0].motion = lp.Translation(velocity=[1.0, 0.0])
    assert "moves the points itself" in refusal(moved)
    soft = block.block_scene(30, 0.02)
    soft.bodies[0].material = [lp.Thermal(density=1, specific_heat=1, conductivity=1)]
    assert "no solid material" in refusal(soft)
    infinite = block.block_scene(30, 0.02)
    infinite.time.steps = None
    assert "time.steps" in refusal(infinite)


@pytest.mark.parametrize(("steps", "reset"), [(1, 0.1), (7, 0.1), (7, 0.0)])
def test_walls_carry_the_weight_in_any_number_of_steps(steps: int, reset: float) -> None:
    """On one grid for all steps and with a reset at every one, whose imbalance is carried along:
    the walls together carry the weight to 1e-9, the residual asked for being 1e-10."""
    scene = column.column_scene(20, 0.02).set(f"time.steps={steps}")
    section(scene).reset = reset
    state = balance(scene)
    force = sum(state.wall_force(wall) for wall in ("left", "right", "base"))
    weight = column.WEIGHT * column.SIZE**2 * Frame(20).e2
    np.testing.assert_allclose(force, weight, rtol=0, atol=1e-9 * np.linalg.norm(weight))


@pytest.mark.parametrize(("steps", "every"), [(1, 0.5), (3, 0.25), (4, 0.1)])
def test_frames_do_not_change_results(steps: int, every: float, tmp_path: Path) -> None:
    """A load step is not cut where a frame is due: the frame follows at its end."""
    scene = lp.Scene.load(str(EXAMPLES[0].parent / "beam.toml")).set(f"time.steps={steps}")
    plain = lp.run(scene, tmp_path / "plain.vtkhdf", progress=False)
    framed = lp.run(scene, tmp_path / "framed.vtkhdf", every, progress=False)
    for name in ("position", "stress", "displacement"):
        np.testing.assert_array_equal(framed[name], plain[name])
    assert framed.simulation.step_index == steps
    ends = np.linspace(0, 1, steps + 1)
    np.testing.assert_allclose(lp.Frames(tmp_path / "framed.vtkhdf").times, ends, atol=1e-12)


def test_large_strains_are_warned_of(tmp_path: Path) -> None:
    scene = block.block_scene(0, 0.02)
    small = lp.run(scene, tmp_path / "small.vtkhdf", progress=False)
    assert small.warnings == []
    section(scene).supports[-1].displacement = ramp([0.004, 0.0])
    large = lp.run(scene, tmp_path / "large.vtkhdf", progress=False)
    assert "the largest strain is 0.04" in large.warnings[0]
