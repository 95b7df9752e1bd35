"""The map of steps tells stable from refused."""

import pytest

from lapilli.cli import main
from lapilli.extremes import Case, Outcome, all_cases, measure
from lapilli.extremes.cases import TRANSFERS, square


def test_automatic_step_is_stable_and_steps_past_the_limit_are_refused() -> None:
    case = Case("lattice", "flip", square("flip", 1.0), True)
    rows = {row.factor: row for row in measure(case, (0.5, 1.0, 4.0))}
    assert rows[0.5].outcome is Outcome.STABLE
    assert rows[1.0].outcome is Outcome.STABLE
    assert rows[4.0].outcome is Outcome.REFUSED
    assert "limit" in rows[4.0].reason
    # Steps are compared with fine ones: the larger step errs more.
    assert rows[0.5].error is not None
    assert rows[1.0].error is not None
    assert 0.0 < rows[0.5].error < rows[1.0].error


def test_soil_is_stable_at_its_automatic_step_and_refused_beyond_its_limit() -> None:
    case = next(case for case in all_cases(("dynamics",)) if case.name == "gimp, musl")
    rows = {row.factor: row for row in measure(case, (0.5, 1.0, 4.0))}
    assert rows[0.5].outcome is rows[1.0].outcome is Outcome.STABLE
    assert rows[4.0].outcome is Outcome.REFUSED


def test_a_flow_is_run_until_sound_has_had_time_to_grow() -> None:
    case = next(case for case in all_cases(("peridynamics",)) if case.name == "flow, Ra 1e+03")
    rows = {row.factor: row for row in measure(case, (1.0, 1.9, 3.0))}
    assert case.length >= 600
    assert rows[1.0].outcome is Outcome.STABLE
    assert rows[1.9].outcome is Outcome.STABLE
    assert rows[3.0].outcome is Outcome.REFUSED


def test_every_transfer_has_cases_and_only_moving_ones_swirl() -> None:
    cases = list(all_cases())
    assert len({(case.transfer, case.name) for case in cases}) == len(cases)
    assert {case.transfer for case in cases} == set(TRANSFERS)
    assert not any(case.transfer == "nodal" and "swirl" in case.name for case in cases)


def test_command_rejects_an_unknown_transfer() -> None:
    with pytest.raises(SystemExit) as stop:
        main(["extremes", "--transfer", "nothing"])
    assert stop.value.code == 2
