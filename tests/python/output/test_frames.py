"""Frames as other programs read them."""

import subprocess
import sys

import h5py
import pytest

POINTS = 11


def write(drivers, path, frames, planned, *more):
    command = [drivers.frames, path, str(frames), str(POINTS), str(planned), *more]
    subprocess.run(command, check=True, capture_output=True)


@pytest.mark.parametrize("vtk", [False, True], ids=["h5py", "pyvista"])
@pytest.mark.parametrize("planned", [5, 2], ids=["one data file", "several data files"])
def test_every_frame_reads_as_written(drivers, check_frame, tmp_path, planned, vtk):
    path = tmp_path / "run.vtkhdf"
    write(drivers, path, 5, planned)
    assert (tmp_path / "run.vtkhdf.data1").exists() == (planned < 5)
    for frame in range(5):
        check_frame(path, POINTS, frame, vtk=vtk)


def test_times_and_vertices_in_pyvista(drivers, tmp_path):
    pyvista = pytest.importorskip("pyvista")
    path = tmp_path / "run.vtkhdf"
    write(drivers, path, 4, 4)
    reader = pyvista.get_reader(path).reader
    reader.UpdateInformation()
    assert reader.GetNumberOfSteps() == 4
    reader.SetStep(3)
    reader.Update()
    mesh = pyvista.wrap(reader.GetOutputDataObject(0))
    assert mesh.n_verts == mesh.n_points == POINTS
    assert mesh.n_lines == mesh.n_strips == 0
    information = reader.GetOutputInformation(0)
    key = reader.GetExecutive().TIME_STEPS()
    assert [information.Get(key, k) for k in range(4)] == [0.0, 0.5, 1.0, 1.5]


def test_units_are_stored(drivers, tmp_path):
    path = tmp_path / "run.vtkhdf"
    for planned in (3, 1):  # linked to, and joined
        write(drivers, path, 3, planned)
        with h5py.File(path, "r") as file:
            units = {name: data.attrs["unit"] for name, data in file["VTKHDF/PointData"].items()}
        assert units["temperature"] == b"K"
        assert units["volume"] == b"m^2"


def test_still_points_take_no_space_again(drivers, tmp_path):
    path = tmp_path / "run.vtkhdf"
    write(drivers, path, 6, 6, "still")
    with h5py.File(path, "r") as file:
        steps = file["VTKHDF/Steps"]
        assert set(steps["PointOffsets"]) == {0}
        assert set(steps["PointDataOffsets/id"]) == {0}
        assert len(set(steps["PointDataOffsets/temperature"])) == 6


def test_frames_move_together_and_a_missing_data_file_is_no_crash(drivers, check_frame, tmp_path):
    write(drivers, tmp_path / "run.vtkhdf", 3, 3)
    moved = tmp_path / "elsewhere"
    moved.mkdir()
    for file in tmp_path.glob("run.vtkhdf*"):
        file.rename(moved / file.name)
    check_frame(moved / "run.vtkhdf", POINTS, 2)
    check_frame(moved / "run.vtkhdf", POINTS, 2, vtk=True)
    (moved / "run.vtkhdf.data").unlink()
    with pytest.raises((KeyError, OSError)):
        check_frame(moved / "run.vtkhdf", POINTS, 2)


@pytest.mark.parametrize("planned", [3, 1], ids=["linked", "joined"])
def test_vtk_survives_a_missing_data_file(drivers, tmp_path, planned):
    """In a process of its own: vtk may complain, it must not crash."""
    pytest.importorskip("pyvista")
    path = tmp_path / "run.vtkhdf"
    write(drivers, path, 3, planned)
    for file in tmp_path.glob("run.vtkhdf.data*"):
        file.unlink()
    code = f"import pyvista; pyvista.get_reader({str(path)!r}).read(); print('alive')"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert run.returncode >= 0  # negative: killed by a signal
    assert "alive" in run.stdout or "Error" in run.stderr


def test_a_reader_that_holds_the_files_does_not_stop_the_writer(drivers, check_frame, tmp_path):
    path = tmp_path / "run.vtkhdf"
    write(drivers, path, 2, 9)
    with h5py.File(path, "r") as file, h5py.File(f"{path}.data", "r"):
        assert file["VTKHDF/Points"].shape[1] == 3
        write(drivers, path, 4, 9)
    check_frame(path, POINTS, 3)
