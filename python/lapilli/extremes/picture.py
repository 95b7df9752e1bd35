"""The map of stable, inaccurate, unstable and refused steps."""

from __future__ import annotations

import os
from collections.abc import Sequence

from lapilli.extremes.steps import FACTORS, Outcome, Row
from lapilli.plot import require_matplotlib
from lapilli.whole_file import whole_file

COLOURS = {
    Outcome.STABLE: "#4c9f70",
    Outcome.INACCURATE: "#e6b84c",
    Outcome.UNSTABLE: "#c8473f",
    Outcome.REFUSED: "0.85",
}


def draw(rows: Sequence[Row], path: str | os.PathLike[str]) -> None:
    """One line a case, one cell a step; the automatic step is the black line."""
    require_matplotlib()
    import matplotlib.pyplot as plt
    from matplotlib.patches import Patch

    names = list(dict.fromkeys(f"{row.case.transfer}: {row.case.name}" for row in rows))
    factors = sorted({row.factor for row in rows})
    figure, axes = plt.subplots(figsize=(8, 1.2 + 0.2 * len(names)), layout="constrained")
    for row in rows:
        line = names.index(f"{row.case.transfer}: {row.case.name}")
        left = factors.index(row.factor)
        axes.barh(line, 1.0, left=left - 0.5, height=0.9, color=COLOURS[row.outcome])
    if 1.0 in factors:
        axes.axvline(factors.index(1.0), color="black", lw=1.5)
    axes.set_xticks(range(len(factors)), [f"{factor:g}" for factor in factors])
    axes.set_yticks(range(len(names)), names, fontsize=7)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.set_xlim(-0.5, len(factors) - 0.5)
    axes.set_xlabel("step over the automatic step (black line)")
    axes.legend(
        handles=[Patch(color=colour, label=str(outcome)) for outcome, colour in COLOURS.items()],
        loc="lower center",
        bbox_to_anchor=(0.3, 1.0),
        ncols=len(COLOURS),
        frameon=False,
    )
    with whole_file(path) as written:
        figure.savefig(written, dpi=150)
    plt.close(figure)


def print_map(rows: Sequence[Row]) -> None:
    """The map as text: one letter a step."""
    letters = {
        Outcome.STABLE: "s",
        Outcome.INACCURATE: "i",
        Outcome.UNSTABLE: "U",
        Outcome.REFUSED: ".",
    }
    cases: dict[str, list[Row]] = {}
    for row in rows:
        cases.setdefault(f"{row.case.transfer}: {row.case.name}", []).append(row)
    width = max(map(len, cases), default=0)
    print(f"{'step / automatic':{width}}  " + " ".join(f"{factor:5g}" for factor in FACTORS))
    for name, tried in cases.items():
        marks = {row.factor: letters[row.outcome] for row in tried}
        line = " ".join(f"{marks.get(factor, ' '):>5}" for factor in FACTORS)
        automatic = next(row.step / row.factor for row in tried)
        print(f"{name:{width}}  {line}  automatic {automatic:.3g} s")
    print("s stable, i inaccurate, U unstable, . refused")
