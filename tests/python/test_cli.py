"""The command line: what it prints, writes and returns."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

import lapilli as lp
from lapilli.cli import main

TRADEOFF = ["tradeoff", "ring.toml", "--reference"]


@pytest.fixture
def scene_file(ring: lp.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.chdir(tmp_path)
    ring.save("ring.toml")
    return "ring.toml"


def test_run_plot_and_merge(scene_file: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", scene_file, "--every", "0.5", "--set", "heat.transfer=flip"]) == 0
    shown = capsys.readouterr()
    assert "finished at 1 s" in shown.out
    assert "residual" in shown.out
    assert "100 %" in shown.err
    assert "left" in shown.err
    assert lp.Frames("ring.vtkhdf").times.tolist() == [0, 0.5, 1]
    assert main(["plot", "ring.vtkhdf"]) == 0
    assert Path("ring.png").read_bytes().startswith(b"\x89PNG")
    assert main(["plot", "ring.vtkhdf", "--save", "ring.gif"]) == 0
    assert Path("ring.gif").read_bytes().startswith(b"GIF8")
    assert main(["merge", "ring.vtkhdf", "one.vtkhdf"]) == 0
    assert lp.Frames("one.vtkhdf")[-1]["temperature"].tobytes() == (
        lp.Frames("ring.vtkhdf")[-1]["temperature"].tobytes()
    )


def test_check_says_what_a_scene_models(
    scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["check", scene_file]) == 0
    assert "heat conduction" in capsys.readouterr().out
    assert main(["check", scene_file, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["dimension"] == 2


def test_keys_lists_units_and_defaults(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["keys"]) == 0
    assert "cell" in capsys.readouterr().out


def test_keys_of_nested_sections_stand_below_their_whole_path(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """[heat] and [peridynamics.heat] are two; a table is also found by the end of its path."""
    assert main(["keys"]) == 0
    headings = [line for line in capsys.readouterr().out.splitlines() if line.startswith("## ")]
    for path in ("[heat]", "[peridynamics.heat]", "[peridynamics.flow]", "[bodies.geostatic]"):
        assert headings.count(f"## `{path}`") == 1
    assert main(["keys", "flow"]) == 0
    assert "`[peridynamics.flow]`" in capsys.readouterr().out


def test_keys_finds_kinds_where_they_are_written(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["keys", "bodies.material"]) == 0
    found = capsys.readouterr().out
    assert "`material elastic`" in found
    assert "shape disk" not in found
    assert main(["keys", "xyz"]) == 2
    names = capsys.readouterr().err.partition("there is: ")[2].strip().split(", ")
    assert len(names) == len(set(names)) > 20


@pytest.mark.parametrize(
    ("words", "code", "says"),
    [
        (["run", "nosuch.toml"], 2, "nosuch.toml"),
        (["run", "ring.toml", "--set", "grid.cel=1"], 2, "did you mean 'cell'"),
        (["run", "ring.toml", "--set", "grid.cell=-1"], 2, "above 0"),
        (["run", "ring.toml", "--set", "time.step=1e3"], 2, "above the limit"),
        (["run", "ring.toml", "--output", "/proc/x.vtkhdf"], 3, "/proc"),
        (["run", "ring.toml", "--resume"], 2, "checkpoint"),
        (["run", "ring.toml", "--threads", "0"], 2, "--threads"),
        (["plot", "ring.toml"], 2, "holds no frames"),
        (["merge", "nosuch.vtkhdf", "b.vtkhdf"], 2, "nosuch.vtkhdf"),
        (["reproduce", "no/such"], 2, "no case 'no/such'"),
        (
            ["tradeoff", "ring.toml", "--vary", "grid.cell", "--reference", "radial"],
            2,
            "path=value",
        ),
        (
            ["tradeoff", "ring.toml", "--vary", "grid.cell=1", "--reference", "x"],
            2,
            "reference 'x'",
        ),
        (["fly"], 2, "fly"),
    ],
)
@pytest.mark.usefixtures("scene_file")
def test_mistakes_are_one_line_and_a_code(
    words: list[str], code: int, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        returned = main(words)
    except SystemExit as left:
        returned = left.code
    shown = capsys.readouterr().err
    assert says in shown
    assert "Traceback" not in shown
    assert returned == code


def test_the_module_is_the_command(scene_file: str) -> None:
    command = [sys.executable, "-m", "lapilli", "run", scene_file, "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
