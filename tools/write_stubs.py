"""Write python/lapilli/_core.pyi from the compiled module, or to a folder given as argument."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

TARGET = Path(__file__).resolve().parents[1] / "python" / "lapilli" / "_core.pyi"

# What the generator says in a way that type checkers do not accept.
MENDED = {
    "(self: typing.Union": "(self",
    "__hash__: typing.ClassVar[None] = None": (
        "__hash__: typing.ClassVar[None]  # type: ignore[assignment]"
    ),
    "(*args, **kwargs):": "(*args: typing.Any, **kwargs: typing.Any) -> typing.Any:",
}


def stubs() -> str:
    """The stub file that belongs to the module as it is now."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["pybind11_stubgen", "lapilli._core", "--output-dir", folder, "--exit-code"]
        subprocess.run([sys.executable, "-m", *command], check=True, capture_output=True)
        text = (Path(folder) / "lapilli" / "_core.pyi").read_text()
    for said, meant in MENDED.items():
        text = text.replace(said, meant)
    return text


if __name__ == "__main__":
    TARGET.write_text(stubs())
