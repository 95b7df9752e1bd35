"""Run a scene from Python."""

from __future__ import annotations

import contextlib
import copy
import functools
import logging
import os
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from lapilli import _core
from lapilli._core import Balance, RunSummary, Scene, Simulation
from lapilli.components import component_of, parted
from lapilli.frames import Frames
from lapilli.history import History, history_of
from lapilli.note import Note
from lapilli.part import Part, names_of
from lapilli.progress import progress_bar
from lapilli.record import read_record
from lapilli.signals import held_back

if TYPE_CHECKING:
    import xarray

    from lapilli.history_frame import HistoryFrame

Callback = Callable[[Simulation], Any]

log = logging.getLogger("lapilli")
log.addHandler(logging.NullHandler())  # silent until a program sets up its logging


class Result:
    """What a run left: the last state, the account of what it conserves, its record and frames.

    ``result["temperature"]`` is a read-only view of the last state in the present order of the
    points; ``result.by_id("temperature")`` is a copy in the order of their ids. Both hold all
    points, those of fluid walls too; ``result.body("air")["temperature"]`` holds those of one
    body. One component of a field is ``result["velocity.x"]``, ``result["stress.xy"]``.
    """

    def __init__(
        self, simulation: Simulation, summary: RunSummary, output: Path | None, scene: Scene
    ) -> None:
        self._bodies = names_of(scene)
        self.simulation = simulation
        self.summary = summary
        self.output = output
        self._output_as_given = scene.output.path or ""

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        field, component = parted(name)
        values = self.simulation[field]
        return component_of(values, name) if component else values

    def __repr__(self) -> str:
        state = "finished" if self.summary.finished else "stopped"
        return f"<{state} at {self.time:g} s, {len(self.simulation)} points>"

    def _repr_html_(self) -> str:
        from lapilli.html import result_as_html

        return result_as_html(self)

    @functools.cached_property
    def history(self) -> HistoryFrame | History:
        """What was recorded in time: a pandas DataFrame where pandas is installed, else a dict of
        arrays. ``history.unit(name)`` and ``history.meaning(name)`` say what a column is."""
        return history_of(self.summary.history, self.summary.history_columns)

    def by_id(self, name: str) -> npt.NDArray[Any]:
        """A copy of a field, or of a component, with its rows in the order of the points' ids."""
        field, component = parted(name)
        values = self.simulation.by_id(field)
        return component_of(values, name) if component else values

    def unit(self, name: str) -> str:
        """The unit of a field, or of a component of it."""
        field = parted(name)[0]
        lengths = self.simulation.dimension
        general = {"position": "m", "volume": "m" if lengths == 1 else f"m^{lengths}"}
        if field in ("position", "volume", "id", "body"):
            return general.get(field, "")
        return self.simulation.unit(field)

    def to_xarray(self) -> xarray.Dataset:
        """All frames over time, point and component; the last state where no frames were written.
        Needs xarray."""
        from lapilli.export import frames_to_xarray, state_to_xarray

        return state_to_xarray(self) if self.output is None else frames_to_xarray(self.frames, None)

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
        return _core.summary_text(self.simulation, self.summary, self._output_as_given)

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
        return read_record(self.output.with_suffix(".json"))

    @property
    def warnings(self) -> list[Note]:
        """What each physics says of its last state that is not wrong but not right either."""
        return self.simulation.warnings()


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
    ``KeyboardInterrupt``. Start and end of the run go to the logger "lapilli" (INFO), its notes and
    warnings too (WARNING; the record of logging has the ``code`` of each).

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
    # The folder of the process may change.
    where = Path(scene.output.path).absolute() if scene.output.path else None
    with _thread_count(threads):
        simulation = Simulation(scene)
        name = scene.title or "scene"
        log.info("%s: run of %d points to %g s", name, len(simulation), simulation.end)
        with progress_bar(progress) as show, held_back() as signals:
            summary = _core.run_simulation(simulation, scene, resume, show, callback, signals)
    result = Result(simulation, summary, where, scene)
    for note in [*summary.notes, *result.warnings]:
        log.warning("%s: %s", name, note.line, extra={"code": note.code})
    log.info("%s: %r, %d steps, %.3g CPU s", name, result, summary.steps, summary.cpu_seconds)
    return result


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


class _Threads:
    """Who asked for how many threads, of runs beside each other in threads of Python."""

    busy = threading.Lock()
    asked: ClassVar[list[tuple[object, int]]] = []
    before = 0


@contextlib.contextmanager
def _thread_count(threads: int | None) -> Iterator[None]:
    if threads is None:
        yield
        return
    mine = (object(), threads)
    with _Threads.busy:
        if not _Threads.asked:
            _Threads.before = _core.thread_count()
        _core.set_thread_count(threads)
        _Threads.asked.append(mine)
    try:
        yield
    finally:
        with _Threads.busy:
            _Threads.asked.remove(mine)
            last = _Threads.asked[-1][1] if _Threads.asked else _Threads.before
            _core.set_thread_count(last)
