"""lapilli suggest: right about error and cost, and silent where it cannot tell."""

import json
import math
import shlex
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli import examples
from lapilli.cli import main
from lapilli.study import InProcess, Suggestion, suggest
from lapilli.study.cost import Cost
from lapilli.study.ladder import Climb, Grade, Judge, Ladder, Rung
from lapilli.study.measure import Task
from lapilli.study.observe import Observation, Snapshot
from lapilli.study.settings import Setting
from lapilli.study.suggest_show import seconds_of, text_of
from lapilli.study.truth import truth_of


def true_error(scene: lp.Scene, setting: Setting, reference: object, field: str) -> float:
    """The error of a setting against a reference that `suggest` does not know."""
    times = (scene.time.end,)
    kinds = ((field, True),)
    truth = truth_of(reference, setting.apply(scene), kinds, times, [setting])
    error = Task(scene, setting, 0, truth, kinds, times)().error
    assert error is not None
    return error


@pytest.mark.parametrize(
    ("name", "changes", "target", "reference", "field"),
    [
        ("vhfm/ring", ["time.end=1", "grid.cell=0.4"], 1e-3, "radial", "temperature"),
        ("vhfm/ring", ["time.end=1", "grid.cell=0.2"], 1e-2, "radial", "temperature"),
        ("vhfm/ring_flux", ["time.end=1", "grid.cell=0.4"], 2e-3, "radial", "temperature"),
        ("vhfm/square", ["time.end=5", "grid.cell=0.4", "grid.lower=[-8,-8]", "grid.upper=[8,8]"],
         1e-3, "slab", "temperature"),
        ("ib/annulus", ["grid.cell=0.016"], 1e-5, "lapilli.references.supports:annulus",
         "displacement"),
    ],
)  # fmt: skip
def test_suggestions_are_right_within_a_factor_of_two(
    name: str, changes: list[str], target: float, reference: str, field: str
) -> None:
    scene = examples.load(name)
    for change in changes:
        scene = scene.set(change)
    found = suggest(scene, target, runner=InProcess(), budget=20)
    assert found.grade is not None, found.reason
    assert found.spent <= 25
    true = true_error(scene, found.setting, reference, field)
    assert true <= 1.2 * target
    assert 0.5 * found.grade.error <= true <= 2 * found.grade.error
    assert found.grade.low <= true <= found.grade.high


def rung(cell: float, value: float) -> Rung:
    """A run that gave one number."""
    history = {"time": np.array([0.0, 1.0]), "x": np.array([0.0, value])}
    shot = Snapshot(1.0, np.zeros((1, 2)), np.ones(1), {})
    seen = Observation([shot], history, {}, Cost(cell**-2, 0, cell**-2, 1, 1, 1))
    return Rung(Setting((("grid.cell", repr(cell)),)), cell, seen)


def ladder(errors: list[float]) -> Ladder:
    """Runs of a number whose truth is 1, each cell half of the former."""
    made = Ladder(Judge("x", False, (1.0,)))
    made.rungs = [rung(2.0**-k, 1 + error) for k, error in enumerate(errors)]
    return made


def test_second_order_is_graded_and_extrapolated_exactly() -> None:
    made = ladder([0.64, 0.16, 0.04, 0.01])
    assert [one.error for one in made.graded()] == pytest.approx([0.64, 0.16, 0.04], rel=1e-9)
    assert made.orders() == pytest.approx([2, 2])
    assert made.falls_as_it_should()
    assert made.finest_error() == pytest.approx(0.01)
    assert made.growth("total_cpu_seconds") == pytest.approx(4)


@pytest.mark.parametrize(
    "errors",
    [
        [0.0025, 0.0022, 0.00025, 0.0002],  # the fill of a turned body changes with its cells
        [0.5, 0.4, 0.3, 0.2],  # not yet converging
        [0.8, 0.4, 0.2, 0.1],  # first order
        [0.1, 0.025, 0.0251, 0.0250],  # a floor
        [0.64, 0.16, 0.04],  # two differences tell no trend
        [0.1, -0.1, 0.1, -0.1],
    ],
)
def test_what_does_not_fall_as_it_should_is_not_extrapolated(errors: list[float]) -> None:
    assert not ladder(errors).falls_as_it_should()


def test_other_settings_carry_the_error_of_their_judge() -> None:
    """One that errs as its judge does differs little from it, and is not thought exact."""
    made = ladder([0.64, 0.16, 0.04, 0.01])
    twin = made.grade_other(rung(0.25, 1.01))
    assert twin.error == pytest.approx(0.01, rel=1e-6)
    for error in (0.04, -0.04, 0.02):
        other = made.grade_other(rung(0.25, 1 + error))
        assert other.low * (1 - 1e-9) <= abs(error) <= other.high * (1 + 1e-9)
        assert 0.5 <= abs(error) / other.error <= 2


def test_first_order_is_seen_and_graded_as_such() -> None:
    made = ladder([0.8, 0.4, 0.2, 0.1])
    assert made.order() == 1
    assert [one.error for one in made.graded()] == pytest.approx([0.8, 0.4, 0.2], rel=1e-9)
    assert ladder([0.64, 0.16, 0.04, 0.01]).order() == 2


def test_a_first_order_error_lies_in_the_range_of_its_grade() -> None:
    for grade, true in zip(ladder([0.8, 0.4, 0.2, 0.1]).graded(), [0.8, 0.4, 0.2], strict=True):
        assert grade.low <= true <= grade.high * (1 + 1e-9)


class Pretended:
    """Runs of a number whose error and cost depend on the cell as they are told to."""

    def __init__(self, error: Callable[[float], float], seconds: Callable[[float], float]) -> None:
        self.error, self.seconds = error, seconds

    def run(self, tasks: Sequence[Climb]) -> Iterator[Rung]:
        for task in tasks:
            value = 1 + self.error(task.cell)
            history = {"time": np.array([0.0, 1.0]), "temperature/largest": np.array([0, value])}
            shot = Snapshot(1.0, np.zeros((1, 2)), np.ones(1), {})
            own = {"grid.cell", "heat.tolerance"}  # of the ladder; variants are slower
            slow = 1.0 if dict(task.setting.changes).keys() <= own else 3.0
            cost = Cost(slow * self.seconds(task.cell), 0, 1, 1, 1, 1000)
            yield Rung(task.setting, task.cell, Observation([shot], history, {}, cost))


def pretended(
    ring: lp.Scene,
    target: float,
    budget: float,
    error: Callable[[float], float],
) -> Suggestion:
    """Cells of 2, 1, 0.5, ... m; the run at 1 m takes a second, each finer one 16 times as long."""
    runner = Pretended(error, lambda cell: cell**-4)
    return suggest(ring, target, quantity="temperature/largest", budget=budget, runner=runner)


def test_beyond_the_budget_second_order_is_extrapolated(ring: lp.Scene) -> None:
    """Runs at 2, 1, 0.5, 0.25 m take 273 s; 3e-2, less a margin for what was not run, needs
    0.125 m."""
    found = pretended(ring, 3e-2, 300, lambda cell: cell**2)
    assert found.grade is not None
    assert not found.was_run
    assert dict(found.setting.changes)["grid.cell"] == "0.125"
    assert found.grade.error == pytest.approx(0.125**2, rel=1e-6)
    assert found.grade.low < 0.125**2 < found.grade.high
    assert found.cpu_seconds == pytest.approx(0.125**-4, rel=1e-6)
    assert found.spent < 300
    # further than two halvings is too far
    assert pretended(ring, 1e-4, 300, lambda cell: cell**2).grade is None


def test_within_the_budget_the_coarsest_that_reaches_is_taken(ring: lp.Scene) -> None:
    found = pretended(ring, 0.3, 300, lambda cell: cell**2)
    assert found.was_run
    assert dict(found.setting.changes)["grid.cell"] == "0.5"
    assert found.grade is not None
    assert found.grade.error == pytest.approx(0.25, rel=1e-6)


@pytest.mark.parametrize(
    "error",
    [
        lambda cell: 0.3 + 0.05 * cell,  # far from converging
        lambda cell: cell**2 if cell > 0.4 else 0.9 * cell,  # the order changes
        lambda cell: 0.1 * math.cos(40 * cell),  # up and down
        lambda cell: 0.2 * cell,  # first order
        lambda cell: {2.0: 0.1, 1.0: 0.0975, 0.5: 0.096, 0.25: 0.07}.get(cell, 0.06),
    ],
)
def test_errors_that_do_not_fall_as_they_should_are_never_extrapolated(
    ring: lp.Scene, error: Callable[[float], float]
) -> None:
    found = pretended(ring, 2e-3, 300, error)
    assert found.grade is None
    assert "cannot tell within 300 CPU s" in found.reason
    assert "orders of the differences are" in found.reason


def test_a_cell_that_is_right_by_chance_is_not_taken(ring: lp.Scene) -> None:
    """The run at 1 m happens to be near the finest; at 0.5 m it is not."""
    errors = {2.0: 0.8, 1.0: 0.013, 0.5: 0.05, 0.25: 0.0125}
    found = pretended(ring, 0.06, 300, lambda cell: errors[cell])
    assert found.grade is not None
    assert dict(found.setting.changes)["grid.cell"] == "1.0"  # all from here on are within 0.06
    narrow = pretended(ring, 0.02, 300, lambda cell: errors[cell])
    assert narrow.grade is None


def test_a_target_out_of_reach_says_what_was_reached(
    ring: lp.Scene, capsys: pytest.CaptureFixture[str]
) -> None:
    ring.save("ring.toml")
    words = ["suggest", "ring.toml", "--target-error", "1e-12", "--budget", "0.3s"]
    assert main(words) == 1
    said = capsys.readouterr().err
    assert "cannot tell within 0.3 CPU s" in said
    assert "errs by" in said


def test_the_command_prints_a_run_and_draws_it(
    ring: lp.Scene, capsys: pytest.CaptureFixture[str]
) -> None:
    ring.save("ring.toml")
    assert main(["suggest", "ring.toml", "--target-error", "2e-2"]) == 0
    shown = capsys.readouterr().out
    assert shown.startswith("lapilli run ring.toml --set grid.cell=")
    assert "rms error of temperature" in shown
    assert Path("ring-suggest.png").read_bytes().startswith(b"\x89PNG")
    command = shown.splitlines()[0].split()[1:]
    assert main([*command, "-q"]) == 0  # it runs as it is
    # and keeps the changes that were asked for
    assert main(["suggest", "ring.toml", "--set", "time.end=0.5", "--target-error", "2e-2"]) == 0
    assert "--set time.end=0.5 --set grid.cell=" in capsys.readouterr().out
    assert main(["suggest", "ring.toml", "--target-error", "2e-2", "--json", "-q"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["error"] <= 2e-2
    assert found["cpu_seconds"] > 0
    assert found["runs"]


def test_scalars_may_be_the_target(ring: lp.Scene) -> None:
    found = suggest(ring, 0.02, quantity="temperature/largest", norm="relative",
                    runner=InProcess(), budget=10)  # fmt: skip
    assert found.grade is not None
    fine = lp.run(ring.set("grid.cell=0.1"), progress=False).history["temperature/largest"][-1]
    value = lp.run(found.setting.apply(ring), progress=False).history["temperature/largest"][-1]
    assert abs(value / fine - 1) <= 0.02


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--target-error", "0"], "above 0"),
        (["--target-error", "1", "--quantity", "temprature"], "did you mean 'temperature'"),
        (["--target-error", "1", "--budget", "soon"], "s, min or h"),
        (["--target-error", "1", "--budget", "-1"], "budget"),
    ],
)
def test_mistakes(
    ring: lp.Scene, words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    ring.save("ring.toml")
    assert main(["suggest", "ring.toml", *words]) == 2
    assert says in capsys.readouterr().err


def test_budgets_are_times() -> None:
    assert [seconds_of(text) for text in ("90", "90s", "1.5min", "2h")] == [90, 90, 90, 7200]
    assert math.isclose(seconds_of("1e-1 s"), 0.1)


def test_the_command_that_is_suggested_runs_whatever_the_name_of_the_scene() -> None:
    made = ladder([0.04, 0.01])
    made.rungs = [replace(one, seen=replace(one.seen, units={"x": "m"})) for one in made.rungs]
    grade = Grade(made.rungs[-1], 1e-3, 5e-4, 2e-3, "against a finer run")
    found = Suggestion(1e-2, made.judge, grade, "", 1.0, 1.0, 1e6, True, 1.0, made)
    said = text_of(found, "my scenes/Kühl 'a'.toml", ["title=a b"])
    assert shlex.split(said.splitlines()[0]) == [
        "lapilli", "run", "my scenes/Kühl 'a'.toml", "--set", "title=a b", "--set", "grid.cell=0.5",
    ]  # fmt: skip
