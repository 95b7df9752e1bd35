"""Read the frames of a run: index and data files, or a merged file."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli import _core
from lapilli._core import Scene
from lapilli.part import Part, names_of

Array = npt.NDArray[Any]


class Frame:
    """The state at one time. Arrays are read, and compared with their checksums, when asked for."""

    def __init__(self, frames: Frames, number: int, time: float) -> None:
        self._frames = frames
        self.number = number
        self.time = time

    def __repr__(self) -> str:
        return f"<frame {self.number} at {self.time:g} s>"

    def __getitem__(self, name: str) -> Array:
        """A field, one row per point in the order of the points' ids.

        Raises ``OutputError`` naming file, frame and field when it is damaged or missing.
        """
        return self._read(name)

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Positions (points, 3) in the order of ids, m; scenes of fewer dimensions have zeros."""
        return self._read("position")

    def body(self, which: int | str) -> Part:
        """The points of one body or fluid wall, by its number (bodies first, from 0) or by the name
        that the run record beside the frames gives it."""
        record = self._frames.path.with_suffix(".json")
        if isinstance(which, int) and not record.is_file():
            return Part(self._read, which, [""] * (which + 1))
        scene = Scene.parse(json.loads(record.read_text())["scene"])
        return Part(self._read, which, names_of(scene))

    def _read(self, name: str) -> Array:
        if name != "position" and name not in self._frames.fields:
            raise KeyError(
                f"no field {name!r} in {self._frames.path}; there is: "
                + ", ".join(self._frames.fields)
            )
        return self._frames.reader.read(self.number, name)


class Frames:
    """The frames of a run, in the order of time: ``Frames("ring.vtkhdf")[-1]`` is the last."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        if not self.path.is_file():
            raise FileNotFoundError(f"{self.path}: no such file")
        self.reader = _core.FrameReader(os.fspath(self.path))
        self.times: npt.NDArray[np.float64] = np.array(self.reader.times)
        self.fields: list[str] = sorted(self.reader.fields)

    def __reduce__(self) -> tuple[type[Frames], tuple[Path]]:
        return Frames, (self.path,)

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        return f"<{len(self)} frames of {', '.join(self.fields)} in {self.path}>"

    def __getitem__(self, number: int) -> Frame:
        index = range(len(self))[number]
        return Frame(self, index, float(self.times[index]))

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
