"""Runs of every method at their automatic steps at the extremes: right, or not silently wrong."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

import lapilli as lp
from lapilli._core import RunError
from lapilli.cli import main
from lapilli.extremes import Outcome
from lapilli.extremes.cases import Case, square
from lapilli.extremes.survey import Judged, Steps, survey
from lapilli.extremes.trials import Mark, Trial, all_trials

EVERY = list(all_trials())
# A tenth of them here, all in `lapilli extremes`.
SOME = EVERY[3::10]


def name_of(trial: Trial) -> str:
    return f"{trial.group}: {trial.name}"


def test_names_are_unique_and_groups_those_of_the_command(capsys: pytest.CaptureFixture[str]):
    assert len({(one.group, one.name) for one in EVERY}) == len(EVERY) > 100
    with pytest.raises(SystemExit):
        main(["extremes", "--only", "nothing"])
    said = capsys.readouterr().err
    assert all(f'"{one.group}"' in said or f"'{one.group}'" in said for one in EVERY)


@pytest.mark.parametrize("trial", SOME, ids=name_of)
def test_nothing_is_unstable_or_silently_wrong(trial: Trial) -> None:
    verdict = trial()
    assert not verdict.is_silent, verdict.text()


def judged_by(value: float, scene: lp.Scene) -> list[Mark]:
    del scene
    return [Mark("error", value, 1.0)]


def failing(error: Exception, scene: lp.Scene) -> list[Mark]:
    del scene
    raise error


def test_what_misses_its_bar_is_told_from_what_says_so_and_from_what_fails() -> None:
    trial = next(one for one in EVERY if one.group == "heat")
    kept = replace(trial, judge=partial(judged_by, 0.5))()
    assert (kept.outcome, kept.is_silent, kept.said) == (Outcome.STABLE, False, ())
    missed = replace(trial, judge=partial(judged_by, float("nan")))()
    assert (missed.outcome, missed.is_silent) == (Outcome.INACCURATE, True)
    grown = replace(trial, judge=partial(judged_by, 2.0), unstable=("error",))()
    assert (grown.outcome, grown.is_silent) == (Outcome.UNSTABLE, True)
    fails = replace(trial, judge=partial(failing, RunError("step 3: broke")))()
    assert (fails.outcome, fails.reason) == (Outcome.UNSTABLE, "step 3: broke")
    refused = replace(trial, judge=partial(failing, ValueError("not so")))()
    assert (refused.outcome, refused.is_silent) == (Outcome.REFUSED, False)
    warned = next(one for one in EVERY if "x 1e-06" in one.name)()
    assert (warned.outcome, warned.is_silent) == (Outcome.INACCURATE, False)
    assert "coarse" in warned.text()


def test_a_survey_that_was_stopped_goes_on(tmp_path: Path) -> None:
    work = [Judged(one) for one in EVERY if one.group == "static"][:3]
    kept = tmp_path / "kept.jsonl"
    survey(work[:2], kept=kept)
    done: list[str] = []
    found = survey(work, kept=kept, report=lambda at, among, name: done.append(name))
    assert done == [work[2].name]
    assert set(found) == {one.name for one in work}
    assert survey(work, workers=2) == {
        name: {**one, "seconds": pytest.approx(one["seconds"], abs=10)}
        for name, one in found.items()
    }


def test_what_a_quick_survey_kept_does_not_stand_for_a_whole_one(tmp_path: Path) -> None:
    case, kept = Case("lattice", "flip", square("flip", 1.0), True), tmp_path / "kept.jsonl"
    quick, whole = Steps(case, (1.0,)), Steps(case, (0.5, 1.0))
    assert len(quick.rows(survey([quick], kept=kept)[quick.name])) == 1
    assert len(whole.rows(survey([whole], kept=kept)[whole.name])) == 2


def test_the_command_draws_and_writes_a_group(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    static = [one for one in EVERY if one.group == "static"][:4]
    monkeypatch.setattr("lapilli.extremes.show.all_trials", lambda: iter(static))
    rows = tmp_path / "rows.json"
    assert main(["extremes", "--only", "static", "--json", str(rows), "--plot", str(tmp_path)]) == 0
    assert len(json.loads(rows.read_text())) == 4
    assert (tmp_path / "extremes_trials.png").stat().st_size > 1000
    assert "error of the displacement" in capsys.readouterr().out
