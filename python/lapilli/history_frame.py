"""What a run recorded in time, as a pandas DataFrame. Imports pandas."""

from __future__ import annotations

from collections.abc import Callable, KeysView, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas

from lapilli.history import Columns, unknown_column

INDEX = "time (s)"  # its name is the label of the axis in plots


class HistoryColumn(pandas.Series):  # type: ignore[misc, type-arg, unused-ignore]
    """One column. An integer is a position, as in an array: ``column[-1]`` is the last value."""

    @property
    def _constructor(self) -> Callable[..., HistoryColumn]:
        return HistoryColumn

    @property
    def _constructor_expanddim(self) -> Callable[..., HistoryFrame]:
        return HistoryFrame

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, (int, np.integer)) and not isinstance(key, bool):
            return self.iloc[key]
        return super().__getitem__(key)

    def tobytes(self) -> bytes:
        """The bytes of the values."""
        return bytes(self.to_numpy().tobytes())


class HistoryFrame(pandas.DataFrame):  # type: ignore[misc, unused-ignore]
    """One row for each recorded moment, one column for each number; the index is the time, which
    is a column too.

    `unit` and `meaning` say what a column stands for.
    """

    _metadata = ["_lapilli_columns"]  # noqa: RUF012  what pandas carries along to parts and copies
    _lapilli_columns: dict[str, tuple[str, str]]

    @classmethod
    def of(cls, numbers: Mapping[str, npt.NDArray[np.float64]], columns: Columns) -> HistoryFrame:
        """The frame of these arrays."""
        frame = cls(dict(numbers), index=pandas.Index(numbers["time"], name=INDEX))
        frame._lapilli_columns = dict(columns)
        return frame

    @property
    def _constructor(self) -> Callable[..., HistoryFrame]:
        return HistoryFrame

    @property
    def _constructor_sliced(self) -> Callable[..., HistoryColumn]:
        return HistoryColumn

    def __getitem__(self, key: Any) -> Any:
        try:
            return super().__getitem__(key)
        except KeyError:
            raise KeyError(unknown_column(key, self)) from None

    def keys(self) -> KeysView[str]:  # type: ignore[override, unused-ignore]
        """The names of the columns, as a dict has them."""
        return dict.fromkeys(self.columns).keys()

    def unit(self, name: str) -> str:
        """The unit of a column; empty where it has none."""
        return self._lapilli_columns[name][0]

    def meaning(self, name: str) -> str:
        """What a column is, in one sentence."""
        return self._lapilli_columns[name][1]

    def to_pandas(self) -> pandas.DataFrame:
        """A plain DataFrame with the time as its index."""
        index = pandas.Index(self["time"].to_numpy(), name="time")
        rest = {name: self[name].to_numpy() for name in self.columns if name != "time"}
        return pandas.DataFrame(rest, index=index)
