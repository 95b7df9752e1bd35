"""The truth of every quantity of a study: of fields by position and time, of scalars by time."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from lapilli._core import Scene
from lapilli.note import Note, note
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
from lapilli.study.shipped import SHIPPED

Array = npt.NDArray[Any]
Given = str | os.PathLike[str] | Function | Reference | float | None


@dataclass(frozen=True)
class Truth:
    """References of fields and of scalars, by name, and what should be said of them."""

    fields: dict[str, Reference] = field(default_factory=dict)
    scalars: dict[str, Callable[[float], float]] = field(default_factory=dict)
    notes: list[Note] = field(default_factory=list)


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

    For what no reference serves, and where none is given, the scene is run finer than all settings.
    """
    by_name = given if isinstance(given, Mapping) else shared(given, quantities)
    truth = Truth()
    runs: dict[Setting, list[tuple[str, bool]]] = {}
    finer = finer_setting(scene, settings)
    for name, is_field in quantities:
        one = by_name.get(name)
        if one is None:
            runs.setdefault(finer, []).append((name, is_field))
            words = f"the error of {name} is that against a finer run: {finer}"
            truth.notes.append(note("study.finer-reference", words))
        elif text_of(one).startswith("finer:"):
            runs.setdefault(parse_finer(text_of(one)), []).append((name, is_field))
        else:
            add(truth, name, is_field, one, scene, times, settings)
    for setting, served in runs.items():
        names = [name for name, is_field in served if is_field]
        add_run(truth, served, observe(setting.apply(scene), times, names))
    return truth


def shared(given: Given, quantities: Sequence[tuple[str, bool]]) -> dict[str, Given]:
    """The quantities that one reference serves: a run all; a shipped reference its own field; a
    function the first field, a number or a table the first scalar."""
    text = text_of(given)
    if given is None:
        return {}
    if text.startswith("finer:") or text.endswith(".vtkhdf"):
        return {name: given for name, _ in quantities}
    if text in SHIPPED:
        known = "velocity" if text.endswith("velocity") else "temperature"
        if not any(name == known for name, _ in quantities):
            raise ValueError(f"reference {text} knows the {known}, not {quantities[0][0]}")
        return {known: given}
    first = next((name for name, is_field in quantities if is_field != is_scalar(given)), None)
    if first is None:
        kind = "a scalar of the history" if is_scalar(given) else "a field"
        raise ValueError(f"reference {named(given)} is one of {kind}, and none is asked for")
    return {first: given}


def is_scalar(given: Given) -> bool:
    """Whether a reference is a number."""
    return isinstance(given, float | int)


def named(reference: object) -> str:
    """A reference as text."""
    if isinstance(reference, Mapping):
        return str({name: named(one) for name, one in reference.items()})
    return str(reference) if isinstance(reference, str | os.PathLike) else repr(reference)


def text_of(given: Given) -> str:
    """A reference that was given as text; empty where it was not."""
    return os.fspath(given) if isinstance(given, str | os.PathLike) else ""


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
