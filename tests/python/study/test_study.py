"""Error against cost: settings, references, tables, resuming."""

import importlib
import json
import threading
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli.study import LocalPool, Setting, parse_variation, settings_of, tradeoff
from lapilli.study.measure import Cost, Measurement, reason_of_blow_up
from lapilli.study.reference import interpolate, reference_of
from lapilli.study.runner import InProcess
from lapilli.study.show import short_names
from lapilli.study.table import Table

UNIT = lp.Thermal(density=1, specific_heat=1, conductivity=1)


def test_variations_are_parted_outside_brackets() -> None:
    assert parse_variation("grid.cell=0.4, 0.2") == ("grid.cell", ["0.4", "0.2"])
    text = "heat.boundaries=[{kind='flux', value=1}],[]"
    assert parse_variation(text)[1] == ["[{kind='flux', value=1}]", "[]"]
    for wrong in ("grid.cell", "=1", "grid.cell=", "grid.cell=1,,2"):
        with pytest.raises(ValueError, match="path=value"):
            parse_variation(wrong)


def test_columns_are_named_by_what_tells_them_apart() -> None:
    assert short_names(["grid.cell", "peridynamics.heat.laplacian"]) == ["cell", "laplacian"]
    both = ["peridynamics.heat.horizon", "peridynamics.flow.horizon"]
    assert short_names(both) == ["heat.horizon", "flow.horizon"]


def test_every_combination_is_a_setting(ring: lp.Scene) -> None:
    settings = settings_of({"grid.cell": [0.5, 0.25], "heat.transfer": ["flip", "pic"]})
    assert [str(s) for s in settings][:2] == [
        "grid.cell=0.5, heat.transfer=flip",
        "grid.cell=0.5, heat.transfer=pic",
    ]
    changed = settings[-1].apply(ring)
    assert (changed.grid.cell, changed.heat.transfer) == (0.25, "pic")


def test_interpolation_reproduces_linear_fields() -> None:
    generator = np.random.default_rng(1)
    for dimension in (1, 2, 3):
        known, wanted = generator.random((400, dimension)), generator.random((50, dimension))
        slope = np.arange(1.0, dimension + 1)
        found = interpolate(known, known @ slope + 1, wanted)
        # the ridge of 1e-12 that keeps the fit regular is the only error
        np.testing.assert_allclose(found, wanted @ slope + 1, atol=1e-8)


def test_errors_of_the_ring_fall_with_the_cell(ring: lp.Scene, tmp_path: Path) -> None:
    store = tmp_path / "ring.jsonl"
    study = {"vary": {"grid.cell": [1.0, 0.5, 0.25]}, "reference": "radial", "repeats": 1}
    table = tradeoff(ring, **study, runner=InProcess(), store=store)
    errors = [row.error for row in table.rows]
    # 1.3e-2, 2.1e-3, 7.2e-4: cells of 1 m do not resolve the hole, then nearly second order
    assert errors[0] > 3 * errors[1]
    assert errors[1] > 2.5 * errors[2] > 0
    assert errors[2] < 2e-3
    assert [row.points for row in table.rows] == sorted(row.points for row in table.rows)
    assert "grid.cell=0.25" in table.advice()
    assert f"grid.cell={1.0}" in table.advice(target_error=10 * errors[0])
    assert "no setting tried" in table.advice(target_error=errors[2] / 10)
    table.to_csv(tmp_path / "ring.csv")
    assert (tmp_path / "ring.csv").read_text().startswith("grid.cell,error,largest,cpu_seconds")
    table.to_json(tmp_path / "ring.json")
    assert json.loads((tmp_path / "ring.json").read_text())[0]["grid.cell"] == "1.0"
    table.picture(tmp_path / "ring.png")
    assert (tmp_path / "ring.png").stat().st_size > 1000

    # a stopped study goes on: the half line of a killed run is forgotten, the rest is not run again
    lines = store.read_text().splitlines(keepends=True)
    store.write_text("".join(lines[:2]) + lines[2][:20])
    ran = []
    tradeoff(ring, **study, runner=InProcess(), store=store, report=lambda m, d, n: ran.append(m))
    assert [str(m.setting) for m in ran] == ["grid.cell=0.25"]
    tradeoff(ring, **study, runner=InProcess(), store=store, report=lambda m, d, n: ran.append(m))
    assert len(ran) == 1


def test_refused_settings_stay_with_their_reason(ring: lp.Scene) -> None:
    vary = {"time.step": [1e-3, 1e3]}
    table = tradeoff(ring, vary, "radial", repeats=1, runner=InProcess())
    assert table.rows[0].reason == ""
    assert "above the limit" in table.rows[1].reason
    assert table.rows[1].error is None


def test_a_misspelt_path_is_an_error(ring: lp.Scene) -> None:
    with pytest.raises(ValueError, match="did you mean 'cell'"):
        tradeoff(ring, {"grid.cel": [1]}, "radial", runner=InProcess())


def test_values_beyond_reason_are_unstable() -> None:
    truth = np.linspace(0, 1, 5)
    assert reason_of_blow_up(truth + 0.5, truth, 1.0) == ""
    assert "stray" in reason_of_blow_up(truth * 50, truth, 1.0)
    assert "no longer finite" in reason_of_blow_up(truth * np.nan, truth, 1.0)


def measured(cell: str, error: float | None, seconds: float, repeat: int = 0) -> Measurement:
    cost = Cost(0.75 * seconds, 0.25 * seconds, seconds, 10, 100, 1000)  # stepping, building
    reason = "" if error is not None else "unstable"
    return Measurement(Setting((("grid.cell", cell),)), repeat, error, error, reason, cost)


def test_front_and_median() -> None:
    rows = [measured("a", 1.0, s, k) for k, s in enumerate((1.0, 9.0, 2.0))]
    rows += [measured("b", 0.5, 3.0), measured("c", 0.7, 4.0), measured("d", None, 1.0)]
    settings = list(dict.fromkeys(row.setting for row in rows))
    table = Table.of(settings, rows, "temperature", "K")
    assert [row.cpu_seconds for row in table.rows] == [2.0, 3.0, 4.0, 1.0]
    assert table.rows[0].cpu_spread == 8.0
    assert [str(row.setting) for row in table.front] == ["grid.cell=a", "grid.cell=b"]
    assert "grid.cell=b" in table.advice(target_error=0.6)
    assert "grid.cell=a" in table.advice(budget=2.5)


def test_worker_processes_measure_alike(ring: lp.Scene) -> None:
    study = {"vary": {"grid.cell": [1.0]}, "reference": "radial", "repeats": 2}
    here = tradeoff(ring, **study, runner=InProcess())
    there = tradeoff(ring, **study, runner=LocalPool(2))
    assert there.rows[0].error == here.rows[0].error
    assert there.rows[0].peak_memory > 1_000_000
    # functions of a script or a notebook go with their tasks; what cannot is named
    even = tradeoff(
        ring, {"grid.cell": [1.0]}, lambda x, t: 0.5 + 0 * x[:, 0], repeats=1, runner=LocalPool(1)
    )
    assert even.rows[0].error > here.rows[0].error
    lock = threading.Lock()
    with pytest.raises(ValueError, match="cannot be sent to worker processes"):
        tradeoff(ring, {"grid.cell": [1.0]}, lambda x, t: lock.name, runner=LocalPool(1))


def test_frames_and_finer_runs_are_references(ring: lp.Scene, tmp_path: Path) -> None:
    lp.run(ring, tmp_path / "ring.vtkhdf", progress=False)
    frames = reference_of(tmp_path / "ring.vtkhdf", ring, "temperature", [1.0])
    finer = reference_of("finer:grid.cell=0.25", ring, "temperature", [1.0])
    simulation = lp.Simulation(ring)
    simulation.run_until(1.0)
    position, values = simulation.position, simulation["temperature"]
    # at its own points the fit smooths the run a little; the finer run differs by its error
    assert np.sqrt(np.mean((frames(position, 1.0) - values) ** 2)) < 2e-2
    assert 0 < np.sqrt(np.mean((finer(position, 1.0) - values) ** 2)) < 0.1
    with pytest.raises(ValueError, match="no state at 0\\.5 s"):
        finer(position, 0.5)


def test_a_process_that_dies_is_a_failed_setting(
    ring: lp.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # a reference that takes its process with it, in a module that a spawned process can import
    source = "import os\n\ndef die(position, time):\n    os._exit(7)\n"
    (tmp_path / "deadly_reference.py").write_text(source)
    monkeypatch.syspath_prepend(tmp_path)
    die = importlib.import_module("deadly_reference").die
    table = tradeoff(ring, {"grid.cell": [1.0, 0.5]}, die, repeats=1, runner=LocalPool(2))
    assert [row.error for row in table.rows] == [None, None]
    assert "process died (exit code 7)" in table.rows[0].reason


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_radial_references_know_bar_disk_and_ball(dimension: int) -> None:
    """A flux through the one surface: the mean rises by area over volume."""
    shapes = {
        1: lp.Box(lower=[0], upper=[2]),
        2: lp.Disk(radius=2),
        3: lp.Sphere(radius=2),
    }
    region = lp.Box(lower=[1] * dimension, upper=[3] * dimension) if dimension == 1 else None
    scene = lp.Scene(
        grid=lp.Grid(lower=[-3] * dimension, upper=[3] * dimension, cell=1),
        bodies=[lp.Body(shape=shapes[dimension], material=UNIT)],
        heat=lp.Heat(boundaries=[lp.Flux(value=1, region=region)]),
        time=lp.Time(end=1),
    )
    reference = reference_of("radial", scene, "temperature", [1.0])
    radius = (np.arange(2000) + 0.5) / 1000
    places = np.zeros((2000, dimension))
    places[:, 0] = radius
    mean = np.average(reference(places, 1.0), weights=radius ** (dimension - 1))
    # the midpoint rule on 2000 rings is good to 1e-7
    assert mean == pytest.approx(dimension / 2, rel=1e-5)
