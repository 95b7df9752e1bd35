"""Pointwise, mean-gap, Nitsche and penalty walls side by side: error, condition number, time."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from lapilli._core import Scene
from lapilli.references import supports
from lapilli.reproduce.case import Case, Row, example
from lapilli.reproduce.ib import annulus, block, cantilever
from lapilli.reproduce.ib.balance import FORMS, Balance, balance, in_form
from lapilli.reproduce.ib.frame import Frame
from lapilli.reproduce.rows import below, rows_of
from lapilli.reproduce.states import changed
from lapilli.study import InProcess, Table, tradeoff
from lapilli.study.table import cost_of, error_of

NAME = "ib/forms"
# Form -> its settings. Stiff pointwise and penalty walls are those of the paper, 1e-6 cells, with
# ghost stabilisation for all, so that only the form differs.
BANDWIDTHS = {"mean-gap": None, "pointwise": 1e-6, "nitsche": None, "penalty": 1e-6}
# Largest condition number with ghost stabilisation at a bandwidth of 1e-6 and of 1e-3 cells.
CONDITION_BARS = {1e-6: 1e12, None: 1e9}

row = rows_of(NAME)


@dataclass(frozen=True)
class Cost:
    """One scene with one form."""

    error: float
    condition: float
    seconds: float


def _block(state: Balance) -> float:
    return block.errors(state, 30).displacement


def _cantilever(state: Balance) -> float:
    frame = Frame(45)
    work = state.volume @ (state.displacement @ (-cantilever.SMALL * frame.e2))
    return float(work) / cantilever.COMPLIANCE - 1


SCENES: dict[str, tuple[str, Callable[[], Scene], Callable[[Balance], float]]] = {
    "block, 30 degrees": (
        "mean error of displacement",
        lambda: block.block_scene(30),
        _block,
    ),
    "cantilever, 45 degrees, h = 2 mm": (
        "error of the compliance",
        lambda: cantilever.cantilever_scene(45, 0.002, 3, cantilever.SMALL),
        _cantilever,
    ),
    "ring, h = 2 mm": (
        "error of the energy",
        lambda: annulus.annulus_scene(0.002),
        annulus.energy_error,
    ),
}
# Largest size of the error by scene and form. Stiff pointwise walls lock on inclined fixed ends and
# on curves, where errors near 0.1 and 0.7 are what they are.
BARS = {
    "block, 30 degrees": {"mean-gap": 1e-11, "pointwise": 1e-9, "nitsche": 1e-11, "penalty": 3e-7},
    "cantilever, 45 degrees, h = 2 mm": {
        "mean-gap": 0.016,
        "pointwise": 0.12,
        "nitsche": 0.016,
        "penalty": 0.12,
    },
    "ring, h = 2 mm": {"mean-gap": 0.008, "pointwise": 0.8, "nitsche": 0.008, "penalty": 0.8},
}


@cache
def cost(scene: str, form: str) -> Cost:
    """Error, condition estimate and time of one load step; the best of three runs."""
    _, make, error = SCENES[scene]
    bandwidth = BANDWIDTHS[form]
    prepared = changed(in_form(make(), form, bandwidth), "quasi_static.ghost_penalty=0.01")
    seconds = []
    for _ in range(3):
        started = time.perf_counter()
        state = balance(prepared)
        seconds.append(time.perf_counter() - started)
    return Cost(error(state), state.report["condition_estimate"], min(seconds))


def form_rows(scene: str, form: str) -> list[Row]:
    """One form on one scene."""
    found = cost(scene, form)
    setting = f"{scene}, {form}"
    bar = BARS[scene][form]
    most = CONDITION_BARS[BANDWIDTHS[form]]
    return [
        row(setting, SCENES[scene][0], found.error, (f"<= {bar:g}", abs(found.error) <= bar)),
        row(setting, "condition number", found.condition, below(found.condition, most)),
        row(setting, "time of set-up and step", found.seconds, ("", True), unit="s"),
    ]


def run(quick: bool) -> list[Row]:
    """Every form on every scene."""
    scenes = list(SCENES)[:2] if quick else list(SCENES)
    return [r for scene in scenes for form in FORMS for r in form_rows(scene, form)]


def plot(folder: Path, quick: bool) -> list[Path]:
    """Error, condition number and time as bars; error against cost."""
    return [bars_picture(folder, quick), tradeoff_picture(folder, quick)]


def bars_picture(folder: Path, quick: bool) -> Path:
    """Error, condition number and time of the forms."""
    from lapilli.reproduce.figures import new_figure, save

    scenes = list(SCENES)[:2] if quick else list(SCENES)
    titles = {"error": "error", "condition": "condition number", "seconds": "time (s)"}
    figure, axes = new_figure(1, 3, width=4.6)
    for panel, (name, title) in zip(axes[0], titles.items(), strict=True):
        for k, form in enumerate(FORMS):
            values = [abs(getattr(cost(scene, form), name)) for scene in scenes]
            panel.bar([i + 0.2 * k for i in range(len(scenes))], values, 0.18, label=form)
        labels = [scene.replace(", ", ",\n") for scene in scenes]
        panel.set_xticks([i + 0.3 for i in range(len(scenes))], labels, fontsize=7)
        panel.set_yscale("log")
        panel.set_title(title)
    axes[0, 0].legend(fontsize=8)
    return save(figure, folder / "ib_forms.png")


def studies(quick: bool) -> dict[str, Table]:
    """Error of the displacement against cost over forms, cells and points per cell."""
    coarse = cantilever.cantilever_scene(45, 0.008, 2, cantilever.SMALL)
    scenes = {
        "block": (example("ib/block"), supports.block, (0.02, 0.01, 0.005)),
        "cantilever": (coarse, supports.cantilever, (0.008, 0.004, 0.002, 0.001)),
        "ring": (annulus.annulus_scene(0.008), supports.annulus, (0.008, 0.004, 0.002, 0.001)),
    }
    return {
        name: tradeoff(
            scene,
            {
                "grid.cell": cells[:2] if quick else cells,
                "bodies.0.points_per_cell": (4, 16),
                "quasi_static.enforcement": FORMS,
            },
            reference,
            field="displacement",
            repeats=1,
            runner=InProcess(),
        )
        for name, (scene, reference, cells) in scenes.items()
    }


def tradeoff_picture(folder: Path, quick: bool) -> Path:
    """The three studies on one picture."""
    from lapilli.reproduce.figures import new_figure, save

    figure, axes = new_figure(1, 3, width=4.6)
    for panel, (name, table) in zip(axes[0], studies(quick).items(), strict=True):
        lines: dict[tuple[str, ...], list[tuple[float, float]]] = {}
        for row_ in table.rows:
            if row_.error is not None and row_.cpu_seconds:
                rest = tuple(value for _, value in row_.setting.changes[1:])
                lines.setdefault(rest, []).append((cost_of(row_), error_of(row_)))
        for (points, form), marks in lines.items():
            style = "o-" if points == "16" else "s--"
            label = f"{form}, {points} points per cell"
            panel.loglog(
                *zip(*marks, strict=True), style, ms=4, label=label, color=f"C{FORMS.index(form)}"
            )
        panel.set(xlabel="CPU time (s)", title=f"{name}: RMS error of the displacement (m)")
        panel.grid(which="both", alpha=0.2)
    axes[0, 0].legend(fontsize=6)
    return save(figure, folder / "ib_tradeoff.png")


CASE = Case(name=NAME, title="four forms of a wall side by side", run=run, plot=plot)
