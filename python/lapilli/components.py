"""Names of fields and of their components: "temperature", "velocity.x", "stress.xy"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli._core import unknown_name

Array = npt.NDArray[Any]

# By the numbers a row holds; frames have vectors of 3 and tensors of 9, states fewer.
NAMES: dict[int, tuple[str, ...]] = {
    2: ("x", "y"),
    3: ("x", "y", "z"),
    4: ("xx", "xy", "yx", "yy"),
    6: ("xx", "yy", "zz", "xy", "yz", "xz"),
    9: ("xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"),
}
MAGNITUDE = "magnitude"


def component_names(values: Array) -> tuple[str, ...]:
    """The names of the components of a field; none for a scalar."""
    if values.ndim == 1:
        return ()
    width = values.shape[1]
    return NAMES.get(width, tuple(str(k) for k in range(width)))


def parted(name: str) -> tuple[str, str]:
    """Field and component of "stress.xy"; the component is empty where none is named."""
    field, _, component = name.partition(".")
    return field, component


def component_of(values: Array, name: str) -> Array:
    """One number per row: the component that `name` ends in, or the magnitude of the rows.

    Raises ``KeyError`` naming the components there are.
    """
    field, component = parted(name)
    names = component_names(values)
    if component in ("", MAGNITUDE):
        return magnitude(values)
    if component not in names:
        known = [f"{field}.{one}" for one in (*names, MAGNITUDE)] if names else [field]
        raise KeyError(unknown_name("component", name, known))
    return values[:, names.index(component)]


def magnitude(values: Array) -> Array:
    """The length of vectors, the Frobenius norm of tensors; scalars as they are.

    Six numbers are a symmetric tensor, whose entries off the diagonal count twice.
    """
    if values.ndim == 1:
        return values
    if values.shape[1] == 6:
        values = values * np.sqrt([1, 1, 1, 2, 2, 2])
    size: Array = np.linalg.norm(values, axis=1)
    return size


def typeset(unit: str) -> str:
    """A unit as it is printed: W/m² for "W/m^2"."""
    return re.sub(r"\^([0-9])", lambda power: "⁰¹²³⁴⁵⁶⁷⁸⁹"[int(power[1])], unit)


def label(name: str, values: Array, unit: str) -> str:
    """ "velocity, magnitude (m/s)": what is drawn, with its unit."""
    field, component = parted(name)
    if values.ndim > 1 and not component:
        component = MAGNITUDE
    words = ", ".join(part for part in (field.replace("_", " "), component) if part)
    return f"{words} ({typeset(unit)})" if unit else words


def require_field(name: str, fields: Sequence[str], where: object) -> str:
    """The field that `name` starts with. Raises ``ValueError`` naming those there are."""
    field, _ = parted(name)
    if field not in fields:
        raise ValueError(f"no field {field!r} in {where}; there is: {', '.join(fields)}")
    return field
