"""What a run records in time: probes, scalars of every physics, the table beside the frames."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli import examples

UNIT = lp.Thermal(density=1, specific_heat=1, conductivity=1)


def plate(**changes: object) -> lp.Scene:
    """A plate at rest with a linear temperature: exact for every probe."""
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 4), cell=0.25),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0.5, 0.5), upper=(3.5, 3.5)),
                material=UNIT,
                temperature=lambda x, s, t: 3 * x[:, 0] - x[:, 1],
            )
        ],
        heat=lp.Heat(),
        time=lp.Time(end=0.02, step=0.001),
        **changes,
    )


def test_a_probe_reads_a_linear_field_exactly_wherever_it_is() -> None:
    places = np.random.default_rng(4).uniform((0.5, 0.5), (3.5, 3.5), (40, 2))
    probes = [lp.Probe(name=f"p{k}", position=place) for k, place in enumerate(places)]
    history = lp.run(plate(probes=probes), progress=False).history
    found = np.array([history[f"p{k}"][0] for k in range(len(places))])
    # at the points the projected start is linear but for the rims, whose points are averaged
    inner = np.all(np.abs(places - 2) < 0.7, axis=1)
    assert inner.sum() >= 3
    np.testing.assert_allclose(found[inner], 3 * places[inner, 0] - places[inner, 1], rtol=1e-9)


def test_probes_come_with_frames_or_at_times_of_their_own(tmp_path: Path) -> None:
    scene = plate(
        probes=[lp.Probe(name="mid", position=(2, 1), every_steps=2)],
        output=lp.Output(path=str(tmp_path / "plate.vtkhdf")),
    )
    result = lp.run(scene, progress=False)
    history = result.history
    assert len(history["time"]) == 1 + result.simulation.step_index // 2 + (
        result.simulation.step_index % 2
    )
    assert history["time"][-1] == 0.02
    record = result.record
    assert record["history"]["mid"] == history["mid"].tolist()
    columns = {row["name"]: row for row in record["history_columns"]}
    assert columns["mid"]["unit"] == "K"
    with (tmp_path / "plate.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["mid"]) for row in rows] == history["mid"].tolist()
    assert [float(row["time"]) for row in rows] == history["time"].tolist()


def test_recording_changes_nothing() -> None:
    quiet = lp.run(plate(), progress=False)
    watched = plate(probes=[lp.Probe(name="mid", position=(2, 1), every=0.0013)])
    watched.output.history_every = 0.0007
    loud = lp.run(watched, progress=False)
    assert loud.simulation.step_index == quiet.simulation.step_index
    assert loud.by_id("temperature").tobytes() == quiet.by_id("temperature").tobytes()
    assert len(loud.history["time"]) > len(quiet.history["time"])


def test_a_resumed_run_has_the_history_of_one_that_was_not_stopped(tmp_path: Path) -> None:
    def scene(name: str, end: float) -> lp.Scene:
        made = ring_scene()
        made.time = lp.Time(end=end, step=1 / 128)
        made.output = lp.Output(path=str(tmp_path / name), every=1 / 16, history_every=3 / 128)
        made.probes = [lp.Probe(name="mid", position=(3, 0), every_steps=3)]
        return made

    whole = lp.run(scene("whole.vtkhdf", 0.25), progress=False)
    lp.run(scene("part.vtkhdf", 0.125), progress=False)
    rest = lp.run(scene("part.vtkhdf", 0.25), progress=False, resume=True)
    assert rest.history.keys() == whole.history.keys()
    for name, values in whole.history.items():
        assert rest.history[name].tobytes() == values.tobytes(), name
    assert (tmp_path / "part.csv").read_bytes() == (tmp_path / "whole.csv").read_bytes()


def ring_scene() -> lp.Scene:
    return lp.Scene(
        grid=lp.Grid(lower=(-6, -6), upper=(6, 6), cell=0.5),
        bodies=[lp.Body(shape=lp.Annulus(inner=1, outer=5), points_per_cell=4, material=UNIT)],
        heat=lp.Heat(boundaries=[lp.Convection(name="rims", coefficient=1, ambient=1)]),
        time=lp.Time(end=0.2),
    )


def test_heat_by_each_boundary_condition_is_recorded() -> None:
    scene = ring_scene()
    scene.output.history_every = 0.02
    result = lp.run(scene, progress=False)
    history = result.history
    supplied = next(name for name in history if name.startswith("heat/supplied_by_"))
    assert "rims" in supplied
    assert history[supplied][-1] == result.balance["heat"].entries["rims"]
    assert np.all(np.diff(history[supplied]) > 0)
    assert history.unit("heat/surface_area") == "m"
    assert history["temperature/smallest"][0] == 0 == history["temperature/largest"][0]
    assert 0 < history["temperature/largest"][-1] < 1
    assert all(history.meaning(name) for name in history)
    with pytest.raises(KeyError, match="no 'x' in the history; there is: time"):
        history["x"]


def test_names_are_snake_case_with_units() -> None:
    for name in lp.run(ring_scene(), progress=False).history:
        assert name == "time" or all(c.islower() or c.isdigit() or c in "_/" for c in name), name


def test_a_material_probe_travels_and_a_fixed_one_sees_the_body_leave() -> None:
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(6, 2), cell=0.25),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0.5, 0.5), upper=(1.5, 1.5)),
                material=UNIT,
                temperature=7,
                motion=lp.Translation(velocity=(3, 0)),
            )
        ],
        heat=lp.Heat(),
        probes=[
            lp.Probe(name="rides", position=(1, 1), material_point=True, field="position"),
            lp.Probe(name="stays", position=(1, 1)),
        ],
        time=lp.Time(end=1.0, step=0.01),
        output=lp.Output(history_every=0.1),
    )
    history = lp.run(scene, progress=False).history
    travelled = history["rides_x"] - history["rides_x"][0]
    np.testing.assert_allclose(travelled, 3 * history["time"], atol=1e-9)
    np.testing.assert_allclose(history["rides_y"], history["rides_y"][0])
    assert history["stays"][0] == pytest.approx(7)
    assert np.isnan(history["stays"][-1])


def test_the_record_holds_numbers_a_reader_of_json_takes(tmp_path: Path) -> None:
    scene = ring_scene()
    scene.time.end = 1.0  # until the heat is as deep as the cells
    lp.run(scene, tmp_path / "ring.vtkhdf", progress=False)
    record = json.loads((tmp_path / "ring.json").read_text())
    assert record["notes"] == []
    scene.heat.theta = 0.7
    lp.run(scene, tmp_path / "ring.vtkhdf", progress=False)
    record = json.loads((tmp_path / "ring.json").read_text())
    assert record["notes"] == ["heat.theta has no effect: heat.time_integration is not implicit"]


@pytest.mark.parametrize("position", [(0, 0), (5.5, 0), (0.99, 0)])
def test_a_probe_outside_of_every_body_is_an_error(position: tuple[float, float]) -> None:
    scene = ring_scene()
    scene.probes = [lp.Probe(name="mid", position=position)]
    with pytest.raises(ValueError, match=r"probes\[0\]\.position lies .* outside of every body"):
        lp.Simulation(scene)


def test_plastic_heat_has_its_column_before_anything_yields() -> None:
    """A column that came later would shift the numbers of all after it."""
    sand = lp.MohrCoulomb(
        density=1000,
        youngs_modulus=1e5,
        poissons_ratio=0.3,
        friction_angle=20,
        dilatancy_angle=0,
        cohesion=50,
    )
    heat = lp.Thermal(density=1000, specific_heat=1, conductivity=1)
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 2), cell=0.25),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(1, 0), upper=(2, 1)),
                material=[sand, heat, lp.PlasticHeating(share=0.5)],
                velocity=(0.5, -1),
            )
        ],
        dynamics=lp.Dynamics(gravity=(0, -10), grid_boundaries=[lp.NoSlipBoundary(face="y_lower")]),
        heat=lp.Heat(),
        time=lp.Time(end=0.1),
        output=lp.Output(every=0.02),
    )
    result = lp.run(scene, progress=False)
    column = result.summary.history["heat/supplied_by_plastic_work"]
    entry = dict(result.balance["heat"].entries)["plastic work"]
    assert column[0] == 0 < column[-1] == entry
    assert result.summary.history["position_y/largest"][0] < 1.01


STARTS = {
    "vhfm/ring": "time.end=1e-3",
    "vhfm/column": "time.end=1e-3",
    "vhfm/swirl": "time.end=1e-3",
    "heat/casting": "time.end=1e-2",
    "heat/pipe": "time.end=1e-2",
    "soil/boulder": "time.end=1e-3",
    "soil/retaining_wall": "time.end=1e-3",
    "soil/slope": "time.end=1e-3",
    "static/beam": "time.steps=1",
    "flow/plume": "time.end=1e-3",
}


@pytest.mark.parametrize("name", STARTS)
def test_every_column_says_what_it_is(name: str) -> None:
    """A column that nobody described repeats its name; energy in the plane is per metre."""
    scene = examples.load(name).set(STARTS[name])
    history = lp.run(scene, progress=False).history
    for column in history:
        meaning = history.meaning(column)
        assert meaning.replace(" ", "_") != column.split("/")[-1], column
        if column.startswith("energy/") and not column.endswith("residual"):
            assert history.unit(column) == ("J/m" if len(scene.grid.lower) == 2 else "J"), column
