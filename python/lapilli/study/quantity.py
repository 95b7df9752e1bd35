"""What a study looks at: a field, or a scalar of the history, perhaps reduced over time."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from lapilli import _core
from lapilli.study.observe import Observation

REDUCTIONS = ("last", "max", "min", "mean", "range")


@dataclass(frozen=True)
class Quantity:
    """A number of a run: "largest(temperature/largest)" or "mean(dynamics/front)" or a plain name.

    A scalar of the history counts with its last value unless reduced over time; a field with its
    mean over the volume of the bodies at the end (its size for vectors and tensors).
    """

    name: str
    reduction: str = "last"
    sign: float = 1.0

    def __str__(self) -> str:
        text = self.name if self.reduction == "last" else f"{self.reduction}({self.name})"
        return text if self.sign > 0 else f"-{text}"

    @classmethod
    def parse(cls, text: str) -> Quantity:
        """The quantity of "name", "max(name)", or "-name"."""
        sign, text = (-1.0, text[1:]) if text.startswith("-") else (1.0, text)
        call = re.fullmatch(r"(\w+)\((.+)\)", text)
        if call is None:
            return cls(text, sign=sign)
        if call[1] not in REDUCTIONS:
            raise ValueError(_core.unknown_name("reduction", call[1], list(REDUCTIONS)))
        return cls(call[2], call[1], sign)

    def of(self, seen: Observation) -> float:
        """Its value in a run; a ValueError names what there is instead."""
        if self.name in seen.history:
            return self.sign * reduced(self.reduction, seen.history[self.name])
        for snapshot in seen.snapshots[-1:]:
            if self.name in snapshot.fields:
                values = np.asarray(snapshot.fields[self.name], float)
                size = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
                return self.sign * float(np.average(size, weights=snapshot.volume))
        raise ValueError(unknown_quantity(self.name, seen.history))


def reduced(reduction: str, values: Any) -> float:
    """One number of a series."""
    series = np.asarray(values, float)
    known = series[~np.isnan(series)]
    if known.size == 0:
        return float("nan")
    if reduction == "last":
        return float(series[-1])
    if reduction == "range":
        return float(np.ptp(known))
    return float({"max": known.max, "min": known.min, "mean": known.mean}[reduction]())


def unknown_quantity(name: str, known: Iterable[str], fields: Sequence[str] = ()) -> str:
    """What is wrong with a name, and what it may have been meant for."""
    names = [*(one for one in known if one != "time"), *fields]
    return _core.unknown_name("field or scalar of the history", name, names)


def parted(names: Sequence[str], scene_fields: Sequence[str], scalars: Iterable[str]) -> list[str]:
    """Those of the names that are fields; the others must be scalars of the history."""
    known = set(scalars)
    for name in names:
        if name not in scene_fields and name not in known:
            raise ValueError(unknown_quantity(name, known, scene_fields))
    return [name for name in names if name in scene_fields]
