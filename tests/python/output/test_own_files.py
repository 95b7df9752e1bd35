"""Nothing that the user made is written over or removed: what a scene reads, tables, pictures."""

import os
import threading

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core
from lapilli.cli import main


@pytest.fixture
def saved(ring, tmp_path, monkeypatch):
    """The ring in a file, where the commands are given."""
    monkeypatch.chdir(tmp_path)
    ring.save("ring.toml")
    return tmp_path


def test_a_history_does_not_take_the_place_of_the_points_it_began_with(ring, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    at = np.arange(4) + 0.5
    rows = [f"{x},{y},1" for x in at for y in at]
    (tmp_path / "points.csv").write_text("\n".join(["x,y,volume", *rows]) + "\n")
    before = (tmp_path / "points.csv").read_bytes()
    ring.bodies[0].shape = None
    ring.bodies[0].points_per_cell = None
    ring.bodies[0].points_file = "points.csv"
    ring.save("scene.toml")
    lp.run("scene.toml", "other.vtkhdf", progress=False)
    (tmp_path / "other.json").rename(tmp_path / "points.json")  # which would make it lapilli's
    for words in ([], ["--resume"]):
        assert main(["run", "scene.toml", "--output", "points.vtkhdf", "-q", *words]) == 2
        assert (tmp_path / "points.csv").read_bytes() == before
        assert not (tmp_path / "points.vtkhdf").exists()
    os.link("points.csv", "same.csv")
    assert main(["run", "scene.toml", "--output", "same.vtkhdf", "-q"]) == 2
    ring.output = lp.Output(path=str(tmp_path / "points.vtkhdf"))
    with pytest.raises(ValueError, match=r"points\.csv' is read by this scene"):
        _core.check_text(ring)


def test_a_picture_nobody_named_replaces_pictures_of_its_kind_only(saved):
    assert main(["run", "ring.toml", "-q"]) == 0
    (saved / "ring.png").write_bytes(b"\x89PNG the mask of a scene")
    assert main(["plot", "ring.vtkhdf"]) == 2
    assert (saved / "ring.png").read_bytes() == b"\x89PNG the mask of a scene"
    assert main(["plot", "ring.vtkhdf", "--save", "ring.png"]) == 0  # the user's own word
    assert main(["plot", "ring.vtkhdf"]) == 0
    frames = (saved / "ring.vtkhdf").read_bytes()
    assert main(["plot", "ring.vtkhdf", "--save", "./ring.vtkhdf"]) == 2
    assert (saved / "ring.vtkhdf").read_bytes() == frames


def test_a_study_keeps_the_table_of_its_cases(saved):
    cases = saved / "ring-study.csv"
    cases.write_text("grid.cell\n0.5\n")
    assert main(["study", "ring.toml", "--cases", "ring-study.csv", "-q"]) == 2
    assert cases.read_text() == "grid.cell\n0.5\n"
    assert main(["study", "ring.toml", "--vary", "grid.cell=0.5", "-q"]) == 2  # not its own
    cases.unlink()
    for _ in range(2):
        assert main(["study", "ring.toml", "--vary", "grid.cell=0.5", "-q"]) == 0


def test_a_tradeoff_keeps_the_record_of_a_run(saved):
    assert main(["run", "ring.toml", "-q"]) == 0
    kept = {name: (saved / name).read_bytes() for name in ("ring.json", "ring.csv")}
    words = ["tradeoff", "ring.toml", "--vary", "grid.cell=0.5", "--reference", "ring.vtkhdf"]
    assert main([*words, "--repeats", "1", "-q", "--output", "ring"]) == 2
    assert {name: (saved / name).read_bytes() for name in kept} == kept
    for _ in range(2):
        assert main([*words, "--repeats", "1", "-q"]) == 0


def test_files_stay_together_when_the_folder_of_the_process_changes(ring, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "elsewhere").mkdir()
    result = lp.run(
        ring,
        "run.vtkhdf",
        every=0.25,
        progress=False,
        callback=lambda simulation: os.chdir(tmp_path / "elsewhere"),
    )
    assert not list((tmp_path / "elsewhere").iterdir())
    assert result.record["status"] == "finished"
    assert len(result.frames) == 5
    assert result.frames.times[-1] == 1


def test_runs_beside_each_other_leave_the_threads_as_they_were(ring):
    before = _core.thread_count()
    inside = threading.Barrier(2)
    seen = []

    def wait(simulation):
        if simulation.step_index == 1:
            inside.wait(timeout=20)
        if len(seen) < 2:
            seen.append(simulation.step_index)

    def work(threads, end):
        scene = lp.Scene.parse(ring.to_toml())
        scene.time.end = end
        lp.run(scene, progress=False, threads=threads, callback=wait)

    both = [threading.Thread(target=work, args=pair) for pair in ((1, 0.3), (3, 1.0))]
    for one in both:
        one.start()
    for one in both:
        one.join()
    assert _core.thread_count() == before


def test_a_scene_file_that_is_no_scene_by_its_size_is_an_error_at_once(tmp_path):
    with (tmp_path / "sparse.toml").open("wb") as file:
        file.truncate(20 << 30)
    with pytest.raises(ValueError, match=r"sparse\.toml: has 21474836480 bytes"):
        lp.Scene.load(tmp_path / "sparse.toml")
    with pytest.raises(ValueError, match="missing"):
        lp.Scene.load("/proc/kmsg")  # a file without a length, and without an end


def test_memory_is_told_of_the_stage_that_takes_the_most():
    box = 'shape = {kind = "box", lower = [5.0, 5.0], upper = [39.0, 39.0]}'
    solid = (
        'material = {kind = "elastic", density = 2e3, youngs_modulus = 1e6, poissons_ratio = 0.3}'
    )
    scene = lp.Scene.parse(f"""
[grid]
lower = [0.0, 0.0]
upper = [40.0, 40.0]
cell = 0.05
[[bodies]]
name = "a"
shape = {{kind = "box", lower = [1.0, 1.0], upper = [3.0, 3.0]}}
{solid}
[dynamics]
[time]
end = 0.01
[[stages]]
name = "fill"
end = 0.02
[[stages.add_bodies]]
name = "b"
points_per_cell = 1000
{box}
{solid}
""")
    with pytest.raises(ValueError, match=r"bodies of stage 'fill' about 4.* points"):
        lp.Simulation(scene)
    with pytest.raises(ValueError, match="stage 'fill'"):
        _core.check_text(scene)
