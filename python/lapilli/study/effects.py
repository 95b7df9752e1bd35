"""Pictures of a study: main effects, pairs, the response over two members."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from lapilli.plot import require_matplotlib
from lapilli.study.results import Results, as_value
from lapilli.whole_file import whole_file

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MOST_PANELS = 6  # quantities and members in one picture


def draw(results: Results, name: str) -> list[Path]:
    """NAME-effects.png, NAME-pairs.png where several members vary, NAME-response.png where two do;
    which were drawn."""
    require_matplotlib()
    pictures = {"effects": effects(results)}
    if len(varied(results)) > 1:
        pictures["pairs"] = pairs(results)
    if len(varied(results)) == 2 and is_number(results, varied(results)):
        pictures["response"] = response(results)
    return [save(figure, f"{name}-{kind}.png") for kind, figure in pictures.items()]


def save(figure: Figure, path: str | os.PathLike[str]) -> Path:
    """Write a picture and let it go."""
    import matplotlib.pyplot as plt

    with whole_file(path) as written:
        figure.savefig(written, dpi=150)
    plt.close(figure)
    return Path(path)


def varied(results: Results) -> list[str]:
    """Members that take more than one value."""
    return [path for path in results.paths if len(set(column(results, path))) > 1] or results.paths


def column(results: Results, name: str) -> list[Any]:
    """The values of a member, or of a quantity, in the cases that finished."""
    if name in results.paths:
        return [as_value(dict(one.setting.changes).get(name)) for one in results.finished]
    return [one.numbers.get(name, math.nan) for one in results.finished]


def is_number(results: Results, names: Sequence[str]) -> bool:
    """Whether all values of members are numbers."""
    return all(isinstance(value, float | int) for name in names for value in column(results, name))


def effects(results: Results) -> Figure:
    """Each quantity over each member: every case, and the mean along it."""
    import matplotlib.pyplot as plt

    members, quantities = varied(results)[:MOST_PANELS], results.quantities[:MOST_PANELS]
    figure, axes = plt.subplots(
        len(quantities), len(members), figsize=(3 * len(members) + 1, 2.4 * len(quantities) + 0.6),
        squeeze=False, sharey="row", layout="constrained",
    )  # fmt: skip
    for line, quantity in zip(axes, quantities, strict=True):
        for panel, member in zip(line, members, strict=True):
            scatter_with_mean(panel, column(results, member), column(results, quantity))
            panel.grid(alpha=0.2)
        line[0].set_ylabel(labelled(results, quantity), fontsize=8)
    for panel, member in zip(axes[-1], members, strict=True):
        panel.set_xlabel(member, fontsize=8)
    figure.suptitle(told(results), fontsize=8)
    return figure


def scatter_with_mean(panel: Axes, values: Sequence[Any], numbers: Sequence[float]) -> None:
    """Cases as points; the mean of each value, or of each eighth of a sample."""
    if not all(isinstance(one, float | int) for one in values):
        words = list(dict.fromkeys(map(str, values)))
        values = [words.index(str(one)) for one in values]
        panel.set_xticks(range(len(words)), words, fontsize=7)
    x, y = np.asarray(values, float), np.asarray(numbers, float)
    panel.set_xscale(scale_of(x))
    panel.plot(x, y, ".", ms=4, alpha=0.5, color="C0")
    levels = np.unique(x)
    if len(levels) > 12:
        edges = np.quantile(x, np.linspace(0, 1, 9))
        group = np.clip(np.searchsorted(edges, x, "right") - 1, 0, 7)
    else:
        group = np.searchsorted(levels, x)
    means = [(x[group == k].mean(), np.nanmean(y[group == k])) for k in np.unique(group)]
    panel.plot(*zip(*means, strict=True), "o-", ms=4, color="C1")


def scale_of(values: Any) -> str:
    """Logarithmic where values above 0 differ by a factor of 50 or more."""
    numbers = np.asarray(values, float)
    wide = numbers.size and numbers.min() > 0 and numbers.max() >= 50 * numbers.min()
    return "log" if wide else "linear"


def pairs(results: Results) -> Figure:
    """Every two members and the first quantity beside each other."""
    import matplotlib.pyplot as plt

    names = [*varied(results)[:MOST_PANELS], *results.quantities[:1]]
    colour = np.asarray(column(results, results.quantities[0]), float)
    figure, axes = plt.subplots(
        len(names) - 1, len(names) - 1, figsize=(2.4 * len(names), 2.2 * len(names)),
        squeeze=False, layout="constrained",
    )  # fmt: skip
    shown: Any = None
    for i, below in enumerate(names[1:]):
        for j, left in enumerate(names[:-1]):
            if j > i:
                axes[i, j].axis("off")
                continue
            x, y = (numbered(column(results, name)) for name in (left, below))
            shown = axes[i, j].scatter(x, y, c=colour, s=9)
            axes[i, j].set(xscale=scale_of(x), yscale=scale_of(y))
            axes[i, j].set_xlabel(left, fontsize=7)
            axes[i, j].set_ylabel(below, fontsize=7)
            axes[i, j].tick_params(labelsize=6)
    if shown is not None:
        figure.colorbar(shown, ax=axes, label=labelled(results, results.quantities[0]), shrink=0.6)
    return figure


def response(results: Results) -> Figure:
    """The first quantity over the two members."""
    import matplotlib.pyplot as plt

    x, y = (np.asarray(column(results, name), float) for name in varied(results))
    z = np.asarray(column(results, results.quantities[0]), float)
    known = np.isfinite(z)
    figure, axes = plt.subplots(figsize=(5.6, 4.4), layout="constrained")
    try:
        drawn: Any = axes.tricontourf(x[known], y[known], z[known], levels=12)
        axes.plot(x[known], y[known], "k.", ms=3)
    except (ValueError, RuntimeError):  # fewer than three cases, or all on a line
        drawn = axes.scatter(x[known], y[known], c=z[known])
    figure.colorbar(drawn, ax=axes, label=labelled(results, results.quantities[0]))
    axes.set(xlabel=varied(results)[0], ylabel=varied(results)[1])
    axes.set(xscale=scale_of(x), yscale=scale_of(y))
    return figure


def numbered(values: Sequence[Any]) -> Sequence[float]:
    """Numbers as they are, words by their order."""
    if all(isinstance(one, float | int) for one in values):
        return [float(one) for one in values]
    words = list(dict.fromkeys(map(str, values)))
    return [float(words.index(str(one))) for one in values]


def labelled(results: Results, quantity: str) -> str:
    """A quantity with its unit."""
    unit = results.units.get(quantity, "")
    return f"{quantity} ({unit})" if unit else quantity


def told(results: Results) -> str:
    """How many cases are shown."""
    failed = len(results.failed)
    return f"{len(results.finished)} cases" + (f", {failed} failed (not shown)" if failed else "")
