"""The maps of stable, inaccurate, unstable and refused steps and trials."""

from __future__ import annotations

import os
from collections.abc import Sequence

from lapilli.extremes.steps import FACTORS, Outcome, Row
from lapilli.extremes.trials import Verdict
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


def draw_trials(verdicts: Sequence[Verdict], path: str | os.PathLike[str]) -> None:
    """One line a trial: the largest of its numbers over its bar."""
    require_matplotlib()
    import matplotlib.pyplot as plt

    groups = list(dict.fromkeys(one.group for one in verdicts))
    figure, axes = plt.subplots(
        len(groups),
        figsize=(8, 1.0 + 0.19 * (len(verdicts) + 3 * len(groups))),
        height_ratios=[3 + sum(one.group == group for one in verdicts) for group in groups],
        squeeze=False,
        layout="constrained",
    )
    for group, (panel,) in zip(groups, axes, strict=True):
        own = [one for one in verdicts if one.group == group]
        least, most = 1e-3, 1e2
        for line, one in enumerate(own):
            over = max((mark.value / mark.bar for mark in one.marks), default=most)
            shown = min(max(over, least), most)
            panel.barh(line, shown, color=COLOURS[one.outcome], height=0.8)
            if one.said:
                panel.text(shown, line, " warned", va="center", fontsize=6)
        panel.axvline(1.0, color="black", lw=1.2)
        panel.set_xscale("log")
        panel.set_xlim(least, most)
        panel.set_ylim(len(own) - 0.5, -0.5)
        panel.set_yticks(range(len(own)), [one.name for one in own], fontsize=6)
        panel.set_title(group, fontsize=9, loc="left")
    axes[-1, 0].set_xlabel("largest number over its bar (black line)")
    with whole_file(path) as written:
        figure.savefig(written, dpi=150)
    plt.close(figure)


def print_trials(verdicts: Sequence[Verdict]) -> None:
    """One line a trial: what came of it, and each number over its bar."""
    width = max(len(f"{one.group}: {one.name}") for one in verdicts)
    for one in verdicts:
        words = one.reason or ", ".join(
            f"{mark.what} {mark.value:.2g} ({mark.bar:.2g})" for mark in one.marks
        )
        warned = ", warned" if one.said else ""
        print(f"{f'{one.group}: {one.name}':{width}}  {one.outcome}{warned}: {words}")
    print("numbers with the most they may be")
