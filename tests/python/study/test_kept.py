"""What a study kept is used again for the same problem only: every input file and array counts."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli.study import InProcess, minimize, study, tradeoff
from lapilli.study.survey import Case

COEFFICIENT = "heat.boundaries.0.coefficient"
SCENE = """
[grid]
lower = [0.0, 0.0]
upper = [4.0, 4.0]
cell = 0.5
[[bodies]]
name = "b"
{body}
material = {{kind = "thermal", density = 1.0, specific_heat = 1.0, conductivity = 1.0}}
[[heat.boundaries]]
kind = "convection"
coefficient = 1.0
ambient = {ambient}
[time]
end = 0.1
"""


def put_image(path: Path, size: int) -> None:
    rows = [" ".join("01"[x < size and y < size] for x in range(8)) for y in range(8)]
    path.write_text("P2\n8 8\n1\n" + "\n".join(rows) + "\n")


def put_points(path: Path, size: int) -> None:
    places = [(0.25 + 0.5 * x, 0.25 + 0.5 * y) for x in range(size) for y in range(size)]
    path.write_text("x,y,volume\n" + "".join(f"{x},{y},0.25\n" for x, y in places))


def put_table(path: Path, size: int) -> None:
    path.write_text(f"time,value\n0,{size}\n1,{size}\n")


BOX = 'shape = {kind = "box", lower = [0.5, 0.5], upper = [3.5, 3.5]}'
IMAGE = 'shape = {kind = "image", file = "input", origin = [0.0, 0.0], pixel = 0.5}'
INPUTS = {
    "image": (put_image, {"body": IMAGE, "ambient": "1.0"}),
    "points": (put_points, {"body": 'points_file = "input"', "ambient": "1.0"}),
    "table": (put_table, {"body": BOX, "ambient": '{file = "input"}'}),
}


def study_of(scene: Path | lp.Scene, store: Path, ran: list[object]) -> float:
    found = study(scene, {COEFFICIENT: [1.0]}, ["heat/stored"], store=store, runner=InProcess(),
                  report=lambda *a: ran.append(a))  # fmt: skip
    return found.outcomes[0].numbers["heat/stored"]


def minimum_of(scene: Path | lp.Scene, store: Path, ran: list[object]) -> float:
    pytest.importorskip("optuna")
    found = minimize(scene, {COEFFICIENT: [1.0]}, "heat/stored", samples=1, store=store,
                     runner=InProcess(), report=lambda *a: ran.append(a))  # fmt: skip
    return found.outcomes[0].numbers["heat/stored"]


def error_of(scene: Path | lp.Scene, store: Path, ran: list[object]) -> float:
    table = tradeoff(scene, {"grid.cell": [0.5]}, 0.0, quantities=["heat/stored"], repeats=1,
                     store=store, runner=InProcess(), report=lambda *a: ran.append(a))  # fmt: skip
    assert table.rows[0].error is not None
    return table.rows[0].error


@pytest.mark.parametrize("kind", INPUTS)
@pytest.mark.parametrize("work", [study_of, minimum_of, error_of])
def test_a_changed_input_file_is_run_again(
    work: Callable[..., float], kind: str, tmp_path: Path
) -> None:
    put, words = INPUTS[kind]
    scene, ran = tmp_path / "s.toml", []
    scene.write_text(SCENE.format(**words))
    found = []
    for size in (4, 4, 6):
        put(tmp_path / "input", size)
        found.append(work(scene, tmp_path / "kept.jsonl", ran))
    assert len(ran) == 2
    assert found[0] == found[1] != found[2]
    assert found[2] == work(scene, tmp_path / "none.jsonl", [])


def test_a_changed_file_that_only_a_setting_names_is_run_again(tmp_path: Path) -> None:
    scene, ran = tmp_path / "s.toml", []
    scene.write_text(SCENE.format(body='points_file = "a.csv"', ambient="1.0"))
    put_points(tmp_path / "a.csv", 4)
    for size in (5, 6):
        put_points(tmp_path / "b.csv", size)
        study(scene, {"bodies.0.points_file": ['"a.csv"', '"b.csv"']}, ["heat/stored"],
              store=tmp_path / "kept.jsonl", runner=InProcess(),
              report=lambda *a: ran.append(str(a[0].setting)))  # fmt: skip
    assert [one.count("b.csv") for one in ran] == [0, 1, 1]


def test_changed_arrays_are_run_again(tmp_path: Path) -> None:
    places = np.stack(np.meshgrid(*[np.arange(6) * 0.5 + 0.25] * 2), -1).reshape(-1, 2)
    scene, ran = lp.Scene.parse(SCENE.format(body=BOX, ambient="1.0")), []
    for volume in (0.25, 0.25, 0.2):
        points = lp.Points(places, np.full(len(places), volume))
        body = lp.Body(name="b", points=points, material=scene.bodies[0].material)
        study_of(scene.set("bodies", [body]), tmp_path / "kept.jsonl", ran)
    assert len(ran) == 2


def test_scenes_with_functions_keep_nothing_and_say_so(tmp_path: Path) -> None:
    scene = lp.Scene.parse(SCENE.format(body=BOX, ambient="1.0"))
    store, found = tmp_path / "kept.jsonl", []
    for ambient in (1.0, 2.0):
        law = lp.Convection(coefficient=1.0, ambient=lambda p, s, t, a=ambient: a)
        results = study(scene.set("heat.boundaries", [law]), {COEFFICIENT: [1.0]}, ["heat/stored"],
                        store=store, runner=InProcess())  # fmt: skip
        found.append(results.outcomes[0].numbers["heat/stored"])
        assert "heat.boundaries.0.ambient" in results.notes[0]
        assert not store.exists()
    assert found[1] == pytest.approx(2 * found[0])


def test_errors_against_other_frames_of_one_name_are_measured_again(tmp_path: Path) -> None:
    scene = lp.Scene.parse(SCENE.format(body=BOX, ambient="1.0"))
    reference, errors, ran = tmp_path / "ref.vtkhdf", [], []
    for cell in (0.25, 0.25, 0.125):
        if cell == 0.125 or not reference.exists():
            lp.run(scene.set("grid.cell", cell), output=reference, progress=False)
        table = tradeoff(scene, {"grid.cell": [0.5]}, reference, repeats=1,
                         store=tmp_path / "kept.jsonl", runner=InProcess(),
                         report=lambda *a: ran.append(a))  # fmt: skip
        errors.append(table.rows[0].error)
    assert len(ran) == 2
    assert errors[0] == errors[1] != errors[2]


@pytest.mark.parametrize("error", [MemoryError("none left"), OSError("disk full"),
                                   ValueError("needs 3 GB of memory")])  # fmt: skip
def test_cases_that_memory_or_a_file_was_wanting_for_are_tried_again(
    error: Exception, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene, store, ran = lp.Scene.parse(SCENE.format(body=BOX, ambient="1.0")), tmp_path / "k", []

    def fail(case: Case) -> None:
        raise error

    with monkeypatch.context() as patched:
        patched.setattr(Case, "_run", fail)
        results = study(scene, {COEFFICIENT: [1.0]}, store=store, runner=InProcess())
        assert len(results.failed) == 1
    assert study_of(scene, tmp_path / "other", []) > 0
    again = study(scene, {COEFFICIENT: [1.0]}, store=store, runner=InProcess(),
                  report=lambda *a: ran.append(a))  # fmt: skip
    assert len(ran) == 1
    assert len(again.finished) == 1


def test_cases_that_are_refused_or_diverge_are_not_tried_again(tmp_path: Path) -> None:
    scene, store, ran = lp.Scene.parse(SCENE.format(body=BOX, ambient="1.0")), tmp_path / "k", []
    for _ in range(2):
        study(scene, {"time.step": [1e3]}, store=store, runner=InProcess(),
              report=lambda *a: ran.append(a))  # fmt: skip
    assert len(ran) == 1


def test_rows_kept_elsewhere_serve_where_inputs_are_the_same(tmp_path: Path) -> None:
    ran: list[object] = []
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        put_points(tmp_path / folder / "input", 4)
        (tmp_path / folder / "s.toml").write_text(SCENE.format(**INPUTS["points"][1]))
        if folder == "two":
            shutil.copy(tmp_path / "one" / "k", tmp_path / "two" / "k")
        study_of(tmp_path / folder / "s.toml", tmp_path / folder / "k", ran)
    assert len(ran) == 1
    assert json.loads((tmp_path / "two" / "k").read_text())["row"]["passing"] is False
