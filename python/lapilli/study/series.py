"""A scalar in time as a reference: from the history beside frames, or from a table."""

from __future__ import annotations

import csv
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli.record import read_record
from lapilli.study.quantity import unknown_quantity

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Series:
    """Values at times, linear between them; beyond them is an error."""

    times: Array
    values: Array

    def __call__(self, time: float) -> float:
        first, last = float(self.times[0]), float(self.times[-1])
        slack = 1e-9 * max(abs(first), abs(last))
        if not first - slack <= time <= last + slack:
            raise ValueError(f"the reference goes from {first:g} to {last:g} s, not to {time:g} s")
        return float(np.interp(time, self.times, self.values))


def series_of_run(frames: str | os.PathLike[str], name: str) -> Series:
    """A scalar of the history in the record beside the frames of a run."""
    path = Path(frames).with_suffix(".json")
    if not path.is_file():
        raise ValueError(f"the reference {frames} has no record beside it: {path} is missing")
    record = read_record(path)
    history = record.get("history", {})
    if name not in history or name == "time":
        raise ValueError(f"{path}: {unknown_quantity(name, history)}")
    return series(history["time"], history[name])


def series_of_table(path: str | os.PathLike[str], name: str) -> Series:
    """The column of a CSV file with a column "time"; the only other one, if there are two."""
    with Path(path).open(newline="") as file:
        rows = list(csv.DictReader(file))
    columns = [one for one in (rows[0] if rows else {}) if one is not None]
    if "time" not in columns:
        raise ValueError(f"{path}: a column 'time' is needed; there is: {', '.join(columns)}")
    others = [one for one in columns if one != "time"]
    column = name if name in columns else others[0] if len(others) == 1 else None
    if column is None:
        raise ValueError(f"{path}: {unknown_quantity(name, others)}")
    try:
        filled = [row for row in rows if row[column]]
        return series(
            [float(row["time"]) for row in filled], [float(row[column]) for row in filled]
        )
    except (TypeError, ValueError) as error:
        raise ValueError(f"{path}: {error}") from error


def series(times: Any, values: Any) -> Series:
    """Times that rise and finite values."""
    held = np.asarray(times, float), np.asarray([np.nan if v is None else v for v in values], float)
    known = np.isfinite(held[1])
    found = Series(held[0][known], held[1][known])
    if len(found.times) == 0 or np.any(np.diff(found.times) <= 0):
        raise ValueError("a series needs numbers at times that rise")
    return found
