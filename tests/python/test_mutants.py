"""The table of `make mutate` fits the sources as they are."""

import sys
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from mutants.table import (  # noqa: E402
    LIBRARY,
    Mutant,
    all_mutants,
    mutated,
    mutated_sources,
    programs_of,
    tables,
)

sys.path.remove(str(ROOT / "tools"))


def test_every_mutant_has_its_place() -> None:
    every = all_mutants()
    assert len(every) >= 80
    sources = mutated_sources(every)
    asked = sum(text.count("lapilli::mutant(") for text in sources.values())
    assert asked == len(every)
    assert max(Counter(mutant.key for mutant in every).values()) == 1
    assert all(mutant.find != mutant.put for mutant in every)


def test_every_area_has_a_program_of_tests() -> None:
    folders = {path.name for path in (ROOT / "tests" / "cpp").iterdir() if path.is_dir()}
    for area in tables():
        assert {name.removeprefix("test_") for name in programs_of(area)} <= folders


@pytest.mark.parametrize("find", ["no such text", "lapilli"])
def test_a_text_must_occur_once(find: str) -> None:
    file = "core/simulation.cpp"
    with pytest.raises(ValueError, match="occurs"):
        mutated(LIBRARY / file, [Mutant(1, "core", file, find, "")])
