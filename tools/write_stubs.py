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

# The generator on the classes as they are compiled, without what Python adds to them.
GENERATE = """
import sys
from lapilli import _core
from pybind11_stubgen import main
for made in vars(_core).values():
    if isinstance(made, type):
        for name in ("__init__", "__setattr__"):
            if hasattr(vars(made).get(name), "__wrapped__"):
                setattr(made, name, vars(made)[name].__wrapped__)
        if "_repr_html_" in vars(made):
            del made._repr_html_
sys.argv = ["pybind11_stubgen", "lapilli._core", "--exit-code", "--output-dir", sys.argv[1]]
main()
"""


def stubs() -> str:
    """The stub file that belongs to the module as it is now."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-c", GENERATE, folder]
        subprocess.run(command, check=True, capture_output=True)
        text = (Path(folder) / "lapilli" / "_core.pyi").read_text()
    for said, meant in MENDED.items():
        text = text.replace(said, meant)
    return text


if __name__ == "__main__":
    TARGET.write_text(stubs())
