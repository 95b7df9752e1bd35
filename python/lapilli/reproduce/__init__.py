"""The cases of the papers: paper, reference and lapilli side by side.

Each case is a `Case` in a module of this package and listed in `cases.py`.
"""

from lapilli.reproduce.case import Case, Row, quotient_within, within
from lapilli.reproduce.show import show_cases

__all__ = ["Case", "Row", "quotient_within", "show_cases", "within"]
