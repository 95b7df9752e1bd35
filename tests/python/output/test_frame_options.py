"""What of the fields a run writes into its frames, and how."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pytest

import lapilli as lp
from lapilli import _core, plot
from lapilli.report import write_report

SINGLE = 2.0**-24  # relative error of rounding to four bytes


def block(**output: object) -> lp.Scene:
    """A block of 256 points that falls on a wall."""
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 2), cell=0.125),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(1, 0), upper=(2, 1)),
                material=lp.Elastic(density=1000, youngs_modulus=1e5, poissons_ratio=0.3),
                velocity=(0.5, -1.0),
            )
        ],
        dynamics=lp.Dynamics(gravity=(0, -10), grid_boundaries=[lp.RollerBoundary(face="y_lower")]),
        time=lp.Time(end=0.1),
        output=lp.Output(every=0.025, **output),
    )


@pytest.fixture
def whole(tmp_path: Path) -> lp.Frames:
    """The frames with everything in them, as they are without any option."""
    return lp.run(block(), tmp_path / "whole.vtkhdf", progress=False).frames


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("compression", [0, 6])
@pytest.mark.parametrize("merged", [False, True], ids=["run", "merged"])
def test_the_fields_asked_for_are_those_of_a_whole_run(
    tmp_path: Path, whole: lp.Frames, precision: str, compression: int, merged: bool
) -> None:
    path = tmp_path / "run.vtkhdf"
    scene = block(fields=["velocity", "stress"], precision=precision, compression=compression)
    lp.run(scene, path, progress=False)
    if merged:
        _core.merge(path, tmp_path / "one.vtkhdf")
        path = tmp_path / "one.vtkhdf"
    frames = lp.Frames(path)
    assert frames.fields == ["body", "id", "stress", "velocity", "volume"]
    assert frames.unit("stress") == "Pa"
    np.testing.assert_array_equal(frames.times, whole.times)
    for frame, full in zip(frames, whole, strict=True):
        np.testing.assert_array_equal(frame.position, full.position)
        np.testing.assert_array_equal(frame["volume"], full["volume"])
        np.testing.assert_array_equal(frame["id"], full["id"])
        for name in ("velocity", "stress"):
            assert frame[name].dtype == np.float64
            tolerance = SINGLE if precision == "single" else 0.0
            np.testing.assert_allclose(frame[name], full[name], rtol=tolerance, atol=1e-38)


@pytest.mark.parametrize("compression", [0, 6])
@pytest.mark.parametrize("merged", [False, True], ids=["run", "merged"])
def test_vtk_and_h5py_read_the_same(tmp_path: Path, compression: int, merged: bool) -> None:
    pyvista = pytest.importorskip("pyvista")
    path = tmp_path / "run.vtkhdf"
    result = lp.run(block(precision="single", compression=compression), path, progress=False)
    if merged:
        _core.merge(path, tmp_path / "one.vtkhdf")
        path = tmp_path / "one.vtkhdf"
    reader = pyvista.get_reader(path).reader
    for frame in result.frames:
        reader.SetStep(frame.number)
        reader.Update()
        mesh = pyvista.wrap(reader.GetOutputDataObject(0))
        np.testing.assert_array_equal(mesh.points, frame.position)
        np.testing.assert_array_equal(mesh.point_data["stress"], frame["stress"])
        assert mesh.point_data["stress"].dtype == np.float32
    with h5py.File(path, "r") as file:
        begin = file["VTKHDF/Steps/PointDataOffsets/density"][2]
        read = file["VTKHDF/PointData/density"][begin : begin + 256]
        np.testing.assert_array_equal(read, result.frames[2]["density"])


def test_the_state_and_the_checkpoint_are_those_of_a_whole_run(tmp_path: Path) -> None:
    few = lp.run(
        block(fields=[], precision="single", compression=9), tmp_path / "a.vtkhdf", progress=False
    )
    full = lp.run(block(), tmp_path / "b.vtkhdf", progress=False)
    np.testing.assert_array_equal(few["stress"], full["stress"])
    sizes = {(tmp_path / f"{name}.checkpoint").stat().st_size for name in "ab"}
    assert len(sizes) == 1
    # Checkpoints name their last frame by its checksum; all else of them is alike.
    saved = [np.fromfile(tmp_path / f"{name}.checkpoint", np.uint8) for name in "ab"]
    assert 0 < np.count_nonzero(saved[0] != saved[1]) <= 2 * 8
    np.testing.assert_array_equal(few.history["stress/largest"], full.history["stress/largest"])


def test_a_resumed_run_has_the_bytes_of_one_that_never_stopped(tmp_path: Path) -> None:
    options = {"fields": ["velocity"], "precision": "single", "compression": 3}
    steps = 0

    def stop(simulation: lp.Simulation) -> bool:
        nonlocal steps
        steps += 1
        return steps < 10

    lp.run(block(**options), tmp_path / "whole.vtkhdf", progress=False)
    path = tmp_path / "run.vtkhdf"
    stopped = lp.run(block(**options), path, progress=False, callback=stop)
    assert not stopped.summary.finished
    lp.run(block(**options), path, progress=False, resume=True)
    parts = [(tmp_path / f"{name}.vtkhdf.data").read_bytes() for name in ("run", "whole")]
    assert parts[0] == parts[1]


@pytest.mark.parametrize(
    "changed",
    [{"fields": ["stress"]}, {"precision": "single"}, {"compression": 1}],
    ids=["fields", "precision", "compression"],
)
def test_a_resume_with_another_form_of_frames_is_refused(
    tmp_path: Path, changed: dict[str, object]
) -> None:
    path = tmp_path / "run.vtkhdf"
    lp.run(block(), path, progress=False)
    before = path.read_bytes()
    longer = block(**changed)
    longer.time.end = 0.2
    with pytest.raises(ValueError, match=r"compression 0; this run asks for .*as they were"):
        lp.run(longer, path, progress=False, resume=True)
    assert path.read_bytes() == before
    longer.output = lp.Output(every=0.05)  # other times are no other form
    assert lp.run(longer, path, progress=False, resume=True).time == 0.2


def test_an_unknown_field_is_named_before_anything_is_written(tmp_path: Path) -> None:
    path = tmp_path / "run.vtkhdf"
    with pytest.raises(ValueError, match=r"output.fields.*'velocty'.*'velocity'.*stress, density"):
        lp.run(block(fields=["velocty"]), path, progress=False)
    assert not path.exists()


def test_pictures_and_report_of_few_fields(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    path = tmp_path / "run.vtkhdf"
    lp.run(block(fields=["velocity"], precision="single", compression=1), path, progress=False)
    plot.draw(path, save=tmp_path / "one.png")
    with pytest.raises(ValueError, match="'stress'"):
        plot.draw(path, "stress", save=tmp_path / "no.png")
    write_report(path)
    assert "velocity" in path.with_suffix(".html").read_text()
    lp.run(block(fields=[]), path, progress=False)
    write_report(path)


def test_the_executable_takes_the_same_keys(tmp_path: Path) -> None:
    folder = os.environ.get("LAPILLI_BUILD")
    if not folder:
        pytest.skip("LAPILLI_BUILD does not name a build folder")
    program = next(Path(folder).resolve().rglob("lapilli-run"))
    scene = tmp_path / "block.toml"
    text = block(fields=["velocity"], precision="single", compression=2).to_toml()
    scene.write_text(text)
    by = {"python": tmp_path / "python.vtkhdf", "program": tmp_path / "program.vtkhdf"}
    lp.run(lp.Scene.load(scene), by["python"], progress=False)
    subprocess.run([program, scene, "--output", by["program"], "--quiet"], check=True)
    data = [path.with_name(path.name + ".data").read_bytes() for path in by.values()]
    assert data[0] == data[1]
    changed = 'output.fields=["stress", "density"]'
    command = [program, scene, "--output", by["program"], "--quiet", "--set", changed]
    subprocess.run(command, check=True)
    assert set(lp.Frames(by["program"]).fields) >= {"stress", "density"}
    assert "velocity" not in lp.Frames(by["program"]).fields
