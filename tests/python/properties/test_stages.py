"""Stages of one run: each goes on from the state before, with other loads, strengths, bodies."""

from __future__ import annotations

import pickle
import re
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp

G = 9.81
STEP = 2.0**-9  # s: times of a run and of its parts are then the same to the last bit


def soil(cohesion: float = 20e3, **changes: float) -> lp.MohrCoulomb:
    values = {"density": 2000, "youngs_modulus": 2e7, "poissons_ratio": 0.3, "friction_angle": 20}
    return lp.MohrCoulomb(cohesion=cohesion, dilatancy_angle=0, **{**values, **changes})


def cut(dimension: int = 2, heat: bool = False, **dynamics: object) -> lp.Scene:
    """A slope of 45 degrees, prismatic in space, with a box of ballast on its crest."""
    flat = slice(dimension)
    profile = [(0, 0), (8, 0), (8, 1), (5, 1), (3, 3), (0, 3)]
    shape: lp.Polygon | lp.Difference = lp.Polygon(vertices=profile)
    if dimension == 3:
        shape = lp.Difference(
            shape=lp.Box(lower=(0, 0, 0), upper=(8, 3, 1)),
            minus=lp.Box(lower=(4, 1, 0), upper=(8, 3, 1)),
        )
    thermal = [lp.Thermal(density=2000, specific_heat=800, conductivity=2)] if heat else []
    faces = ["y_lower", "x_lower", "x_upper", "z_lower", "z_upper"][: 3 if dimension == 2 else 5]
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0, 0)[flat], upper=(8, 5, 1)[flat], cell=0.5),
        bodies=[
            lp.Body(
                name="slope",
                shape=shape,
                material=[soil(), *thermal],
                geostatic=lp.Geostatic(k0=0.5),
                temperature=290,
            ),
            lp.Body(
                name="ballast",
                shape=lp.Box(lower=(0, 3, 0)[flat], upper=(2, 4, 1)[flat]),
                material=[soil(1e5), *thermal],
                temperature=350,
            ),
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -G, 0)[flat],
            grid_boundaries=[
                lp.NoSlipBoundary(face=faces[0]),
                *(lp.RollerBoundary(face=face) for face in faces[1:]),
            ],
            **{"local_damping": 0.5, **dynamics},
        ),
        heat=lp.Heat(boundaries=[lp.Convection(coefficient=20, ambient=250)]) if heat else None,
        time=lp.Time(end=64 * STEP, step=STEP),
        output=lp.Output(every=32 * STEP),
    )


WEAKER = {"bodies.slope.material.mohr_coulomb.cohesion": 500.0, "dynamics.local_damping": 0.0}


def weakened(scene: lp.Scene, **changes: object) -> lp.Scene:
    scene.stages = [lp.Stage(name="weak", end=160 * STEP, set=WEAKER, **changes)]
    return scene


def fields_of(result: lp.Result | lp.Simulation, heat: bool = False) -> dict[str, np.ndarray]:
    names = ["position", "velocity", "stress", "density", *(["temperature_carried"] * heat)]
    return {name: result.by_id(name) for name in names}


@pytest.mark.parametrize("heat", [False, True], ids=["cold", "heat"])
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("transfer", ["blended_apic", "flip"])
def test_two_stages_are_two_runs_that_are_linked(
    tmp_path: Path, transfer: str, dimension: int, heat: bool
) -> None:
    first = cut(dimension, heat, transfer=transfer)
    lp.run(first, tmp_path / "rest.vtkhdf", progress=False)
    second = cut(dimension, heat, transfer=transfer, local_damping=0)
    second.bodies[0].material[0].cohesion = 500
    second.initial_state = tmp_path / "rest.checkpoint"
    second.time.end = 96 * STEP
    linked = lp.run(second, progress=False)
    staged = lp.run(weakened(first), tmp_path / "staged.vtkhdf", progress=False)
    assert staged.time == 160 * STEP
    assert staged.simulation.stage == "weak"
    for name, values in fields_of(linked, heat).items():
        np.testing.assert_array_equal(staged.by_id(name), values, err_msg=name)
    # It did change something.
    strong = cut(dimension, heat, transfer=transfer, local_damping=0)
    strong.initial_state = tmp_path / "rest.checkpoint"
    strong.time.end = 96 * STEP
    assert np.abs(lp.run(strong, progress=False)["velocity"] - staged["velocity"]).max() > 1e-3


def everything(heat: bool = False) -> lp.Scene:
    """Three stages after the first: weaker, without ballast and with a dam, at rest with a load."""
    scene = cut(heat=heat, obstacles=[boulder(), plate()])
    scene.bodies[0].name = "slope"
    thermal = [lp.Thermal(density=2400, specific_heat=800, conductivity=2)] if heat else []
    dam = lp.Body(
        name="dam",
        shape=lp.Box(lower=(6, 1), upper=(7, 2)),
        material=[lp.Elastic(density=2400, youngs_modulus=3e7, poissons_ratio=0.2), *thermal],
        temperature=280,
    )
    scene.stages = [
        lp.Stage(name="weak", end=100 * STEP, set=WEAKER),
        lp.Stage(name="dam", end=140 * STEP, remove=["ballast", "plate"], add_bodies=[dam]),
        lp.Stage(
            name="load",
            end=170 * STEP,
            reset_velocity=True,
            add_boundaries=[
                lp.Pressure(name="fill", value=1e4, region=lp.Box(lower=(0, 2.5), upper=(2, 3.5)))
            ],
        ),
    ]
    return scene


def boulder() -> lp.Obstacle:
    return lp.Obstacle(
        name="boulder", shape=lp.Disk(center=(6.5, 4), radius=0.4), mass=500, velocity=(-1, 0)
    )


def plate() -> lp.Obstacle:
    return lp.Obstacle(name="plate", shape=lp.Box(lower=(7.5, 3), upper=(8, 3.5)), velocity=(0, 1))


def files_of(path: Path) -> dict[str, bytes]:
    names = [".vtkhdf.data", ".checkpoint", ".csv"]
    return {name: path.with_suffix(name).read_bytes() for name in names}


@pytest.mark.parametrize("heat", [False, True], ids=["cold", "heat"])
@pytest.mark.parametrize("stop", [20, 64, 65, 80, 100, 120, 140, 141, 160])
def test_a_run_resumed_in_any_stage_has_the_same_bytes(
    tmp_path: Path, stop: int, heat: bool
) -> None:
    scene = everything(heat)
    whole = tmp_path / "whole.vtkhdf"
    lp.run(scene, whole, progress=False)
    parts = tmp_path / "parts.vtkhdf"
    lp.run(scene, parts, progress=False, callback=lambda now: now.step_index < stop)
    result = lp.run(scene, parts, progress=False, resume=True)
    assert result.summary.finished
    for name, content in files_of(whole).items():
        assert files_of(parts)[name] == content, name


def test_any_number_of_threads_gives_the_same_bytes(tmp_path: Path) -> None:
    for threads in (1, 2, 3):
        lp.run(everything(True), tmp_path / f"{threads}.vtkhdf", progress=False, threads=threads)
    one = files_of(tmp_path / "1.vtkhdf")
    assert one == files_of(tmp_path / "2.vtkhdf") == files_of(tmp_path / "3.vtkhdf")


def test_bodies_keep_their_numbers_and_points_their_ids(tmp_path: Path) -> None:
    result = lp.run(everything(), tmp_path / "run.vtkhdf", progress=False)
    frames = result.frames
    assert frames.body_names == ["slope", "ballast", "dam"]
    assert frames.times.tolist() == [k * STEP for k in (0, 32, 64, 96, 100, 128, 140, 160, 170)]
    slope = frames[0].body("slope")["id"]
    ballast = frames[0].body("ballast")["id"]
    dam = frames[-1].body("dam")["id"]
    for frame in frames:
        np.testing.assert_array_equal(frame.body("slope")["id"], slope)
        before = frame.time <= 100 * STEP
        np.testing.assert_array_equal(frame.body("ballast")["id"], ballast if before else [])
        np.testing.assert_array_equal(frame.body("dam")["id"], [] if before else dam)
    assert dam.min() > ballast.max()
    assert len(result.body("dam")) == len(dam)
    assert set(result.simulation.volumes()) == {"slope", "dam"}


def test_balances_close_over_stages_and_say_what_they_took(tmp_path: Path) -> None:
    scene = everything(heat=True)
    scene.heat.boundaries = []
    result = lp.run(scene, tmp_path / "run.vtkhdf", progress=False)
    heat = result.balance["heat"]
    entries = dict(heat.entries)
    frames = result.frames
    before = frames[int(np.argmin(np.abs(frames.times - 100 * STEP)))]
    # 800 J/(kg K): what the ballast carried then, and the dam when it came.
    mass = before.body("ballast")["density"] * before.body("ballast")["volume"]
    carried = 800 * mass @ before.body("ballast")["temperature_carried"]
    assert entries["stage dam removed"] == pytest.approx(-carried, rel=1e-12)
    assert entries["stage dam added"] == pytest.approx(2400 * 800 * 280 * 1.0, rel=1e-9)
    # Nothing else has happened to the heat; rounding of a million joules.
    assert abs(heat.stored - heat.initial - heat.supplied) < 1e-9 * heat.initial
    for axis in "xy":
        momentum = result.balance[f"momentum {axis}"]
        assert abs(momentum.residual) < 1e-9
    still = dict(result.balance["momentum y"].entries)
    assert abs(still["stage load changed"]) > 1  # motion that was taken away
    # Strain is half a step ahead of the force that answers it, as in runs of one stage.
    assert abs(result.balance["energy"].residual) < 3e-3
    record = result.record
    assert record["stage"] == "load"
    names = [one["name"] for one in record["physics"][0]["balances"][0]["entries"]]
    assert "stage dam removed" in names


def test_the_history_has_the_columns_of_all_stages(tmp_path: Path) -> None:
    result = lp.run(everything(), tmp_path / "run.vtkhdf", progress=False)
    history = result.summary.history
    times = history["time"]
    pushed = history["dynamics/plate_force_x"]
    loaded = history["momentum_y/supplied_by_fill"]
    gone, new = times > 100 * STEP, times <= 140 * STEP
    assert np.all(np.isfinite(pushed[~gone]))
    assert np.all(np.isnan(pushed[gone]))
    assert np.all(np.isnan(loaded[new]))
    assert np.all(np.isfinite(loaded[~new]))
    # What counts up goes on over the stages.
    for name in ("dynamics/plastic_dissipation", "momentum_y/supplied_by_gravity"):
        steps = np.diff(np.abs(history[name]))
        assert np.all(steps >= 0), name
    assert (
        history["momentum_y/supplied_by_gravity"][-1]
        < 2 * history["momentum_y/supplied_by_gravity"][2]
    )


def test_obstacles_go_on_with_their_motion() -> None:
    scene = everything()
    scene.bodies.pop()
    scene.stages[0].set = {"bodies.slope.material.cohesion": 500.0}  # damping stays: it acts on it
    scene.stages[1].remove = ["plate"]
    free = lp.Simulation(scene)
    alone = everything()
    alone.bodies.pop()
    alone.stages = []
    alone.time.end = 170 * STEP
    one = lp.Simulation(alone)
    for time in (64 * STEP, 90 * STEP, 130 * STEP):
        free.run_until(time)
        one.run_until(time)
        for name in ("position_x", "position_y", "velocity_y"):
            key = f"dynamics/boulder_{name}"
            assert free.diagnostics()[key] == pytest.approx(one.diagnostics()[key], abs=1e-12)


def test_bodies_that_slid_are_not_bonded_by_a_stage() -> None:
    """A block rests on a plane of ten degrees; a stage takes its friction away."""
    tilt = np.radians(10)
    rock = lp.Elastic(density=2000, youngs_modulus=1e7, poissons_ratio=0.2)
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(8, 3), cell=0.25),
        bodies=[
            lp.Body(name="base", shape=lp.Box(lower=(0, 0), upper=(8, 1)), material=rock),
            lp.Body(name="block", shape=lp.Box(lower=(1, 1), upper=(2, 2)), material=rock),
        ],
        dynamics=lp.Dynamics(
            gravity=(G * np.sin(tilt), -G * np.cos(tilt)),
            grid_boundaries=[lp.NoSlipBoundary(face="y_lower")],
            contacts=[lp.BodyContact(bodies=("base", "block"), friction=0.5)],
            local_damping=0.7,
        ),
        time=lp.Time(end=0.3),
        stages=[
            lp.Stage(
                name="ice",
                end=0.6,
                set={"dynamics": {"contacts": [{"friction": 0.0}], "local_damping": 0.0}},
            ),
            lp.Stage(name="defaults", end=0.7, set={"dynamics.contacts": []}),
        ],
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(0.3)
    block = simulation["body"] == 1
    rest = simulation["velocity"][block, 0].mean()
    assert abs(rest) < 0.02
    simulation.run_until(0.6)
    # Slides by gravity along the plane: 1 % as of blocks on planes.
    speed = simulation["velocity"][simulation["body"] == 1, 0].mean()
    assert speed - rest == pytest.approx(G * np.sin(tilt) * 0.3, rel=0.02)
    simulation.run_until(0.7)
    speed = simulation["velocity"][simulation["body"] == 1, 0].mean()
    assert speed - rest == pytest.approx(G * np.sin(tilt) * 0.4, rel=0.02)


def test_a_solid_may_become_another_one(tmp_path: Path) -> None:
    """An elastic slope comes to rest; then it may yield, by a law that has more to remember."""
    scene = cut()
    elastic = lp.Elastic(density=2000, youngs_modulus=2e7, poissons_ratio=0.3)
    scene.bodies[0].material = [elastic]
    law = {
        "kind": "drucker_prager",
        "density": 2000,
        "youngs_modulus": 2e7,
        "poissons_ratio": 0.3,
        "friction_angle": 20,
        "cohesion": 500.0,
    }
    scene.stages = [lp.Stage(name="yield", end=160 * STEP, set={"bodies.slope.material": law})]
    frames = lp.run(scene, tmp_path / "run.vtkhdf", progress=False).frames
    assert np.all(frames.at(64 * STEP).body("slope")["plastic_strain"] == 0)
    assert frames[-1].body("slope")["plastic_strain"].max() > 1e-4


def test_heat_goes_on_with_the_points(tmp_path: Path) -> None:
    scene = cut(heat=True)
    scene.heat.boundaries = []
    rested = lp.run(scene, tmp_path / "rest.vtkhdf", progress=False)
    second = cut(heat=True)
    second.heat.boundaries = []
    second.initial_state = tmp_path / "rest.checkpoint"
    second.bodies[0].material = [
        soil(),
        lp.Thermal(density=2000, specific_heat=1600, conductivity=2),
    ]
    linked = lp.Simulation(second)
    np.testing.assert_array_equal(
        linked.by_id("temperature_carried"), rested.by_id("temperature_carried")
    )
    # The capacity belongs to the mass, although volumes have changed.
    part = rested.by_id("body") == 0
    mass = rested.by_id("density") * rested.by_id("volume")
    heat = mass * np.where(part, 1600, 800) * rested.by_id("temperature_carried")
    stored = {one.quantity: one.stored for one in linked.balance()}
    assert stored["heat"] == pytest.approx(heat.sum(), rel=1e-12)
    assert np.abs(rested.by_id("volume") / linked.by_id("volume") - 1).max() == 0


def test_a_slope_below_its_factor_of_safety_stays(tmp_path: Path) -> None:
    """Bishop & Morgenstern 1960, Griffiths & Lane 1999 (example 1): a slope of 1 : 2 in soil of 20
    degrees with c / (gamma H) = .05 has a factor of 1.38 to 1.40."""
    known, cell, height = 1.38, 0.5, 10.0
    cohesion, tangent = 0.05 * 2000 * G * height, np.tan(np.radians(20))

    def strength(factor: float) -> dict[str, float]:
        return {
            "bodies.slope.material.cohesion": cohesion / factor,
            "bodies.slope.material.friction_angle": float(np.degrees(np.arctan(tangent / factor))),
        }

    profile = [(0, 0), (44, 0), (44, 2), (32, 2), (12, 12), (0, 12)]
    law = soil(cohesion, youngs_modulus=1e8)
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(44, 13), cell=cell),
        bodies=[
            lp.Body(
                name="slope",
                shape=lp.Polygon(vertices=profile),
                material=[law],
                geostatic=lp.Geostatic(k0=0.5),
            )
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -G),
            grid_boundaries=[
                lp.NoSlipBoundary(face="y_lower"),
                lp.RollerBoundary(face="x_lower"),
                lp.RollerBoundary(face="x_upper"),
            ],
            local_damping=0.7,
        ),
        time=lp.Time(end=1.0),
        stages=[
            lp.Stage(name="below", end=2.0, set=strength(0.95 * known)),
            lp.Stage(name="above", end=4.0, set=strength(1.25 * known)),
        ],
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(1.0)
    rest = simulation.by_id("position")
    simulation.run_until(2.0)
    moved = np.abs(simulation.by_id("position") - rest).max()
    simulation.run_until(4.0)
    failed = np.abs(simulation.by_id("position") - rest).max()
    assert moved < cell / 100
    assert failed > cell / 5


def test_scenes_without_stages_know_nothing_of_them(tmp_path: Path) -> None:
    lp.run(cut(), tmp_path / "run.vtkhdf", progress=False)
    content = (tmp_path / "run.checkpoint").read_bytes()
    assert b"stage/" not in content
    assert b"history_units" not in content
    assert "stages" not in cut().to_toml()


def test_a_scene_with_stages_is_the_same_from_its_file() -> None:
    scene = everything(heat=True)  # lists of one material are written as the one
    again = lp.Scene.parse(scene.to_toml())
    assert again == scene
    assert pickle.loads(pickle.dumps(scene)) == scene
    assert lp.Scene.parse(again.to_toml(everything=True)) == scene
    text = """
    [[stages]]
    name = "weak"
    end = 2.0
    [stages.set]
    "dynamics.local_damping" = 0.1
    bodies.slope.material.mohr_coulomb.cohesion = 500.0
    dynamics.gravity_factor = {times = [1.0, 2.0], values = [1.0, 2.0]}
    """
    nested = lp.Scene.parse(cut().to_toml() + text)
    flat = cut()
    flat.stages = [
        lp.Stage(
            name="weak",
            end=2.0,
            set={
                **WEAKER,
                "dynamics.local_damping": 0.1,
                "dynamics.gravity_factor": lp.Table([1.0, 2.0], [1.0, 2.0]),
            },
        )
    ]
    runs = [lp.Simulation(one) for one in (nested, flat)]
    for run in runs:
        run.run_until(100 * STEP)
    np.testing.assert_array_equal(runs[0]["velocity"], runs[1]["velocity"])


def test_check_tells_every_stage() -> None:
    from lapilli import _core

    text = _core.check_text(everything())
    lines = [line for line in text.splitlines() if line.startswith("stage ")]
    assert re.search(r"weak: .*cohesion = 500\.0, dynamics.local_damping = 0\.0", lines[0])
    assert "without ballast, without plate, with body dam" in lines[1]
    assert "with load pressure" in lines[2]
    assert re.search(r"about 30 steps", lines[2])


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
        ([stage(set={"time.steps": 3, "time.step": 0.1})], None),
    ],
)
def test_a_stage_that_cannot_be_is_refused_by_name(
    stages: list[lp.Stage], message: str | None
) -> None:
    scene = cut()
    scene.stages = stages
    if message is None:
        return
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
