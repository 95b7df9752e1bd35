"""The cases of a study as a table: CSV, Parquet, pandas, xarray, pictures."""

from __future__ import annotations

import csv
import math
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from lapilli.note import Note
from lapilli.whole_file import whole_file

if TYPE_CHECKING:
    import pandas
    import xarray

    from lapilli.study.survey import Outcome

COSTS = ("cpu_seconds", "wall_seconds", "steps", "points")


class Results:
    """One row per case, in the order of the cases, whatever finished first."""

    def __init__(
        self,
        outcomes: Sequence[Outcome],
        quantities: Sequence[str],
        units: dict[str, str],
        notes: Sequence[Note] = (),
    ) -> None:
        self.outcomes = list(outcomes)
        named = dict.fromkeys(name for one in outcomes for name in one.numbers)
        self.quantities = list(quantities) or list(named)
        self.units = units
        self.notes = list(notes)  # settings that were changed to fit
        paths = (path for one in outcomes for path, _ in one.setting.changes)
        self.paths = list(dict.fromkeys(paths))

    def __len__(self) -> int:
        return len(self.outcomes)

    def __repr__(self) -> str:
        return f"<{len(self)} cases, {len(self) - len(self.failed)} finished>"

    @property
    def finished(self) -> list[Outcome]:
        """Cases with numbers."""
        return [one for one in self.outcomes if not one.reason]

    @property
    def failed(self) -> list[Outcome]:
        """Cases without numbers; `reason` says why."""
        return [one for one in self.outcomes if one.reason]

    @property
    def reasons(self) -> list[str]:
        """Why cases have no numbers, each reason once."""
        return list(dict.fromkeys(one.reason for one in self.failed))

    def rows(self) -> list[dict[str, Any]]:
        """Values of the members, quantities, status, reason, cost."""
        return [
            {
                **{path: as_value(dict(one.setting.changes).get(path)) for path in self.paths},
                **{name: one.numbers.get(name, math.nan) for name in self.quantities},
                "status": one.status,
                "reason": one.reason,
                **{name: getattr(one, name) for name in COSTS},
            }
            for one in self.outcomes
        ]

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """One line a case; empty where there is no number."""
        rows = self.rows()
        with whole_file(path) as written, written.open("w", newline="") as file:
            writer = csv.DictWriter(file, list(rows[0]) if rows else [])
            writer.writeheader()
            for row in rows:
                writer.writerow({name: "" if is_nan(cell) else cell for name, cell in row.items()})

    def to_pandas(self) -> pandas.DataFrame:
        """One row per case."""
        return needs("pandas").DataFrame(self.rows())

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """A Parquet file."""
        needs("pyarrow")
        frame = self.to_pandas()
        for name in self.paths:  # a column is of one kind
            if frame[name].dtype == object:
                frame[name] = frame[name].astype("string")
        with whole_file(path) as written:
            frame.to_parquet(written, index=False)

    def to_xarray(self) -> xarray.Dataset:
        """A dataset over the varied members where the cases are all their combinations, over the
        number of the case otherwise; with units."""
        needs("xarray")
        frame = self.to_pandas()
        counts = math.prod(frame[path].nunique(dropna=False) for path in self.paths)
        whole = counts == len(frame) and not frame.duplicated(self.paths).any()
        frame = frame.set_index(self.paths) if whole else frame.rename_axis("case")
        data: xarray.Dataset = frame.to_xarray()
        for name, unit in self.units.items():
            if name in data:
                data[name].attrs["units"] = unit
        return data

    def best(self, quantity: str) -> Outcome:
        """The case with the smallest value."""
        known = [one for one in self.finished if not math.isnan(one.numbers[quantity])]
        if not known:
            raise ValueError("no case finished: " + "; ".join(self.reasons))
        return min(known, key=lambda one: one.numbers[quantity])


def as_value(text: str | None) -> Any:
    """A number where the text is one."""
    if text is None:
        return None
    try:
        return int(text) if text.lstrip("+-").isdigit() else float(text)
    except ValueError:
        return text


def is_nan(value: Any) -> bool:
    """Whether a value is no number."""
    return isinstance(value, float) and math.isnan(value)


def needs(module: str) -> Any:
    """An optional module."""
    import importlib

    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ValueError(f"this needs {module}: pip install 'lapilli[study]'") from error
