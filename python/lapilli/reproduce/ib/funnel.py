"""Section 5.6: a block pushed into a funnel whose roof is a curved roller."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.ib.balance import Balance, balances, in_form
from lapilli.reproduce.rows import at_least, below, between, rows_of
from lapilli.reproduce.states import Array

NAME = "ib/funnel"
PUSH = 0.024  # m
REFERENCE = {"mean-gap": 1.502, "pointwise": 10.097}  # MN/m, push in the last step
LOW, HIGH = 1.0, 1.5  # MN/m
OUTSIDE = 0.3  # mm
SLIDES = 20.0  # mm, least way of any point

row = rows_of(NAME)


def roof(x: Array) -> Array:
    """Height of the channel, m."""
    share = np.clip((x - 0.056) / 0.048, 0, 1)
    height: Array = 0.04 - 0.006 * (1 - np.cos(np.pi * share))
    return height


def funnel_scene(form: str = "mean-gap", bandwidth: float | None = None) -> Scene:
    """The example with another form of its walls."""
    return in_form(example(NAME), form, bandwidth)


@cache
def pushed(form: str) -> tuple[Balance, ...]:
    """The load steps; the paper's walls are 1e-6 cells stiff."""
    return tuple(balances(funnel_scene(form, 1e-6 if form == "pointwise" else None)))


def outside(states: tuple[Balance, ...]) -> float:
    """How far a point is outside the channel or behind the piston at worst, mm."""
    worst = 0.0
    for state in states:
        x, y = state.position.T
        worst = max(worst, (y - roof(x)).max(), -y.min(), (PUSH * state.time - x).max())
    return 1e3 * worst


def run(quick: bool) -> list[Row]:
    """The default slides; the paper's walls stick."""
    slides = pushed("mean-gap")
    force = 1e-6 * float(slides[-1].wall_force("piston")[0])
    out = outside(slides)
    least = 1e3 * float(slides[-1].displacement[:, 0].min())
    rows = [
        row(
            "default",
            "force of the piston",
            force,
            between(force, LOW, HIGH),
            unit="MN/m",
            reference=REFERENCE["mean-gap"],
        ),
        row("default", "farthest point outside", out, within(out, OUTSIDE), unit="mm"),
        row("default", "least way of a point", least, at_least(least, SLIDES), unit="mm"),
    ]
    if quick:
        return rows
    stuck = pushed("pointwise")
    force = 1e-6 * float(stuck[-1].wall_force("piston")[0])
    least = 1e3 * float(stuck[-1].displacement[:, 0].min())
    setting = "pointwise, bandwidth 1e-6 cells (the paper)"
    return [
        *rows,
        row(
            setting,
            "force of the piston",
            force,
            at_least(force, 5.0),
            unit="MN/m",
            reference=REFERENCE["pointwise"],
        ),
        row(setting, "least way of a point", least, below(least, 5.0), unit="mm"),
    ]


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figure 23: the block on its way."""
    from lapilli.reproduce.figures import new_figure, save

    forms = ("mean-gap",) if quick else ("mean-gap", "pointwise")
    figure, axes = new_figure(len(forms), 1, width=8, height=2.6)
    for panel, form in zip(axes[:, 0], forms, strict=True):
        state = pushed(form)[-1]
        x = np.linspace(0, 0.14, 200)
        panel.plot(1e3 * x, 1e3 * roof(x), "k", lw=1)
        panel.axhline(0.0, color="k", lw=1)
        drawn = panel.scatter(*(1e3 * state.position.T), c=1e3 * state.displacement[:, 0], s=6)
        panel.set_aspect("equal")
        panel.set_title(f"{form}: displacement along x (mm)")
        figure.colorbar(drawn, ax=panel)
    return [save(figure, folder / "ib_funnel.png")]


CASE = Case(name=NAME, title="block pushed into a funnel", run=run, plot=plot)
