"""Whole runs as other programs see them: the record, resuming after a kill, merging."""

import json
import os
import signal
import subprocess

import h5py
import numpy as np
import pytest


def drive(drivers, *words, **environment):
    return subprocess.run(
        [drivers.run, *words], capture_output=True, text=True, env={**os.environ, **environment}
    )


def contents(folder):
    """What a resumed run must write alike; the record tells wall time and is left out."""
    return {file.name: file.read_bytes() for file in folder.iterdir() if file.suffix != ".json"}


def history(folder):
    return json.loads((folder / "run.json").read_text())["history"]


def test_the_record_says_everything(drivers, tmp_path):
    assert drive(drivers, "run", tmp_path / "run.vtkhdf").stdout == "finished\n"
    record = json.loads((tmp_path / "run.json").read_text())
    assert record["status"] == "finished"
    assert record["message"] == ""
    assert record["scene"] == '[time]\nend = 0.45  # "quoted"\n'
    assert record["settings"] == {"time": {"end": 0.45}}
    assert record["frames_file"] == "run.vtkhdf"
    assert record["frames"] == 6
    assert record["time"] == record["end"] == 0.45
    assert record["points"] == 5
    assert record["iterations"] == 2 * record["steps"]
    assert 0 < record["smallest_step"] <= record["largest_step"] < 0.05
    assert record["threads"] >= 1
    assert record["wall_seconds"] > 0
    speed = record["points"] * record["steps"] / record["wall_seconds"]
    assert record["point_steps_per_second"] == pytest.approx(speed)
    assert record["peak_memory_bytes"] > 1_000_000
    (physics,) = record["physics"]
    (balance,) = physics["balances"]
    # Sums of five numbers over some twenty steps: rounding of 1e-16 each.
    assert abs(balance["residual"]) < 1e-13
    assert balance["stored"] - balance["initial"] == pytest.approx(balance["entries"][0]["in"])
    assert 0 < physics["diagnostics"]["hottest"] < 2
    told = history(tmp_path)
    assert len(told["time"]) == record["frames"]
    assert told["time"][0] == 0
    assert told["time"][-1] == record["end"]
    (hottest,) = (values for name, values in told.items() if name.endswith("/hottest"))
    assert len(hottest) == record["frames"]
    assert hottest[-1] == physics["diagnostics"]["hottest"] < hottest[0]


@pytest.mark.parametrize("stride", [4, pytest.param(1, marks=pytest.mark.slow)])
def test_a_run_killed_at_any_write_resumes_to_the_same_bytes(drivers, tmp_path, stride):
    if not drivers.kill_at_write.exists():
        pytest.skip("a sanitizer build has no library that kills at a write")
    whole = tmp_path / "whole"
    drive(drivers, "run", whole / "run.vtkhdf")
    resumed = 0
    for position in range(0, 1000, stride):
        folder = tmp_path / str(position)
        output = folder / "run.vtkhdf"
        environment = {"LD_PRELOAD": str(drivers.kill_at_write), "KILL_AT_WRITE": str(position)}
        killed = drive(drivers, "run", output, **environment)
        if killed.returncode == 0:
            break
        assert killed.returncode == -signal.SIGKILL
        if (folder / "run.checkpoint").exists():
            resumed += 1
            again = drive(drivers, "resume", output)
        else:  # killed before the first acknowledged checkpoint
            again = drive(drivers, "run", output)
        assert again.stdout == "finished\n", again.stderr
        assert contents(folder) == contents(whole)
        assert history(folder) == history(whole)
    assert resumed > 30 // stride  # frames 1 to 5, with more than six calls each


def test_a_resume_killed_at_any_write_can_be_resumed(drivers, tmp_path):
    if not drivers.kill_at_write.exists():
        pytest.skip("a sanitizer build has no library that kills at a write")
    whole = tmp_path / "whole"
    drive(drivers, "run", whole / "run.vtkhdf")
    shim = {"LD_PRELOAD": str(drivers.kill_at_write)}
    for position in range(1000):
        folder = tmp_path / str(position)
        output = folder / "run.vtkhdf"
        drive(drivers, "run", output, **shim, KILL_AT_WRITE="60")
        assert (folder / "run.checkpoint").exists()
        killed = drive(drivers, "resume", output, **shim, KILL_AT_WRITE=str(position))
        assert drive(drivers, "resume", output).stdout == "finished\n"
        assert contents(folder) == contents(whole)
        if killed.returncode == 0:
            break
    assert position > 10


def test_a_merged_run_reads_like_the_run(drivers, tmp_path):
    pyvista = pytest.importorskip("pyvista")
    path, merged = tmp_path / "run.vtkhdf", tmp_path / "alone" / "merged.vtkhdf"
    merged.parent.mkdir()
    drive(drivers, "run", path)
    run = drive(drivers, "merge", path, merged)
    assert run.returncode == 0, run.stderr
    assert merged.stat().st_size < 40_000
    for frame in range(6):
        meshes = []
        for file in (path, merged):
            reader = pyvista.get_reader(file).reader
            reader.SetStep(frame)
            reader.Update()
            meshes.append(pyvista.wrap(reader.GetOutputDataObject(0)))
        assert meshes[1].n_verts == meshes[1].n_points == 5
        np.testing.assert_array_equal(meshes[0].points, meshes[1].points)
        for name in ("temperature", "id", "volume", "body"):
            np.testing.assert_array_equal(
                meshes[0].point_data[name], meshes[1].point_data[name], err_msg=name
            )
    with h5py.File(merged, "r") as file:
        assert file["VTKHDF/PointData/temperature"].attrs["unit"] == b"K"
