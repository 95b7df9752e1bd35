"""Scenes at their automatic steps at the extremes, each with its judge."""

from collections.abc import Callable, Iterator

from lapilli.extremes.trials.contact import contact_trials
from lapilli.extremes.trials.fluid import fluid_trials
from lapilli.extremes.trials.heat import heat_trials
from lapilli.extremes.trials.soil import soil_trials
from lapilli.extremes.trials.static import static_trials
from lapilli.extremes.trials.trial import Mark, Trial, Verdict
from lapilli.extremes.trials.vibration import vibration_trials

__all__ = ["TRIALS", "Mark", "Trial", "Verdict", "all_trials"]

TRIALS: tuple[Callable[[], Iterator[Trial]], ...] = (
    heat_trials,
    vibration_trials,
    soil_trials,
    contact_trials,
    static_trials,
    fluid_trials,
)


def all_trials() -> Iterator[Trial]:
    """Every trial of every group."""
    for some in TRIALS:
        yield from some()
