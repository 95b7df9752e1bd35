"""What a run recorded in time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from lapilli.extras import required

if TYPE_CHECKING:
    import pandas

    from lapilli.history_frame import HistoryFrame

Array = npt.NDArray[np.float64]
Columns = Mapping[str, tuple[str, str]]  # unit and meaning by name


class History(dict[str, Array]):
    """Arrays by name, all as long as ``history["time"]``: ``history["heat/stored"]``.

    `unit` and `meaning` say what a name stands for.
    """

    def __init__(self, numbers: Mapping[str, Array], columns: Columns) -> None:
        super().__init__(numbers)
        self._columns = dict(columns)

    def __repr__(self) -> str:
        return f"<history of {len(self.get('time', ()))} rows: {', '.join(self)}>"

    def __missing__(self, name: str) -> Array:
        raise KeyError(unknown_column(name, self))

    def unit(self, name: str) -> str:
        """The unit of a column; empty where it has none."""
        return self._columns[name][0]

    def meaning(self, name: str) -> str:
        """What a column is, in one sentence."""
        return self._columns[name][1]

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the time as its index."""
        pandas = required("pandas", "a DataFrame")
        rest: dict[str, Any] = {name: values for name, values in self.items() if name != "time"}
        index = pandas.Index(self["time"], name="time")
        return pandas.DataFrame(rest, index=index)


def unknown_column(name: object, known: Mapping[str, Any] | Any) -> str:
    """The message for a column that is not there."""
    return f"no {name!r} in the history; there is: {', '.join(map(str, known))}"


def history_of(numbers: Mapping[str, Array], columns: Columns) -> History | HistoryFrame:
    """A pandas DataFrame where pandas is installed, else a dict of arrays."""
    try:
        from lapilli.history_frame import HistoryFrame
    except ImportError:
        return History(numbers, columns)
    return HistoryFrame.of(numbers, columns)
