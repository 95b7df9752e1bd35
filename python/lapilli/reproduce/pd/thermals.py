"""Section 6.1.2: thermals above a heated plate in a tank of water. The paper gives pictures and a
recorded temperature, and no numbers: what is measured has no bar."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from lapilli._core import Scene, Simulation
from lapilli.reproduce.case import Case, Row, example
from lapilli.reproduce.pd.fluid_state import FluidState, fluid_state, sample
from lapilli.reproduce.rows import NO_BAR, rows_of
from lapilli.reproduce.states import Array, changed

NAME = "pd/thermals"
row = rows_of(NAME)
COLD, HOT = 23.6, 43.1  # degree C
MONITOR = 0.008  # m above the plate
PLATE = (0.015, 0.105)  # m
FULL, QUICK = (0.0006, 60.0), (0.003, 6.0)  # spacing in m, end in s
ACTIVE = 0.5  # K above the water: a thermal


@dataclass(frozen=True)
class Record:
    """Temperatures along the monitor line in time, and the last state."""

    time: Array  # (looks,), s
    place: Array  # (monitors,), m along the plate
    temperature: Array  # (looks, monitors), degree C
    density_variation: float
    state: FluidState


def scene(spacing: float, end: float) -> Scene:
    """The example with other points and another end."""
    return changed(
        example("pd/thermals"), f"grid.cell={spacing!r}", f"time.end={end!r}", 'output.path=""'
    )


@cache
def record(spacing: float, end: float, looks: int = 120) -> Record:
    """Run and look at the line 0.8 cm above the plate."""
    simulation = Simulation(scene(spacing, end))
    place = np.linspace(*PLATE, 46)
    line = np.column_stack([place, np.full_like(place, MONITOR)])
    times = end * np.arange(1, looks + 1) / looks
    rows = []
    for time in times:
        simulation.run_until(float(time))
        state = fluid_state(simulation)
        rows.append(sample(state.position, state.temperature, line, 2.5 * spacing))
    numbers = simulation.diagnostics()
    variation = max(-numbers["flow/least_density_variation"],
                    numbers["flow/greatest_density_variation"])  # fmt: skip
    return Record(times, place, np.array(rows), variation, state)


def monitor(found: Record) -> Array:
    """The trace above the most active place, as the experiment has it."""
    trace: Array = found.temperature[:, found.temperature.std(axis=0).argmax()]
    return trace


def period(time: Array, trace: Array) -> float:
    """Mean time between the starts of warm spells after the first; NaN below two of them."""
    level = 0.5 * (trace.min() + trace.max())
    starts = time[1:][(trace[1:] > level) & (trace[:-1] <= level)]
    return float(np.diff(starts).mean()) if len(starts) > 1 else float("nan")


def thermals(found: Record) -> int:
    """Warm stretches of the monitor line at the end."""
    warm = np.concatenate([[False], found.temperature[-1] > COLD + ACTIVE])
    return int(np.count_nonzero(warm[1:] & ~warm[:-1]))


def run(quick: bool) -> list[Row]:
    """104,236 points for 60 s (hours); 4,000 points for 6 s if `quick`."""
    spacing, end = QUICK if quick else FULL
    found = record(spacing, end)
    trace = monitor(found)
    setting = f"{1e3 * spacing:g} mm, {len(found.state.volume)} fluid points, {end:g} s"

    beat = period(found.time, trace)
    top = found.state.position[found.state.temperature > COLD + ACTIVE, 1]
    return [
        row(setting, "thermals 0.8 cm above the plate", thermals(found), NO_BAR),
        row(setting, "warmest at the monitor", trace.max(), NO_BAR, unit="degree C"),
        *([row(setting, "period at the monitor", beat, NO_BAR, unit="s")]
          if np.isfinite(beat) else []),
        row(setting, "height of the highest thermal", 100 * top.max(initial=0.0), NO_BAR,
            unit="cm"),
        row(setting, "density variation", found.density_variation, NO_BAR),
    ]  # fmt: skip


def plot(folder: Path, quick: bool) -> list[Path]:
    """Figs. 17 and 18."""
    from lapilli.reproduce.pd.figures import draw_thermals

    return [draw_thermals(folder, *(QUICK if quick else FULL))]


CASE = Case(name=NAME, title="thermals above a heated plate", run=run, plot=plot)
