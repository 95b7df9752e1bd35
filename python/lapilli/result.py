"""Run a scene from Python."""

from __future__ import annotations

import contextlib
import copy
import json
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli import _core
from lapilli._core import Balance, RunSummary, Scene, Simulation
from lapilli.frames import Frames
from lapilli.history import History
from lapilli.part import Part, names_of
from lapilli.progress import progress_bar

Callback = Callable[[Simulation], Any]


class Result:
    """What a run left: the last state, the account of what it conserves, its record and frames.

    ``result["temperature"]`` is a read-only view of the last state in the present order of the
    points; ``result.by_id("temperature")`` is a copy in the order of their ids. Both hold all
    points, those of fluid walls too; ``result.body("air")["temperature"]`` holds those of one
    body.
    ``result.history`` holds what was recorded in time.
    """

    def __init__(
        self, simulation: Simulation, summary: RunSummary, output: Path | None, scene: Scene
    ) -> None:
        self._bodies = names_of(scene)
        self.simulation = simulation
        self.summary = summary
        self.output = output
        self.history = History(summary.history, summary.history_columns)

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        return self.simulation[name]

    def __repr__(self) -> str:
        state = "finished" if self.summary.finished else "stopped"
        return f"<{state} at {self.time:g} s, {len(self.simulation)} points>"

    def by_id(self, name: str) -> npt.NDArray[Any]:
        """A copy of a field with its rows in the order of the points' ids."""
        return self.simulation.by_id(name)

    def body(self, which: int | str) -> Part:
        """The points of one body or fluid wall, by its name or number (bodies first, from 0)."""
        return Part(self.by_id, which, self._bodies)

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Positions (points, dimension), a view, m."""
        return self.simulation.position

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self.simulation.time

    @property
    def balance(self) -> dict[str, Balance]:
        """The account of every conserved quantity, by its name ("heat")."""
        return {balance.quantity: balance for balance in self.simulation.balance()}

    def report(self) -> str:
        """How the run ended, its balances and what its user should know, as lines of text."""
        return _core.summary_text(self.simulation, self.summary, str(self.output or ""))

    @property
    def frames(self) -> Frames:
        """The frames on disk."""
        if self.output is None:
            raise ValueError("the run wrote no frames: give output='name.vtkhdf'")
        return Frames(self.output)

    @property
    def times(self) -> npt.NDArray[np.float64]:
        """The times of the frames on disk, s."""
        return self.frames.times

    @property
    def record(self) -> dict[str, Any]:
        """The run record that lies beside the frames: settings, version, timings, balances."""
        if self.output is None:
            raise ValueError("the run wrote no record: give output='name.vtkhdf'")
        record: dict[str, Any] = json.loads(self.output.with_suffix(".json").read_text())
        return record

    @property
    def warnings(self) -> list[str]:
        """What each physics says of its last state that is not wrong but not right either; needs
        the record."""
        return [warning for physics in self.record["physics"] for warning in physics["warnings"]]


def run(
    scene: Scene | str | os.PathLike[str],
    output: str | os.PathLike[str] | None = None,
    every: float | None = None,
    *,
    threads: int | None = None,
    progress: bool = True,
    resume: bool = False,
    callback: Callback | None = None,
) -> Result:
    """Run a scene, or the scene of a TOML file, to its end.

    Ctrl-C ends the run after its step, with frame and checkpoint written, and raises
    ``KeyboardInterrupt``.

    Parameters
    ----------
    output
        File of frames for ParaView (``.vtkhdf``); overrides ``scene.output.path``.
    every
        Time between frames, s; overrides ``scene.output.every`` and ``every_steps``.
    threads
        Threads of this run; all processors unless given.
    progress
        Show how far the run has come and the time left.
    resume
        Go on from the checkpoint beside ``output``.
    callback
        Called as ``callback(simulation)`` after each step; False ends the run early.
    """
    scene = with_output(scene, output, every)
    path = Path(scene.output.path) if scene.output.path else None
    with _thread_count(threads):
        simulation = Simulation(scene)
        with progress_bar(progress) as show:
            summary = _core.run_simulation(simulation, scene, resume, show, callback)
    return Result(simulation, summary, path, scene)


def with_output(
    scene: Scene | str | os.PathLike[str],
    output: str | os.PathLike[str] | None,
    every: float | None,
) -> Scene:
    """A copy of the scene, read from its file if need be, that writes its frames elsewhere."""
    scene = copy.copy(scene) if isinstance(scene, Scene) else Scene.load(os.fspath(scene))
    scene.output = copy.copy(scene.output)
    if output is not None:
        scene.output.path = os.fspath(output)
    if every is not None:
        scene.output.every = every
        scene.output.every_steps = None
    return scene


@contextlib.contextmanager
def _thread_count(threads: int | None) -> Iterator[None]:
    before = _core.thread_count()
    if threads is not None:
        _core.set_thread_count(threads)
    try:
        yield
    finally:
        if threads is not None:
            _core.set_thread_count(before)
