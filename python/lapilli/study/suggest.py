"""The cheapest setting of a scene within an error, without a reference: `lapilli suggest`."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence

from lapilli import _core
from lapilli._core import Scene
from lapilli.study.ladder import Judge
from lapilli.study.norms import NORMS
from lapilli.study.observe import names_of
from lapilli.study.quantity import parted
from lapilli.study.runner import LocalPool, Runner
from lapilli.study.search import Search, Suggestion, Tell

__all__ = ["Suggestion", "suggest"]


def suggest(
    scene: Scene | str | os.PathLike[str],
    target_error: float,
    *,
    quantity: str | None = None,
    times: Sequence[float] | None = None,
    norm: str = "rms",
    budget: float = 120.0,
    threads: int = 1,
    runner: Runner | None = None,
    tell: Tell = lambda text: None,
) -> Suggestion:
    """Find the cheapest setting whose error is within a target.

    A ladder of cheap runs, each with half of the cell (and of the steps, where the scene sets
    them) of the one before, is graded by its finest. At the cell that reaches the target other
    settings are tried and graded likewise. Where the budget ends first, the error is extrapolated
    with the design order if the last differences fall with it; otherwise nothing is suggested, and
    the reason says what was reached.

    Parameters
    ----------
    quantity
        A field or a scalar of the history; temperature, displacement or velocity unless given.
    times
        When the error counts, s; the end of the scene unless given.
    norm
        rms, max, mean or relative.
    budget
        CPU seconds for all runs together.
    tell
        Called with a line after each run.
    """
    scene = scene if isinstance(scene, Scene) else Scene.load(os.fspath(scene))
    if not (math.isfinite(target_error) and target_error > 0):
        raise ValueError(f"the target error must be above 0, got {target_error:g}")
    if not budget > 0:
        raise ValueError(f"the budget must be above 0 s, got {budget:g}")
    if norm not in NORMS:
        raise ValueError(_core.unknown_name("norm", norm, list(NORMS)))
    moments = tuple(sorted(times)) if times is not None else (scene.time.end,)
    judge = judge_of(scene, quantity, moments, norm)
    search = Search(scene, judge, target_error, budget, threads, runner or LocalPool(), tell)
    return search.run()


def judge_of(scene: Scene, quantity: str | None, times: tuple[float, ...], norm: str) -> Judge:
    """What is judged: the field that the scene is about unless named."""
    fields, units = names_of(scene, [] if quantity is None else [quantity])
    if quantity is None:
        usual = ("temperature", "displacement", "velocity")
        quantity = next((one for one in usual if one in fields), fields[0])
    return Judge(quantity, bool(parted([quantity], fields, units)), times, norm)
