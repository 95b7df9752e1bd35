"""What a run recorded in time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    import pandas

Array = npt.NDArray[np.float64]


class History(dict[str, Array]):
    """Arrays by name, all as long as ``history["time"]``: ``history["heat/stored"]``.

    `unit` and `meaning` say what a name stands for.
    """

    def __init__(
        self, numbers: Mapping[str, Array], columns: Mapping[str, tuple[str, str]]
    ) -> None:
        super().__init__(numbers)
        self._columns = dict(columns)

    def __repr__(self) -> str:
        return f"<history of {len(self.get('time', ()))} rows: {', '.join(self)}>"

    def __missing__(self, name: str) -> Array:
        raise KeyError(f"no {name!r} in the history; there is: {', '.join(self)}")

    def unit(self, name: str) -> str:
        """The unit of a column; empty where it has none."""
        return self._columns[name][0]

    def meaning(self, name: str) -> str:
        """What a column is, in one sentence."""
        return self._columns[name][1]

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the time as its index."""
        try:
            import pandas
        except ImportError as error:
            raise ValueError("a DataFrame needs pandas: pip install pandas") from error
        rest: dict[str, Any] = {name: values for name, values in self.items() if name != "time"}
        return pandas.DataFrame(rest, index=pandas.Index(self["time"], name="time"))
