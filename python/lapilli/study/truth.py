"""The truth of every quantity of a study: of fields by position and time, of scalars by time."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli._core import Scene
from lapilli.study.finer import finer_setting
from lapilli.study.observe import Observation, observe
from lapilli.study.reference import (
    Function,
    PointsReference,
    Reference,
    from_frames,
    parse_finer,
    reference_of,
)
from lapilli.study.same_scene import require_same_problem
from lapilli.study.series import Series, series_of_run
from lapilli.study.settings import Setting

Array = npt.NDArray[Any]
Given = str | os.PathLike[str] | Function | Reference | float | None


@dataclass(frozen=True)
class Truth:
    """References of fields and of scalars, by name, and what should be said of them."""

    fields: dict[str, Reference] = field(default_factory=dict)
    scalars: dict[str, Callable[[float], float]] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Constant:
    """A known number."""

    value: float

    def __call__(self, time: float) -> float:
        del time
        return self.value


def truth_of(
    given: Given | Mapping[str, Given],
    scene: Scene,
    quantities: Sequence[tuple[str, bool]],
    times: Sequence[float],
    settings: Sequence[Setting],
) -> Truth:
    """References of the quantities (name, whether it is a field) from what a user may give.

    One reference serves all that it can: a run, or the frames of one, every quantity; a shipped
    reference or a function of (positions, time) the fields. For what is left, and where none is
    given, the scene is run finer than all settings.
    """
    by_name = given if isinstance(given, Mapping) else {name: given for name, _ in quantities}
    truth = Truth()
    runs: dict[Setting, list[tuple[str, bool]]] = {}
    finer = finer_setting(scene, settings)
    for name, is_field in quantities:
        one = by_name.get(name)
        if one is None or not (is_field or serves_scalars(one, isinstance(given, Mapping))):
            runs.setdefault(finer, []).append((name, is_field))
            truth.notes.append(f"the error of {name} is that against a finer run: {finer}")
        elif text_of(one).startswith("finer:"):
            runs.setdefault(parse_finer(text_of(one)), []).append((name, is_field))
        else:
            add(truth, name, is_field, one, scene, times, settings)
    for setting, served in runs.items():
        names = [name for name, is_field in served if is_field]
        add_run(truth, served, observe(setting.apply(scene), times, names))
    return truth


def text_of(given: Given) -> str:
    """A reference that was given as text; empty where it was not."""
    return os.fspath(given) if isinstance(given, str | os.PathLike) else ""


def serves_scalars(given: Given, is_own: bool) -> bool:
    """Whether a reference knows scalars of the history: runs do, functions given for one do."""
    text = text_of(given)
    return (
        isinstance(given, float | int)
        or text.startswith("finer:")
        or text.endswith(".vtkhdf")
        or (is_own and callable(given))
    )


def add(
    truth: Truth,
    name: str,
    is_field: bool,
    given: Given,
    scene: Scene,
    times: Sequence[float],
    settings: Sequence[Setting],
) -> None:
    """The reference of one quantity."""
    text = text_of(given)
    if text.endswith(".vtkhdf"):
        require_same_problem(text, scene, settings)
    if is_field:
        frames = text.endswith(".vtkhdf")
        truth.fields[name] = (
            from_frames(text, name) if frames else reference_of(given, scene, name, times)  # type: ignore[arg-type]
        )
    elif isinstance(given, float | int):
        truth.scalars[name] = Constant(float(given))
    elif text:
        truth.scalars[name] = series_of_run(text, name)
    else:
        truth.scalars[name] = given  # type: ignore[assignment]


def add_run(truth: Truth, quantities: Sequence[tuple[str, bool]], run: Observation) -> None:
    """A run as the reference of quantities."""
    for name, is_field in quantities:
        if is_field:
            truth.fields[name] = PointsReference(
                np.array([one.time for one in run.snapshots]),
                [one.position for one in run.snapshots],
                [one.fields[name] for one in run.snapshots],
            )
        else:
            run.scalar(name, 0.0)  # there is one
            truth.scalars[name] = Series(run.history["time"], run.history[name])
