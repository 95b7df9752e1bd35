"""What tradeoff counts: costs of all parts, errors of any quantity, references of all kinds."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli.study import InProcess, settings_of, tradeoff
from lapilli.study.fitting import fitted
from lapilli.study.norms import field_errors, scalar_errors
from lapilli.study.observe import common_interval, frames_of, observe
from lapilli.study.same_scene import require_same_problem

SUPPLIED = "heat/supplied_by_convection"


def supplied_name(scene: lp.Scene) -> str:
    """How the history calls the heat through the rims."""
    history = lp.run(scene, progress=False).history
    return next(name for name in history if name.startswith("heat/supplied_by_"))


def test_norms_of_hand_made_errors() -> None:
    volume, truth = np.array([1.0, 3.0]), np.array([1.0, 5.0])
    found = field_errors([truth + np.array([2.0, -1.0]), truth], [truth, truth], [volume, volume])
    assert found["rms"] == pytest.approx(math.sqrt((4 + 3) / 4))
    assert found["max"] == 2.0
    assert found["mean"] == pytest.approx((2 + 3) / 4)
    # the reference spreads by sqrt(3) about its mean of 4
    assert found["relative"] == pytest.approx(found["rms"] / math.sqrt(3))
    vectors = field_errors([np.array([[3.0, 4.0]])], [np.zeros((1, 2))], [np.ones(1)])
    assert vectors["max"] == 5.0
    assert math.isnan(vectors["relative"])  # of nothing
    even = field_errors([np.array([2.2, 2.2])], [np.array([2.0, 2.0])], [np.ones(2)])
    assert even["relative"] == pytest.approx(0.1)
    scalars = scalar_errors([1.0, 4.0], [2.0, 4.0])
    assert scalars == {
        "rms": pytest.approx(math.sqrt(0.5)),
        "max": 1.0,
        "mean": 0.5,
        "relative": pytest.approx(math.sqrt(0.5) / 4),
    }


def test_common_intervals() -> None:
    assert common_interval([0.5, 1.25]) == 0.25
    assert common_interval([0.1, 0.2, 0.3]) == 0.1
    with pytest.raises(ValueError, match="no common interval"):
        common_interval([0.1, 0.100000001])


def test_costs_are_those_of_building_stepping_and_output(ring: lp.Scene) -> None:
    """Parts add up; output is that of the frames which the scene asks for: ten times as many take
    several times as long."""
    ring.grid.cell = 0.1
    few = observe(ring, [1.0], ["temperature"], output_cost=True).cost
    assert min(few.build_seconds, few.cpu_seconds, few.output_seconds) > 0
    total = few.build_seconds + few.cpu_seconds + few.output_seconds
    assert few.total_cpu_seconds == pytest.approx(total)
    assert few.total_wall_seconds > few.wall_seconds > 0
    assert few.peak_memory > 1e7
    ring.output = lp.Output(every=0.02)
    assert frames_of(ring, 1.0, few.steps) == 51
    many = observe(ring, [1.0], ["temperature"], output_cost=True).cost
    assert many.output_seconds > 5 * few.output_seconds
    assert many.steps == few.steps  # frames are timed apart: steps are those of the named times


def test_looking_at_named_times_changes_nothing_else(ring: lp.Scene) -> None:
    ring.time.step = 1 / 64
    seen = observe(ring, [0.25, 0.5, 1.0], ["temperature"])
    simulation = lp.Simulation(ring)
    for one in seen.snapshots:
        simulation.run_until(one.time)
        assert one.fields["temperature"].tobytes() == simulation["temperature"].tobytes()
    assert [one.time for one in seen.snapshots] == [0.25, 0.5, 1.0]
    assert seen.history["time"].tolist() == [0, 0.25, 0.5, 0.75, 1.0]
    # a run that ends before its scene does
    early = observe(ring, [0.5], ["temperature"], output_cost=True)
    assert early.snapshots[0].fields["temperature"].tobytes() == (
        seen.snapshots[1].fields["temperature"].tobytes()
    )
    assert early.cost.steps == 32
    assert early.cost.output_seconds >= 0
    for wrong in ([], [0.0], [2.0], [0.5, 0.5]):
        with pytest.raises(ValueError, match="times must"):
            observe(ring, wrong, [])


def test_any_quantity_has_errors_against_a_finer_run_chosen_by_itself(ring: lp.Scene) -> None:
    name = supplied_name(ring)
    table = tradeoff(
        ring,
        {"grid.cell": [1.0, 0.5]},
        quantities=["temperature", name, "temperature/largest"],
        times=[0.5, 1.0],
        repeats=1,
        runner=InProcess(),
    )
    assert sum("finer run: grid.cell=0.25" in note for note in table.notes) == 3
    for quantity in ("temperature", name, "temperature/largest"):
        coarse, fine = (row.errors[quantity]["rms"] for row in table.rows)
        # measured 7.1, 11 and 5: second order, from cells that hardly resolve the hole
        assert coarse > 2 * fine > 0, quantity
    assert table.unit == "K"
    row = table.rows[0].as_json()
    assert row["max error of temperature"] == row["largest"]
    assert row[f"relative error of {name}"] > 0


def test_scalars_take_numbers_functions_and_runs(ring: lp.Scene, tmp_path: Path) -> None:
    name = supplied_name(ring)
    fine = ring.set("grid.cell=0.25")
    result = lp.run(fine, tmp_path / "fine.vtkhdf", progress=False)
    true = float(result.history[name][-1])
    errors = [
        tradeoff(
            ring,
            {"grid.cell": [0.5]},
            {name: reference},
            quantities=[name],
            repeats=1,
            runner=InProcess(),
        )
        .rows[0]
        .error
        for reference in (true, lambda time: true, tmp_path / "fine.vtkhdf", "finer:grid.cell=0.25")
    ]
    assert errors == pytest.approx([errors[0]] * 4, rel=1e-9)
    assert 0 < errors[0] < 0.1 * true


def test_a_norm_ranks(ring: lp.Scene) -> None:
    study = {"vary": {"grid.cell": [0.5]}, "reference": "radial", "repeats": 1}
    rms, most, relative = (
        tradeoff(ring, **study, norm=norm, runner=InProcess()).rows[0]
        for norm in ("rms", "max", "relative")
    )
    assert rms.error < most.error == most.largest
    assert relative.error == rms.errors["temperature"]["relative"]
    with pytest.raises(ValueError, match="did you mean 'rms'"):
        tradeoff(ring, **study, norm="rsm", runner=InProcess())


@pytest.mark.parametrize(
    ("quantity", "says"),
    [("temperatur", "did you mean 'temperature'"), ("heat/surface_are", "heat/surface_area")],
)
def test_a_misspelt_quantity_is_an_error(ring: lp.Scene, quantity: str, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        tradeoff(ring, {"grid.cell": [0.5]}, quantities=[quantity], runner=InProcess())


def test_refused_failed_unstable_and_inaccurate_are_told_apart(ring: lp.Scene) -> None:
    vary = {"grid.cell": [1.0, 0.5], "time.step": ["auto", "1e3"]}
    table = tradeoff(ring, vary, "radial", repeats=1, runner=InProcess(), target_error=5e-3)
    assert [row.status for row in table.rows] == ["inaccurate", "refused", "measured", "refused"]
    assert "cell=0.5" in table.advice(target_error=5e-3)
    far = tradeoff(
        ring, {"grid.cell": [0.5]}, lambda x, t: 0.1 + 0 * x[:, 0], repeats=1, runner=InProcess()
    )
    assert far.rows[0].status == "inaccurate"  # further off than the size of the reference
    wild = tradeoff(
        ring, {"grid.cell": [0.5]}, lambda x, t: 1e-3 + 0 * x[:, 0], repeats=1, runner=InProcess()
    )
    assert wild.rows[0].status == "unstable"


def test_cells_that_do_not_fit_are_rounded_or_the_grid_grows() -> None:
    scene = lp.Scene(
        grid=lp.Grid(lower=(-5.5, -5.5), upper=(5.5, 5.5), cell=0.5),
        bodies=[lp.Body(shape=lp.Disk(radius=1), material=lp.Thermal(
            density=1, specific_heat=1, conductivity=1))],
        heat=lp.Heat(),
        time=lp.Time(end=1),
    )  # fmt: skip
    settings, notes = fitted(settings_of({"grid.cell": [0.4, 0.5]}), scene)
    assert [str(one) for one in settings] == [f"grid.cell={11 / 28!r}", "grid.cell=0.5"]
    assert "does not fit the grid" in notes[0]
    assert settings[0].apply(scene).grid.cell == 11 / 28
    scene.grid.upper = (5.5, 1.773)  # no cell divides both
    settings, notes = fitted(settings_of({"grid.cell": [0.4]}), scene)
    assert "grows" in notes[0]
    lp.Simulation(settings[0].apply(scene))


def test_the_frames_of_another_scene_are_no_reference(ring: lp.Scene, tmp_path: Path) -> None:
    frames = tmp_path / "ring.vtkhdf"
    lp.run(ring.set("grid.cell=0.25"), frames, progress=False)
    require_same_problem(frames, ring)  # cells may differ
    other = ring.set("heat.boundaries.0.ambient=2")
    vary = {"grid.cell": [0.5]}
    with pytest.raises(ValueError, match=r"another scene: heat\.boundaries\.0\.ambient = 1"):
        tradeoff(other, vary, frames, repeats=1, runner=InProcess())
    # unless that is what is varied
    tradeoff(other, {"heat.boundaries.0.ambient": [1, 2]}, frames, repeats=1, runner=InProcess())
    frames.with_suffix(".json").unlink()
    moved = ring.set("bodies.0.shape.center=[3, 0]").set("grid.upper=[9, 6]")
    table = tradeoff(moved, vary, frames, repeats=1, runner=InProcess())
    assert "outside of the reference: it is of another scene" in table.advice()


def test_a_reference_of_the_wrong_shape_is_named(ring: lp.Scene) -> None:
    table = tradeoff(
        ring, {"grid.cell": [0.5]}, lambda x, t: np.zeros((len(x), 2)), repeats=1,
        runner=InProcess(),
    )  # fmt: skip
    assert "the field is" in table.rows[0].reason
    assert not table.worked


def test_tables_hold_every_cost_and_error(ring: lp.Scene, tmp_path: Path) -> None:
    table = tradeoff(ring, {"grid.cell": [1.0]}, "radial", repeats=2, runner=InProcess())
    table.to_json(tmp_path / "x.json")
    (row,) = json.loads((tmp_path / "x.json").read_text())
    assert row["cpu_seconds"] > 0
    assert row["wall_spread"] >= 0
    parts = [row[name] for name in ("build_seconds", "step_seconds", "output_seconds")]
    assert sum(parts) == pytest.approx(row["cpu_seconds"], rel=0.3)  # medians of two
    table.to_csv(tmp_path / "x.csv")
    assert "relative error of temperature" in (tmp_path / "x.csv").read_text()


def test_one_reference_serves_what_it_knows(ring: lp.Scene) -> None:
    """A shipped reference its field, a function the first field, a number a scalar; a finer run
    serves the rest, and says so."""
    both = {"quantities": ["temperature", "temperature/largest"], "repeats": 1}
    table = tradeoff(ring, {"grid.cell": [0.5]}, "radial", **both, runner=InProcess())
    assert ["temperature/largest" in note for note in table.notes] == [True]
    shipped = table.rows[0].errors["temperature"]["rms"]
    alone = tradeoff(ring, {"grid.cell": [0.5]}, "radial", repeats=1, runner=InProcess())
    assert shipped == alone.rows[0].error
    with pytest.raises(ValueError, match="radial knows the temperature"):
        tradeoff(ring, {"grid.cell": [0.5]}, "radial", field="volume", runner=InProcess())
    with pytest.raises(ValueError, match="scalar of the history, and none is asked for"):
        tradeoff(ring, {"grid.cell": [0.5]}, 1.0, runner=InProcess())
    number = tradeoff(ring, {"grid.cell": [0.5]}, 1.0, **both, runner=InProcess())
    largest = number.rows[0].errors["temperature/largest"]["max"]
    assert 0 < largest < 1  # 1 K is the surroundings' temperature
