"""Which cases there are; a case is imported when it is asked for."""

from __future__ import annotations

import importlib
from collections.abc import Sequence

from lapilli.reproduce.case import Case
from lapilli.words import chosen

# name of the case -> module that holds it as CASE
MODULES: dict[str, str] = {
    "vhfm/rod": "lapilli.reproduce.vhfm.rod",
    "vhfm/ring": "lapilli.reproduce.vhfm.ring",
    "vhfm/sphere": "lapilli.reproduce.vhfm.sphere",
    "vhfm/square": "lapilli.reproduce.vhfm.square",
    "vhfm/fan": "lapilli.reproduce.vhfm.fan",
    "vhfm/column": "lapilli.reproduce.vhfm.column",
    "pd/conduction": "lapilli.reproduce.pd.conduction",
    "pd/cavity": "lapilli.reproduce.pd.cavity",
    "pd/benard": "lapilli.reproduce.pd.benard",
    "pd/thermals": "lapilli.reproduce.pd.thermals",
    "soil/collapse": "lapilli.reproduce.soil.collapse",
    "ib/block": "lapilli.reproduce.ib.block",
    "ib/beam": "lapilli.reproduce.ib.beam",
    "ib/shear": "lapilli.reproduce.ib.shear",
    "ib/cantilever": "lapilli.reproduce.ib.cantilever",
    "ib/footing": "lapilli.reproduce.ib.footing",
    "ib/funnel": "lapilli.reproduce.ib.funnel",
    "ib/annulus": "lapilli.reproduce.ib.annulus",
    "ib/column": "lapilli.reproduce.ib.column",
    "ib/block3d": "lapilli.reproduce.ib.block3d",
    "ib/forms": "lapilli.reproduce.ib.forms",
}


def names(wanted: Sequence[str]) -> list[str]:
    """The cases of these names or groups ("vhfm"); all where none is named."""
    return chosen("case", wanted, list(MODULES))


def load(name: str) -> Case:
    """One case."""
    case: Case = importlib.import_module(MODULES[name]).CASE
    return case
