"""Notes: what a user should know of a scene, a run or a study, each with a code for good."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from lapilli import _core

KINDS = {code: (when, advice) for code, when, advice in _core.note_kinds()}


class Note(str):
    """The words, and a code ("heat.bridged-gap") that stays the same while words change.

    ``lapilli keys notes`` says of each code when it is said and what to do.
    """

    code: str

    def __new__(cls, text: str, code: str) -> Note:
        made = super().__new__(cls, text)
        made.code = code
        return made

    def __getnewargs__(self) -> tuple[str, str]:  # type: ignore[override]
        return str(self), self.code

    @property
    def line(self) -> str:
        """The words with the code behind them, where there is one."""
        return f"{self} [{self.code}]" if self.code else str(self)


def note(code: str, text: str) -> Note:
    """A note that Python says; its kind is in the list of all."""
    if code not in KINDS:
        raise KeyError(f"{code} has no entry in cpp/lapilli/core/note_kinds.hpp")
    return Note(text, code)


def notes_in(table: dict[str, Any], texts: str, codes: str) -> list[Note]:
    """The notes of a record or of `check --json`, which has words and codes beside each other."""
    said: Iterable[str] = table[texts]
    known = table.get(codes) or [""] * len(table[texts])  # records of earlier versions have none
    return [Note(text, code) for text, code in zip(said, known, strict=True)]


def kinds_as_markdown(wanted: str = "") -> str:
    """A table of all codes, or of one."""
    said = {wanted: KINDS[wanted]} if wanted else KINDS
    rows = [f"| `{code}` | {when} | {advice} |" for code, (when, advice) in said.items()]
    return "\n".join(["| code | said when | what to do |", "|---|---|---|", *rows]) + "\n"
