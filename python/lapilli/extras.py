"""Packages that are used where they are installed, and are not needed otherwise."""

from __future__ import annotations

import importlib
from typing import Any


def required(package: str, purpose: str, extra: str = "") -> Any:
    """The module, imported. Raises ``ValueError`` that says how to install it."""
    try:
        return importlib.import_module(package)
    except ImportError as error:
        name = f"'lapilli[{extra}]'" if extra else package.partition(".")[0]
        raise ValueError(
            f"{purpose} needs {package.partition('.')[0]}: pip install {name}"
        ) from error
