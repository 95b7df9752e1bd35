"""The mutants of the tables beside this file, and sources with all of them in."""

from __future__ import annotations

import hashlib
import itertools
import sys
from collections import defaultdict
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FOLDER = Path(__file__).parent
ROOT = FOLDER.parents[1]
LIBRARY = ROOT / "cpp" / "lapilli"
HEADER = LIBRARY / "core" / "mutant.hpp"
CHOICE = """#pragma once

#include <cstdlib>

namespace lapilli {

inline const int chosen_mutant = [] {
  const char* number = std::getenv("LAPILLI_MUTANT");
  return number != nullptr ? std::atoi(number) : 0;
}();

inline bool mutant(int number) { return chosen_mutant == number; }

}  // namespace lapilli
"""


@dataclass(frozen=True)
class Mutant:
    """One small change of one file."""

    number: int  # from 1
    area: str
    file: str
    find: str
    put: str
    near: str = ""  # text before the place, where `find` occurs more than once
    type: str = ""  # of both expressions, where C++ would not find it

    @property
    def key(self) -> str:
        words = "\0".join((self.area, self.file, self.near, self.find, self.put))
        return hashlib.sha256(words.encode()).hexdigest()[:16]

    @property
    def is_statement(self) -> bool:
        return self.find.endswith(";")

    def place(self, text: str) -> int:
        """Where the replaced text begins. Raises ``ValueError`` unless there is one such place."""
        if text.count(self.near) != 1 and self.near:
            raise ValueError(f"{self}: {self.near!r} occurs {text.count(self.near)} times")
        start = text.index(self.near) if self.near else 0
        found = text.count(self.find, start)
        if found == 0 or (found > 1 and not self.near):
            raise ValueError(f"{self}: occurs {found} times")
        return text.index(self.find, start)

    def __str__(self) -> str:
        return f"{self.file}: {self.find}  ->  {self.put}"


@cache
def tables() -> dict[str, dict[str, Any]]:
    """The tables by area."""
    return {path.stem: tomllib.loads(path.read_text()) for path in sorted(FOLDER.glob("*.toml"))}


def programs_of(area: str) -> list[str]:
    """The test programs of an area."""
    programs: list[str] = tables()[area]["programs"]
    return programs


def all_mutants() -> list[Mutant]:
    """Every mutant of every table."""
    every = [(area, row) for area, table in tables().items() for row in table["mutants"]]
    return [Mutant(number, area, **row) for number, (area, row) in enumerate(every, 1)]


def mutated_sources(mutants: list[Mutant]) -> dict[Path, str]:
    """The files that mutants change, each asking for the chosen one, and the header they ask."""
    by_file = defaultdict(list)
    for mutant in mutants:
        by_file[mutant.file].append(mutant)
    sources = {LIBRARY / file: mutated(LIBRARY / file, own) for file, own in by_file.items()}
    return sources | {HEADER: CHOICE}


def mutated(path: Path, mutants: list[Mutant]) -> str:
    """A file with all of its mutants in."""
    text = path.read_text()
    at_place = defaultdict(list)
    for mutant in mutants:
        at_place[mutant.place(text), len(mutant.find)].append(mutant)
    ends = sorted((begin, begin + size) for begin, size in at_place)
    for (_, end), (begin, _) in itertools.pairwise(ends):
        if begin < end:
            raise ValueError(f"{path.name}: two mutants overlap at {text[begin:end]!r}")
    for (begin, size), own in sorted(at_place.items(), reverse=True):
        text = text[:begin] + choice(own, text[begin : begin + size]) + text[begin + size :]
    return '#include "lapilli/core/mutant.hpp"\n' + text


def choice(mutants: list[Mutant], text: str) -> str:
    """C++ that does what the chosen of these mutants puts in place of a text."""
    for mutant in mutants:
        asks = f"lapilli::mutant({mutant.number})"
        if mutant.is_statement:
            text = f"if ({asks}) {{ {mutant.put} }} else {{ {text} }}"
        elif mutant.type:
            text = f"({asks} ? {mutant.type}({mutant.put}) : {mutant.type}({text}))"
        else:
            text = f"({asks} ? ({mutant.put}) : ({text}))"
    return text
