"""What every command shares: mistakes, JSON, how much is said, completion, version."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import lapilli as lp
from lapilli.cli import main
from lapilli.commands import COMMANDS
from lapilli.commands.keys import tables


@pytest.fixture
def scene_file(ring: lp.Scene) -> str:
    ring.save("ring.toml")
    return "ring.toml"


def printed(words: list[str], capsys: pytest.CaptureFixture[str], code: int = 0) -> Any:
    """What a command prints as JSON, and nothing beside it on standard output."""
    capsys.readouterr()
    assert main(words) == code
    return json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["ruin"], "unknown command 'ruin'; did you mean 'run'?"),
        (["examples", "lst"], "unknown command 'lst'; did you mean 'list'?"),
        (["check", "ring.toml", "--jsn"], "Did you mean --json?"),
        (["run", "ring.toml", "--ouput", "x"], "Did you mean --output?"),
        (["run"], "SCENE is missing"),
        (["tradeoff", "ring.toml", "--reference", "radial"], "--vary is missing"),
        (["run", "ring.toml", "more"], "too many arguments: more"),
        (["run", "ring.toml", "--threads", "5000"], "--threads"),
        (["run", "ring.toml", "--every", "often"], "often"),
        (["extremes", "--transfer", "flop"], "flip"),
        (["reproduce", "--json", "--list"], "a file is needed"),
    ],
)
def test_mistakes_in_the_words_are_named(
    words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as left:
        main(words)
    assert left.value.code == 2
    shown = capsys.readouterr()
    assert says in shown.err
    assert shown.err.count("\n") == 2
    assert shown.out == ""


def test_every_command_has_help(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--help"]) == 0
    listed = capsys.readouterr().out
    for name in COMMANDS:
        assert main([name, "--help"]) == 0
        title = capsys.readouterr().out.splitlines()[2].strip()
        assert title.endswith(".")
        assert f"{name} " in listed
        assert title[:40] in listed
    assert main([]) == 2  # no command is no success
    assert main(["examples"]) == 2


def test_results_as_json(scene_file: str, capsys: pytest.CaptureFixture[str]) -> None:
    ran = printed(["run", scene_file, "--json", "-q"], capsys)
    assert ran["finished"]
    assert ran["time"] == 1.0
    assert ran["balances"]["heat"]["residual"] < 1e-10
    assert Path(ran["output"]).exists()
    assert Path(ran["record"]).exists()
    assert printed(["verify", "ring.vtkhdf", "--json"], capsys)["damages"] == []
    assert printed(["check", scene_file, "--json"], capsys)["dimension"] == 2
    names = [row["name"] for row in printed(["examples", "list", "--json"], capsys)]
    assert "vhfm/ring" in names
    cells = [row for row in printed(["keys", "grid", "--json"], capsys) if row["key"] == "cell"]
    assert cells[0]["section"] == "[grid]"
    assert cells[0]["unit"] == "m"
    assert cells[0]["allowed"] == "above 0"
    cases = printed(["reproduce", "--list", "--json", "-"], capsys)
    assert {"name", "title"} == set(cases[0])
    assert printed(["merge", "ring.vtkhdf", "one.vtkhdf", "--json"], capsys) == {
        "wrote": ["one.vtkhdf"]
    }
    study = ["tradeoff", scene_file, "--vary", "grid.cell=1,0.5", "--reference", "radial"]
    rows = printed([*study, "--repeats", "1", "--json", "-q"], capsys)
    assert [row["grid.cell"] for row in rows] == ["1", "0.5"]
    # damage is told as JSON, with the code of a failed disk
    data = Path("ring.vtkhdf.data")
    held = data.read_bytes()
    data.write_bytes(held[: len(held) // 2])
    assert printed(["verify", "ring.vtkhdf", "--json"], capsys, code=3)["damages"]


def test_quiet_and_verbose(scene_file: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", scene_file, "-q"]) == 0
    shown = capsys.readouterr()
    assert (shown.out, shown.err) == ("", "")
    assert main(["run", scene_file, "-v"]) == 0
    assert "heat conduction" in capsys.readouterr().err  # what the scene models
    assert main(["check", scene_file, "--quiet"]) == 0
    assert capsys.readouterr().out == ""
    assert main(["check", "nosuch.toml"]) == 2
    assert "Traceback" not in capsys.readouterr().err
    assert main(["check", "nosuch.toml", "-v"]) == 2
    shown = capsys.readouterr()
    assert "Traceback" in shown.err
    assert shown.err.splitlines()[-1].startswith("lapilli: nosuch.toml")


def test_tables_of_markdown() -> None:
    text = "## `[a]`\n\n| key | unit |\n|---|---|\n| `x` | m |\n"
    text += "\n## `[b]`\n\n| key |\n|---|\n| `y` |\n"
    assert tables(text) == [
        {"section": "[a]", "key": "x", "unit": "m"},
        {"section": "[b]", "key": "y"},
    ]


def test_a_shell_completes_commands_and_options(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", "bash"]) == 0
    script = capsys.readouterr().out

    def completed(*words: str) -> list[str]:
        line = " ".join(f"'{word}'" for word in ("lapilli", *words))
        ask = f"COMP_WORDS=({line}); COMP_CWORD={len(words)}; _lapilli; echo ${{COMPREPLY[@]}}"
        done = subprocess.run(["bash", "-c", f"{script}\n{ask}"], capture_output=True, text=True)
        assert done.stderr == ""
        return done.stdout.split()

    assert completed("ru") == ["run"]
    assert set(completed("examples", "")) >= {"list", "copy"}
    assert completed("run", "x.toml", "--thr") == ["--threads"]
    assert completed("extremes", "--transfer", "aff") == ["affine"]
    Path("scene.toml").touch()
    assert completed("check", "sce") == ["scene.toml"]


def test_version_tells_how_it_was_built(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == f"lapilli {lp.__version__}"
    assert lines[-1] == f"threads: {lp.thread_count()}"
    told = dict(line.split(": ", 1) for line in lines[1:])
    assert list(told) == ["compiler", "kernel set", "build type", "threads"]
    assert all(told.values())


def test_commands_start_light() -> None:
    """What takes long to import is imported by the command that needs it."""
    heavy = "scipy matplotlib pyvista pandas xarray dask joblib optuna h5py"
    code = (
        "import sys\n"
        "from lapilli.cli import main\n"
        "main(['--version'])\n"
        "main(['--help'])\n"
        f"print(*[name for name in '{heavy}'.split() if name in sys.modules])\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == ""


def test_every_other_command_prints_json_too(
    scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", scene_file, "-q"]) == 0
    assert printed(["new", "heat", "--json"], capsys) == {"wrote": ["heat.toml"]}
    assert printed(["plot", "ring.vtkhdf", "--json"], capsys) == {"wrote": ["ring.png"]}
    assert printed(["report", "ring.vtkhdf", "--json"], capsys) == {"wrote": ["ring.html"]}
    assert {"code", "said when", "what to do"} < set(
        printed(["keys", "notes", "--json"], capsys)[0]
    )
    cases = ["study", scene_file, "--vary", "heat.boundaries.0.coefficient=1,-1", "--json", "-q"]
    rows = printed([*cases, "--quantity", "temperature"], capsys)
    assert [row["status"] for row in rows] == ["finished", "refused"]
    found = printed(["suggest", scene_file, "--target-error", "0.1", "--json", "-q"], capsys)
    assert found["error"] < 0.1
    assert printed(["schema"], capsys)["title"]
    assert printed(["extremes", "--only", "static", "--quick", "--json", "-"], capsys)


def test_no_command_is_without_json() -> None:
    """But those whose output is a file in a language of its own."""
    from lapilli.cli import application

    for name in set(COMMANDS) - {"completion", "schema", "examples"}:
        command = application()[name]
        names = command.default_command.__annotations__
        assert "json" in names, name
