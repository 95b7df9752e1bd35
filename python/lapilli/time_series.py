"""A field at one position, or of one point, in time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from lapilli.components import component_names, parted, require_field
from lapilli.history import History, history_of
from lapilli.probing import fit_at, value_at

if TYPE_CHECKING:
    from lapilli.frames import Frame, Frames
    from lapilli.history_frame import HistoryFrame

Array = npt.NDArray[Any]


def time_series(
    frames: Frames, field: str, probe: Sequence[float] | str | None, point: int | None
) -> HistoryFrame | History:
    """See ``Frames.time_series``."""
    if (probe is None) == (point is None):
        raise ValueError("a time series needs either probe=(x, y) or point=id")
    require_field(field, [*frames.readable, "position"], frames.path)
    if isinstance(probe, str):
        probe = _place_of(frames, probe)
    read = _follower(frames, point) if point is not None else _prober(frames, probe or ())
    rows = [read(frame, field) for frame in frames]
    numbers = dict(zip(_names(frames[0], field), np.transpose(rows), strict=True))
    where = f"point {point}" if probe is None else f"({', '.join(f'{x:g}' for x in probe)})"
    columns = {name: (frames.unit(field), f"{name} at {where}") for name in numbers}
    return history_of({"time": frames.times, **numbers}, {"time": ("s", "time"), **columns})


def _names(frame: Frame, field: str) -> list[str]:
    names = () if parted(field)[1] else component_names(frame[field])
    return [f"{field}.{name}" for name in names] or [field]


def _follower(frames: Frames, point: int) -> Callable[[Frame, str], Array]:
    ids = frames.all_points[0]
    if point not in ids:
        raise ValueError(f"there is no point {point} in {frames.path}: ids go from 0 to {ids[-1]}")

    def read(frame: Frame, field: str) -> Array:
        values = np.asarray(frame[field])
        row = int(np.searchsorted(frame["id"], point))
        if row == len(values) or frame["id"][row] != point:  # it has left, or not come yet
            return np.full(values[:1].size, np.nan)
        return np.atleast_1d(values[row])

    return read


def _place_of(frames: Frames, name: str) -> list[float]:
    """Where a probe of the run stands."""
    settings = (frames.record or {}).get("settings") or {}
    found = {one["name"]: one for one in settings.get("probes") or []}
    if name not in found:
        known = ", ".join(map(repr, found)) or "none"
        raise ValueError(
            f"no probe {name!r} in {frames.record_path}; there is {known}. A place: probe=(x, y)"
        )
    if found[name]["material_point"]:
        raise ValueError(f"probe {name!r} moves with its material: its values are in the history")
    return [float(x) for x in found[name]["position"]]


def _prober(frames: Frames, probe: Sequence[float]) -> Callable[[Frame, str], Array]:
    dimension = frames.dimension
    to = np.asarray(probe, dtype=float)
    if to.shape != (dimension,):
        raise ValueError(f"probe needs {dimension} coordinates, m, got {list(probe)}")

    def read(frame: Frame, field: str) -> Array:
        body = frame["body"]
        own = np.flatnonzero(body < frames.body_count)
        fit = fit_at(frame.position[own, :dimension], frame["volume"][own], body[own], to)
        return value_at(frame[field][own], fit)

    return read
