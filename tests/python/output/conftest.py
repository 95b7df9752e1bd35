"""The programs of tests/cpp/output, and what the frames they write must hold."""

import importlib.util
import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import h5py
import numpy as np
import pytest


@pytest.fixture(scope="session")
def drivers() -> SimpleNamespace:
    """Paths of the C++ test programs; the build folder is given by LAPILLI_BUILD."""
    build = os.environ.get("LAPILLI_BUILD")
    if not build:
        pytest.skip("LAPILLI_BUILD does not name a build folder with the C++ tests")
    folder = Path(build).resolve() / "tests" / "cpp" / "output"
    return SimpleNamespace(
        frames=folder / "frame_driver",
        checkpoint=folder / "checkpoint_driver",
        run=folder / "run_driver",
        kill_at_write=folder / "libkill_at_write.so",
    )


def made(points: int, frame: int) -> dict[str, np.ndarray]:
    """What tests/cpp/output/made_frames.hpp puts into a frame."""
    ids = np.arange(points, dtype=float)
    step = np.full(points, float(frame))
    zero = np.zeros(points)
    return {
        "Points": np.stack([ids, step, zero], axis=1),
        "id": np.arange(points),
        "body": np.full(points, 3),
        "volume": np.full(points, 0.25),
        "temperature": ids + 1000.0 * step,
        "velocity": np.stack([ids, -step, zero], axis=1),
        "stress": np.stack([ids, step, zero, -ids, -step, zero, zero, zero, zero], axis=1),
    }


def read_h5py(path: Path, frame: int) -> dict[str, np.ndarray]:
    """One frame, found as the VTKHDF format says."""
    with h5py.File(path, "r") as file:
        root = file["VTKHDF"]
        points = int(root["NumberOfPoints"][0])
        begin = root["Steps/PointOffsets"][frame]
        arrays = {"Points": root["Points"][begin : begin + points]}
        for name, offsets in root["Steps/PointDataOffsets"].items():
            begin = offsets[frame]
            arrays[name] = root["PointData"][name][begin : begin + points]
    return arrays


def read_pyvista(path: Path, frame: int) -> dict[str, np.ndarray]:
    """One frame, as vtk reads it."""
    pyvista = pytest.importorskip("pyvista")
    reader = pyvista.get_reader(path).reader
    reader.SetStep(frame)
    reader.Update()
    mesh = pyvista.wrap(reader.GetOutputDataObject(0))
    return {"Points": mesh.points} | {name: mesh.point_data[name] for name in mesh.point_data}


@pytest.fixture(scope="session")
def check_frame() -> Callable[..., None]:
    """Compare one frame with what was written, through h5py or pyvista, every number exactly."""

    def check(path: Path, points: int, frame: int, *, vtk: bool = False) -> None:
        arrays = read_pyvista(path, frame) if vtk else read_h5py(path, frame)
        expected = made(points, frame)
        assert set(arrays) == set(expected)
        for name, values in expected.items():
            np.testing.assert_array_equal(arrays[name], values, err_msg=f"{name}, frame {frame}")

    return check


@pytest.fixture(scope="session")
def check_killed(drivers: SimpleNamespace, check_frame: Callable[..., None]) -> Callable[..., int]:
    """Every acknowledged frame and checkpoint of a killed writer can be read; counts them."""

    def check(path: Path, points: int, lines: str) -> int:
        acknowledged = lines.count("\n")
        if not path.exists():
            assert acknowledged == 0
            return 0
        with h5py.File(path, "r") as file:
            steps = int(file["VTKHDF/Steps"].attrs["NSteps"])
            times = file["VTKHDF/Steps/Values"][:]
        assert acknowledged <= steps <= acknowledged + 1
        np.testing.assert_array_equal(times, 0.5 * np.arange(steps))
        for frame in range(max(0, steps - 10), steps):
            check_frame(path, points, frame)
        for frame in {0, steps - 1} if importlib.util.find_spec("pyvista") else ():
            check_frame(path, points, frame, vtk=True)
        checkpoint = path.with_name("run.checkpoint")
        if acknowledged > 0 or checkpoint.exists():
            command = [drivers.checkpoint, checkpoint]
            run = subprocess.run(command, capture_output=True, text=True, check=True)
            assert acknowledged <= int(run.stdout) <= steps
        return acknowledged

    return check
