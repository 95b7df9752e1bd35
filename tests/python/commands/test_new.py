"""lapilli new: scenes to start from run as they are."""

import sys
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core, new_scene
from lapilli.cli import main
from lapilli.study import InProcess, tradeoff

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


def ran(method: str) -> lp.Result:
    """A new scene, run to its end without a word of warning."""
    assert main(["new", method, "--quiet"]) == 0
    result = lp.run(f"{method}.toml", progress=False)
    assert [*result.summary.notes, *result.warnings] == []
    return result


def test_a_new_disk_warms_as_the_series_says() -> None:
    assert main(["new", "heat", "--quiet"]) == 0
    scene = lp.Scene.load("heat.toml")
    cell = {"grid.cell": [scene.grid.cell]}
    (row,) = tradeoff(scene, cell, "radial", repeats=1, runner=InProcess()).rows
    assert row.error < 0.005 * (600 - 293)


def test_new_sand_comes_to_rest_and_keeps_its_energy() -> None:
    result = ran("soil")
    assert np.hypot(result.history["foot_x"][-1], result.history["foot_y"][-1]) < 0.01
    assert abs(result.balance["energy"].residual) < 0.01
    assert 1.2 < result.history["position_x/largest"][-1] - 1 < 1.8  # m, of a column of one metre


def test_a_new_bar_bends_as_a_beam() -> None:
    result = ran("static")
    bar = lp.Scene.load("static.toml").bodies[0]
    (_, _), (length, height) = bar.shape.lower, bar.shape.upper
    load, steel = 1e6 * height, bar.material
    shear = steel.youngs_modulus / (2 * (1 + steel.poissons_ratio))
    stiffness = steel.youngs_modulus / (1 - steel.poissons_ratio**2) * height**3 / 12
    deflection = load * length**3 / (3 * stiffness) + 1.2 * load * length / (shear * height)
    assert -result.history["tip_y"][-1] == pytest.approx(deflection, rel=0.03)


def test_new_air_carries_the_heat_of_its_rayleigh_number() -> None:
    """7,700: between 1.118 at 1e3 and 2.243 at 1e4 (de Vahl Davis 1983), on a power of Ra."""
    result = ran("flow")
    air = lp.Scene.load("flow.toml").bodies[0]
    size = air.shape.upper[0] - air.shape.lower[0]
    thermal, fluid = air.material
    diffusivity = thermal.conductivity / (thermal.density * thermal.specific_heat)
    viscosity = fluid.viscosity / fluid.density
    rayleigh = 9.81 * fluid.thermal_expansion * 10 * size**3 / (viscosity * diffusivity)
    nusselt = result.history["heat/heat_flow_from_wall_hot"][-1] / (10 * thermal.conductivity)
    expected = 2.243 * (rayleigh / 1e4) ** np.log10(2.243 / 1.118)
    assert nusselt == pytest.approx(expected, rel=0.06)
    given, taken = (
        result.history[f"heat/heat_flow_from_wall_{one}"][-1] for one in ("hot", "cold")
    )
    assert given == pytest.approx(-taken, rel=0.02)


def test_what_to_do_next_is_a_command_whatever_the_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Blanks and quotes are those of a shell."""
    monkeypatch.chdir(tmp_path)
    assert main(["new", "heat", "--output", "my kühl scene.toml"]) == 0
    said = capsys.readouterr().out
    assert "lapilli run 'my kühl scene.toml'; lapilli plot 'my kühl scene.vtkhdf'" in said
