"""Quantities of pint: numbers with units, converted to the unit of a key."""

from __future__ import annotations

from typing import Any

import numpy as np

PINT_NAMES = {"": "dimensionless", "cells": "dimensionless"}
ALLOWS_TABLE = "float | Table"  # how the type of a key begins that a pair (times, values) may fill


def is_quantity(value: Any) -> bool:
    """Whether it is a quantity of pint (or has the same members)."""
    return hasattr(value, "dimensionality") and hasattr(value, "magnitude")


def in_unit(value: Any, unit: str, key: str, annotation: str = "") -> Any:
    """Quantities, and lists with quantities in them, as plain numbers in `unit`; anything else as
    it is. Raises ``ValueError`` naming the key where the dimension is another."""
    if is_quantity(value):
        return _number(value, unit, key)
    if not isinstance(value, (list, tuple)) or not _holds_quantity(value):
        return value
    if annotation.startswith(ALLOWS_TABLE) and len(value) == 2:
        times, values = value
        return in_unit(times, "s", f"{key}, times"), in_unit(values, unit, key)
    return [_all_in_unit(entry, unit, key) for entry in value]


def table_in_units(given: dict[str, Any]) -> dict[str, Any]:
    """The arguments of a Table, with its times in s; its values have the unit of the key that it is
    given to, which it does not know."""
    if "values" in given and (is_quantity(given["values"]) or _holds_quantity(given["values"])):
        raise ValueError(
            "Table: values get the unit of the key that the table is given to; give plain numbers, "
            "or give the pair (times, values) to the key itself"
        )
    if "times" in given:
        given = {**given, "times": in_unit(given["times"], "s", "Table: times")}
    return given


def points_in_units(given: dict[str, Any]) -> dict[str, Any]:
    """The arguments of Points: positions in m, volumes in m^dimension."""
    made = dict(given)
    if is_quantity(made.get("positions")):
        made["positions"] = in_unit(made["positions"], "m", "Points: positions")
    if is_quantity(made.get("volumes")):
        unit = f"m^{np.shape(made['positions'])[-1]}"
        made["volumes"] = in_unit(made["volumes"], unit, "Points: volumes")
    return made


def _all_in_unit(value: Any, unit: str, key: str) -> Any:
    if isinstance(value, (list, tuple)):
        return [_all_in_unit(entry, unit, key) for entry in value]
    if is_quantity(value):
        return _number(value, unit, key)
    if isinstance(value, (int, float)) and unit and value != 0:
        raise ValueError(f"{key}: {value!r} stands beside quantities without a unit of its own")
    return value


def _holds_quantity(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and any(
        is_quantity(entry) or _holds_quantity(entry) for entry in value
    )


def _number(value: Any, unit: str, key: str) -> Any:
    try:
        number = value.to(PINT_NAMES.get(unit, unit)).magnitude
    except Exception as error:
        allowed = f"a quantity in {unit}" if unit else "a number without a unit"
        raise ValueError(
            f"{key} must be {allowed} (or what converts to it), got {value}"
        ) from error
    return number if isinstance(number, np.ndarray) and number.ndim else float(number)
