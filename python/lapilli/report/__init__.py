"""A run as one page of HTML that needs nothing else."""

from lapilli.report.page import write_report

__all__ = ["write_report"]
