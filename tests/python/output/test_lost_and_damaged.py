"""What is lost or damaged beside frames is named, with what can be done about it."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

import lapilli as lp
from lapilli._core import OutputError
from lapilli.cli import main


@pytest.fixture
def frames(ring: lp.Scene, tmp_path: Path) -> Path:
    path = tmp_path / "ring.vtkhdf"
    lp.run(ring.set("grid.cell=1").set("time.end=0.1"), output=path, progress=False)
    return path


DAMAGES = {
    "no JSON": lambda record: b'{"half": ',
    "no text": lambda record: b"\xff\xfe\x00",
    "a list": lambda record: b"[]",
    "a number": lambda record: b"3",
    "no physics": lambda record: (
        json.dumps({**record, "physics": None}).encode()
        and json.dumps({key: value for key, value in record.items() if key != "physics"}).encode()
    ),
}


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_a_damaged_record_is_named(
    damage: Callable[[dict], bytes], frames: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record = frames.with_suffix(".json")
    assert main(["verify", str(frames)]) == 0
    record.write_bytes(damage(json.loads(record.read_text())))
    capsys.readouterr()
    assert main(["verify", str(frames)]) == 3
    assert f"the record '{record}' is damaged" in capsys.readouterr().out
    assert main(["report", str(frames), "-q"]) == 3
    assert f"the record '{record}' is damaged" in capsys.readouterr().err


@pytest.mark.parametrize("is_gone", [True, False])
def test_a_lost_index_says_how_it_is_made_anew(
    is_gone: bool, frames: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if is_gone:
        frames.unlink()
    else:
        frames.write_bytes(frames.read_bytes()[:-100])
    with pytest.raises((OSError, ValueError), match=f"lapilli verify {frames} --rebuild"):
        lp.Frames(frames)
    for command in ("plot", "verify"):
        assert main([command, str(frames)]) != 0
        assert "--rebuild" in capsys.readouterr().err.replace("\n", " ")
    assert main(["verify", str(frames), "--rebuild"]) == 0
    assert len(lp.Frames(frames)) > 0


def test_pictures_of_nothing_and_on_full_devices_are_errors(
    frames: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["plot", str(frames), "--probe", "50,50"]) == 2
    assert "no material at (50, 50) m" in capsys.readouterr().err.replace("\n", " ")
    assert main(["plot", str(frames), "--contours", "100000"]) == 2
    assert main(["plot", str(frames), "--save", "/dev/full", "-q"]) == 3
    assert "/dev/full" not in capsys.readouterr().out


def test_damage_of_frames_is_an_output_error(frames: Path) -> None:
    frames.with_suffix(".json").write_text("[]")
    with pytest.raises(OutputError, match="holds no table"):
        assert lp.Frames(frames).record
