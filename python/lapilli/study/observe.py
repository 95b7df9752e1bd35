"""Run a scene without its files and see its fields and scalars at named times."""

from __future__ import annotations

import copy
import itertools
import math
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli import _core
from lapilli._core import Output, Scene, Simulation
from lapilli.study.cost import Clock, Cost, PeakMemory

Array = npt.NDArray[Any]

MOST_INTERVALS = 5000  # of the common interval of the named times in one run


@dataclass(frozen=True)
class Snapshot:
    """The points of the bodies, without those of walls, at one time."""

    time: float
    position: Array  # (points, dimension), m
    volume: Array
    fields: dict[str, Array]


@dataclass(frozen=True)
class Observation:
    """What was seen of a run."""

    snapshots: list[Snapshot]
    history: dict[str, Array]  # "time" and every scalar
    units: dict[str, str]  # of fields and scalars
    cost: Cost

    def scalar(self, name: str, time: float) -> float:
        """A column of the history at a time, linear between its rows."""
        if name not in self.history:
            raise ValueError(f"nothing called {name!r} is recorded by this scene")
        return float(np.interp(time, self.history["time"], self.history[name]))


def observe(
    scene: Scene,
    times: Sequence[float],
    fields: Sequence[str] = (),
    *,
    threads: int = 1,
    history_every: float | None = None,
    output_cost: bool = False,
) -> Observation:
    """Run a scene to the last of the times. Scalars are recorded at each time, or every
    `history_every` seconds; with `output_cost`, what the frames of the scene take is measured on
    its last state."""
    _core.set_thread_count(threads)
    clock, memory = Clock(), PeakMemory()
    quiet = without_files(scene, times, history_every)
    with clock.time("build"):
        simulation = Simulation(quiet)
    require_fields(simulation, fields)
    snapshots: list[Snapshot] = []
    left = list(times)

    def look(running: Simulation) -> bool:
        if left and running.time >= left[0] * (1 - 1e-9):
            with clock.time("look"):
                snapshots.append(snapshot(running, scene, left.pop(0), fields))
        return bool(left)

    only_the_end = len(left) == 1 and left[0] >= simulation.end * (1 - 1e-12)
    with clock.time("steps"):
        summary = _core.run_simulation(
            simulation, quiet, False, None, None if only_the_end else look
        )
    peak = memory.read()
    if left:
        snapshots.append(snapshot(simulation, scene, left.pop(0), fields))
    units = {name: unit for name, (unit, _) in summary.history_columns.items()}
    units |= {name: unit_of(simulation, name) for name in fields}
    steps, time = max(1, summary.steps), simulation.time
    per_step = (clock.cpu["steps"] / steps, clock.wall["steps"] / steps)
    output = write_frames(simulation, quiet, per_step) if output_cost else Clock()
    cost = cost_of(
        clock, output, frames_of(scene, time, steps), summary.steps, len(simulation), peak
    )
    return Observation(snapshots, summary.history, units, cost)


def cost_of(clock: Clock, output: Clock, frames: int, steps: int, points: int, peak: int) -> Cost:
    """Costs of the parts; looking is none of them."""
    return Cost(
        clock.cpu["steps"] - clock.cpu.get("look", 0.0),
        clock.cpu["build"],
        clock.wall["steps"] - clock.wall.get("look", 0.0),
        steps,
        points,
        peak,
        frames * output.cpu.get("frame", 0.0),
        clock.wall["build"],
        frames * output.wall.get("frame", 0.0),
    )


def without_files(scene: Scene, times: Sequence[float], history_every: float | None) -> Scene:
    """The scene with steps that end at the named times, and nothing written."""
    scene = copy.copy(scene)
    last = scene.time.end
    if not times or times[0] <= 0 or times[-1] > last * (1 + 1e-12):
        raise ValueError(f"times must lie above 0 and up to the end of the scene at {last:g} s")
    if any(not later > earlier for earlier, later in itertools.pairwise(times)):
        raise ValueError("times must rise")
    inner = [time for time in times if time < last * (1 - 1e-12)]
    every = common_interval(inner) if inner else None
    scene.output = Output(every=every, history_every=history_every)
    return scene


def common_interval(times: Sequence[float]) -> float:
    """The longest interval of which all times are multiples."""
    parts = [Fraction(repr(float(time))) for time in times]
    whole = math.lcm(*(part.denominator for part in parts))
    common = Fraction(math.gcd(*(int(part * whole) for part in parts)), whole)
    if max(parts) / common > MOST_INTERVALS:
        raise ValueError(
            f"the times {', '.join(f'{time:g}' for time in times)} s have no common interval: "
            "choose multiples of one"
        )
    return float(common)


def snapshot(simulation: Simulation, scene: Scene, time: float, fields: Sequence[str]) -> Snapshot:
    """Copies of the points of the bodies as they are now."""
    own = simulation["body"] < len(scene.bodies)
    return Snapshot(
        time,
        simulation.position[own].copy(),
        simulation["volume"][own].copy(),
        {name: np.array(simulation[name][own]) for name in fields},
    )


def require_fields(simulation: Simulation, fields: Sequence[str]) -> None:
    """Fields that there are."""
    for name in fields:
        if name not in simulation.fields:
            raise ValueError(_core.unknown_name("field", name, simulation.fields))


def unit_of(simulation: Simulation, field: str) -> str:
    """The unit of a field; empty for what is no field of a physics, such as the volume."""
    try:
        return "m" if field == "position" else simulation.unit(field)
    except KeyError:
        return ""


def names_of(scene: Scene, wanted: Sequence[str] = ()) -> tuple[list[str], dict[str, str]]:
    """The fields of a scene, and the units of fields and scalars; a step is taken to see the
    scalars, unless all that is wanted are fields."""
    quiet = copy.copy(scene)
    quiet.output = Output()
    simulation = Simulation(quiet)
    units = {name: unit_of(simulation, name) for name in simulation.fields}
    if not wanted or any(name not in units for name in wanted):
        columns = _core.run_simulation(
            simulation, quiet, False, None, lambda _: False
        ).history_columns
        units = {name: unit for name, (unit, _) in columns.items() if name != "time"} | units
    return list(simulation.fields), units


def frames_of(scene: Scene, end: float, steps: int) -> int:
    """How many frames a run of the scene writes until a time."""
    if scene.output.every is not None:
        return math.floor(end / scene.output.every * (1 + 1e-12)) + 1
    if scene.output.every_steps is not None:
        return steps // scene.output.every_steps + 1
    return 2


def write_frames(simulation: Simulation, scene: Scene, step: tuple[float, float]) -> Clock:
    """What one frame and checkpoint of the present state take, in a folder that goes again.

    `step` is the processor and wall time of one step: a run that has not reached its end takes one
    between its two frames.
    """
    clock = Clock()
    written = copy.copy(scene)
    before = simulation.step_index
    with tempfile.TemporaryDirectory(prefix="lapilli-") as folder:
        written.output = Output(path=str(Path(folder) / "frame.vtkhdf"))
        with clock.time("frame"):
            summary = _core.run_simulation(simulation, written, False, None, lambda _: False)
    steps, frames = simulation.step_index - before, max(1, summary.frames)
    clock.cpu["frame"] = max(0.0, clock.cpu["frame"] - steps * step[0]) / frames
    clock.wall["frame"] = max(0.0, clock.wall["frame"] - steps * step[1]) / frames
    return clock
