"""lapilli examples: list and copy; what is copied runs where it lies."""

from pathlib import Path

import pytest

import lapilli as lp
from lapilli import examples, notebooks
from lapilli.cli import main


def test_list_names_every_scene_with_its_title(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["examples", "list"]) == 0
    shown = capsys.readouterr().out.splitlines()
    assert len(shown) == len(examples.names()) + len(notebooks.pages()) > 20
    assert any(line.startswith("vhfm/ring ") and "ring" in line[20:].lower() for line in shown)


def test_copy_takes_what_a_scene_reads_and_overwrites_nothing(tmp_path: Path) -> None:
    assert main(["examples", "copy", "vhfm/fan", "--to", str(tmp_path)]) == 0
    assert sorted(path.name for path in (tmp_path / "vhfm").iterdir()) == ["fan.pgm", "fan.toml"]
    lp.Simulation(lp.Scene.load(tmp_path / "vhfm" / "fan.toml"))
    assert main(["examples", "copy", "vhfm/fan", "--to", str(tmp_path)]) == 2


def test_a_scene_that_reads_a_file_is_checked_from_another_folder() -> None:
    assert main(["examples", "copy", "vhfm/fan", "--quiet"]) == 0
    assert main(["check", "vhfm/fan.toml"]) == 0


def test_a_misspelt_name_gets_the_nearest(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["examples", "copy", "vhfm/rings"]) == 2
    assert "did you mean 'vhfm/ring'?" in capsys.readouterr().err
    assert main(["reproduce", "vhfm/rin"]) == 2
    assert "did you mean 'vhfm/ring'?" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["chek", "ring.toml"])
    assert "did you mean 'check'?" in capsys.readouterr().err
