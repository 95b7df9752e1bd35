"""What a run in stages leaves: frames, history, balances, checkpoints; what its file says."""

from __future__ import annotations

import os
import pickle
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp

sys.path.insert(0, str(Path(__file__).parent))
from stage_scenes import STEP, WEAKER, cut, everything, files_of

sys.path.pop(0)


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


def test_both_front_ends_write_the_same_bytes(tmp_path: Path) -> None:
    folder = os.environ.get("LAPILLI_BUILD")
    if not folder:
        pytest.skip("LAPILLI_BUILD does not name a build folder with the executable")
    scene = everything(heat=True)
    scene.save(tmp_path / "scene.toml")
    lp.run(scene, tmp_path / "python.vtkhdf", progress=False)
    program = Path(folder).resolve() / "cpp" / "lapilli-run"
    subprocess.run(
        [program, "scene.toml", "--quiet", "--output", "program.vtkhdf"], cwd=tmp_path, check=True
    )
    assert files_of(tmp_path / "program.vtkhdf") == files_of(tmp_path / "python.vtkhdf")


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


def test_tables_hold_points_that_come_and_go(tmp_path: Path) -> None:
    frames = lp.run(everything(), tmp_path / "run.vtkhdf", progress=False).frames
    gone, new = int(frames[0].body("ballast")["id"][0]), int(frames[-1].body("dam")["id"][0])
    for point, there in ((gone, frames.times <= 100 * STEP), (new, frames.times > 100 * STEP)):
        series = np.asarray(frames.time_series("density", point=point)["density"])
        np.testing.assert_array_equal(np.isfinite(series), there)
    with pytest.raises(ValueError, match="there is no point"):
        frames.time_series("density", point=new + 1000)
    pytest.importorskip("xarray")
    table = frames.to_xarray()
    assert table.sizes["point"] == len(np.union1d(frames[0]["id"], frames[-1]["id"]))
    assert int(table["body"].sel(point=new)) == 2
    assert np.isnan(table["density"].sel(point=new)[0])
    assert float(table["density"].sel(point=new)[-1]) == frames[-1].body("dam")["density"][0]


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
