"""Scenes written by Python: whole or not at all, and over nothing but what was named."""

import os
import stat
from pathlib import Path

import pytest

import lapilli as lp


def test_files_beside_it_are_left_alone(ring: lp.Scene, tmp_path: Path) -> None:
    beside = tmp_path / "ring.toml.tmp"
    beside.write_text("mine")
    ring.save(tmp_path / "ring.toml")
    assert beside.read_text() == "mine"
    assert sorted(os.listdir(tmp_path)) == ["ring.toml", "ring.toml.tmp"]


def test_a_link_stays_one(ring: lp.Scene, tmp_path: Path) -> None:
    (tmp_path / "store").mkdir()
    target = tmp_path / "store" / "ring.toml"
    target.write_text("")
    link = tmp_path / "ring.toml"
    link.symlink_to(target)
    ring.save(link)
    assert link.is_symlink()
    assert lp.Scene.load(target) == ring


def test_a_pipe_takes_the_bytes(ring: lp.Scene, tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    ring.save(pipe)
    assert os.read(reader, 1 << 16).decode() == ring.to_toml()
    os.close(reader)
    assert stat.S_ISFIFO(pipe.stat().st_mode)


@pytest.mark.parametrize("place", ["", "missing/ring.toml", "/dev/full"])
def test_what_cannot_be_written_is_an_error_of_output(
    ring: lp.Scene, tmp_path: Path, place: str
) -> None:
    with pytest.raises(lp.OutputError):
        ring.save(tmp_path / place)
    assert os.listdir(tmp_path) == []
