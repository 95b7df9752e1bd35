"""Section 5.5: a rough footing pressed into an elastic block."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import RunError, Scene
from lapilli.reproduce.case import Case, Row, example, quotient_within
from lapilli.reproduce.ib.balance import Balance, balances, in_mode
from lapilli.reproduce.rows import below, between, rows_of
from lapilli.reproduce.states import changed

NAME = "ib/footing"
HEIGHT = 3.0  # m
PRESS = 1.0  # m
STEPS = (17, 20, 40)
FORCES = {17: 1425.0, 20: 1426.0, 40: 1436.0}  # MN/m at 1 m, independent implementation
EARLY = {20: 93.6, 40: 94.5}  # MN/m at 0.1 m
LOW, HIGH = 1390.0, 1450.0  # MN/m
SPREAD = 0.03
# Height of the highest point above the footing under the paper's rule, m.
PAPER_RULE = {17: 0.207, 20: -0.034, 40: 0.165}

row = rows_of(NAME)


def footing_scene(steps: int) -> Scene:
    """The example in another number of load steps."""
    return changed(example(NAME), f"time.steps={steps}")


@cache
def pressed(steps: int) -> tuple[Balance, ...]:
    """The load steps of the default mode."""
    return tuple(balances(footing_scene(steps)))


def force(state: Balance) -> float:
    """Force of the footing downwards, MN/m."""
    return -1e-6 * float(state.wall_force("footing")[1])


def highest(states: tuple[Balance, ...]) -> float:
    """Largest height of a point above the footing among those that were and are under it, m."""
    worst = -np.inf
    for state in states:
        x0, x = state.start[:, 0], state.position[:, 0]
        under = (x0 > 1) & (x0 < 2) & (x > 1 + 1e-6) & (x < 2 - 1e-6)
        worst = max(worst, float((state.position[under, 1] - HEIGHT + PRESS * state.time).max()))
    return worst


def step_rows(steps: int) -> list[Row]:
    """One number of load steps: does anything cross, and what the footing carries."""
    states = pressed(steps)
    height, final = highest(states), force(states[-1])
    setting = f"{steps} steps, default"
    rows = [
        row(setting, "highest point above the footing", height, below(height, 0.0), unit="m"),
        row(
            setting,
            "force at 1 m",
            final,
            between(final, LOW, HIGH),
            unit="MN/m",
            reference=FORCES[steps],
        ),
    ]
    if steps in EARLY:
        early = force(states[steps // 10 - 1])
        bar = quotient_within(early, EARLY[steps], 0.01)
        rows.append(row(setting, "force at 0.1 m", early, bar, unit="MN/m", reference=EARLY[steps]))
    return rows


def spread_row() -> Row:
    """How far apart the forces of the three numbers of steps are."""
    forces = [force(pressed(steps)[-1]) for steps in STEPS]
    spread = max(forces) / min(forces) - 1
    return row("17, 20, 40 steps, default", "spread of the force", spread, below(spread, SPREAD))


def paper_rule(scene: Scene) -> Scene:
    """Linear shape functions, and walls in empty cells ignored."""
    scene = in_mode(scene, "literal")
    return changed(scene, "quasi_static.hold_empty_cells=false", "grid.shape_function=linear")


def refused(steps: int) -> bool:
    """Whether the paper's rule is stopped with the name of the footing."""
    try:
        for _ in balances(paper_rule(footing_scene(steps))):
            pass
    except RunError as error:
        return "footing" in str(error)
    return False


def refusal_row(steps: int) -> Row:
    """The paper's rule drops the wall where its cell is empty: lapilli stops."""
    found = refused(steps)
    return row(
        f"{steps} steps, the paper's rule (lets points cross by {PAPER_RULE[steps]:g} m)",
        "refused",
        float(found),
        ("1: yes", found),
    )


def run(quick: bool) -> list[Row]:
    """Three numbers of load steps, and the paper's rule where it loses the wall."""
    rows = [r for steps in (STEPS[1:2] if quick else STEPS) for r in step_rows(steps)]
    return rows if quick else [*rows, spread_row(), refusal_row(17), refusal_row(40)]


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figure 22: the block at 0.5 and 1 m, and the force over the way."""
    from lapilli.reproduce.figures import new_figure, save

    figure, axes = new_figure(1, 3)
    states = pressed(20)
    for panel, state in ((axes[0, 0], states[9]), (axes[0, 1], states[-1])):
        drawn = panel.scatter(*state.position.T, c=state.stress[:, 1] / 1e6, s=6, cmap="viridis")
        panel.plot([1, 2], [HEIGHT - state.time] * 2, "k", lw=2)
        panel.set_aspect("equal")
        panel.set_title(f"footing at {state.time:g} m: vertical stress (MPa)")
        figure.colorbar(drawn, ax=panel)
    for steps in STEPS[1:2] if quick else STEPS:
        path = [(state.time, force(state)) for state in pressed(steps)]
        axes[0, 2].plot(*np.array(path).T, ".-", label=f"{steps} steps")
    axes[0, 2].set(xlabel="way of the footing (m)", ylabel="force (MN/m)")
    axes[0, 2].grid(alpha=0.2)
    axes[0, 2].legend()
    return [save(figure, folder / "ib_footing.png")]


CASE = Case(name=NAME, title="footing pressed into an elastic block", run=run, plot=plot)
