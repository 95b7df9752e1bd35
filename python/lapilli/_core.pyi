"""
The compiled part of lapilli.
"""
from __future__ import annotations
import collections.abc
import inspect
import lapilli.note
import numpy
import numpy.typing
import os
import typing
__all__: list[str] = ['Annulus', 'Balance', 'Body', 'BodyContact', 'Box', 'Convection', 'Cylinder', 'Difference', 'Disk', 'DruckerPrager', 'Dynamics', 'Elastic', 'Ellipse', 'Ellipsoid', 'FluidWall', 'Flux', 'FrameReader', 'FrictionalBoundary', 'FunctionSolid', 'Geostatic', 'Grid', 'HalfSpace', 'Heat', 'HeatContact', 'HeightField', 'Image', 'Intersection', 'Mesh', 'ModifiedCamClay', 'MohrCoulomb', 'Newtonian', 'NoSlipBoundary', 'Obstacle', 'Output', 'OutputError', 'PeridynamicFlow', 'PeridynamicHeat', 'Peridynamics', 'PlasticHeating', 'Points', 'Polygon', 'PrescribedTemperature', 'Pressure', 'Probe', 'Progress', 'QuasiStatic', 'Radiation', 'RollerBoundary', 'Rotated', 'Rotation', 'RunError', 'RunSummary', 'Scene', 'Shape', 'Simulation', 'Sphere', 'Stage', 'StepReport', 'Support', 'SurfaceTraction', 'Swirl', 'Table', 'TabulatedMohrCoulomb', 'Thermal', 'ThermalExpansion', 'Time', 'Traction', 'Translated', 'Translation', 'Union', 'VonMises', 'check_json', 'check_text', 'cpu_seconds', 'keys_as_markdown', 'merge', 'note_kinds', 'peak_memory', 'progress_text', 'readable_time', 'rebuild_index', 'run_simulation', 'scene_identity', 'scene_schema', 'set_thread_count', 'summary_text', 'thread_count', 'unknown_name', 'unused_settings', 'verify', 'version_text']
class RunError(RuntimeError):
    """
    A run that went wrong; the message names step, time, point, field and likely cause.
    """
class Table:
    """
    A number tabulated in time: linear between the times, constant outside them; two equal times are a jump.
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    @staticmethod
    def __getstate__(*args: typing.Any, **kwargs: typing.Any) -> typing.Any:
        ...
    @staticmethod
    def __setstate__(*args: typing.Any, **kwargs: typing.Any) -> typing.Any:
        ...
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __init__(self, times: collections.abc.Sequence[float], values: collections.abc.Sequence[float]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def at(self, time: float) -> float:
        """
        The value at one time; at a jump the one after it.
        """
    def mean(self, begin: float, end: float) -> float:
        """
        The mean over a span of time, exact.
        """
    @property
    def times(self) -> tuple[float, ...]:
        """
        times in s, increasing but for jumps
        """
    @property
    def values(self) -> tuple[float, ...]:
        """
        the values at these times
        """
class Shape:
    """
    Any shape. Scenes of one or two dimensions leave out the last coordinates.
    
    ``one | other`` is their union, ``one & other`` what lies in both, ``one - other`` what lies in one and not in the other.
    """
    def __and__(self, other: Shape) -> Intersection:
        """
        What lies in both.
        """
    def __or__(self, other: Shape) -> typing.Union:
        """
        What lies in any of both.
        """
    def __reduce__(self) -> typing.Any:
        ...
    def __sub__(self, other: Shape) -> Difference:
        """
        What lies outside of the other.
        """
    def distance(self, positions: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """
        Signed distance of positions (n, dimension) to the surface, negative inside, m.
        """
    def rotated(self, degrees: float, **more: typing.Any) -> Rotated:
        """
        Turned; ``center`` and ``axis`` as for `Rotated`.
        """
    def translated(self, by: collections.abc.Sequence[float]) -> Translated:
        """
        Moved, m.
        """
class Box(Shape):
    """
    Interval, rectangle or box with sides along the axes; infinite along axes beyond the given numbers.
    
    Parameters
    ----------
    lower : collections.abc.Sequence[float], m, required
        corner with the least coordinates
    upper : collections.abc.Sequence[float], m, required
        corner with the largest coordinates
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, lower: collections.abc.Sequence[float], upper: collections.abc.Sequence[float]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def lower(self) -> collections.abc.Sequence[float]:
        """
        corner with the least coordinates, m
        """
    @lower.setter
    def lower(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def upper(self) -> collections.abc.Sequence[float]:
        """
        corner with the largest coordinates, m
        """
    @upper.setter
    def upper(self, value: collections.abc.Sequence[float]) -> None:
        ...
class HalfSpace(Shape):
    """
    Everything on the side of a plane that its normal points away from.
    
    Parameters
    ----------
    point : collections.abc.Sequence[float], m, required
        any point of the plane
    normal : collections.abc.Sequence[float], required
        direction pointing out of the half-space
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, point: collections.abc.Sequence[float], normal: collections.abc.Sequence[float]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def normal(self) -> collections.abc.Sequence[float]:
        """
        direction pointing out of the half-space
        """
    @normal.setter
    def normal(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def point(self) -> collections.abc.Sequence[float]:
        """
        any point of the plane, m
        """
    @point.setter
    def point(self, value: collections.abc.Sequence[float]) -> None:
        ...
class Disk(Shape):
    """
    Disk in the x-y plane; infinite along z.
    
    Parameters
    ----------
    center : collections.abc.Sequence[float], m, default (0.0, 0.0)
        centre
    radius : float, m, required
        radius; above 0 (m)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, center: collections.abc.Sequence[float] = ..., radius: float) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        centre, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def radius(self) -> float:
        """
        radius, m
        """
    @radius.setter
    def radius(self, value: float) -> None:
        ...
class Annulus(Shape):
    """
    Ring between two circles in the x-y plane; infinite along z.
    
    Parameters
    ----------
    center : collections.abc.Sequence[float], m, default (0.0, 0.0)
        centre
    inner : float, m, required
        radius of the hole; above 0 (m)
    outer : float, m, required
        radius of the rim; above 0 (m)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, center: collections.abc.Sequence[float] = ..., inner: float, outer: float) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        centre, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def inner(self) -> float:
        """
        radius of the hole, m
        """
    @inner.setter
    def inner(self, value: float) -> None:
        ...
    @property
    def outer(self) -> float:
        """
        radius of the rim, m
        """
    @outer.setter
    def outer(self, value: float) -> None:
        ...
class Ellipse(Shape):
    """
    Ellipse in the x-y plane with its axes along x and y; infinite along z.
    
    Parameters
    ----------
    center : collections.abc.Sequence[float], m, default (0.0, 0.0)
        centre
    semi_axes : collections.abc.Sequence[float], m, required
        half lengths along x and y
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, center: collections.abc.Sequence[float] = ..., semi_axes: collections.abc.Sequence[float]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        centre, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def semi_axes(self) -> collections.abc.Sequence[float]:
        """
        half lengths along x and y, m
        """
    @semi_axes.setter
    def semi_axes(self, value: collections.abc.Sequence[float]) -> None:
        ...
class Ellipsoid(Shape):
    """
    Ellipsoid with its axes along x, y and z.
    
    Parameters
    ----------
    center : collections.abc.Sequence[float], m, default (0.0, 0.0, 0.0)
        centre
    semi_axes : collections.abc.Sequence[float], m, required
        half lengths along x, y and z
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, center: collections.abc.Sequence[float] = ..., semi_axes: collections.abc.Sequence[float]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        centre, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def semi_axes(self) -> collections.abc.Sequence[float]:
        """
        half lengths along x, y and z, m
        """
    @semi_axes.setter
    def semi_axes(self, value: collections.abc.Sequence[float]) -> None:
        ...
class HeightField(Shape):
    """
    Ground below heights on a regular grid, down to a flat bottom.
    
    Parameters
    ----------
    file : str, default ''
        ESRI ASCII grid of heights, PNG or PGM image
    values : collections.abc.Sequence[collections.abc.Sequence[float]], default ()
        heights, rows from the far side, where no file is given
    spacing : float | None, m, default None
        between heights; an ESRI grid knows it; above 0 (m)
    origin : collections.abc.Sequence[float], m, default ()
        place of the first height of the last row; empty: that of the ESRI grid, or 0
    scale : float, m, default 1.0
        height of one unit; in images that of white; above 0 (m)
    bottom : float, m, required
        where the ground ends, below all heights
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, file: str = ..., values: collections.abc.Sequence[collections.abc.Sequence[float]] = ..., spacing: float | None = ..., origin: collections.abc.Sequence[float] = ..., scale: float = ..., bottom: float) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def bottom(self) -> float:
        """
        where the ground ends, below all heights, m
        """
    @bottom.setter
    def bottom(self, value: float) -> None:
        ...
    @property
    def file(self) -> str:
        """
        ESRI ASCII grid of heights, PNG or PGM image
        """
    @file.setter
    def file(self, value: str) -> None:
        ...
    @property
    def origin(self) -> collections.abc.Sequence[float]:
        """
        place of the first height of the last row; empty: that of the ESRI grid, or 0, m
        """
    @origin.setter
    def origin(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def scale(self) -> float:
        """
        height of one unit; in images that of white, m
        """
    @scale.setter
    def scale(self, value: float) -> None:
        ...
    @property
    def spacing(self) -> float | None:
        """
        between heights; an ESRI grid knows it, m
        """
    @spacing.setter
    def spacing(self, value: float | None) -> None:
        ...
    @property
    def values(self) -> collections.abc.Sequence[collections.abc.Sequence[float]]:
        """
        heights, rows from the far side, where no file is given
        """
    @values.setter
    def values(self, value: collections.abc.Sequence[collections.abc.Sequence[float]]) -> None:
        ...
class Sphere(Shape):
    """
    Ball.
    
    Parameters
    ----------
    center : collections.abc.Sequence[float], m, default (0.0, 0.0, 0.0)
        centre
    radius : float, m, required
        radius; above 0 (m)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, center: collections.abc.Sequence[float] = ..., radius: float) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        centre, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def radius(self) -> float:
        """
        radius, m
        """
    @radius.setter
    def radius(self, value: float) -> None:
        ...
class Cylinder(Shape):
    """
    Cylinder with flat ends, from start to end.
    
    Parameters
    ----------
    start : collections.abc.Sequence[float], m, required
        centre of one end
    end : collections.abc.Sequence[float], m, required
        centre of the other end
    radius : float, m, required
        radius; above 0 (m)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, start: collections.abc.Sequence[float], end: collections.abc.Sequence[float], radius: float) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def end(self) -> collections.abc.Sequence[float]:
        """
        centre of the other end, m
        """
    @end.setter
    def end(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def radius(self) -> float:
        """
        radius, m
        """
    @radius.setter
    def radius(self, value: float) -> None:
        ...
    @property
    def start(self) -> collections.abc.Sequence[float]:
        """
        centre of one end, m
        """
    @start.setter
    def start(self, value: collections.abc.Sequence[float]) -> None:
        ...
class Polygon(Shape):
    """
    Polygon in the x-y plane, convex or not; infinite along z.
    
    Parameters
    ----------
    vertices : collections.abc.Sequence[collections.abc.Sequence[float]], m, required
        corners in order, the last joins the first
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, vertices: collections.abc.Sequence[collections.abc.Sequence[float]]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def vertices(self) -> collections.abc.Sequence[collections.abc.Sequence[float]]:
        """
        corners in order, the last joins the first, m
        """
    @vertices.setter
    def vertices(self, value: collections.abc.Sequence[collections.abc.Sequence[float]]) -> None:
        ...
class Mesh(Shape):
    """
    What lies inside a closed surface of triangles.
    
    Parameters
    ----------
    file : str, default ''
        STL file of a closed surface, binary or text
    scale : float, m, default 1.0
        length of one unit of the file; above 0 (m)
    vertices : collections.abc.Sequence[collections.abc.Sequence[float]], default ()
        corners, where no file is given
    triangles : collections.abc.Sequence[collections.abc.Sequence[int]], default ()
        rows of three vertices, counted from 0
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, file: str = ..., scale: float = ..., vertices: collections.abc.Sequence[collections.abc.Sequence[float]] = ..., triangles: collections.abc.Sequence[collections.abc.Sequence[int]] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def file(self) -> str:
        """
        STL file of a closed surface, binary or text
        """
    @file.setter
    def file(self, value: str) -> None:
        ...
    @property
    def scale(self) -> float:
        """
        length of one unit of the file, m
        """
    @scale.setter
    def scale(self, value: float) -> None:
        ...
    @property
    def triangles(self) -> collections.abc.Sequence[collections.abc.Sequence[int]]:
        """
        rows of three vertices, counted from 0
        """
    @triangles.setter
    def triangles(self, value: collections.abc.Sequence[collections.abc.Sequence[int]]) -> None:
        ...
    @property
    def vertices(self) -> collections.abc.Sequence[collections.abc.Sequence[float]]:
        """
        corners, where no file is given
        """
    @vertices.setter
    def vertices(self, value: collections.abc.Sequence[collections.abc.Sequence[float]]) -> None:
        ...
class Image(Shape):
    """
    The bright (or dark) pixels of an image, in the x-y plane; infinite along z.
    
    Parameters
    ----------
    file : str, default ''
        PNG, PGM or PPM image
    values : collections.abc.Sequence[collections.abc.Sequence[float]], default ()
        brightness 0 to 1, rows from the top, where no file is given
    pixel : float, m, required
        side of a pixel; above 0 (m)
    origin : collections.abc.Sequence[float], m, default (0.0, 0.0)
        lower left corner of the image
    threshold : float, default 0.5
        brightness from which a pixel is inside; from 0 to 1
    dark : bool, default False
        pixels below the threshold are inside instead
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, file: str = ..., values: collections.abc.Sequence[collections.abc.Sequence[float]] = ..., pixel: float, origin: collections.abc.Sequence[float] = ..., threshold: float = ..., dark: bool = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def dark(self) -> bool:
        """
        pixels below the threshold are inside instead
        """
    @dark.setter
    def dark(self, value: bool) -> None:
        ...
    @property
    def file(self) -> str:
        """
        PNG, PGM or PPM image
        """
    @file.setter
    def file(self, value: str) -> None:
        ...
    @property
    def origin(self) -> collections.abc.Sequence[float]:
        """
        lower left corner of the image, m
        """
    @origin.setter
    def origin(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def pixel(self) -> float:
        """
        side of a pixel, m
        """
    @pixel.setter
    def pixel(self, value: float) -> None:
        ...
    @property
    def threshold(self) -> float:
        """
        brightness from which a pixel is inside
        """
    @threshold.setter
    def threshold(self, value: float) -> None:
        ...
    @property
    def values(self) -> collections.abc.Sequence[collections.abc.Sequence[float]]:
        """
        brightness 0 to 1, rows from the top, where no file is given
        """
    @values.setter
    def values(self, value: collections.abc.Sequence[collections.abc.Sequence[float]]) -> None:
        ...
class Union(Shape):
    """
    What lies in any of the shapes.
    
    Parameters
    ----------
    shapes : list[Shape], required
        shapes that are joined
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, shapes: list[Shape]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def shapes(self) -> list[Shape]:
        """
        shapes that are joined
        """
    @shapes.setter
    def shapes(self, value: list[Shape]) -> None:
        ...
class Intersection(Shape):
    """
    What lies in all of the shapes.
    
    Parameters
    ----------
    shapes : list[Shape], required
        shapes whose common part is taken
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, shapes: list[Shape]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def shapes(self) -> list[Shape]:
        """
        shapes whose common part is taken
        """
    @shapes.setter
    def shapes(self, value: list[Shape]) -> None:
        ...
class Difference(Shape):
    """
    What lies in one shape and not in another.
    
    Parameters
    ----------
    shape : Shape, required
        shape that is cut
    minus : Shape, required
        shape that is taken away
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, shape: Shape, minus: Shape) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def minus(self) -> Shape:
        """
        shape that is taken away
        """
    @minus.setter
    def minus(self, value: Shape) -> None:
        ...
    @property
    def shape(self) -> Shape:
        """
        shape that is cut
        """
    @shape.setter
    def shape(self, value: Shape) -> None:
        ...
class Rotated(Shape):
    """
    A shape turned about an axis by the right-hand rule; in two dimensions counter-clockwise.
    
    Parameters
    ----------
    shape : Shape, required
        shape that is turned
    degrees : float, degree, required
        angle, counter-clockwise
    center : collections.abc.Sequence[float], m, default ()
        point that stays; empty: the origin
    axis : collections.abc.Sequence[float], default (0.0, 0.0, 1.0)
        direction that stays, in three dimensions
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, shape: Shape, degrees: float, center: collections.abc.Sequence[float] = ..., axis: collections.abc.Sequence[float] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def axis(self) -> collections.abc.Sequence[float]:
        """
        direction that stays, in three dimensions
        """
    @axis.setter
    def axis(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        point that stays; empty: the origin, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def degrees(self) -> float:
        """
        angle, counter-clockwise, degree
        """
    @degrees.setter
    def degrees(self, value: float) -> None:
        ...
    @property
    def shape(self) -> Shape:
        """
        shape that is turned
        """
    @shape.setter
    def shape(self, value: Shape) -> None:
        ...
class Translated(Shape):
    """
    A shape moved without turning.
    
    Parameters
    ----------
    shape : Shape, required
        shape that is moved
    by : collections.abc.Sequence[float], m, required
        displacement
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, shape: Shape, by: collections.abc.Sequence[float]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def by(self) -> collections.abc.Sequence[float]:
        """
        displacement, m
        """
    @by.setter
    def by(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def shape(self) -> Shape:
        """
        shape that is moved
        """
    @shape.setter
    def shape(self, value: Shape) -> None:
        ...
class Newtonian:
    """
    A viscous fluid, slightly lighter or heavier with temperature.
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per volume at rest; above 0 (kg/m^3)
    viscosity : float, Pa s, required
        dynamic viscosity; at least 0 (Pa s)
    thermal_expansion : float, 1/K, default 0.0
        thermal expansion per volume
    reference_temperature : float, K, default 0.0
        at which the fluid has its density; 0: the mean of the fluid
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, viscosity: float, thermal_expansion: float = ..., reference_temperature: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per volume at rest, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def reference_temperature(self) -> float:
        """
        at which the fluid has its density; 0: the mean of the fluid, K
        """
    @reference_temperature.setter
    def reference_temperature(self, value: float) -> None:
        ...
    @property
    def thermal_expansion(self) -> float:
        """
        thermal expansion per volume, 1/K
        """
    @thermal_expansion.setter
    def thermal_expansion(self, value: float) -> None:
        ...
    @property
    def viscosity(self) -> float:
        """
        dynamic viscosity, Pa s
        """
    @viscosity.setter
    def viscosity(self, value: float) -> None:
        ...
class Thermal:
    """
    A solid that stores and conducts heat (Fourier) and may melt; what depends on the temperature is a pair (temperatures, values).
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per undeformed volume; above 0 (kg/m^3)
    specific_heat : float | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]], J/(kg K), required
        heat per mass and kelvin: a number, or a table over the temperature; above 0 (J/(kg K))
    conductivity : float | collections.abc.Sequence[float] | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]], W/(m K), required
        thermal conductivity: a number, xx, yy, zz, xy, yz, xz of a symmetric tensor, or a table over the temperature
    latent_heat : float, J/kg, default 0.0
        heat of melting per mass; at least 0 (J/kg)
    solidus : float | None, K, default None
        temperature at which melting begins
    liquidus : float | None, K, default None
        temperature at which melting ends, solidus unless said
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, specific_heat: float | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]], conductivity: float | collections.abc.Sequence[float] | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]], latent_heat: float = ..., solidus: float | None = ..., liquidus: float | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def conductivity(self) -> float | collections.abc.Sequence[float] | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]]:
        """
        thermal conductivity: a number, xx, yy, zz, xy, yz, xz of a symmetric tensor, or a table over the temperature, W/(m K)
        """
    @conductivity.setter
    def conductivity(self, value: float | collections.abc.Sequence[float] | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]]) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per undeformed volume, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def latent_heat(self) -> float:
        """
        heat of melting per mass, J/kg
        """
    @latent_heat.setter
    def latent_heat(self, value: float) -> None:
        ...
    @property
    def liquidus(self) -> float | None:
        """
        temperature at which melting ends, solidus unless said, K
        """
    @liquidus.setter
    def liquidus(self, value: float | None) -> None:
        ...
    @property
    def solidus(self) -> float | None:
        """
        temperature at which melting begins, K
        """
    @solidus.setter
    def solidus(self, value: float | None) -> None:
        ...
    @property
    def specific_heat(self) -> float | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]]:
        """
        heat per mass and kelvin: a number, or a table over the temperature, J/(kg K)
        """
    @specific_heat.setter
    def specific_heat(self, value: float | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]]) -> None:
        ...
class Elastic:
    """
    An isotropic linear elastic solid.
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per undeformed volume; above 0 (kg/m^3)
    youngs_modulus : float, Pa, required
        stiffness in tension; above 0 (Pa)
    poissons_ratio : float, default 0.0
        lateral contraction, in (-1, 0.5); above -1 and at most 0.5
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, youngs_modulus: float, poissons_ratio: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per undeformed volume, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def poissons_ratio(self) -> float:
        """
        lateral contraction, in (-1, 0.5)
        """
    @poissons_ratio.setter
    def poissons_ratio(self, value: float) -> None:
        ...
    @property
    def youngs_modulus(self) -> float:
        """
        stiffness in tension, Pa
        """
    @youngs_modulus.setter
    def youngs_modulus(self, value: float) -> None:
        ...
class MohrCoulomb:
    """
    Elastic, perfectly plastic soil with friction, dilation, cohesion and a tension cut-off.
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per undeformed volume; above 0 (kg/m^3)
    youngs_modulus : float, Pa, required
        stiffness in tension; above 0 (Pa)
    poissons_ratio : float, default 0.0
        lateral contraction, in (-1, 0.5); above -1 and at most 0.5
    friction_angle : float, degree, required
        friction angle; from 0 to 89.999 (degree)
    dilatancy_angle : float, degree, default 0.0
        dilatancy angle, at most the friction angle; from 0 to 89.999 (degree)
    cohesion : float, Pa, default 0.0
        shear strength without pressure; at least 0 (Pa)
    tension_cutoff : float, Pa, default inf
        largest principal stress; the apex of the cone where it is lower; at least 0 (Pa)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, youngs_modulus: float, poissons_ratio: float = ..., friction_angle: float, dilatancy_angle: float = ..., cohesion: float = ..., tension_cutoff: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def cohesion(self) -> float:
        """
        shear strength without pressure, Pa
        """
    @cohesion.setter
    def cohesion(self, value: float) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per undeformed volume, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def dilatancy_angle(self) -> float:
        """
        dilatancy angle, at most the friction angle, degree
        """
    @dilatancy_angle.setter
    def dilatancy_angle(self, value: float) -> None:
        ...
    @property
    def friction_angle(self) -> float:
        """
        friction angle, degree
        """
    @friction_angle.setter
    def friction_angle(self, value: float) -> None:
        ...
    @property
    def poissons_ratio(self) -> float:
        """
        lateral contraction, in (-1, 0.5)
        """
    @poissons_ratio.setter
    def poissons_ratio(self, value: float) -> None:
        ...
    @property
    def tension_cutoff(self) -> float:
        """
        largest principal stress; the apex of the cone where it is lower, Pa
        """
    @tension_cutoff.setter
    def tension_cutoff(self, value: float) -> None:
        ...
    @property
    def youngs_modulus(self) -> float:
        """
        stiffness in tension, Pa
        """
    @youngs_modulus.setter
    def youngs_modulus(self, value: float) -> None:
        ...
class DruckerPrager:
    """
    Elastic, perfectly plastic soil with a smooth cone, cut at its apex.
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per undeformed volume; above 0 (kg/m^3)
    youngs_modulus : float, Pa, required
        stiffness in tension; above 0 (Pa)
    poissons_ratio : float, default 0.0
        lateral contraction, in (-1, 0.5); above -1 and at most 0.5
    friction_angle : float, degree, required
        friction angle; from 0 to 89.999 (degree)
    dilatancy_angle : float, degree, default 0.0
        dilatancy angle, at most the friction angle; from 0 to 89.999 (degree)
    cohesion : float, Pa, default 0.0
        shear strength without pressure; at least 0 (Pa)
    fit : typing.Literal['plane_strain', 'compression', 'extension'], default 'plane_strain'
        where the cone has the strength of Mohr-Coulomb of these angles: plane_strain, compression or extension (triaxial)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, youngs_modulus: float, poissons_ratio: float = ..., friction_angle: float, dilatancy_angle: float = ..., cohesion: float = ..., fit: typing.Literal['plane_strain', 'compression', 'extension'] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def cohesion(self) -> float:
        """
        shear strength without pressure, Pa
        """
    @cohesion.setter
    def cohesion(self, value: float) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per undeformed volume, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def dilatancy_angle(self) -> float:
        """
        dilatancy angle, at most the friction angle, degree
        """
    @dilatancy_angle.setter
    def dilatancy_angle(self, value: float) -> None:
        ...
    @property
    def fit(self) -> typing.Literal['plane_strain', 'compression', 'extension']:
        """
        where the cone has the strength of Mohr-Coulomb of these angles: plane_strain, compression or extension (triaxial)
        """
    @fit.setter
    def fit(self, value: typing.Literal['plane_strain', 'compression', 'extension']) -> None:
        ...
    @property
    def friction_angle(self) -> float:
        """
        friction angle, degree
        """
    @friction_angle.setter
    def friction_angle(self, value: float) -> None:
        ...
    @property
    def poissons_ratio(self) -> float:
        """
        lateral contraction, in (-1, 0.5)
        """
    @poissons_ratio.setter
    def poissons_ratio(self, value: float) -> None:
        ...
    @property
    def youngs_modulus(self) -> float:
        """
        stiffness in tension, Pa
        """
    @youngs_modulus.setter
    def youngs_modulus(self, value: float) -> None:
        ...
class VonMises:
    """
    Elastic, plastic solid with von Mises' yield stress, hardening by a table.
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per undeformed volume; above 0 (kg/m^3)
    youngs_modulus : float, Pa, required
        stiffness in tension; above 0 (Pa)
    poissons_ratio : float, default 0.0
        lateral contraction, in (-1, 0.5); above -1 and at most 0.5
    yield_stress : collections.abc.Sequence[float], Pa, required
        uniaxial yield stress: a number, or one for each plastic strain, not falling; above 0 (Pa)
    plastic_strain : collections.abc.Sequence[float], default ()
        equivalent plastic strains of the yield stresses, rising from 0; linear between them, constant after the last; at least 0
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, youngs_modulus: float, poissons_ratio: float = ..., yield_stress: collections.abc.Sequence[float], plastic_strain: collections.abc.Sequence[float] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per undeformed volume, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def plastic_strain(self) -> collections.abc.Sequence[float]:
        """
        equivalent plastic strains of the yield stresses, rising from 0; linear between them, constant after the last
        """
    @plastic_strain.setter
    def plastic_strain(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def poissons_ratio(self) -> float:
        """
        lateral contraction, in (-1, 0.5)
        """
    @poissons_ratio.setter
    def poissons_ratio(self, value: float) -> None:
        ...
    @property
    def yield_stress(self) -> collections.abc.Sequence[float]:
        """
        uniaxial yield stress: a number, or one for each plastic strain, not falling, Pa
        """
    @yield_stress.setter
    def yield_stress(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def youngs_modulus(self) -> float:
        """
        stiffness in tension, Pa
        """
    @youngs_modulus.setter
    def youngs_modulus(self, value: float) -> None:
        ...
class TabulatedMohrCoulomb:
    """
    Mohr-Coulomb soil whose strength and dilatancy are tables of its plastic strain.
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per undeformed volume; above 0 (kg/m^3)
    youngs_modulus : float, Pa, required
        stiffness in tension; above 0 (Pa)
    poissons_ratio : float, default 0.0
        lateral contraction, in (-1, 0.5); above -1 and at most 0.5
    plastic_strain : collections.abc.Sequence[float], required
        deviatoric plastic strains of the tables, rising from 0; linear in sines and strength between them, constant after the last; at least 0
    friction_angle : collections.abc.Sequence[float], degree, required
        friction angle, one or one a plastic strain; from 0 to 89.999 (degree)
    dilatancy_angle : collections.abc.Sequence[float], degree, default 0.0
        dilatancy angle, at most the friction angle, one or one a plastic strain; from 0 to 89.999 (degree)
    cohesion : collections.abc.Sequence[float], Pa, default 0.0
        shear strength without pressure, one or one a plastic strain; at least 0 (Pa)
    tension_cutoff : float, Pa, default inf
        largest principal stress; the apex of the cone where it is lower; at least 0 (Pa)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, youngs_modulus: float, poissons_ratio: float = ..., plastic_strain: collections.abc.Sequence[float], friction_angle: collections.abc.Sequence[float], dilatancy_angle: collections.abc.Sequence[float] = ..., cohesion: collections.abc.Sequence[float] = ..., tension_cutoff: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def cohesion(self) -> collections.abc.Sequence[float]:
        """
        shear strength without pressure, one or one a plastic strain, Pa
        """
    @cohesion.setter
    def cohesion(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per undeformed volume, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def dilatancy_angle(self) -> collections.abc.Sequence[float]:
        """
        dilatancy angle, at most the friction angle, one or one a plastic strain, degree
        """
    @dilatancy_angle.setter
    def dilatancy_angle(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def friction_angle(self) -> collections.abc.Sequence[float]:
        """
        friction angle, one or one a plastic strain, degree
        """
    @friction_angle.setter
    def friction_angle(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def plastic_strain(self) -> collections.abc.Sequence[float]:
        """
        deviatoric plastic strains of the tables, rising from 0; linear in sines and strength between them, constant after the last
        """
    @plastic_strain.setter
    def plastic_strain(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def poissons_ratio(self) -> float:
        """
        lateral contraction, in (-1, 0.5)
        """
    @poissons_ratio.setter
    def poissons_ratio(self, value: float) -> None:
        ...
    @property
    def tension_cutoff(self) -> float:
        """
        largest principal stress; the apex of the cone where it is lower, Pa
        """
    @tension_cutoff.setter
    def tension_cutoff(self, value: float) -> None:
        ...
    @property
    def youngs_modulus(self) -> float:
        """
        stiffness in tension, Pa
        """
    @youngs_modulus.setter
    def youngs_modulus(self, value: float) -> None:
        ...
class ModifiedCamClay:
    """
    Clay that hardens with compaction and softens with dilation, up to a critical state.
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per undeformed volume; above 0 (kg/m^3)
    youngs_modulus : float, Pa, required
        stiffness in tension; above 0 (Pa)
    poissons_ratio : float, default 0.0
        lateral contraction, in (-1, 0.5); above -1 and at most 0.5
    critical_state_slope : float, required
        M of q = M p at the critical state; 6 sin(phi) / (3 - sin(phi)) in triaxial compression; above 0
    plastic_compressibility : float, required
        plastic volume strain for a rise of the preconsolidation pressure by a factor e: (lambda - kappa) / (1 + void ratio); above 0
    preconsolidation_pressure : float, Pa, required
        pressure at which it yields at the start without shear; above 0 (Pa)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, youngs_modulus: float, poissons_ratio: float = ..., critical_state_slope: float, plastic_compressibility: float, preconsolidation_pressure: float) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def critical_state_slope(self) -> float:
        """
        M of q = M p at the critical state; 6 sin(phi) / (3 - sin(phi)) in triaxial compression
        """
    @critical_state_slope.setter
    def critical_state_slope(self, value: float) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per undeformed volume, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def plastic_compressibility(self) -> float:
        """
        plastic volume strain for a rise of the preconsolidation pressure by a factor e: (lambda - kappa) / (1 + void ratio)
        """
    @plastic_compressibility.setter
    def plastic_compressibility(self, value: float) -> None:
        ...
    @property
    def poissons_ratio(self) -> float:
        """
        lateral contraction, in (-1, 0.5)
        """
    @poissons_ratio.setter
    def poissons_ratio(self, value: float) -> None:
        ...
    @property
    def preconsolidation_pressure(self) -> float:
        """
        pressure at which it yields at the start without shear, Pa
        """
    @preconsolidation_pressure.setter
    def preconsolidation_pressure(self, value: float) -> None:
        ...
    @property
    def youngs_modulus(self) -> float:
        """
        stiffness in tension, Pa
        """
    @youngs_modulus.setter
    def youngs_modulus(self, value: float) -> None:
        ...
class FunctionSolid:
    """
    A solid whose stress is a function over blocks of points.
    
    Parameters
    ----------
    density : float, kg/m^3, required
        mass per undeformed volume; above 0 (kg/m^3)
    youngs_modulus : float, Pa, required
        stiffness in tension; above 0 (Pa)
    poissons_ratio : float, default 0.0
        lateral contraction, in (-1, 0.5); above -1 and at most 0.5
    function : collections.abc.Callable[..., typing.Any], required
        (strain_increment, stress, state, time_step) of arrays with a row a point and the columns xx, yy, zz, xy, yz, xz; returns the stress, or the stress and the state
    state : collections.abc.Sequence[str], default ()
        names of its state variables
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, density: float, youngs_modulus: float, poissons_ratio: float = ..., function: collections.abc.Callable[..., typing.Any], state: collections.abc.Sequence[str] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def density(self) -> float:
        """
        mass per undeformed volume, kg/m^3
        """
    @density.setter
    def density(self, value: float) -> None:
        ...
    @property
    def function(self) -> collections.abc.Callable[..., typing.Any]:
        """
        (strain_increment, stress, state, time_step) of arrays with a row a point and the columns xx, yy, zz, xy, yz, xz; returns the stress, or the stress and the state
        """
    @function.setter
    def function(self, value: collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def poissons_ratio(self) -> float:
        """
        lateral contraction, in (-1, 0.5)
        """
    @poissons_ratio.setter
    def poissons_ratio(self, value: float) -> None:
        ...
    @property
    def state(self) -> collections.abc.Sequence[str]:
        """
        names of its state variables
        """
    @state.setter
    def state(self, value: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def youngs_modulus(self) -> float:
        """
        stiffness in tension, Pa
        """
    @youngs_modulus.setter
    def youngs_modulus(self, value: float) -> None:
        ...
class ThermalExpansion:
    """
    Isotropic expansion with temperature, beside a solid and a thermal material.
    
    Parameters
    ----------
    coefficient : float, 1/K, required
        relative change of length per kelvin
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, coefficient: float) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def coefficient(self) -> float:
        """
        relative change of length per kelvin, 1/K
        """
    @coefficient.setter
    def coefficient(self, value: float) -> None:
        ...
class PlasticHeating:
    """
    Heat released by plastic work, beside a solid and a thermal material.
    
    Parameters
    ----------
    share : float, default 0.9
        share of the plastic work that becomes heat; from 0 to 1
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, share: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def share(self) -> float:
        """
        share of the plastic work that becomes heat
        """
    @share.setter
    def share(self, value: float) -> None:
        ...
class Flux:
    """
    A prescribed flux, positive into the body.
    
    Parameters
    ----------
    name : str, default ''
        name of the region in balance and messages
    value : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], W/m^2, required
        flux, positive into the body
    region : Shape | None, default None
        shape that selects the surface
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], region: Shape | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name of the region in balance and messages
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def region(self) -> Shape | None:
        """
        shape that selects the surface
        """
    @region.setter
    def region(self, value: Shape | None) -> None:
        ...
    @property
    def value(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        flux, positive into the body, W/m^2
        """
    @value.setter
    def value(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
class Convection:
    """
    Newton's law of cooling: flux into the body = coefficient (ambient - T).
    
    Parameters
    ----------
    name : str, default ''
        name of the region in balance and messages
    coefficient : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], W/(m^2 K), required
        heat transfer coefficient; at least 0 (W/(m^2 K))
    ambient : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], K, required
        temperature far away
    region : Shape | None, default None
        shape that selects the surface
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., coefficient: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], ambient: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], region: Shape | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def ambient(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        temperature far away, K
        """
    @ambient.setter
    def ambient(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def coefficient(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        heat transfer coefficient, W/(m^2 K)
        """
    @coefficient.setter
    def coefficient(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name of the region in balance and messages
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def region(self) -> Shape | None:
        """
        shape that selects the surface
        """
    @region.setter
    def region(self, value: Shape | None) -> None:
        ...
class Radiation:
    """
    Grey-body exchange: flux into the body = emissivity sigma (ambient^4 - T^4), in absolute kelvin.
    
    Parameters
    ----------
    name : str, default ''
        name of the region in balance and messages
    emissivity : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], default 1.0
        emissivity; from 0 to 1
    ambient : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], K, required
        temperature far away, absolute unless temperature_unit says otherwise
    stefan_boltzmann : float, W/(m^2 K^4), default 5.670374419e-08
        Stefan-Boltzmann constant in the scene's units; above 0 (W/(m^2 K^4))
    region : Shape | None, default None
        shape that selects the surface
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., emissivity: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ..., ambient: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], stefan_boltzmann: float = ..., region: Shape | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def ambient(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        temperature far away, absolute unless temperature_unit says otherwise, K
        """
    @ambient.setter
    def ambient(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def emissivity(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        emissivity
        """
    @emissivity.setter
    def emissivity(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name of the region in balance and messages
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def region(self) -> Shape | None:
        """
        shape that selects the surface
        """
    @region.setter
    def region(self, value: Shape | None) -> None:
        ...
    @property
    def stefan_boltzmann(self) -> float:
        """
        Stefan-Boltzmann constant in the scene's units, W/(m^2 K^4)
        """
    @stefan_boltzmann.setter
    def stefan_boltzmann(self, value: float) -> None:
        ...
class PrescribedTemperature:
    """
    A temperature held on a surface that need not fit the grid.
    
    Parameters
    ----------
    name : str, default ''
        name of the region in balance and messages
    value : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], K, required
        temperature of the surface
    region : Shape | None, default None
        shape that selects the surface
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], region: Shape | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name of the region in balance and messages
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def region(self) -> Shape | None:
        """
        shape that selects the surface
        """
    @region.setter
    def region(self, value: Shape | None) -> None:
        ...
    @property
    def value(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        temperature of the surface, K
        """
    @value.setter
    def value(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
class HeatContact:
    """
    A thermal resistance where two bodies, or all other pairs, touch.
    
    Parameters
    ----------
    bodies : collections.abc.Sequence[str], default ()
        names of the two bodies; empty: every pair that no other entry names
    conductance : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], W/(m^2 K), required
        thermal contact conductance: flux over the jump of the temperature; at least 0 (W/(m^2 K))
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, bodies: collections.abc.Sequence[str] = ..., conductance: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def bodies(self) -> collections.abc.Sequence[str]:
        """
        names of the two bodies; empty: every pair that no other entry names
        """
    @bodies.setter
    def bodies(self, value: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def conductance(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        thermal contact conductance: flux over the jump of the temperature, W/(m^2 K)
        """
    @conductance.setter
    def conductance(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
class Heat:
    """
    Heat conduction: the section [heat] of a scene.
    
    Parameters
    ----------
    method : typing.Literal['virtual', 'paper', 'particle', 'node'], default 'virtual'
        how fluxes reach the nodes
    transfer : typing.Literal['auto', 'nodal', 'affine', 'flip', 'pic', 'tpic'], default 'auto'
        what points and nodes hand each other
    time_integration : typing.Literal['auto', 'explicit', 'implicit'], default 'auto'
        explicit Euler, the implicit theta scheme, or what costs least
    tolerance : float, default 0.0001
        error of time integration "auto", as a share of the span of temperatures; from 1e-08 to 0.1
    theta : float, default 0.5
        implicitness of the theta scheme; from 0.5 to 1
    solver : typing.Literal['auto', 'direct', 'cg'], default 'auto'
        linear solver of the theta scheme
    temperature_unit : typing.Literal['kelvin', 'celsius'] | None, default None
        unit of all temperatures, kelvin unless said; radiation needs absolute ones
    blend : float, default 4.0
        c of the step-scaled blend 1 - exp(-c dt alpha/h^2); from 0 to 1000
    normal_smoothing : int, default 2
        smoothing passes before nodal normals; from 0 to 16
    surface_fraction : float, default 0.55
        volume fraction below which a cell is surface (method paper); above 0 and at most 1
    implicit_robin : bool, default True
        take convection and radiation at the end of the step, stable for any coefficient
    corner_fit : bool, default True
        give sharp corners their whole area
    subcycling : bool | None, default 'auto'
        one step of heat for several of [dynamics], or several for one; where the clock chooses the step and transfer is affine or flip when not given
    boundaries : list[Flux | Convection | Radiation | PrescribedTemperature], default []
        fluxes and prescribed temperatures; the first region that covers a place wins
    contacts : list[HeatContact], default []
        where bodies that touch resist the heat between them
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, method: typing.Literal['virtual', 'paper', 'particle', 'node'] = ..., transfer: typing.Literal['auto', 'nodal', 'affine', 'flip', 'pic', 'tpic'] = ..., time_integration: typing.Literal['auto', 'explicit', 'implicit'] = ..., tolerance: float = ..., theta: float = ..., solver: typing.Literal['auto', 'direct', 'cg'] = ..., temperature_unit: typing.Literal['kelvin', 'celsius'] | None = ..., blend: float = ..., normal_smoothing: int = ..., surface_fraction: float = ..., implicit_robin: bool = ..., corner_fit: bool = ..., subcycling: bool | None | str = ..., boundaries: list[Flux | Convection | Radiation | PrescribedTemperature] = ..., contacts: list[HeatContact] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def blend(self) -> float:
        """
        c of the step-scaled blend 1 - exp(-c dt alpha/h^2)
        """
    @blend.setter
    def blend(self, value: float) -> None:
        ...
    @property
    def boundaries(self) -> list[Flux | Convection | Radiation | PrescribedTemperature]:
        """
        fluxes and prescribed temperatures; the first region that covers a place wins
        """
    @boundaries.setter
    def boundaries(self, value: list[Flux | Convection | Radiation | PrescribedTemperature]) -> None:
        ...
    @property
    def contacts(self) -> list[HeatContact]:
        """
        where bodies that touch resist the heat between them
        """
    @contacts.setter
    def contacts(self, value: list[HeatContact]) -> None:
        ...
    @property
    def corner_fit(self) -> bool:
        """
        give sharp corners their whole area
        """
    @corner_fit.setter
    def corner_fit(self, value: bool) -> None:
        ...
    @property
    def implicit_robin(self) -> bool:
        """
        take convection and radiation at the end of the step, stable for any coefficient
        """
    @implicit_robin.setter
    def implicit_robin(self, value: bool) -> None:
        ...
    @property
    def method(self) -> typing.Literal['virtual', 'paper', 'particle', 'node']:
        """
        how fluxes reach the nodes
        """
    @method.setter
    def method(self, value: typing.Literal['virtual', 'paper', 'particle', 'node']) -> None:
        ...
    @property
    def normal_smoothing(self) -> int:
        """
        smoothing passes before nodal normals
        """
    @normal_smoothing.setter
    def normal_smoothing(self, value: int) -> None:
        ...
    @property
    def solver(self) -> typing.Literal['auto', 'direct', 'cg']:
        """
        linear solver of the theta scheme
        """
    @solver.setter
    def solver(self, value: typing.Literal['auto', 'direct', 'cg']) -> None:
        ...
    @property
    def subcycling(self) -> bool | None | str:
        """
        one step of heat for several of [dynamics], or several for one; where the clock chooses the step and transfer is affine or flip when not given
        """
    @subcycling.setter
    def subcycling(self, value: bool | None | str) -> None:
        ...
    @property
    def surface_fraction(self) -> float:
        """
        volume fraction below which a cell is surface (method paper)
        """
    @surface_fraction.setter
    def surface_fraction(self, value: float) -> None:
        ...
    @property
    def temperature_unit(self) -> typing.Literal['kelvin', 'celsius'] | None:
        """
        unit of all temperatures, kelvin unless said; radiation needs absolute ones
        """
    @temperature_unit.setter
    def temperature_unit(self, value: typing.Literal['kelvin', 'celsius'] | None) -> None:
        ...
    @property
    def theta(self) -> float:
        """
        implicitness of the theta scheme
        """
    @theta.setter
    def theta(self, value: float) -> None:
        ...
    @property
    def time_integration(self) -> typing.Literal['auto', 'explicit', 'implicit']:
        """
        explicit Euler, the implicit theta scheme, or what costs least
        """
    @time_integration.setter
    def time_integration(self, value: typing.Literal['auto', 'explicit', 'implicit']) -> None:
        ...
    @property
    def tolerance(self) -> float:
        """
        error of time integration "auto", as a share of the span of temperatures
        """
    @tolerance.setter
    def tolerance(self, value: float) -> None:
        ...
    @property
    def transfer(self) -> typing.Literal['auto', 'nodal', 'affine', 'flip', 'pic', 'tpic']:
        """
        what points and nodes hand each other
        """
    @transfer.setter
    def transfer(self, value: typing.Literal['auto', 'nodal', 'affine', 'flip', 'pic', 'tpic']) -> None:
        ...
class NoSlipBoundary:
    """
    A face of the grid that the material sticks to.
    
    Parameters
    ----------
    face : typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper'], required
        x_lower, x_upper, y_lower, y_upper, z_lower or z_upper
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, face: typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper']) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def face(self) -> typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper']:
        """
        x_lower, x_upper, y_lower, y_upper, z_lower or z_upper
        """
    @face.setter
    def face(self, value: typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper']) -> None:
        ...
class RollerBoundary:
    """
    A face of the grid that the material slides along and cannot part from.
    
    Parameters
    ----------
    face : typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper'], required
        x_lower, x_upper, y_lower, y_upper, z_lower or z_upper
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, face: typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper']) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def face(self) -> typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper']:
        """
        x_lower, x_upper, y_lower, y_upper, z_lower or z_upper
        """
    @face.setter
    def face(self, value: typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper']) -> None:
        ...
class FrictionalBoundary:
    """
    A face of the grid that the material parts from freely and slides along with Coulomb friction.
    
    Parameters
    ----------
    face : typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper'], required
        x_lower, x_upper, y_lower, y_upper, z_lower or z_upper
    coefficient : float, default 0.0
        tangent of the angle of wall friction; at least 0
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, face: typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper'], coefficient: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def coefficient(self) -> float:
        """
        tangent of the angle of wall friction
        """
    @coefficient.setter
    def coefficient(self, value: float) -> None:
        ...
    @property
    def face(self) -> typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper']:
        """
        x_lower, x_upper, y_lower, y_upper, z_lower or z_upper
        """
    @face.setter
    def face(self, value: typing.Literal['x_lower', 'x_upper', 'y_lower', 'y_upper', 'z_lower', 'z_upper']) -> None:
        ...
class Obstacle:
    """
    A rigid obstacle of any shape, at rest or with a prescribed motion.
    
    Parameters
    ----------
    name : str, default ''
        name of the obstacle in diagnostics and messages
    shape : Shape, required
        what material cannot enter, any shape
    contact : typing.Literal['frictional', 'slip', 'no_slip'], default 'frictional'
        frictional, slip or no_slip
    friction : float, default 0.0
        coefficient of Coulomb friction, of frictional; at least 0
    adhesion : float, Pa, default 0.0
        shear it bears beyond friction; at least 0 (Pa)
    separation : bool, default True
        whether material that has touched it may part from it; else it can pull
    velocity : collections.abc.Sequence[float], m/s, default ()
        one number an axis, with a mass at the start; empty: none
    revolutions_per_second : float, 1/s, default 0.0
        positive counter-clockwise, with a mass at the start
    center : collections.abc.Sequence[float], m, default ()
        centre of the turning; empty: the origin, with a mass the centre of the shape
    axis : collections.abc.Sequence[float], default (0.0, 0.0, 1.0)
        direction of the axis, in 3D
    factor : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], default 1.0
        multiplies the motion: a number or a table in time
    mass : float | None, kg, default None
        of one that its weight and the forces on it move, in 2D per metre of depth; absent: its motion is prescribed; above 0 (kg)
    inertia : collections.abc.Sequence[float], kg m^2, default ()
        about its centre, one number in 2D, about x, y, z in 3D; empty: of the shape at one density
    force : collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]], N, default ()
        on one with a mass, besides weight and contacts, one value an axis; empty: none
    held : collections.abc.Sequence[str], default ()
        of one with a mass: "x", "y", "z", "rotation" that go on as at the start
    temperature : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] | None, K, default None
        of its surface, a number or a table in time; absent: no heat passes
    conductance : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] | None, W/(m^2 K), default 'perfect'
        thermal contact conductance where material touches it: flux over the jump of the temperature, a number or a table in time; at least 0 (W/(m^2 K))
    heat_capacity : float | None, J/K, default None
        of one that the heat it takes warms, from its temperature on, in 2D per metre of depth; absent: its temperature stays as given; above 0 (J/K)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., shape: Shape, contact: typing.Literal['frictional', 'slip', 'no_slip'] = ..., friction: float = ..., adhesion: float = ..., separation: bool = ..., velocity: collections.abc.Sequence[float] = ..., revolutions_per_second: float = ..., center: collections.abc.Sequence[float] = ..., axis: collections.abc.Sequence[float] = ..., factor: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ..., mass: float | None = ..., inertia: collections.abc.Sequence[float] = ..., force: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]] = ..., held: collections.abc.Sequence[str] = ..., temperature: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] | None = ..., conductance: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] | None | str = ..., heat_capacity: float | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def adhesion(self) -> float:
        """
        shear it bears beyond friction, Pa
        """
    @adhesion.setter
    def adhesion(self, value: float) -> None:
        ...
    @property
    def axis(self) -> collections.abc.Sequence[float]:
        """
        direction of the axis, in 3D
        """
    @axis.setter
    def axis(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        centre of the turning; empty: the origin, with a mass the centre of the shape, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def conductance(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] | None | str:
        """
        thermal contact conductance where material touches it: flux over the jump of the temperature, a number or a table in time, W/(m^2 K)
        """
    @conductance.setter
    def conductance(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] | None | str) -> None:
        ...
    @property
    def contact(self) -> typing.Literal['frictional', 'slip', 'no_slip']:
        """
        frictional, slip or no_slip
        """
    @contact.setter
    def contact(self, value: typing.Literal['frictional', 'slip', 'no_slip']) -> None:
        ...
    @property
    def factor(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        multiplies the motion: a number or a table in time
        """
    @factor.setter
    def factor(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def force(self) -> collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]:
        """
        on one with a mass, besides weight and contacts, one value an axis; empty: none, N
        """
    @force.setter
    def force(self, value: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]) -> None:
        ...
    @property
    def friction(self) -> float:
        """
        coefficient of Coulomb friction, of frictional
        """
    @friction.setter
    def friction(self, value: float) -> None:
        ...
    @property
    def heat_capacity(self) -> float | None:
        """
        of one that the heat it takes warms, from its temperature on, in 2D per metre of depth; absent: its temperature stays as given, J/K
        """
    @heat_capacity.setter
    def heat_capacity(self, value: float | None) -> None:
        ...
    @property
    def held(self) -> collections.abc.Sequence[str]:
        """
        of one with a mass: "x", "y", "z", "rotation" that go on as at the start
        """
    @held.setter
    def held(self, value: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def inertia(self) -> collections.abc.Sequence[float]:
        """
        about its centre, one number in 2D, about x, y, z in 3D; empty: of the shape at one density, kg m^2
        """
    @inertia.setter
    def inertia(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def mass(self) -> float | None:
        """
        of one that its weight and the forces on it move, in 2D per metre of depth; absent: its motion is prescribed, kg
        """
    @mass.setter
    def mass(self, value: float | None) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name of the obstacle in diagnostics and messages
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def revolutions_per_second(self) -> float:
        """
        positive counter-clockwise, with a mass at the start, 1/s
        """
    @revolutions_per_second.setter
    def revolutions_per_second(self, value: float) -> None:
        ...
    @property
    def separation(self) -> bool:
        """
        whether material that has touched it may part from it; else it can pull
        """
    @separation.setter
    def separation(self, value: bool) -> None:
        ...
    @property
    def shape(self) -> Shape:
        """
        what material cannot enter, any shape
        """
    @shape.setter
    def shape(self, value: Shape) -> None:
        ...
    @property
    def temperature(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] | None:
        """
        of its surface, a number or a table in time; absent: no heat passes, K
        """
    @temperature.setter
    def temperature(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] | None) -> None:
        ...
    @property
    def velocity(self) -> collections.abc.Sequence[float]:
        """
        one number an axis, with a mass at the start; empty: none, m/s
        """
    @velocity.setter
    def velocity(self, value: collections.abc.Sequence[float]) -> None:
        ...
class BodyContact:
    """
    What one pair of bodies, or every other pair, does where it meets.
    
    Parameters
    ----------
    bodies : collections.abc.Sequence[str], default ()
        names of the two bodies; empty: every pair that no other entry names
    contact : typing.Literal['frictional', 'bonded'], default 'frictional'
        frictional: parts and slides; bonded: one body, tension included
    friction : float, default 0.0
        coefficient of Coulomb friction, of frictional; at least 0
    adhesion : float, Pa, default 0.0
        shear it bears beyond friction; at least 0 (Pa)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, bodies: collections.abc.Sequence[str] = ..., contact: typing.Literal['frictional', 'bonded'] = ..., friction: float = ..., adhesion: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def adhesion(self) -> float:
        """
        shear it bears beyond friction, Pa
        """
    @adhesion.setter
    def adhesion(self, value: float) -> None:
        ...
    @property
    def bodies(self) -> collections.abc.Sequence[str]:
        """
        names of the two bodies; empty: every pair that no other entry names
        """
    @bodies.setter
    def bodies(self, value: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def contact(self) -> typing.Literal['frictional', 'bonded']:
        """
        frictional: parts and slides; bonded: one body, tension included
        """
    @contact.setter
    def contact(self, value: typing.Literal['frictional', 'bonded']) -> None:
        ...
    @property
    def friction(self) -> float:
        """
        coefficient of Coulomb friction, of frictional
        """
    @friction.setter
    def friction(self, value: float) -> None:
        ...
class Pressure:
    """
    A pressure on a free surface.
    
    Parameters
    ----------
    name : str, default ''
        name of the region in balance and messages
    value : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], Pa, required
        pressure, positive into the body
    region : Shape | None, default None
        shape that selects the surface
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], region: Shape | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name of the region in balance and messages
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def region(self) -> Shape | None:
        """
        shape that selects the surface
        """
    @region.setter
    def region(self, value: Shape | None) -> None:
        ...
    @property
    def value(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        pressure, positive into the body, Pa
        """
    @value.setter
    def value(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
class Traction:
    """
    A force per area of a free surface.
    
    Parameters
    ----------
    name : str, default ''
        name of the region in balance and messages
    value : collections.abc.Sequence[float], Pa, required
        force per area, one number an axis
    factor : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], default 1.0
        multiplies it: a number, a table in time or a function
    region : Shape | None, default None
        shape that selects the surface
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., value: collections.abc.Sequence[float], factor: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ..., region: Shape | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def factor(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        multiplies it: a number, a table in time or a function
        """
    @factor.setter
    def factor(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name of the region in balance and messages
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def region(self) -> Shape | None:
        """
        shape that selects the surface
        """
    @region.setter
    def region(self, value: Shape | None) -> None:
        ...
    @property
    def value(self) -> collections.abc.Sequence[float]:
        """
        force per area, one number an axis, Pa
        """
    @value.setter
    def value(self, value: collections.abc.Sequence[float]) -> None:
        ...
class Dynamics:
    """
    Explicit dynamics: the section [dynamics] of a scene.
    
    Parameters
    ----------
    gravity : collections.abc.Sequence[float], m/s^2, default ()
        one number an axis; empty: none
    gravity_factor : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], default 1.0
        multiplies gravity: a number or a table in time
    local_damping : float, default 0.0
        share of the force out of balance that acts against the velocity, for a static start; from 0 to 0.95
    damping_until : float | None, s, default None
        when local damping ends; absent: with the run; at least 0 (s)
    transfer : typing.Literal['blended_apic', 'flip', 'apic', 'tpic'], default 'blended_apic'
        what points and nodes hand each other
    blend_rate : float, default 4.0
        blended_apic: rate, per unit of strain, at which points take the nodal velocity; at least 0
    pic_fraction : float, default 0.05
        flip: share of the nodal velocity, applied once a step; from 0 to 1
    stress_update : typing.Literal['usl', 'musl'], default 'musl'
        which nodal velocity strains the points
    b_bar : bool | None, default 'auto'
        points take the mean dilatation of their cell, so that it does not lock; absent: those of a Poisson ratio above 0.4, or whose strength does not grow with pressure
    courant : float, default 0.5
        automatic step over h / (wave speed + point speed); above 0 and at most 1
    grid_boundaries : list[NoSlipBoundary | RollerBoundary | FrictionalBoundary], default []
        faces of the grid that hold the material; others are open
    outside : typing.Literal['stop', 'remove'], default 'stop'
        what becomes of points that leave through open faces: the run stops, or they are removed with all that they carry
    obstacles : list[Obstacle], default []
        rigid shapes that material cannot enter, at rest or moving
    contacts : list[BodyContact], default []
        what pairs of bodies do where they meet; others: see the manual
    boundaries : list[Pressure | Traction], default []
        loads on free surfaces; the first region that covers a place wins
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, gravity: collections.abc.Sequence[float] = ..., gravity_factor: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ..., local_damping: float = ..., damping_until: float | None = ..., transfer: typing.Literal['blended_apic', 'flip', 'apic', 'tpic'] = ..., blend_rate: float = ..., pic_fraction: float = ..., stress_update: typing.Literal['usl', 'musl'] = ..., b_bar: bool | None | str = ..., courant: float = ..., grid_boundaries: list[NoSlipBoundary | RollerBoundary | FrictionalBoundary] = ..., outside: typing.Literal['stop', 'remove'] = ..., obstacles: list[Obstacle] = ..., contacts: list[BodyContact] = ..., boundaries: list[Pressure | Traction] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def b_bar(self) -> bool | None | str:
        """
        points take the mean dilatation of their cell, so that it does not lock; absent: those of a Poisson ratio above 0.4, or whose strength does not grow with pressure
        """
    @b_bar.setter
    def b_bar(self, value: bool | None | str) -> None:
        ...
    @property
    def blend_rate(self) -> float:
        """
        blended_apic: rate, per unit of strain, at which points take the nodal velocity
        """
    @blend_rate.setter
    def blend_rate(self, value: float) -> None:
        ...
    @property
    def boundaries(self) -> list[Pressure | Traction]:
        """
        loads on free surfaces; the first region that covers a place wins
        """
    @boundaries.setter
    def boundaries(self, value: list[Pressure | Traction]) -> None:
        ...
    @property
    def contacts(self) -> list[BodyContact]:
        """
        what pairs of bodies do where they meet; others: see the manual
        """
    @contacts.setter
    def contacts(self, value: list[BodyContact]) -> None:
        ...
    @property
    def courant(self) -> float:
        """
        automatic step over h / (wave speed + point speed)
        """
    @courant.setter
    def courant(self, value: float) -> None:
        ...
    @property
    def damping_until(self) -> float | None:
        """
        when local damping ends; absent: with the run, s
        """
    @damping_until.setter
    def damping_until(self, value: float | None) -> None:
        ...
    @property
    def gravity(self) -> collections.abc.Sequence[float]:
        """
        one number an axis; empty: none, m/s^2
        """
    @gravity.setter
    def gravity(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def gravity_factor(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        multiplies gravity: a number or a table in time
        """
    @gravity_factor.setter
    def gravity_factor(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def grid_boundaries(self) -> list[NoSlipBoundary | RollerBoundary | FrictionalBoundary]:
        """
        faces of the grid that hold the material; others are open
        """
    @grid_boundaries.setter
    def grid_boundaries(self, value: list[NoSlipBoundary | RollerBoundary | FrictionalBoundary]) -> None:
        ...
    @property
    def local_damping(self) -> float:
        """
        share of the force out of balance that acts against the velocity, for a static start
        """
    @local_damping.setter
    def local_damping(self, value: float) -> None:
        ...
    @property
    def obstacles(self) -> list[Obstacle]:
        """
        rigid shapes that material cannot enter, at rest or moving
        """
    @obstacles.setter
    def obstacles(self, value: list[Obstacle]) -> None:
        ...
    @property
    def outside(self) -> typing.Literal['stop', 'remove']:
        """
        what becomes of points that leave through open faces: the run stops, or they are removed with all that they carry
        """
    @outside.setter
    def outside(self, value: typing.Literal['stop', 'remove']) -> None:
        ...
    @property
    def pic_fraction(self) -> float:
        """
        flip: share of the nodal velocity, applied once a step
        """
    @pic_fraction.setter
    def pic_fraction(self, value: float) -> None:
        ...
    @property
    def stress_update(self) -> typing.Literal['usl', 'musl']:
        """
        which nodal velocity strains the points
        """
    @stress_update.setter
    def stress_update(self, value: typing.Literal['usl', 'musl']) -> None:
        ...
    @property
    def transfer(self) -> typing.Literal['blended_apic', 'flip', 'apic', 'tpic']:
        """
        what points and nodes hand each other
        """
    @transfer.setter
    def transfer(self, value: typing.Literal['blended_apic', 'flip', 'apic', 'tpic']) -> None:
        ...
class Support:
    """
    A surface on which the displacement is prescribed; it need not fit the grid.
    
    Parameters
    ----------
    name : str, default ''
        name in messages and results
    kind : typing.Literal['fixed', 'roller', 'tangent'], default 'fixed'
        fixed, roller (free along its face) or tangent (free across it)
    shape : Shape | None, default None
        shape whose surface it is
    inside : bool, default False
        whether the material is inside the shape, or outside
    line : collections.abc.Sequence[collections.abc.Sequence[float]], m, default ()
        2D: points of an open line, the material on its left
    within : Shape | None, default None
        the part of the surface that counts; absent: all of it
    displacement : collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]], m, default ()
        of the support since time 0, one value an axis; empty: it stands
    advance : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], m, default 0.0
        of the face along its normal into the material since time 0: a hole that widens
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., kind: typing.Literal['fixed', 'roller', 'tangent'] = ..., shape: Shape | None = ..., inside: bool = ..., line: collections.abc.Sequence[collections.abc.Sequence[float]] = ..., within: Shape | None = ..., displacement: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]] = ..., advance: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def advance(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        of the face along its normal into the material since time 0: a hole that widens, m
        """
    @advance.setter
    def advance(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def displacement(self) -> collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]:
        """
        of the support since time 0, one value an axis; empty: it stands, m
        """
    @displacement.setter
    def displacement(self, value: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]) -> None:
        ...
    @property
    def inside(self) -> bool:
        """
        whether the material is inside the shape, or outside
        """
    @inside.setter
    def inside(self, value: bool) -> None:
        ...
    @property
    def kind(self) -> typing.Literal['fixed', 'roller', 'tangent']:
        """
        fixed, roller (free along its face) or tangent (free across it)
        """
    @kind.setter
    def kind(self, value: typing.Literal['fixed', 'roller', 'tangent']) -> None:
        ...
    @property
    def line(self) -> collections.abc.Sequence[collections.abc.Sequence[float]]:
        """
        2D: points of an open line, the material on its left, m
        """
    @line.setter
    def line(self, value: collections.abc.Sequence[collections.abc.Sequence[float]]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name in messages and results
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def shape(self) -> Shape | None:
        """
        shape whose surface it is
        """
    @shape.setter
    def shape(self, value: Shape | None) -> None:
        ...
    @property
    def within(self) -> Shape | None:
        """
        the part of the surface that counts; absent: all of it
        """
    @within.setter
    def within(self, value: Shape | None) -> None:
        ...
class SurfaceTraction:
    """
    A surface on which a force per area acts.
    
    Parameters
    ----------
    name : str, default ''
        name in messages and results
    shape : Shape | None, default None
        shape whose surface it is
    inside : bool, default False
        whether the material is inside the shape, or outside
    line : collections.abc.Sequence[collections.abc.Sequence[float]], m, default ()
        2D: points of an open line, the material on its left
    within : Shape | None, default None
        the part of the surface that counts; absent: all of it
    traction : collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]], Pa, default ()
        force per area on the material, one value an axis; empty: none
    pressure : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], Pa, default 0.0
        force per area along the normal into the material
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., shape: Shape | None = ..., inside: bool = ..., line: collections.abc.Sequence[collections.abc.Sequence[float]] = ..., within: Shape | None = ..., traction: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]] = ..., pressure: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def inside(self) -> bool:
        """
        whether the material is inside the shape, or outside
        """
    @inside.setter
    def inside(self, value: bool) -> None:
        ...
    @property
    def line(self) -> collections.abc.Sequence[collections.abc.Sequence[float]]:
        """
        2D: points of an open line, the material on its left, m
        """
    @line.setter
    def line(self, value: collections.abc.Sequence[collections.abc.Sequence[float]]) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name in messages and results
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def pressure(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        force per area along the normal into the material, Pa
        """
    @pressure.setter
    def pressure(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def shape(self) -> Shape | None:
        """
        shape whose surface it is
        """
    @shape.setter
    def shape(self, value: Shape | None) -> None:
        ...
    @property
    def traction(self) -> collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]:
        """
        force per area on the material, one value an axis; empty: none, Pa
        """
    @traction.setter
    def traction(self, value: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]) -> None:
        ...
    @property
    def within(self) -> Shape | None:
        """
        the part of the surface that counts; absent: all of it
        """
    @within.setter
    def within(self, value: Shape | None) -> None:
        ...
class QuasiStatic:
    """
    Equilibrium under load steps with implicit boundaries: the section [quasi_static] of a scene.
    
    Parameters
    ----------
    enforcement : typing.Literal['mean-gap', 'pointwise', 'literal', 'nitsche', 'penalty'], default 'mean-gap'
        how supports that do not fit the grid are imposed
    bandwidth : float | None, cells, default None
        of the stiff constraint; absent: 1e-3, literal 1e-6; above 0 and at most 1 (cells)
    gap_bandwidth : float | None, cells, default None
        of the moderate constraint of mean-gap and nitsche; absent: 0.05, mean-gap 0.5 until a point has moved by half a cell; above 0 and at most 1 (cells)
    ghost_penalty : float | None, default None
        stabilisation of cut and surface cells; absent: 0.01, literal none; from 0 to 1
    hold_empty_cells : bool, default True
        supports in empty cells beside material still hold it
    reset : float | None, cells, default None
        points keep their shape functions until one has moved this far; absent: 0.1, literal 0; from 0 to 1 (cells)
    relaxation : float | None, cells, default None
        forces that a reset of the grid leaves out of balance are taken up while points move this far; absent: 0.5, literal 0 (at once); from 0 to 100 (cells)
    update_volumes : bool | None, default 'auto'
        volumes of points follow their strain at each reset of the grid; absent: yes, literal no
    b_bar : bool | None, default 'auto'
        points take the mean dilatation of their cell, so that it does not lock; absent: those of a Poisson ratio above 0.4
    max_penetration : float, cells, default 0.5
        a point further behind a support fails the load step; above 0 (cells)
    gravity : collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]], m/s^2, default ()
        acts on the density of every body, one value an axis; empty: none
    body_force : collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]], N/m^3, default ()
        force per volume, one value an axis
    tolerance : float, default 1e-10
        of the out-of-balance force, relative; above 0 and at most 0.01
    max_iterations : int, default 12
        of Newton's method in one load step; from 1 to 1000
    max_cutbacks : int, default 6
        of a load step that fails; from 0 to 30
    supports : list[Support], default []
        where the displacement is prescribed
    tractions : list[SurfaceTraction], default []
        where forces act on the surface
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, enforcement: typing.Literal['mean-gap', 'pointwise', 'literal', 'nitsche', 'penalty'] = ..., bandwidth: float | None = ..., gap_bandwidth: float | None = ..., ghost_penalty: float | None = ..., hold_empty_cells: bool = ..., reset: float | None = ..., relaxation: float | None = ..., update_volumes: bool | None | str = ..., b_bar: bool | None | str = ..., max_penetration: float = ..., gravity: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]] = ..., body_force: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]] = ..., tolerance: float = ..., max_iterations: int = ..., max_cutbacks: int = ..., supports: list[Support] = ..., tractions: list[SurfaceTraction] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def b_bar(self) -> bool | None | str:
        """
        points take the mean dilatation of their cell, so that it does not lock; absent: those of a Poisson ratio above 0.4
        """
    @b_bar.setter
    def b_bar(self, value: bool | None | str) -> None:
        ...
    @property
    def bandwidth(self) -> float | None:
        """
        of the stiff constraint; absent: 1e-3, literal 1e-6, cells
        """
    @bandwidth.setter
    def bandwidth(self, value: float | None) -> None:
        ...
    @property
    def body_force(self) -> collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]:
        """
        force per volume, one value an axis, N/m^3
        """
    @body_force.setter
    def body_force(self, value: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]) -> None:
        ...
    @property
    def enforcement(self) -> typing.Literal['mean-gap', 'pointwise', 'literal', 'nitsche', 'penalty']:
        """
        how supports that do not fit the grid are imposed
        """
    @enforcement.setter
    def enforcement(self, value: typing.Literal['mean-gap', 'pointwise', 'literal', 'nitsche', 'penalty']) -> None:
        ...
    @property
    def gap_bandwidth(self) -> float | None:
        """
        of the moderate constraint of mean-gap and nitsche; absent: 0.05, mean-gap 0.5 until a point has moved by half a cell, cells
        """
    @gap_bandwidth.setter
    def gap_bandwidth(self, value: float | None) -> None:
        ...
    @property
    def ghost_penalty(self) -> float | None:
        """
        stabilisation of cut and surface cells; absent: 0.01, literal none
        """
    @ghost_penalty.setter
    def ghost_penalty(self, value: float | None) -> None:
        ...
    @property
    def gravity(self) -> collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]:
        """
        acts on the density of every body, one value an axis; empty: none, m/s^2
        """
    @gravity.setter
    def gravity(self, value: collections.abc.Sequence[float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]]) -> None:
        ...
    @property
    def hold_empty_cells(self) -> bool:
        """
        supports in empty cells beside material still hold it
        """
    @hold_empty_cells.setter
    def hold_empty_cells(self, value: bool) -> None:
        ...
    @property
    def max_cutbacks(self) -> int:
        """
        of a load step that fails
        """
    @max_cutbacks.setter
    def max_cutbacks(self, value: int) -> None:
        ...
    @property
    def max_iterations(self) -> int:
        """
        of Newton's method in one load step
        """
    @max_iterations.setter
    def max_iterations(self, value: int) -> None:
        ...
    @property
    def max_penetration(self) -> float:
        """
        a point further behind a support fails the load step, cells
        """
    @max_penetration.setter
    def max_penetration(self, value: float) -> None:
        ...
    @property
    def relaxation(self) -> float | None:
        """
        forces that a reset of the grid leaves out of balance are taken up while points move this far; absent: 0.5, literal 0 (at once), cells
        """
    @relaxation.setter
    def relaxation(self, value: float | None) -> None:
        ...
    @property
    def reset(self) -> float | None:
        """
        points keep their shape functions until one has moved this far; absent: 0.1, literal 0, cells
        """
    @reset.setter
    def reset(self, value: float | None) -> None:
        ...
    @property
    def supports(self) -> list[Support]:
        """
        where the displacement is prescribed
        """
    @supports.setter
    def supports(self, value: list[Support]) -> None:
        ...
    @property
    def tolerance(self) -> float:
        """
        of the out-of-balance force, relative
        """
    @tolerance.setter
    def tolerance(self, value: float) -> None:
        ...
    @property
    def tractions(self) -> list[SurfaceTraction]:
        """
        where forces act on the surface
        """
    @tractions.setter
    def tractions(self, value: list[SurfaceTraction]) -> None:
        ...
    @property
    def update_volumes(self) -> bool | None | str:
        """
        volumes of points follow their strain at each reset of the grid; absent: yes, literal no
        """
    @update_volumes.setter
    def update_volumes(self, value: bool | None | str) -> None:
        ...
class Points:
    """
    Points handed over as arrays; no scene file holds them.
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    @staticmethod
    def __getstate__(*args: typing.Any, **kwargs: typing.Any) -> typing.Any:
        ...
    @staticmethod
    def __setstate__(*args: typing.Any, **kwargs: typing.Any) -> typing.Any:
        ...
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __init__(self, positions: numpy.typing.ArrayLike, volumes: numpy.typing.ArrayLike) -> None:
        ...
    def __len__(self) -> int:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def positions(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        copy of the positions (points, dimension), m
        """
    @property
    def volumes(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        copy of the volumes (points,), m^dimension
        """
class _Places:
    """
    Where keys stand in a file.
    """
    @staticmethod
    def __getstate__(*args: typing.Any, **kwargs: typing.Any) -> typing.Any:
        ...
    @staticmethod
    def __setstate__(*args: typing.Any, **kwargs: typing.Any) -> typing.Any:
        ...
    def __reduce__(self) -> typing.Any:
        ...
class Rotation:
    """
    A body turned at constant speed.
    
    Parameters
    ----------
    revolutions_per_second : float, 1/s, required
        positive counter-clockwise
    center : collections.abc.Sequence[float], m, default ()
        a place on the axis; empty: the origin
    axis : collections.abc.Sequence[float], default (0.0, 0.0, 1.0)
        direction of the axis, in 3D
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, revolutions_per_second: float, center: collections.abc.Sequence[float] = ..., axis: collections.abc.Sequence[float] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def axis(self) -> collections.abc.Sequence[float]:
        """
        direction of the axis, in 3D
        """
    @axis.setter
    def axis(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        a place on the axis; empty: the origin, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def revolutions_per_second(self) -> float:
        """
        positive counter-clockwise, 1/s
        """
    @revolutions_per_second.setter
    def revolutions_per_second(self, value: float) -> None:
        ...
class Translation:
    """
    A body moved at constant velocity.
    
    Parameters
    ----------
    velocity : collections.abc.Sequence[float], m/s, required
        one number an axis
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, velocity: collections.abc.Sequence[float]) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def velocity(self) -> collections.abc.Sequence[float]:
        """
        one number an axis, m/s
        """
    @velocity.setter
    def velocity(self, value: collections.abc.Sequence[float]) -> None:
        ...
class Swirl:
    """
    Circles that turn at their own speeds.
    
    Parameters
    ----------
    revolutions_per_second : float, 1/s, required
        of the rim
    shear : float, default 0.4
        s of w (1 + s (1 - r^2/R^2))
    radius : float, m, default 1.0
        R, the rim; above 0 (m)
    center : collections.abc.Sequence[float], m, default ()
        centre of the swirl; empty: the origin
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, revolutions_per_second: float, shear: float = ..., radius: float = ..., center: collections.abc.Sequence[float] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def center(self) -> collections.abc.Sequence[float]:
        """
        centre of the swirl; empty: the origin, m
        """
    @center.setter
    def center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def radius(self) -> float:
        """
        R, the rim, m
        """
    @radius.setter
    def radius(self, value: float) -> None:
        ...
    @property
    def revolutions_per_second(self) -> float:
        """
        of the rim, 1/s
        """
    @revolutions_per_second.setter
    def revolutions_per_second(self, value: float) -> None:
        ...
    @property
    def shear(self) -> float:
        """
        s of w (1 + s (1 - r^2/R^2))
        """
    @shear.setter
    def shear(self, value: float) -> None:
        ...
class Geostatic:
    """
    The stress of a body that rests below an even free surface, level or inclined.
    
    Parameters
    ----------
    surface : collections.abc.Sequence[float], m, default ()
        a place on an even free surface; empty: the weight of all bodies above, level by level
    normal : collections.abc.Sequence[float], default ()
        outward normal of the surface; empty: against gravity
    k0 : float, default 0.5
        stress along the surface over the one across it; at least 0
    surcharge : float, Pa, default 0.0
        load on the surface that the stress at the start bears too; at least 0 (Pa)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, surface: collections.abc.Sequence[float] = ..., normal: collections.abc.Sequence[float] = ..., k0: float = ..., surcharge: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def k0(self) -> float:
        """
        stress along the surface over the one across it
        """
    @k0.setter
    def k0(self, value: float) -> None:
        ...
    @property
    def normal(self) -> collections.abc.Sequence[float]:
        """
        outward normal of the surface; empty: against gravity
        """
    @normal.setter
    def normal(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def surcharge(self) -> float:
        """
        load on the surface that the stress at the start bears too, Pa
        """
    @surcharge.setter
    def surcharge(self, value: float) -> None:
        ...
    @property
    def surface(self) -> collections.abc.Sequence[float]:
        """
        a place on an even free surface; empty: the weight of all bodies above, level by level, m
        """
    @surface.setter
    def surface(self, value: collections.abc.Sequence[float]) -> None:
        ...
class Body:
    """
    A body: where its points come from (one of shape, points_file, points), what it is made of, how it starts and how it is moved.
    
    Parameters
    ----------
    name : str, default ''
        name in messages and results
    shape : Shape | None, default None
        shape filled with points
    points_file : str, default ''
        text file of points: coordinates and volume in each row
    points : Points | None, default None
        arrays of points, from a program only
    points_per_cell : int | None, default 'auto'
        points in a full cell, the same number along each axis; from 1 to 1000
    fill : typing.Literal['exact', 'lattice'] | None, default 'auto'
        points with the volume of their part of the shape, or whole boxes of a lattice; automatic: lattice in peridynamic flow and under conditions on the surface of gimp points that may move, otherwise exact
    jitter : float, default 0.0
        random displacement, in spacings of the points; from 0 to 0.5
    random : bool, default False
        points anywhere in the shape instead of on a lattice
    seed : int, default 1
        seed of jitter and random; at least 0
    rotation : float, degree, default 0.0
        turn of the filled points, counter-clockwise
    rotation_center : collections.abc.Sequence[float], m, default ()
        point that stays; empty: the origin
    rotation_axis : collections.abc.Sequence[float], default (0.0, 0.0, 1.0)
        direction that stays, in three dimensions
    translation : collections.abc.Sequence[float], m, default ()
        displacement after the turn
    material : list[Thermal | Newtonian | ThermalExpansion | PlasticHeating | Elastic | MohrCoulomb | DruckerPrager | VonMises | TabulatedMohrCoulomb | ModifiedCamClay | FunctionSolid], required
        what it is made of: one material, or one for each physics
    temperature : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], K, default 0.0
        temperature at the start
    source : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], W/m^3, default 0.0
        heat released in its volume
    velocity : collections.abc.Sequence[float], m/s, default ()
        velocity at the start
    spin : collections.abc.Sequence[float], rad/s, default ()
        angular velocity at the start, counter-clockwise: a number, or x, y, z in space
    spin_center : collections.abc.Sequence[float], m, default ()
        place about which it spins; empty: the centre of its volume
    geostatic : Geostatic | None, default None
        stress at the start, of a body at rest; absent: none
    motion : Rotation | Translation | Swirl | None, default None
        prescribed motion
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str = ..., shape: Shape | None = ..., points_file: str = ..., points: Points | None = ..., points_per_cell: int | None | str = ..., fill: typing.Literal['exact', 'lattice'] | None | str = ..., jitter: float = ..., random: bool = ..., seed: int = ..., rotation: float = ..., rotation_center: collections.abc.Sequence[float] = ..., rotation_axis: collections.abc.Sequence[float] = ..., translation: collections.abc.Sequence[float] = ..., material: list[Thermal | Newtonian | ThermalExpansion | PlasticHeating | Elastic | MohrCoulomb | DruckerPrager | VonMises | TabulatedMohrCoulomb | ModifiedCamClay | FunctionSolid], temperature: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ..., source: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ..., velocity: collections.abc.Sequence[float] = ..., spin: collections.abc.Sequence[float] = ..., spin_center: collections.abc.Sequence[float] = ..., geostatic: Geostatic | None = ..., motion: Rotation | Translation | Swirl | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def fill(self) -> typing.Literal['exact', 'lattice'] | None | str:
        """
        points with the volume of their part of the shape, or whole boxes of a lattice; automatic: lattice in peridynamic flow and under conditions on the surface of gimp points that may move, otherwise exact
        """
    @fill.setter
    def fill(self, value: typing.Literal['exact', 'lattice'] | None | str) -> None:
        ...
    @property
    def geostatic(self) -> Geostatic | None:
        """
        stress at the start, of a body at rest; absent: none
        """
    @geostatic.setter
    def geostatic(self, value: Geostatic | None) -> None:
        ...
    @property
    def jitter(self) -> float:
        """
        random displacement, in spacings of the points
        """
    @jitter.setter
    def jitter(self, value: float) -> None:
        ...
    @property
    def material(self) -> list[Thermal | Newtonian | ThermalExpansion | PlasticHeating | Elastic | MohrCoulomb | DruckerPrager | VonMises | TabulatedMohrCoulomb | ModifiedCamClay | FunctionSolid]:
        """
        what it is made of: one material, or one for each physics
        """
    @material.setter
    def material(self, value: list[Thermal | Newtonian | ThermalExpansion | PlasticHeating | Elastic | MohrCoulomb | DruckerPrager | VonMises | TabulatedMohrCoulomb | ModifiedCamClay | FunctionSolid]) -> None:
        ...
    @property
    def motion(self) -> Rotation | Translation | Swirl | None:
        """
        prescribed motion
        """
    @motion.setter
    def motion(self, value: Rotation | Translation | Swirl | None) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name in messages and results
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def points(self) -> Points | None:
        """
        arrays of points, from a program only
        """
    @points.setter
    def points(self, value: Points | None) -> None:
        ...
    @property
    def points_file(self) -> str:
        """
        text file of points: coordinates and volume in each row
        """
    @points_file.setter
    def points_file(self, value: str) -> None:
        ...
    @property
    def points_per_cell(self) -> int | None | str:
        """
        points in a full cell, the same number along each axis
        """
    @points_per_cell.setter
    def points_per_cell(self, value: int | None | str) -> None:
        ...
    @property
    def random(self) -> bool:
        """
        points anywhere in the shape instead of on a lattice
        """
    @random.setter
    def random(self, value: bool) -> None:
        ...
    @property
    def rotation(self) -> float:
        """
        turn of the filled points, counter-clockwise, degree
        """
    @rotation.setter
    def rotation(self, value: float) -> None:
        ...
    @property
    def rotation_axis(self) -> collections.abc.Sequence[float]:
        """
        direction that stays, in three dimensions
        """
    @rotation_axis.setter
    def rotation_axis(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def rotation_center(self) -> collections.abc.Sequence[float]:
        """
        point that stays; empty: the origin, m
        """
    @rotation_center.setter
    def rotation_center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def seed(self) -> int:
        """
        seed of jitter and random
        """
    @seed.setter
    def seed(self, value: int) -> None:
        ...
    @property
    def shape(self) -> Shape | None:
        """
        shape filled with points
        """
    @shape.setter
    def shape(self, value: Shape | None) -> None:
        ...
    @property
    def source(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        heat released in its volume, W/m^3
        """
    @source.setter
    def source(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def spin(self) -> collections.abc.Sequence[float]:
        """
        angular velocity at the start, counter-clockwise: a number, or x, y, z in space, rad/s
        """
    @spin.setter
    def spin(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def spin_center(self) -> collections.abc.Sequence[float]:
        """
        place about which it spins; empty: the centre of its volume, m
        """
    @spin_center.setter
    def spin_center(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def temperature(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        temperature at the start, K
        """
    @temperature.setter
    def temperature(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def translation(self) -> collections.abc.Sequence[float]:
        """
        displacement after the turn, m
        """
    @translation.setter
    def translation(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def velocity(self) -> collections.abc.Sequence[float]:
        """
        velocity at the start, m/s
        """
    @velocity.setter
    def velocity(self, value: collections.abc.Sequence[float]) -> None:
        ...
class FluidWall:
    """
    A wall of a peridynamic fluid: its shape, and what it does to flow and heat.
    
    Parameters
    ----------
    shape : Shape, required
        where the wall is, at least a horizon thick
    name : str, default 'wall'
        how output calls the wall
    slip : typing.Literal['no-slip', 'free-slip'], default 'no-slip'
        whether the fluid sticks to the wall
    velocity : collections.abc.Sequence[float], m/s, default ()
        velocity of the wall's surface
    moves : bool, default False
        whether the wall's points travel with that velocity
    heat : typing.Literal['adiabatic', 'temperature', 'flux', 'convection'], default 'adiabatic'
        thermal condition on the wall
    temperature : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], K, default 0.0
        of the surface, or of the surroundings (convection)
    flux : float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any], W/m^2, default 0.0
        heat flux into the fluid
    coefficient : float, W/(m^2 K), default 0.0
        of convection; at least 0 (W/(m^2 K))
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, shape: Shape, name: str = ..., slip: typing.Literal['no-slip', 'free-slip'] = ..., velocity: collections.abc.Sequence[float] = ..., moves: bool = ..., heat: typing.Literal['adiabatic', 'temperature', 'flux', 'convection'] = ..., temperature: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ..., flux: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any] = ..., coefficient: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def coefficient(self) -> float:
        """
        of convection, W/(m^2 K)
        """
    @coefficient.setter
    def coefficient(self, value: float) -> None:
        ...
    @property
    def flux(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        heat flux into the fluid, W/m^2
        """
    @flux.setter
    def flux(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def heat(self) -> typing.Literal['adiabatic', 'temperature', 'flux', 'convection']:
        """
        thermal condition on the wall
        """
    @heat.setter
    def heat(self, value: typing.Literal['adiabatic', 'temperature', 'flux', 'convection']) -> None:
        ...
    @property
    def moves(self) -> bool:
        """
        whether the wall's points travel with that velocity
        """
    @moves.setter
    def moves(self, value: bool) -> None:
        ...
    @property
    def name(self) -> str:
        """
        how output calls the wall
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def shape(self) -> Shape:
        """
        where the wall is, at least a horizon thick
        """
    @shape.setter
    def shape(self, value: Shape) -> None:
        ...
    @property
    def slip(self) -> typing.Literal['no-slip', 'free-slip']:
        """
        whether the fluid sticks to the wall
        """
    @slip.setter
    def slip(self, value: typing.Literal['no-slip', 'free-slip']) -> None:
        ...
    @property
    def temperature(self) -> float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]:
        """
        of the surface, or of the surroundings (convection), K
        """
    @temperature.setter
    def temperature(self, value: float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]] | collections.abc.Callable[..., typing.Any]) -> None:
        ...
    @property
    def velocity(self) -> collections.abc.Sequence[float]:
        """
        velocity of the wall's surface, m/s
        """
    @velocity.setter
    def velocity(self, value: collections.abc.Sequence[float]) -> None:
        ...
class PeridynamicHeat:
    """
    Heat conduction on the thermal horizon.
    
    Parameters
    ----------
    horizon : float, default 0.0
        thermal horizon, in spacings, above 1; 0: 1.2 for points at rest on a lattice that their surface follows, 2.015 for points that flow, otherwise 1.515; from 0 to 10
    influence : typing.Literal['gaussian', 'unity', 'spline'], default 'gaussian'
        weight of a bond by its length
    laplacian : typing.Literal['literal', 'zero-energy', 'compact', 'corrected'], default 'corrected'
        how conduction is formed from bonds
    zero_energy : float, default 0.5
        coefficient of the zero-energy term; at least 0
    viscous_dissipation : bool, default False
        whether viscous work becomes heat
    skin : float, default 0.3
        reach of the neighbour list beyond the horizon, in spacings; above 0 and at most 2
    step_factor : float, default 0.25
        of spacing^2 / (dimension diffusivity); above 0 and at most 1
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, horizon: float = ..., influence: typing.Literal['gaussian', 'unity', 'spline'] = ..., laplacian: typing.Literal['literal', 'zero-energy', 'compact', 'corrected'] = ..., zero_energy: float = ..., viscous_dissipation: bool = ..., skin: float = ..., step_factor: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def horizon(self) -> float:
        """
        thermal horizon, in spacings, above 1; 0: 1.2 for points at rest on a lattice that their surface follows, 2.015 for points that flow, otherwise 1.515
        """
    @horizon.setter
    def horizon(self, value: float) -> None:
        ...
    @property
    def influence(self) -> typing.Literal['gaussian', 'unity', 'spline']:
        """
        weight of a bond by its length
        """
    @influence.setter
    def influence(self, value: typing.Literal['gaussian', 'unity', 'spline']) -> None:
        ...
    @property
    def laplacian(self) -> typing.Literal['literal', 'zero-energy', 'compact', 'corrected']:
        """
        how conduction is formed from bonds
        """
    @laplacian.setter
    def laplacian(self, value: typing.Literal['literal', 'zero-energy', 'compact', 'corrected']) -> None:
        ...
    @property
    def skin(self) -> float:
        """
        reach of the neighbour list beyond the horizon, in spacings
        """
    @skin.setter
    def skin(self, value: float) -> None:
        ...
    @property
    def step_factor(self) -> float:
        """
        of spacing^2 / (dimension diffusivity)
        """
    @step_factor.setter
    def step_factor(self, value: float) -> None:
        ...
    @property
    def viscous_dissipation(self) -> bool:
        """
        whether viscous work becomes heat
        """
    @viscous_dissipation.setter
    def viscous_dissipation(self, value: bool) -> None:
        ...
    @property
    def zero_energy(self) -> float:
        """
        coefficient of the zero-energy term
        """
    @zero_energy.setter
    def zero_energy(self, value: float) -> None:
        ...
class PeridynamicFlow:
    """
    Weakly compressible viscous flow on the fluid horizon.
    
    Parameters
    ----------
    gravity : collections.abc.Sequence[float], m/s^2, default ()
        empty: none
    buoyancy : typing.Literal['reduced', 'full'], default 'reduced'
        reduced: only what temperature changes; full: the pressure bears all of the weight
    horizon : float, default 3.015
        fluid horizon, in spacings; above 1 and at most 10
    influence : typing.Literal['gaussian', 'unity', 'spline'], default 'gaussian'
        weight of a bond by its length
    laplacian : typing.Literal['literal', 'zero-energy', 'compact', 'corrected'], default 'corrected'
        how the viscous force is formed from bonds
    zero_energy : float, default 1.0
        coefficient of the zero-energy term; at least 0
    sound_speed : float, m/s, default 0.0
        0: max(factor sqrt(g beta dT l), 10 wall speed, 10 nu / l); at least 0 (m/s)
    sound_speed_factor : float, default 5.0
        of sqrt(g beta dT l); above 0
    length : float, m, default 0.0
        l of the sound speed; 0: height of the fluid; at least 0 (m)
    temperature_range : float, K, default 0.0
        dT of the sound speed; 0: what walls, their surroundings and the start span; at least 0 (K)
    stiffness_exponent : float, default 7.0
        of the equation of state; above 0
    density_diffusion : float, default 0.1
        smooths the pressure; at least 0
    shifting : float, default 0.1
        keeps points evenly spread; at least 0
    courant : float, default 0.5
        of spacing / sound speed; above 0 and at most 1
    viscous_step : float, default 0.25
        of spacing^2 / (dimension nu); above 0 and at most 1
    skin : float, default 0.3
        reach of the neighbour list beyond the horizon, in spacings; above 0 and at most 2
    largest_density_variation : float, default 0.1
        a run beyond it stops; above 0 and at most 1
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, gravity: collections.abc.Sequence[float] = ..., buoyancy: typing.Literal['reduced', 'full'] = ..., horizon: float = ..., influence: typing.Literal['gaussian', 'unity', 'spline'] = ..., laplacian: typing.Literal['literal', 'zero-energy', 'compact', 'corrected'] = ..., zero_energy: float = ..., sound_speed: float = ..., sound_speed_factor: float = ..., length: float = ..., temperature_range: float = ..., stiffness_exponent: float = ..., density_diffusion: float = ..., shifting: float = ..., courant: float = ..., viscous_step: float = ..., skin: float = ..., largest_density_variation: float = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def buoyancy(self) -> typing.Literal['reduced', 'full']:
        """
        reduced: only what temperature changes; full: the pressure bears all of the weight
        """
    @buoyancy.setter
    def buoyancy(self, value: typing.Literal['reduced', 'full']) -> None:
        ...
    @property
    def courant(self) -> float:
        """
        of spacing / sound speed
        """
    @courant.setter
    def courant(self, value: float) -> None:
        ...
    @property
    def density_diffusion(self) -> float:
        """
        smooths the pressure
        """
    @density_diffusion.setter
    def density_diffusion(self, value: float) -> None:
        ...
    @property
    def gravity(self) -> collections.abc.Sequence[float]:
        """
        empty: none, m/s^2
        """
    @gravity.setter
    def gravity(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def horizon(self) -> float:
        """
        fluid horizon, in spacings
        """
    @horizon.setter
    def horizon(self, value: float) -> None:
        ...
    @property
    def influence(self) -> typing.Literal['gaussian', 'unity', 'spline']:
        """
        weight of a bond by its length
        """
    @influence.setter
    def influence(self, value: typing.Literal['gaussian', 'unity', 'spline']) -> None:
        ...
    @property
    def laplacian(self) -> typing.Literal['literal', 'zero-energy', 'compact', 'corrected']:
        """
        how the viscous force is formed from bonds
        """
    @laplacian.setter
    def laplacian(self, value: typing.Literal['literal', 'zero-energy', 'compact', 'corrected']) -> None:
        ...
    @property
    def largest_density_variation(self) -> float:
        """
        a run beyond it stops
        """
    @largest_density_variation.setter
    def largest_density_variation(self, value: float) -> None:
        ...
    @property
    def length(self) -> float:
        """
        l of the sound speed; 0: height of the fluid, m
        """
    @length.setter
    def length(self, value: float) -> None:
        ...
    @property
    def shifting(self) -> float:
        """
        keeps points evenly spread
        """
    @shifting.setter
    def shifting(self, value: float) -> None:
        ...
    @property
    def skin(self) -> float:
        """
        reach of the neighbour list beyond the horizon, in spacings
        """
    @skin.setter
    def skin(self, value: float) -> None:
        ...
    @property
    def sound_speed(self) -> float:
        """
        0: max(factor sqrt(g beta dT l), 10 wall speed, 10 nu / l), m/s
        """
    @sound_speed.setter
    def sound_speed(self, value: float) -> None:
        ...
    @property
    def sound_speed_factor(self) -> float:
        """
        of sqrt(g beta dT l)
        """
    @sound_speed_factor.setter
    def sound_speed_factor(self, value: float) -> None:
        ...
    @property
    def stiffness_exponent(self) -> float:
        """
        of the equation of state
        """
    @stiffness_exponent.setter
    def stiffness_exponent(self, value: float) -> None:
        ...
    @property
    def temperature_range(self) -> float:
        """
        dT of the sound speed; 0: what walls, their surroundings and the start span, K
        """
    @temperature_range.setter
    def temperature_range(self, value: float) -> None:
        ...
    @property
    def viscous_step(self) -> float:
        """
        of spacing^2 / (dimension nu)
        """
    @viscous_step.setter
    def viscous_step(self, value: float) -> None:
        ...
    @property
    def zero_energy(self) -> float:
        """
        coefficient of the zero-energy term
        """
    @zero_energy.setter
    def zero_energy(self, value: float) -> None:
        ...
class Peridynamics:
    """
    Bodies as points that act on each other at a distance instead of through a grid.
    
    Parameters
    ----------
    heat : PeridynamicHeat | None, default None
        heat on the thermal horizon; absent: not modelled
    flow : PeridynamicFlow | None, default None
        viscous flow on the fluid horizon; absent: nothing moves
    walls : list[FluidWall], default []
        walls
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, heat: PeridynamicHeat | None = ..., flow: PeridynamicFlow | None = ..., walls: list[FluidWall] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def flow(self) -> PeridynamicFlow | None:
        """
        viscous flow on the fluid horizon; absent: nothing moves
        """
    @flow.setter
    def flow(self, value: PeridynamicFlow | None) -> None:
        ...
    @property
    def heat(self) -> PeridynamicHeat | None:
        """
        heat on the thermal horizon; absent: not modelled
        """
    @heat.setter
    def heat(self, value: PeridynamicHeat | None) -> None:
        ...
    @property
    def walls(self) -> list[FluidWall]:
        """
        walls
        """
    @walls.setter
    def walls(self, value: list[FluidWall]) -> None:
        ...
class Grid:
    """
    The background grid; its corners give the dimension of the scene.
    
    Parameters
    ----------
    lower : collections.abc.Sequence[float], m, required
        corner with the least coordinates
    upper : collections.abc.Sequence[float], m, required
        corner with the largest coordinates, a whole number of cells away
    cell : float, m, required
        size of a cell; above 0 (m)
    shape_function : typing.Literal['linear', 'gimp', 'bspline'], default 'gimp'
        shape function of the nodes
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, lower: collections.abc.Sequence[float], upper: collections.abc.Sequence[float], cell: float, shape_function: typing.Literal['linear', 'gimp', 'bspline'] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def cell(self) -> float:
        """
        size of a cell, m
        """
    @cell.setter
    def cell(self, value: float) -> None:
        ...
    @property
    def lower(self) -> collections.abc.Sequence[float]:
        """
        corner with the least coordinates, m
        """
    @lower.setter
    def lower(self, value: collections.abc.Sequence[float]) -> None:
        ...
    @property
    def shape_function(self) -> typing.Literal['linear', 'gimp', 'bspline']:
        """
        shape function of the nodes
        """
    @shape_function.setter
    def shape_function(self, value: typing.Literal['linear', 'gimp', 'bspline']) -> None:
        ...
    @property
    def upper(self) -> collections.abc.Sequence[float]:
        """
        corner with the largest coordinates, a whole number of cells away, m
        """
    @upper.setter
    def upper(self, value: collections.abc.Sequence[float]) -> None:
        ...
class Time:
    """
    When the run ends and how its steps are chosen.
    
    Parameters
    ----------
    end : float, s, required
        time at which the run ends; above 0 (s)
    step : float | None, s, default 'auto'
        size of a step; above 0 (s)
    steps : int | None, default None
        number of equal steps to the end, instead of a size; from 1 to 1e+12
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, end: float, step: float | None | str = ..., steps: int | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def end(self) -> float:
        """
        time at which the run ends, s
        """
    @end.setter
    def end(self, value: float) -> None:
        ...
    @property
    def step(self) -> float | None | str:
        """
        size of a step, s
        """
    @step.setter
    def step(self, value: float | None | str) -> None:
        ...
    @property
    def steps(self) -> int | None:
        """
        number of equal steps to the end, instead of a size
        """
    @steps.setter
    def steps(self, value: int | None) -> None:
        ...
class Probe:
    """
    A field recorded in time at one position, or at one material point.
    
    Parameters
    ----------
    name : str, required
        name of its column in the history
    position : collections.abc.Sequence[float], m, required
        where it is, inside a body
    material_point : bool, default False
        follow the material point nearest to the position at the start, instead of staying there
    field : str, default 'temperature'
        field of the output, or position
    every : float | None, s, default None
        least time between records; with the rest of the history when not given; above 0 (s)
    every_steps : int | None, default None
        steps between records, instead of a time; from 1 to 1e+12
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str, position: collections.abc.Sequence[float], material_point: bool = ..., field: str = ..., every: float | None = ..., every_steps: int | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def every(self) -> float | None:
        """
        least time between records; with the rest of the history when not given, s
        """
    @every.setter
    def every(self, value: float | None) -> None:
        ...
    @property
    def every_steps(self) -> int | None:
        """
        steps between records, instead of a time
        """
    @every_steps.setter
    def every_steps(self, value: int | None) -> None:
        ...
    @property
    def field(self) -> str:
        """
        field of the output, or position
        """
    @field.setter
    def field(self, value: str) -> None:
        ...
    @property
    def material_point(self) -> bool:
        """
        follow the material point nearest to the position at the start, instead of staying there
        """
    @material_point.setter
    def material_point(self, value: bool) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name of its column in the history
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def position(self) -> collections.abc.Sequence[float]:
        """
        where it is, inside a body, m
        """
    @position.setter
    def position(self, value: collections.abc.Sequence[float]) -> None:
        ...
class Output:
    """
    What a run leaves on disk.
    
    Parameters
    ----------
    path : str, default ''
        file of frames for ParaView, ending in .vtkhdf
    every : float | None, s, default None
        time between frames; the first and the last only when not given; above 0 (s)
    every_steps : int | None, default None
        steps between frames, instead of a time; from 1 to 1e+12
    fields : collections.abc.Sequence[str] | None, default None
        names of the fields that frames hold beside position, id, body and volume; every field when not given
    precision : typing.Literal['double', 'single'], default 'double'
        of the fields of frames: eight bytes a number, or four with 7 digits; positions and checkpoints always have eight
    compression : int, default 0
        of frames, without loss: 0 none, 1 fast, 9 small; from 0 to 9
    history_every : float | None, s, default None
        least time between rows of the history; one with every frame when not given; above 0 (s)
    checkpoint : bool, default True
        keep a state to resume from beside the frames
    checkpoint_every : float | None, s, default None
        wall time between checkpoints; one with every frame when not given; above 0 (s)
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, path: str = ..., every: float | None = ..., every_steps: int | None = ..., fields: collections.abc.Sequence[str] | None = ..., precision: typing.Literal['double', 'single'] = ..., compression: int = ..., history_every: float | None = ..., checkpoint: bool = ..., checkpoint_every: float | None = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def checkpoint(self) -> bool:
        """
        keep a state to resume from beside the frames
        """
    @checkpoint.setter
    def checkpoint(self, value: bool) -> None:
        ...
    @property
    def checkpoint_every(self) -> float | None:
        """
        wall time between checkpoints; one with every frame when not given, s
        """
    @checkpoint_every.setter
    def checkpoint_every(self, value: float | None) -> None:
        ...
    @property
    def compression(self) -> int:
        """
        of frames, without loss: 0 none, 1 fast, 9 small
        """
    @compression.setter
    def compression(self, value: int) -> None:
        ...
    @property
    def every(self) -> float | None:
        """
        time between frames; the first and the last only when not given, s
        """
    @every.setter
    def every(self, value: float | None) -> None:
        ...
    @property
    def every_steps(self) -> int | None:
        """
        steps between frames, instead of a time
        """
    @every_steps.setter
    def every_steps(self, value: int | None) -> None:
        ...
    @property
    def fields(self) -> collections.abc.Sequence[str] | None:
        """
        names of the fields that frames hold beside position, id, body and volume; every field when not given
        """
    @fields.setter
    def fields(self, value: collections.abc.Sequence[str] | None) -> None:
        ...
    @property
    def history_every(self) -> float | None:
        """
        least time between rows of the history; one with every frame when not given, s
        """
    @history_every.setter
    def history_every(self, value: float | None) -> None:
        ...
    @property
    def path(self) -> str:
        """
        file of frames for ParaView, ending in .vtkhdf
        """
    @path.setter
    def path(self, value: str) -> None:
        ...
    @property
    def precision(self) -> typing.Literal['double', 'single']:
        """
        of the fields of frames: eight bytes a number, or four with 7 digits; positions and checkpoints always have eight
        """
    @precision.setter
    def precision(self, value: typing.Literal['double', 'single']) -> None:
        ...
class Stage:
    """
    What follows in the same run: what changes in the scene, and when it ends.
    
    Parameters
    ----------
    name : str, required
        name in messages, balances and results
    end : float, s, required
        time at which it ends; the clock goes on from stage to stage; above 0 (s)
    remove : collections.abc.Sequence[str], default ()
        names of bodies, obstacles and loads that are taken away
    set : dict[str, typing.Any], default {}
        keys of the scene, by their paths, and the values they take
    add_bodies : list[Body], default []
        bodies that are new, at rest or as they say
    add_obstacles : list[Obstacle], default []
        obstacles that are new
    add_boundaries : list[Pressure | Traction], default []
        loads that are new, after those there are
    reset_velocity : bool, default False
        take the velocity of all bodies away at its begin
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, name: str, end: float, remove: collections.abc.Sequence[str] = ..., set: dict[str, typing.Any] = ..., add_bodies: list[Body] = ..., add_obstacles: list[Obstacle] = ..., add_boundaries: list[Pressure | Traction] = ..., reset_velocity: bool = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    @property
    def add_bodies(self) -> list[Body]:
        """
        bodies that are new, at rest or as they say
        """
    @add_bodies.setter
    def add_bodies(self, value: list[Body]) -> None:
        ...
    @property
    def add_boundaries(self) -> list[Pressure | Traction]:
        """
        loads that are new, after those there are
        """
    @add_boundaries.setter
    def add_boundaries(self, value: list[Pressure | Traction]) -> None:
        ...
    @property
    def add_obstacles(self) -> list[Obstacle]:
        """
        obstacles that are new
        """
    @add_obstacles.setter
    def add_obstacles(self, value: list[Obstacle]) -> None:
        ...
    @property
    def end(self) -> float:
        """
        time at which it ends; the clock goes on from stage to stage, s
        """
    @end.setter
    def end(self, value: float) -> None:
        ...
    @property
    def name(self) -> str:
        """
        name in messages, balances and results
        """
    @name.setter
    def name(self, value: str) -> None:
        ...
    @property
    def remove(self) -> collections.abc.Sequence[str]:
        """
        names of bodies, obstacles and loads that are taken away
        """
    @remove.setter
    def remove(self, value: collections.abc.Sequence[str]) -> None:
        ...
    @property
    def reset_velocity(self) -> bool:
        """
        take the velocity of all bodies away at its begin
        """
    @reset_velocity.setter
    def reset_velocity(self, value: bool) -> None:
        ...
    @property
    def set(self) -> dict[str, typing.Any]:
        """
        keys of the scene, by their paths, and the values they take
        """
    @set.setter
    def set(self, value: dict[str, typing.Any]) -> None:
        ...
class Scene:
    """
    All that a run computes, as plain data. A section that is absent is physics that is not modelled.
    
    Parameters
    ----------
    title : str, default ''
        what the scene shows
    grid : Grid, required
        background grid
    initial_state : str, default ''
        checkpoint of another run with [dynamics]: bodies of the same name go on from there, with the loads and materials of this scene
    bodies : list[Body], required
        bodies
    heat : Heat | None, default None
        heat conduction; absent: not modelled
    dynamics : Dynamics | None, default None
        explicit dynamics; absent: not modelled
    quasi_static : QuasiStatic | None, default None
        equilibrium under load steps; absent: not modelled
    peridynamics : Peridynamics | None, default None
        bodies as peridynamic points, with heat and flow; absent: none
    time : Time, required
        end and steps
    output : Output, default Output()
        frames and checkpoints
    probes : list[Probe], default []
        fields recorded in time at single positions
    stages : list[Stage], default []
        what follows in the same run after time.end: other loads, properties, bodies
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    __signature__: typing.ClassVar[inspect.Signature]
    @staticmethod
    def load(path: str | os.PathLike[str]) -> Scene:
        """
        The scene of a TOML file.
        """
    @staticmethod
    def parse(text: str, name: str = 'scene') -> Scene:
        """
        The scene of a TOML text; messages call it by `name`.
        """
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> dict[str, typing.Any]:
        ...
    def __init__(self, *, title: str = ..., grid: Grid, initial_state: str = ..., bodies: list[Body], heat: Heat | None = ..., dynamics: Dynamics | None = ..., quasi_static: QuasiStatic | None = ..., peridynamics: Peridynamics | None = ..., time: Time, output: Output = ..., probes: list[Probe] = ..., stages: list[Stage] = ...) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    def __setattr__(self, name: str, value: typing.Any) -> None:
        ...
    def __setstate__(self, members: dict[str, typing.Any]) -> None:
        ...
    def save(self, path: str | os.PathLike[str]) -> None:
        """
        Write the scene as TOML. Functions and arrays, which no file holds, are a ValueError; what cannot be written is an OutputError.
        """
    def set(self, path: str, value: typing.Any = ...) -> Scene:
        """
        A copy with one member changed by its path: scene.set('grid.cell', 0.05), or as on the command line, scene.set('grid.cell=0.05').
        """
    def to_json(self) -> str:
        """
        Every setting with defaults filled in; functions and arrays are named only.
        """
    def to_toml(self, everything: bool = False) -> str:
        """
        The scene as TOML; with defaults filled in if `everything`.
        """
    @property
    def bodies(self) -> list[Body]:
        """
        bodies
        """
    @bodies.setter
    def bodies(self, value: list[Body]) -> None:
        ...
    @property
    def dynamics(self) -> Dynamics | None:
        """
        explicit dynamics; absent: not modelled
        """
    @dynamics.setter
    def dynamics(self, value: Dynamics | None) -> None:
        ...
    @property
    def grid(self) -> Grid:
        """
        background grid
        """
    @grid.setter
    def grid(self, value: Grid) -> None:
        ...
    @property
    def heat(self) -> Heat | None:
        """
        heat conduction; absent: not modelled
        """
    @heat.setter
    def heat(self, value: Heat | None) -> None:
        ...
    @property
    def initial_state(self) -> str:
        """
        checkpoint of another run with [dynamics]: bodies of the same name go on from there, with the loads and materials of this scene
        """
    @initial_state.setter
    def initial_state(self, value: str) -> None:
        ...
    @property
    def output(self) -> Output:
        """
        frames and checkpoints
        """
    @output.setter
    def output(self, value: Output) -> None:
        ...
    @property
    def peridynamics(self) -> Peridynamics | None:
        """
        bodies as peridynamic points, with heat and flow; absent: none
        """
    @peridynamics.setter
    def peridynamics(self, value: Peridynamics | None) -> None:
        ...
    @property
    def probes(self) -> list[Probe]:
        """
        fields recorded in time at single positions
        """
    @probes.setter
    def probes(self, value: list[Probe]) -> None:
        ...
    @property
    def quasi_static(self) -> QuasiStatic | None:
        """
        equilibrium under load steps; absent: not modelled
        """
    @quasi_static.setter
    def quasi_static(self, value: QuasiStatic | None) -> None:
        ...
    @property
    def stages(self) -> list[Stage]:
        """
        what follows in the same run after time.end: other loads, properties, bodies
        """
    @stages.setter
    def stages(self, value: list[Stage]) -> None:
        ...
    @property
    def time(self) -> Time:
        """
        end and steps
        """
    @time.setter
    def time(self, value: Time) -> None:
        ...
    @property
    def title(self) -> str:
        """
        what the scene shows
        """
    @title.setter
    def title(self, value: str) -> None:
        ...
class StepReport:
    """
    What one step did.
    """
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def accepted(self) -> float:
        """
        size of the step taken, s
        """
    @property
    def iterations(self) -> int:
        """
        iterations of implicit solves
        """
    @property
    def residual(self) -> float:
        """
        relative residual of implicit solves
        """
class Balance:
    """
    The account of one conserved quantity: what was there, what was supplied, what is there now.
    """
    __hash__: typing.ClassVar[None]  # type: ignore[assignment]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def entries(self) -> dict[str, float]:
        """
        what came in by each way since the start; negative: went out
        """
    @property
    def initial(self) -> float:
        """
        stored at the start
        """
    @property
    def quantity(self) -> str:
        """
        what is conserved
        """
    @property
    def residual(self) -> float:
        """
        (stored - initial - taken in) over the largest turnover or span of the store so far
        """
    @property
    def stored(self) -> float:
        """
        stored now
        """
    @property
    def supplied(self) -> float:
        """
        sum of the entries, counted inwards
        """
    @property
    def turnover(self) -> float:
        """
        sum of the entries' sizes
        """
    @property
    def unit(self) -> str:
        """
        unit of every amount
        """
class Simulation:
    """
    A clock, the points and an ordered list of physics, built from a scene. Stepping releases the GIL.
    """
    def __copy__(self) -> typing.Any:
        ...
    def __getitem__(self, name: str) -> numpy.typing.NDArray[typing.Any]:
        """
        A field, or a component of one (stress.xy), as a read-only view without copy, brought up to date, one row per point in the present order. It keeps the simulation alive; later steps change it. In a scene with stages it is a copy.
        """
    def __init__(self, scene: Scene) -> None:
        ...
    def __len__(self) -> int:
        """
        The number of points.
        """
    def __reduce__(self) -> typing.Any:
        ...
    def balance(self) -> list[Balance]:
        """
        The account of every conserved quantity.
        """
    def by_id(self, name: str) -> numpy.typing.NDArray[typing.Any]:
        """
        A copy of a field with its rows in the order of the points' ids.
        """
    def diagnostics(self) -> dict[str, float]:
        """
        Numbers worth watching, by physics.
        """
    def limits(self) -> dict[str, tuple[float, float, str]]:
        """
        Of each physics the automatic step, the largest one allowed and why, s.
        """
    def run_until(self, time: float, callback: collections.abc.Callable[[Simulation], typing.Any] | None = None) -> None:
        """
        Step until `time`, exactly. After each step `callback(simulation)` may return False to stop early.
        """
    def step(self) -> StepReport:
        """
        Take one step.
        """
    def surface(self) -> dict[str, numpy.typing.NDArray[numpy.float64]]:
        """
        The nodes that boundary conditions act on: position on the surface, outward normal, area. Empty without them.
        """
    def unit(self, name: str) -> str:
        """
        The unit of a field.
        """
    def volumes(self) -> dict[str, tuple[float, float | None]]:
        """
        Of each body the volume of its points now and that of its shape, None where it has none; area, length in fewer dimensions.
        """
    def warnings(self) -> list[lapilli.note.Note]:
        """
        What each physics says of its present state that is not wrong but not right either.
        """
    @property
    def dimension(self) -> int:
        """
        1, 2 or 3
        """
    @property
    def end(self) -> float:
        """
        time at which the scene ends, s
        """
    @property
    def fields(self) -> list[str]:
        """
        names that can be asked for
        """
    @property
    def position(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        positions (points, dimension), a view, m
        """
    @property
    def stage(self) -> str:
        """
        name of the present stage; empty before the first of them
        """
    @property
    def step_index(self) -> int:
        """
        steps taken
        """
    @property
    def step_size(self) -> float:
        """
        size of the next step, s
        """
    @property
    def time(self) -> float:
        """
        the clock, s
        """
class OutputError(OSError):
    """
    A file could not be written or read; the message names the file and the reason.
    """
class Progress:
    """
    How far a run has come.
    """
    def __reduce__(self) -> typing.Any:
        ...
    @property
    def fraction(self) -> float:
        """
        of the time to simulate, 0 to 1
        """
    @property
    def points(self) -> int:
        """
        number of points
        """
    @property
    def seconds_elapsed(self) -> float:
        """
        of wall time
        """
    @property
    def seconds_left(self) -> float:
        """
        of wall time, estimated; NaN while unknown
        """
    @property
    def step(self) -> int:
        """
        steps since the start
        """
    @property
    def step_size(self) -> float:
        """
        of the last step, s
        """
    @property
    def steps_taken(self) -> int:
        """
        since the start or the resume
        """
    @property
    def time(self) -> float:
        """
        simulated, s
        """
class RunSummary:
    """
    What a run did.
    """
    def __reduce__(self) -> typing.Any:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def cpu_seconds(self) -> float:
        """
        of processor time, all threads together
        """
    @property
    def finished(self) -> bool:
        """
        whether it came to its end
        """
    @property
    def frames(self) -> int:
        """
        frames on disk
        """
    @property
    def history(self) -> dict[str, numpy.typing.NDArray[numpy.float64]]:
        """
        what was recorded in time: the times, s, and every scalar by its name
        """
    @property
    def history_columns(self) -> dict[str, tuple[str, str]]:
        """
        unit and meaning of every scalar of the history
        """
    @property
    def iterations(self) -> int:
        """
        of implicit solves
        """
    @property
    def largest_step(self) -> float:
        """
        s
        """
    @property
    def notes(self) -> list[lapilli.note.Note]:
        """
        what the user should know
        """
    @property
    def smallest_step(self) -> float:
        """
        s
        """
    @property
    def steps(self) -> int:
        """
        steps taken since the start or the resume
        """
    @property
    def time(self) -> float:
        """
        simulated, s
        """
    @property
    def wall_seconds(self) -> float:
        """
        of wall time
        """
class FrameReader:
    """
    Reads the frames of a run and gives no number that does not fit its checksum.
    """
    def __init__(self, path: str) -> None:
        ...
    def __reduce__(self) -> typing.Any:
        ...
    def read(self, frame: int, name: str) -> numpy.typing.NDArray[typing.Any]:
        """
        One field of one frame, one row per point in the order of ids.
        """
    @property
    def fields(self) -> list[str]:
        """
        names that can be read beside position
        """
    @property
    def point_counts(self) -> list[int]:
        """
        points in every frame
        """
    @property
    def times(self) -> list[float]:
        """
        of every frame, s
        """
def check_json(scene: Scene) -> str:
    """
    What a scene models and costs, as JSON.
    """
def check_text(scene: Scene) -> str:
    """
    What a scene models and costs, as lines of text.
    """
def cpu_seconds() -> float:
    """
    Processor time used by this process.
    """
def keys_as_markdown(section: str = '') -> str:
    """
    The keys of a scene file, or of one section, as Markdown tables.
    """
def merge(from_path: str | os.PathLike[str], to_path: str | os.PathLike[str]) -> None:
    """
    Gather a series of frames into one self-contained file.
    """
def note_kinds() -> list[tuple[str, str, str]]:
    """
    Every kind of note: its code, when it is said, what to do.
    """
def peak_memory() -> int:
    """
    The most memory this process has used, bytes.
    """
def progress_text(progress: Progress) -> str:
    """
    Time, step, speed and time left.
    """
def readable_time(seconds: float) -> str:
    """
    3.2 s, 14 min, 2 h 5 min.
    """
def rebuild_index(frames: str) -> int:
    """
    Make a lost or damaged index anew from the data files beside it; the number of frames.
    """
def run_simulation(simulation: Simulation, scene: Scene, resume: bool, progress: collections.abc.Callable[[Progress], None] | None, callback: collections.abc.Callable[[Simulation], typing.Any] | None, signals: collections.abc.Callable[[], None] | None = None) -> RunSummary:
    """
    Run to the end of the scene and leave what its output section asks for. After Ctrl-C, or an error in the callback or the progress, the last frame and checkpoint are written before it is raised. `signals` is asked between steps to raise those that were held back.
    """
def scene_identity(scene: Scene) -> tuple[str, list[str]]:
    """
    What makes a scene the same problem, arrays and input files by their checksums; and the keys given as functions, which nothing can compare. End, output and title are left out.
    """
def scene_schema() -> str:
    """
    The JSON Schema of scene files.
    """
def set_thread_count(threads: int) -> None:
    """
    Set the threads of every following run; 0 means all processors. Other libraries are not touched.
    """
def summary_text(simulation: Simulation, summary: RunSummary, output: str) -> str:
    """
    How a run ended, its balances and what its user should know.
    """
def thread_count() -> int:
    """
    Threads that every loop may use.
    """
def unknown_name(what: str, given: str, names: list[str]) -> str:
    """
    What to say of a name that is none of these: what it is called now, what was meant, or what there is.
    """
def unused_settings(scene: Scene) -> list[lapilli.note.Note]:
    """
    Settings that nothing reads in this scene, with the reason.
    """
def verify(frames: str) -> tuple[int, int, list[str]]:
    """
    Frames of a run or a merged file, those of which every number fits its checksum, and what is damaged, checkpoints too.
    """
def version_text() -> str:
    """
    Version, compiler, processor level of the kernels, build type and threads, a line each.
    """
__version__: str = '0.1.0'
