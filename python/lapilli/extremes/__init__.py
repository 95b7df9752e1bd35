"""Which steps are stable: every extreme case over a range of step sizes."""

from lapilli.extremes.cases import Case, all_cases
from lapilli.extremes.steps import Outcome, Row, measure

__all__ = ["Case", "Outcome", "Row", "all_cases", "measure"]
