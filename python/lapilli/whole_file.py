"""Write files that appear all at once, or not at all."""

from __future__ import annotations

import contextlib
import os
import tempfile
import uuid
from collections.abc import Iterable, Iterator
from pathlib import Path


@contextlib.contextmanager
def whole_file(path: str | os.PathLike[str]) -> Iterator[Path]:
    """A name beside `path` with the same ending, to be written to.

    When the block ends, what was written takes the place of `path`; when it fails, a former file
    stays as it was and nothing remains. Devices and pipes take the bytes when all are there.
    """
    target = Path(path).resolve()
    if target.exists() and not target.is_file():
        with tempfile.TemporaryDirectory() as folder:
            made = Path(folder) / f"made{target.suffix or Path(path).suffix}"
            yield made
            # Some libraries put an ending to a name without one.
            (written,) = Path(folder).iterdir()
            with target.open("wb", buffering=0) as device:
                device.write(written.read_bytes())
        return
    written = target.with_name(f"{target.stem}.{uuid.uuid4().hex[:12]}{target.suffix}")
    try:
        yield written
        descriptor = os.open(written, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
        os.replace(written, target)
    finally:
        written.unlink(missing_ok=True)


def require_apart(
    targets: Iterable[str | os.PathLike[str]], inputs: Iterable[str | os.PathLike[str]]
) -> None:
    """Refuse to write over what is read, by whatever name."""
    read = [Path(given) for given in inputs]
    for target in map(Path, targets):
        for given in read:
            if target.exists() and given.exists() and target.samefile(given):
                raise ValueError(f"{given} is read here and would be written over: choose another")


def write_text(path: str | os.PathLike[str], text: str) -> None:
    """Write `text` as a whole file."""
    with whole_file(path) as written:
        written.write_text(text)
