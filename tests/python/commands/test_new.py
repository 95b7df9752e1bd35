"""lapilli new: scenes to start from run as they are."""

import sys
from pathlib import Path

import pytest

import lapilli as lp
from lapilli import _core, new_scene
from lapilli.cli import main

METHODS = ["heat", "soil", "static", "flow"]


def test_every_method_has_a_template() -> None:
    assert list(new_scene.METHODS) == METHODS
    assert sorted(METHODS) == sorted(path.stem for path in new_scene.TEMPLATES.glob("*.toml"))


@pytest.mark.parametrize("method", METHODS)
def test_a_new_scene_runs_a_few_steps(method: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["new", method, "--output", "mine.toml"]) == 0
    assert "wrote mine.toml" in capsys.readouterr().out
    text = Path("mine.toml").read_text()
    assert text.count("#") > 10
    assert "$" not in text
    scene = lp.Scene.load("mine.toml")
    assert scene.output.path == "mine.vtkhdf"
    assert _core.unused_settings(scene) == []
    assert main(["check", "mine.toml"]) == 0
    checked = capsys.readouterr().out
    assert "note" not in checked.lower()
    simulation = lp.Simulation(scene)
    before = {name: simulation.by_id(name) for name in simulation.fields}
    for _ in range(3):
        simulation.step()
    assert any((simulation.by_id(name) != before[name]).any() for name in before)
    volume, exact = next(iter(simulation.volumes().values()))
    assert exact is None or volume == pytest.approx(exact, rel=0.01)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("size", "cells"), [(0.003, 8), (7.3, 9)])
def test_size_and_cells_scale_the_scene(method: str, size: float, cells: int) -> None:
    words = ["new", method, "--size", str(size), "--cells", str(cells)]
    assert main([*words, "--end", "0.5", "--quiet"]) == 0
    scene = lp.Scene.load(f"{method}.toml")
    assert scene.grid.cell == pytest.approx(size / cells)
    assert scene.time.end == (1.0 if method == "static" else 0.5)
    simulation = lp.Simulation(scene)
    simulation.step()
    width = simulation.position[simulation["body"] == 0, 0]
    assert width.max() - width.min() == pytest.approx(size * (1 - 1 / cells), rel=0.15)


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["heat", "--size", "-1"], "above 0 m"),
        (["heat", "--cells", "2"], "from 4 to 1000"),
        (["heat", "--end", "nan"], "above 0 s"),
        (["heat", "--output", "nosuch/x.toml"], "nosuch"),
        ([], "which method? there is: heat, soil, static, flow"),
    ],
)
def test_mistakes_write_nothing(
    words: list[str],
    says: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sys.stdin, "isatty", lambda: False, raising=False)
    assert main(["new", *words]) == 2
    assert says in capsys.readouterr().err
    assert list(Path().iterdir()) == []


def test_nothing_is_overwritten(capsys: pytest.CaptureFixture[str]) -> None:
    Path("heat.toml").write_text("mine")
    assert main(["new", "heat"]) == 2
    assert "heat.toml is there already" in capsys.readouterr().err
    assert Path("heat.toml").read_text() == "mine"


def test_it_asks_on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    import rich.prompt

    answers = iter(["soil", "2", "", "my.toml"])
    monkeypatch.setattr(sys.stdin, "isatty", lambda: True, raising=False)
    monkeypatch.setattr(rich.prompt.PromptBase, "get_input", lambda *_args, **_more: next(answers))
    assert main(["new"]) == 0
    scene = lp.Scene.load("my.toml")
    assert scene.dynamics is not None
    assert scene.grid.cell == 0.1


@pytest.mark.parametrize("name", ['a"b.toml', "a\\b.toml", "a\nb.toml", "ü $size.toml"])
def test_names_of_files_are_spelt_as_toml(name: str, tmp_path: Path) -> None:
    scene = tmp_path / name
    assert main(["new", "heat", "--output", str(scene), "-q"]) == 0
    assert lp.Scene.load(scene).output.path == scene.stem + ".vtkhdf"
