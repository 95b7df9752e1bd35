"""A disk that fails at any write costs no frame that was told, and crashes nothing."""

import json
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

import lapilli as lp
from lapilli import _core

SCENE = """
[grid]
lower = [-6.0, -6.0]
upper = [6.0, 6.0]
cell = 0.8
[[bodies]]
shape = {kind = "annulus", inner = 1.0, outer = 5.0}
points_per_cell = 4
material = {kind = "thermal", density = 1.0, specific_heat = 1.0, conductivity = 1.0}
[heat]
boundaries = [{kind = "convection", coefficient = 1.0, ambient = 1.0}]
[time]
end = 0.5
[output]
every = 0.1
"""


def whole_frames(path: Path) -> int:
    """Frames on disk; every one must be whole."""
    if not path.exists():
        return 0
    frames, whole, damages = _core.verify(str(path))
    assert not damages
    assert whole == frames
    return frames


@pytest.mark.parametrize("once", [False, True], ids=["full from then on", "one write refused"])
def test_every_write_made_to_fail_in_turn(drivers, tmp_path, once):
    if not drivers.kill_at_write.exists():
        pytest.skip("a sanitizer build has no library that fails writes")
    environment = {**os.environ, "LD_PRELOAD": str(drivers.kill_at_write)}
    if once:
        environment["FAIL_ONCE"] = "1"
    seen = set()
    for position in range(1000):
        folder = tmp_path / str(position)
        folder.mkdir()
        environment["FAIL_AT_WRITE"] = str(position)
        run = subprocess.run(
            [drivers.run, "run", folder / "run.vtkhdf"],
            capture_output=True,
            text=True,
            env=environment,
        )
        seen.add(whole_frames(folder / "run.vtkhdf"))
        assert not list(folder.glob("*.tmp"))
        assert not list(folder.glob("*.lock"))
        if run.returncode == 0:
            break
        assert run.returncode == 1, run.stderr
        assert "No space left" in run.stderr
        if once and (folder / "run.json").exists():  # there was room to say so
            assert json.loads((folder / "run.json").read_text())["status"] == "failed"
        if (folder / "run.checkpoint").exists():  # with room again it goes on
            again = subprocess.run([drivers.run, "resume", folder / "run.vtkhdf"])
            assert again.returncode == 0
            assert whole_frames(folder / "run.vtkhdf") == 6
    assert position > 60
    assert seen >= {0, 1, 2, 3, 4, 5, 6}


@pytest.mark.parametrize("limit", [0, 3000, 20_000, 60_000])
def test_a_limit_of_the_file_size_is_an_error_of_both_front_ends(tmp_path, limit):
    scene = tmp_path / "ring.toml"
    scene.write_text(SCENE)
    output = tmp_path / "run.vtkhdf"

    def limited():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    program = Path(os.environ.get("LAPILLI_BUILD", "build/release")) / "cpp" / "lapilli-run"
    python = [sys.executable, "-B", "-m", "lapilli", "run"]
    for command in ([program], python):
        if not Path(command[0]).exists():
            pytest.skip("no executable")
        run = subprocess.run(
            [*command, scene, "-q", "--output", output],
            capture_output=True,
            text=True,
            preexec_fn=limited,
        )
        assert run.returncode == 3, run.stderr
        assert "File too large" in run.stderr
        whole_frames(output)


def test_python_gets_an_output_error_and_ends_well(tmp_path):
    (tmp_path / "ring.toml").write_text(SCENE)
    code = f"""
import resource, lapilli as lp
resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
try:
    lp.run({str(tmp_path / "ring.toml")!r}, {str(tmp_path / "run.vtkhdf")!r}, progress=False)
except lp.OutputError as error:
    print("OutputError", error)
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert "OutputError" in run.stdout


def test_a_folder_that_goes_away_is_an_output_error(ring, tmp_path):
    folder = tmp_path / "gone"
    folder.mkdir()

    def remove(_simulation):
        for file in folder.iterdir():
            file.unlink()
        folder.rmdir()
        raise_once.append(1)

    raise_once: list[int] = []
    with pytest.raises((lp.OutputError, OSError)):
        lp.run(
            ring,
            folder / "run.vtkhdf",
            every=0.1,
            progress=False,
            callback=lambda s: None if raise_once else remove(s),
        )


@pytest.mark.parametrize("words", [["keys"], ["check", "SCENE"]])
def test_what_cannot_be_printed_is_an_error(tmp_path, words):
    (tmp_path / "ring.toml").write_text(SCENE)
    words = [str(tmp_path / "ring.toml") if word == "SCENE" else word for word in words]
    with open("/dev/full", "w") as full:
        run = subprocess.run(
            [sys.executable, "-m", "lapilli", *words],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
        )
    assert run.returncode == 3
    assert "No space left" in run.stderr
    program = Path(os.environ.get("LAPILLI_BUILD", "build/release")) / "cpp" / "lapilli-run"
    if program.exists():
        flag = ["--keys"] if words[0] == "keys" else [words[1], "--check"]
        with open("/dev/full", "w") as full:
            run = subprocess.run([program, *flag], stdout=full, stderr=subprocess.PIPE, text=True)
        assert run.returncode == 3
