"""Where defaults lie between error and cost: what bench/fronts.py makes of a table."""

import importlib.util
import math
import sys
from pathlib import Path
from types import ModuleType

import pytest

import lapilli as lp
from lapilli import examples
from lapilli.study import InProcess, Setting, settings_of, tradeoff
from lapilli.study.table import Row, Table

ROOT = Path(__file__).parents[3]
pytest.importorskip("tomllib")


def loaded() -> ModuleType:
    spec = importlib.util.spec_from_file_location("fronts", ROOT / "bench" / "fronts.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["fronts"] = module
    spec.loader.exec_module(module)
    return module


fronts = loaded()


def row(cell: str, error: float, cost: float, *more: tuple[str, str]) -> Row:
    setting = Setting((("grid.cell", cell), *more))
    return Row(setting, error, error, cost, 0.0, 1, 1, 1, 1, False, "")


def test_costs_lie_between_cells_on_logarithms() -> None:
    curve = [(1e-1, 1.0), (1e-3, 100.0)]
    assert fronts.cost_at(curve, 1e-2) == pytest.approx(10.0)
    assert fronts.cost_at(curve, 1.0) == 1.0  # the coarsest is better than asked for
    assert math.isinf(fronts.cost_at(curve, 1e-4))


def test_a_default_is_compared_at_equal_error() -> None:
    other = ("heat.method", "paper")
    table = Table(
        [row("0.2", 1e-1, 4.0), row("0.1", 1e-3, 40.0), row("0.2", 1e-2, 2.0, other)],
        "temperature",
    )
    coarse, fine = fronts.compared(table)
    assert coarse["over_front"] == pytest.approx(2.0)
    assert coarse["best"] == "heat.method=paper"
    assert fine["over_front"] == 1.0
    assert fine["best"] == "default"


def test_several_mappings_are_tried_one_after_the_other(ring: lp.Scene) -> None:
    several = [{"grid.cell": [1.0]}, {"grid.cell": [1.0, 0.5], "heat.tolerance": [0.1]}]
    assert [str(one) for one in settings_of([*several, several[0]])] == [
        "grid.cell=1.0",
        "grid.cell=1.0, heat.tolerance=0.1",
        "grid.cell=0.5, heat.tolerance=0.1",
    ]
    table = tradeoff(ring, several, "radial", repeats=1, runner=InProcess())
    assert len(table.rows) == 3
    with pytest.raises(ValueError, match="nothing to vary"):
        settings_of([])


def test_the_picture_tells_settings_apart_from_the_scene() -> None:
    pytest.importorskip("matplotlib")
    one, other = ("heat.method", "paper"), ("heat.transfer", "flip")
    rows = [
        row("0.2", 1e-1, 4.0),
        row("0.2", 1e-2, 5.0, one),
        row("0.2", 1e-3, 6.0, one, other),
    ]
    (legend,) = Table(rows, "temperature").picture().legends
    assert [text.get_text() for text in legend.get_texts()] == [
        "as in the scene",
        "method = paper",
        "method = paper, transfer = flip",
    ]


@pytest.mark.parametrize("name", fronts.scenes())
def test_scenes_take_their_settings(name: str) -> None:
    given = fronts.scenes()[name]
    scene = lp.Scene.load(str(examples.path(given["scene"])))
    for change in given.get("set", []):
        scene = scene.set(change)
    for texts in given.get("others", []):
        for change in texts:
            scene.set(change)
    assert given["cells"] == sorted(given["cells"], reverse=True)
