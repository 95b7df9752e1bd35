"""Implicit boundaries where they are hardest: slivers, bandwidths, walls on nodes and faces."""

import pytest

from lapilli.extremes.steps import Outcome
from lapilli.extremes.supports import FORMS, is_astray, measure_support, support_cases


@pytest.mark.parametrize("form", FORMS)
def test_uniform_stress_at_the_extremes(form: str) -> None:
    """Rounding over the bandwidth; 2e-8 in slivers down to 1e-13 cells. Only Nitsche's form may be
    refused, in slivers, where it is not coercive."""
    rows = [measure_support(case) for case in support_cases([form])]
    assert not [row for row in rows if is_astray(row)]
    assert any(row.outcome is Outcome.REFUSED for row in rows) == (form == "nitsche")
