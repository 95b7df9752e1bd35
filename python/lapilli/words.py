"""Names that users give: what a misspelt one was meant for, groups of names."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence


def meant(word: str, known: Iterable[str]) -> str:
    """The name that was meant by a word that is none, or all names."""
    names = list(known)
    near = difflib.get_close_matches(word, names, 1)
    return f"did you mean '{near[0]}'?" if near else f"there is: {', '.join(names)}"


def chosen(kind: str, wanted: Sequence[str], known: Sequence[str]) -> list[str]:
    """The names, or groups of names ("vhfm"), that were asked for; all where nothing was."""
    found: list[str] = []
    for one in wanted or [""]:
        group = one.rstrip("/") + "/"
        here = [name for name in known if not one or name == one or name.startswith(group)]
        if not here:
            raise ValueError(f"no {kind} {one!r}; {meant(one, known)}")
        found += [name for name in here if name not in found]
    return found
