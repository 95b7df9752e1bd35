"""What scene classes take beside plain values: quantities of pint, surfaces of other packages.

Neither package is imported here: their objects are known by what they are called and carry.
"""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable, Sequence
from typing import Any

from lapilli import _core
from lapilli.accept.quantities import in_unit, points_in_units, table_in_units
from lapilli.accept.surfaces import shape_of

PLAIN = (float, int, str, bool, type(None))


def accept_foreign_values() -> None:
    """Let the constructors and attributes of all described classes convert what they are given."""
    for made in vars(_core).values():
        if (
            isinstance(made, type)
            and "__setattr__" in vars(made)
            and hasattr(made, "__signature__")
        ):
            _wrap(made)
    table, points = _core.Table, _core.Points
    table.__init__ = _converting(table.__init__, table_in_units, ("times", "values"))  # type: ignore[method-assign]
    points.__init__ = _converting(points.__init__, points_in_units, ("positions", "volumes"))  # type: ignore[method-assign]


def _wrap(made: Any) -> None:
    def convert(given: dict[str, Any]) -> dict[str, Any]:
        return {name: _converted(made, name, value) for name, value in given.items()}

    made.__init__ = _converting(made.__init__, convert)
    set_plain = made.__setattr__

    @functools.wraps(set_plain)
    def set_converted(self: Any, name: str, value: Any) -> None:
        set_plain(self, name, _converted(made, name, value))

    made.__setattr__ = set_converted


def _converting(
    init: Callable[..., None],
    convert: Callable[[dict[str, Any]], dict[str, Any]],
    names: Sequence[str] = (),
) -> Callable[..., None]:
    @functools.wraps(init)
    def initialise(self: Any, *positional: Any, **given: Any) -> None:
        named = dict(zip(names, positional, strict=False))
        init(self, *positional[len(named) :], **convert({**named, **given}))

    return initialise


def _converted(made: Any, name: str, value: Any) -> Any:
    if isinstance(value, PLAIN):
        return value
    parameter = made.__signature__.parameters.get(name)
    if parameter is None:
        return value
    if "Shape" in parameter.annotation:
        return shape_of(value, f"{made.__name__}: {name}")
    return in_unit(value, _unit(made, name), f"{made.__name__}: {name}", parameter.annotation)


@functools.cache
def _unit(made: Any, name: str) -> str:
    """The unit of a key, from "name : type, unit, default" in the documentation of its class."""
    annotation = made.__signature__.parameters[name].annotation
    kind = annotation.removesuffix(" | str")
    for line in (inspect.getdoc(made) or "").splitlines():
        rest = line.removeprefix(f"{name} : ")
        found = re.match(r"(?:, (.*?))?, (?:default |required)", rest.removeprefix(kind))
        if rest != line and found is not None:
            return found[1] or ""
    return ""
