"""Read the frames of a run with h5py: index and data files, or a merged file."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import numpy.typing as npt

from lapilli._core import Scene
from lapilli.part import Part, names_of

Array = npt.NDArray[Any]


class Frame:
    """The state at one time. Arrays are read when asked for."""

    def __init__(self, path: Path, number: int, time: float) -> None:
        self._path = path
        self.number = number
        self.time = time

    def __repr__(self) -> str:
        return f"<frame {self.number} at {self.time:g} s>"

    def __getitem__(self, name: str) -> Array:
        """A field, one row a point in the order of the points' ids."""
        return self._read(name)

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Positions (points, 3) in the order of ids, m; scenes of fewer dimensions have zeros."""
        return self._read("position")

    def body(self, which: int | str) -> Part:
        """The points of one body or fluid wall, by its number (bodies first, from 0) or by the name
        that the run record beside the frames gives it."""
        record = self._path.with_suffix(".json")
        if isinstance(which, int) and not record.is_file():
            return Part(self._read, which, [""] * (which + 1))
        return Part(self._read, which, names_of(Scene.parse(json.loads(record.read_text())["scene"])))

    def _read(self, name: str) -> Array:
        with h5py.File(self._path, "r", locking=False) as file:
            root = file["VTKHDF"]
            steps = root["Steps"]
            rows = int(root["NumberOfPoints"][int(steps["PartOffsets"][self.number])])
            if name == "position":
                values, first = root["Points"], int(steps["PointOffsets"][self.number])
            else:
                if name not in root["PointData"]:
                    raise KeyError(
                        f"no field {name!r} in {self._path}; there is: "
                        + ", ".join(root["PointData"])
                    )
                values = root["PointData"][name]
                first = int(steps["PointDataOffsets"][name][self.number])
            array: Array = values[first : first + rows]
            return array


class Frames:
    """The frames of a run, in the order of time: ``Frames("ring.vtkhdf")[-1]`` is the last."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        if not self.path.is_file():
            raise FileNotFoundError(f"{self.path}: no such file")
        try:
            with h5py.File(self.path, "r", locking=False) as file:
                self.times: npt.NDArray[np.float64] = file["VTKHDF/Steps/Values"][:]
                self.fields: list[str] = sorted(file["VTKHDF/PointData"])
        except (OSError, KeyError) as error:
            raise ValueError(f"{self.path} holds no frames of lapilli ({error})") from error

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        return f"<{len(self)} frames of {', '.join(self.fields)} in {self.path}>"

    def __getitem__(self, number: int) -> Frame:
        index = range(len(self))[number]
        return Frame(self.path, index, float(self.times[index]))

    def __iter__(self) -> Iterator[Frame]:
        return (self[number] for number in range(len(self)))

    def at(self, time: float) -> Frame:
        """The frame nearest to a time. Times before the first or after the last are an error."""
        first, last = float(self.times[0]), float(self.times[-1])
        slack = 1e-9 * max(abs(first), abs(last))
        if not first - slack <= time <= last + slack:
            raise ValueError(
                f"no frame at {time:g} s in {self.path}: they go from {first:g} s to {last:g} s"
            )
        return self[int(np.argmin(np.abs(self.times - time)))]
