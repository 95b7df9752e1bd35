"""Read the frames of a run: index and data files, or a merged file."""

from __future__ import annotations

import functools
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from lapilli import _core
from lapilli.components import component_of, parted
from lapilli.part import Part
from lapilli.record import read_record

if TYPE_CHECKING:
    import pyvista
    import xarray

    from lapilli.history import History
    from lapilli.history_frame import HistoryFrame

Array = npt.NDArray[Any]

MADE = {"displacement": "m"}  # from the positions, where a run does not write it


class Frame:
    """The state at one time. Arrays are read, and compared with their checksums, when asked for."""

    def __init__(self, frames: Frames, number: int, time: float) -> None:
        self.frames = frames
        self.number = number
        self.time = time

    def __repr__(self) -> str:
        return f"<frame {self.number} at {self.time:g} s>"

    def __getitem__(self, name: str) -> Array:
        """A field, one row per point in the order of the points' ids, or one component of it:
        ``frame["velocity.x"]``, ``frame["stress.xy"]``, ``frame["velocity.magnitude"]``. Points
        that have left the grid have no row; ``frame["id"]`` says who is left. "displacement" is
        there in every run: since the first frame, where the run does not write it.

        Raises ``OutputError`` naming file, frame and field when it is damaged or missing.
        """
        field, component = parted(name)
        values = self._read(field)
        return component_of(values, name) if component else values

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Positions (points, 3) in the order of ids, m; scenes of fewer dimensions have zeros."""
        return self._read("position")

    def body(self, which: int | str) -> Part:
        """The points of one body or fluid wall, by its number (bodies first, from 0) or by the name
        that the run record beside the frames gives it."""
        names = self.frames.body_names
        if isinstance(which, int) and names is None:
            return Part(self.__getitem__, which, [""] * (which + 1))
        if names is None:
            raise ValueError(
                f"bodies have no names here: the run record {self.frames.record_path} is missing; "
                "give a number"
            )
        return Part(self.__getitem__, which, names)

    def to_pyvista(self, fields: Sequence[str] | None = None) -> pyvista.PolyData:
        """The points with all fields, or those named, as vertices for pyvista."""
        from lapilli.export import to_pyvista

        return to_pyvista(self, fields)

    def _read(self, name: str) -> Array:
        if name != "position" and name not in self.frames.readable:
            raise KeyError(
                f"no field {name!r} in {self.frames.path}; there is: "
                + ", ".join(self.frames.readable)
            )
        if name in MADE and name not in self.frames.fields:
            return self._displacement()
        return self.frames.reader.read(self.number, name)

    def _displacement(self) -> Array:
        """How far each point is from where the first frame that has it shows it, m."""
        ids, start = self.frames.first_positions
        moved: Array = self.position - start[np.searchsorted(ids, self["id"])]
        return moved


def way_back(path: Path) -> str:
    """What can be done about an index that is lost or damaged, as the end of a message."""
    if not path.with_name(path.name + ".data").is_file():
        return ""
    return f"; its numbers are there: lapilli verify {path} --rebuild makes the index anew"


class Frames:
    """The frames of a run, in the order of time: ``Frames("ring.vtkhdf")[-1]`` is the last."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        if not self.path.is_file():
            raise FileNotFoundError(f"{self.path}: no such file{way_back(self.path)}")
        try:
            self.reader = _core.FrameReader(os.fspath(self.path))
        except (_core.OutputError, ValueError) as error:
            raise type(error)(f"{error}{way_back(self.path)}") from None
        self.times: npt.NDArray[np.float64] = np.array(self.reader.times)
        self.fields: list[str] = sorted(self.reader.fields)
        self.point_counts: list[int] = self.reader.point_counts

    def __reduce__(self) -> tuple[type[Frames], tuple[Path]]:
        return Frames, (self.path,)

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        return f"<{len(self)} frames of {', '.join(self.fields)} in {self.path}>"

    def _repr_html_(self) -> str:
        from lapilli.html import frames_as_html

        return frames_as_html(self)

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

    @functools.cached_property
    def all_points(self) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        """Ids of all points that any frame has, rising, and the body of each. Points leave and come
        in the course of a run, and none comes back."""
        first, last = self[0]["id"], self[-1]["id"]
        if len(set(self.point_counts)) == 1 and np.array_equal(first, last):
            return first, self[0]["body"]
        ids, rows = np.unique(np.concatenate([one["id"] for one in self]), return_index=True)
        return ids, np.concatenate([one["body"] for one in self])[rows]

    @property
    def readable(self) -> list[str]:
        """The fields, and what is made from the positions."""
        return [*self.fields, *(name for name in MADE if name not in self.fields)]

    @functools.cached_property
    def first_positions(self) -> tuple[npt.NDArray[np.int64], Array]:
        """Ids of all points, rising, and the position of each in the first frame that has it."""
        if np.array_equal(self[0]["id"], self.all_points[0]):
            return self.all_points[0], self[0].position
        ids, rows = np.unique(np.concatenate([one["id"] for one in self]), return_index=True)
        return ids, np.concatenate([one.position for one in self])[rows]

    @property
    def record_path(self) -> Path:
        """Where the run record lies."""
        return self.path.with_suffix(".json")

    @functools.cached_property
    def record(self) -> dict[str, Any] | None:
        """The run record beside the frames; None where there is none."""
        if not self.record_path.is_file():
            return None
        return read_record(self.record_path)

    @functools.cached_property
    def body_names(self) -> list[str] | None:
        """Names by body number, fluid walls last; None without a run record."""
        settings = (self.record or {}).get("settings")
        if settings is None:
            return None
        walls = (settings.get("peridynamics") or {}).get("walls") or []
        return [body.get("name", "") for body in [*_bodies_in(settings), *walls]]

    @property
    def body_count(self) -> int:
        """Bodies that are no fluid walls; their points have lower numbers in the field "body". All
        count as bodies where the run record is missing."""
        settings = (self.record or {}).get("settings")
        return int(np.iinfo(np.int64).max) if settings is None else len(_bodies_in(settings))

    @functools.cached_property
    def units(self) -> dict[str, str]:
        """The unit of every field; empty where it has none."""
        import h5py

        units = dict.fromkeys(self.fields, "")
        with h5py.File(self.path, "r") as file:
            for name in units:
                stored = file["VTKHDF/PointData"].get(name)
                unit = "" if stored is None else stored.attrs.get("unit", "")
                units[name] = unit.decode() if isinstance(unit, bytes) else str(unit)
        return units

    def unit(self, name: str) -> str:
        """The unit of a field, or of a component of it."""
        field, _ = parted(name)
        return "m" if field == "position" else self.units.get(field) or MADE.get(field, "")

    @property
    def dimension(self) -> int:
        """1, 2 or 3."""
        return {"m": 1, "m^2": 2}.get(self.units["volume"], 3)

    def time_series(
        self,
        field: str,
        probe: Sequence[float] | str | None = None,
        point: int | None = None,
    ) -> HistoryFrame | History:
        """A field, or one component of it, in time: a table like ``result.history``.

        Parameters
        ----------
        field
            "temperature", "velocity.x"; all components where none is named.
        probe
            A position, m: the field is fitted linearly to the points around it, as a probe of the
            run does, and is NaN where there is no material. Or the name of such a probe.
        point
            The id of a material point that is followed instead; NaN once it has left the grid.
        """
        from lapilli.time_series import time_series

        return time_series(self, field, probe, point)

    def to_xarray(self, fields: Sequence[str] | None = None) -> xarray.Dataset:
        """All frames, of all fields or those named, over time, point and component.

        Reads everything into memory: 8 bytes a number. Points that have left the grid are NaN.
        """
        from lapilli.export import frames_to_xarray

        return frames_to_xarray(self, fields)


def _bodies_in(settings: dict[str, Any]) -> list[dict[str, Any]]:
    """Bodies of the scene, then those that its stages add."""
    stages = settings.get("stages") or []
    return [*settings["bodies"], *(body for one in stages for body in one.get("add_bodies") or [])]
