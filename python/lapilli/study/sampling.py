"""Which cases a study runs: lists, grids, Latin hypercube and Sobol' samples, a table of cases."""

from __future__ import annotations

import csv
import itertools
import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lapilli import _core
from lapilli.study.settings import Setting, as_toml, parse_variation

SAMPLERS = ("grid", "latin-hypercube", "sobol")
MOST_CASES = 1_000_000


@dataclass(frozen=True)
class Range:
    """All numbers from `low` to `high`, evenly or in proportion."""

    low: float
    high: float
    logarithmic: bool = False

    def __post_init__(self) -> None:
        if not (math.isfinite(self.low) and math.isfinite(self.high) and self.low < self.high):
            raise ValueError(f"a range must rise, got {self.low:g}..{self.high:g}")
        if self.logarithmic and self.low <= 0:
            raise ValueError(f"a logarithmic range must lie above 0, got {self.low:g}")

    def at(self, share: float) -> float:
        """The number at a share from 0 to 1 of the way, to 12 digits."""
        if self.logarithmic:
            value = self.low * (self.high / self.low) ** share
        else:
            value = self.low + (self.high - self.low) * share
        return float(f"{value:.12g}")

    def even(self, count: int) -> list[float]:
        """So many numbers from end to end."""
        return [self.at(k / max(1, count - 1)) for k in range(count)]


Values = Sequence[Any] | Range


def parse_values(text: str) -> tuple[str, list[str] | Range]:
    """The path and values of "grid.cell=0.4,0.2", "friction=20..40" or "cell=0.01..1 log"."""
    path, _, values = text.partition("=")
    low, dots, rest = values.partition("..")
    if not dots:
        return parse_variation(text)
    high, _, how = rest.strip().partition(" ")
    try:
        if not path.strip() or how.strip() not in {"", "log"}:
            raise ValueError
        found = float(low), float(high)
    except ValueError:
        raise ValueError(
            f"--vary {text}: expected path=value,value,... or path=low..high, perhaps with ' log'"
        ) from None
    return path.strip(), Range(*found, how.strip() == "log")


def cases_of(
    vary: Mapping[str, Values], sample: str = "grid", samples: int = 5, seed: int = 0
) -> list[Setting]:
    """The cases: every combination of lists and of `samples` numbers of each range, or `samples`
    draws from all of them at once."""
    if not vary:
        raise ValueError("nothing to vary: give paths and values, as in grid.cell=0.4,0.2")
    if sample not in SAMPLERS:
        raise ValueError(_core.unknown_name("sampler", sample, list(SAMPLERS)))
    if not 1 <= samples <= MOST_CASES:
        raise ValueError(f"samples must be from 1 to {MOST_CASES}, got {samples}")
    if sample == "grid":
        lists = [
            one.even(samples) if isinstance(one, Range) else list(one) for one in vary.values()
        ]
        count = math.prod(map(len, lists))
        if count > MOST_CASES:
            raise ValueError(f"{count} cases are more than {MOST_CASES}")
        rows: Any = itertools.product(*lists)
    else:
        shares = drawn(sample, len(vary), samples, seed)
        rows = ([pick(one, s) for one, s in zip(vary.values(), row, strict=True)] for row in shares)
    return [
        Setting(tuple(zip(vary, (as_toml(value) for value in row), strict=True))) for row in rows
    ]


def drawn(sample: str, dimension: int, count: int, seed: int) -> Any:
    """Numbers from 0 to 1, (count, dimension), the same for the same seed."""
    try:
        from scipy.stats import qmc
    except ImportError as error:
        raise ValueError("samples need SciPy: pip install 'lapilli[study]'") from error
    if sample == "latin-hypercube":
        return qmc.LatinHypercube(dimension, rng=seed).random(count)
    # The first powers of two of a sequence are balanced: the rest is drawn and left.
    return qmc.Sobol(dimension, rng=seed).random_base2(math.ceil(math.log2(count)))[:count]


def pick(values: Values, share: float) -> Any:
    """The value at a share of the way."""
    if isinstance(values, Range):
        return values.at(share)
    return values[min(int(share * len(values)), len(values) - 1)]


def cases_in(path: str | os.PathLike[str]) -> list[Setting]:
    """The cases of a CSV file: paths in its first line, a case in each other; an empty cell leaves
    the scene as it is."""
    with Path(path).open(newline="", encoding="utf-8-sig") as file:
        rows = [row for row in csv.reader(file) if any(cell.strip() for cell in row)]
    if len(rows) < 2 or not all(cell.strip() for cell in rows[0]):
        raise ValueError(f"{path}: the first line must name members, each other line is a case")
    cases = []
    for number, row in enumerate(rows[1:], 2):
        if len(row) != len(rows[0]):
            raise ValueError(f"{path}, line {number}: {len(row)} values for {len(rows[0])} names")
        pairs = zip(rows[0], row, strict=True)
        cases.append(
            Setting(tuple((name.strip(), cell.strip()) for name, cell in pairs if cell.strip()))
        )
    return cases
