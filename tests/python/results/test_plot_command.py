"""`lapilli plot` and `lapilli report`: options reach the pictures, mistakes are one line."""

import json
from pathlib import Path

import pytest

import lapilli as lp
from lapilli.cli import main

pytest.importorskip("matplotlib")


def run(words: list[str]) -> int:
    try:
        return main(words)
    except SystemExit as left:
        return int(left.code or 0)


def test_pictures_of_every_kind(falling: lp.Result, tmp_path: Path) -> None:
    frames = str(falling.output)
    for name, words in {
        "a.png": ["--field", "stress.yy", "--vectors", "velocity", "--range=-1,1"],
        "b.png": [frames, "--field", "velocity", "--time", "0.02"],
        "c.pdf": ["--history", "velocity/*"],
        "d.png": ["--field", "velocity", "--probe", "0.4,0.5"],
        "e.gif": ["--field", "velocity.y"],
    }.items():
        save = tmp_path / name
        assert run(["plot", frames, *words, "--save", str(save), "-q"]) == 0, words
        assert save.stat().st_size > 1000


def test_a_report_is_written_beside_the_frames_or_where_told(
    falling: lp.Result, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    save = tmp_path / "page.html"
    words = ["report", str(falling.output), "--pictures", "2", "--field", "velocity.y"]
    assert run([*words, "--save", str(save), "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == {"wrote": [str(save)]}
    assert "velocity.y" in save.read_text()


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ([], "needs the frames"),
        (["F", "--time", "9"], "no frame at 9 s"),
        (["F", "--field", "heat"], "no field 'heat'"),
        (["F", "--field", "velocity.q"], "did you mean 'velocity.x'"),
        (["F", "--range", "1"], "expected two numbers"),
        (["F", "--range", "2,1"], "from a lower to an upper end"),
        (["F", "--cut", "y"], "scenes in space"),
        (["F", "--probe", "here"], "expected numbers"),
        (["F", "--probe", "1,2,3"], "2 coordinates"),
        (["F", "--history", "velocty/*"], "no column 'velocty/*'"),
        (["F", "--time", "0.02", "--save", "x.gif"], "an animation shows all times"),
        (["F", "--save", "x.jpeg2"], "jpeg2"),
    ],
)
def test_mistakes_are_one_line(
    falling: lp.Result, words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    given = [str(falling.output) if word == "F" else word for word in words]
    assert run(["plot", *given]) == 2
    shown = capsys.readouterr().err
    assert says in shown
    assert len(shown.strip().splitlines()) == 1
