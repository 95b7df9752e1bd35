"""Results as objects of other packages: xarray and pyvista."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from lapilli.components import component_names, require_field
from lapilli.extras import required

if TYPE_CHECKING:
    import pyvista
    import xarray

    from lapilli.frames import Frame, Frames
    from lapilli.result import Result

Array = npt.NDArray[Any]
NOT_VARIABLES = ("id", "body")  # coordinates of the points
AXES = {2: "axis", 3: "axis", 4: "entry", 6: "component", 9: "component"}  # by numbers a row


def to_pyvista(frame: Frame, fields: Sequence[str] | None) -> pyvista.PolyData:
    """See ``Frame.to_pyvista``."""
    vista = required("pyvista", "to_pyvista", "vtk")
    frames = frame.frames
    cloud: pyvista.PolyData = vista.PolyData(frame.position)
    for name in frames.fields if fields is None else fields:
        require_field(name, frames.readable, frames.path)
        cloud.point_data[name] = frame[name]
    cloud.field_data["TimeValue"] = [frame.time]
    return cloud


def frames_to_xarray(frames: Frames, fields: Sequence[str] | None) -> xarray.Dataset:
    """See ``Frames.to_xarray``."""
    for name in fields or ():
        require_field(name, frames.readable, frames.path)
    names = [name for name in fields or frames.fields if name not in NOT_VARIABLES]
    arrays = {
        name: np.stack([_of_all_points(frame, name) for frame in frames])
        for name in ["position", *names]
    }
    units = {name: frames.unit(name) for name in arrays}
    return dataset(frames.times, *frames.all_points, arrays, units)


def _of_all_points(frame: Frame, name: str) -> Array:
    """A field with a row for every point of the run: NaN for those the frame does not have."""
    values: Array = frame[name]
    ids, own = frame.frames.all_points[0], frame["id"]
    if np.array_equal(own, ids):
        return values
    padded = np.full((len(ids), *values.shape[1:]), np.nan)
    padded[np.searchsorted(ids, own)] = values
    return padded


def state_to_xarray(result: Result) -> xarray.Dataset:
    """The last state of a run that wrote no frames, with one time."""
    simulation = result.simulation
    names = [name for name in simulation.fields if name not in NOT_VARIABLES]
    arrays = {name: result.by_id(name)[None] for name in dict.fromkeys(["position", *names])}
    units = {name: result.unit(name) for name in arrays}
    times = np.array([result.time])
    return dataset(times, result.by_id("id"), result.by_id("body"), arrays, units)


def dataset(
    times: Array, ids: Array, body: Array, arrays: dict[str, Array], units: dict[str, str]
) -> xarray.Dataset:
    """Arrays (times, points[, components]) with named axes, coordinates and units."""
    made_by = required("xarray", "to_xarray")
    variables, coordinates = {}, {}
    for name, values in arrays.items():
        axes = ["time", "point"]
        if components := component_names(values[0]):
            axes.append(AXES.get(len(components), f"component{len(components)}"))
            coordinates[axes[-1]] = list(components)
        variables[name] = (axes, values, {"units": units[name]})
    made: xarray.Dataset = made_by.Dataset(
        variables,
        coords={
            "time": ("time", times, {"units": "s"}),
            "point": ids,
            "body": ("point", body),
            **coordinates,
        },
    )
    return made
