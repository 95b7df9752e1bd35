"""Runs that go on from the checkpoint of another: whose points are whose, and what of the new scene
does nothing."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core

G = 9.81
DENSITY = {"spoil": 1000.0, "ground": 2000.0, "block": 3000.0, "dam": 1500.0, "cap": 2500.0}
LOWER = {"spoil": 0.2, "ground": 1.0, "block": 2.0, "dam": 3.0, "cap": 3.5}


def rock(density: float) -> lp.Elastic:
    return lp.Elastic(density=density, youngs_modulus=1e6, poissons_ratio=0.3)


def body(name: str) -> lp.Body:
    left = LOWER[name]
    shape = lp.Box(lower=(left, 0.2), upper=(left + 0.4, 0.6))
    return lp.Body(name=name, shape=shape, material=rock(DENSITY[name]))


def row(names: list[str], stages: list[lp.Stage], **dynamics: object) -> lp.Scene:
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 2), cell=0.1),
        bodies=[body(name) for name in names],
        dynamics=lp.Dynamics(**dynamics),
        time=lp.Time(end=0.01),
        stages=stages,
    )


RUNS: dict[str, tuple[list[str], list[lp.Stage]]] = {
    "first goes": (
        ["spoil", "ground", "block"],
        [lp.Stage(name="dig", end=0.02, remove=["spoil"])],
    ),
    "middle goes, two come": (
        ["spoil", "ground", "block"],
        [
            lp.Stage(name="dig", end=0.02, remove=["ground"], add_bodies=[body("dam")]),
            lp.Stage(name="build", end=0.03, remove=["spoil"], add_bodies=[body("cap")]),
        ],
    ),
    "none goes": (["block", "ground"], []),
}


@pytest.mark.parametrize("which", RUNS)
def test_bodies_go_on_with_their_own_points(tmp_path: Path, which: str) -> None:
    names, stages = RUNS[which]
    present = list(names)
    for stage in stages:
        present = [one for one in present if one not in stage.remove]
        present += [one.name for one in stage.add_bodies]
    lp.run(row(names, stages), tmp_path / "run.vtkhdf", progress=False)
    drawn = np.random.default_rng(7)
    for _ in range(6):
        count = int(drawn.integers(1, len(DENSITY) + 1))
        chosen = [str(one) for one in drawn.permutation(list(DENSITY))[:count]]
        if not set(chosen) & set(present):
            continue
        linked = row(chosen, [])
        linked.initial_state = tmp_path / "run.checkpoint"
        simulation = lp.Simulation(linked)
        for number, name in enumerate(chosen):
            own = simulation["body"] == number
            middle = simulation.position[own, 0].mean()
            assert middle == pytest.approx(LOWER[name] + 0.2, abs=0.02), (chosen, name)
            assert simulation["density"][own].mean() == pytest.approx(DENSITY[name], rel=0.01)


@pytest.mark.parametrize("last", ["apic", "blended_apic"])
def test_the_transfer_of_the_last_stage_goes_on(tmp_path: Path, last: str) -> None:
    disk = lp.Body(
        name="disk",
        shape=lp.Disk(center=(1, 1), radius=0.5),
        material=rock(1000),
        spin=6.0,
    )
    scene = row(["ground"], [lp.Stage(name="next", end=0.02, set={"dynamics.transfer": last})])
    scene.bodies = [disk]
    run = lp.run(scene, tmp_path / "run.vtkhdf", progress=False)
    linked = row(["ground"], [], transfer=last)
    linked.bodies = [disk]
    linked.initial_state = tmp_path / "run.checkpoint"
    key = "dynamics/kinetic_energy"
    ended = run.simulation.diagnostics()[key]
    assert lp.Simulation(linked).diagnostics()[key] == pytest.approx(ended, rel=1e-3)


def test_a_body_that_goes_on_keeps_its_mass(tmp_path: Path) -> None:
    lp.run(row(["ground", "block"], []), tmp_path / "run.vtkhdf", progress=False)
    linked = row(["ground", "block"], [])
    linked.bodies[1].material = [rock(500)]
    linked.initial_state = tmp_path / "run.checkpoint"
    with pytest.raises(ValueError, match=r"bodies\[1\].material has a density of 500 .* is 3000"):
        lp.Simulation(linked)


START = {
    "velocity": (1.0, 0.0),
    "spin": 2.0,
    "translation": (0.1, 0.0),
    "rotation": 10.0,
    "geostatic": lp.Geostatic(),
    "points_per_cell": 9,
    "jitter": 0.1,
}


@pytest.mark.parametrize("key", START)
def test_what_a_body_started_with_is_idle_where_it_goes_on(tmp_path: Path, key: str) -> None:
    lp.run(row(["ground"], []), tmp_path / "run.vtkhdf", progress=False)
    linked = row(["ground", "block"], [], gravity=(0, -G))
    for one in linked.bodies:
        setattr(one, key, START[key])
    linked.initial_state = tmp_path / "run.checkpoint"
    said = f"bodies[{{}}].{key} has no effect: the body goes on from initial_state"
    for notes in (
        json.loads(_core.check_json(linked))["notes"],
        lp.run(linked, progress=False).report().splitlines(),
    ):
        assert any(said.format(0) in note for note in notes)
        assert not any(said.format(1) in note for note in notes)


@pytest.mark.parametrize(("points", "cell"), [(4, 0.1), (16, 0.1), (4, 0.05), (1, 0.05), (4, 0.2)])
def test_what_rests_stays_whatever_fill_the_next_scene_asks_for(
    tmp_path: Path, points: int, cell: float
) -> None:
    """Points keep the width that they were filled with, not that of a fill that is not used."""

    def stack(cell: float, end: float, points: int | None = None) -> lp.Scene:
        def box(name: str, below: float, above: float) -> lp.Body:
            return lp.Body(
                name=name,
                shape=lp.Box(lower=(0.4, below), upper=(0.8, above)),
                points_per_cell=points,
                material=lp.Elastic(density=2000, youngs_modulus=2e6, poissons_ratio=0.0),
            )

        return lp.Scene(
            grid=lp.Grid(lower=(0, 0), upper=(1.2, 1.2), cell=cell),
            bodies=[box("low", 0, 0.4), box("high", 0.4, 0.8)],
            dynamics=lp.Dynamics(
                gravity=(0, -G),
                local_damping=0.7,
                grid_boundaries=[lp.RollerBoundary(face="y_lower")],
                contacts=[lp.BodyContact(friction=0.3)],
            ),
            time=lp.Time(end=end),
        )

    lp.run(stack(0.1, 0.3), tmp_path / "rest.vtkhdf", progress=False)
    linked = stack(cell, 0.3, points)
    linked.initial_state = tmp_path / "rest.checkpoint"
    simulation = lp.Simulation(linked)
    before = simulation.by_id("position")[:, 1].copy()
    simulation.run_until(0.3)
    high = simulation.by_id("body") == 1
    moved = (simulation.by_id("position")[:, 1] - before)[high].mean()
    assert abs(moved) < 0.05 * cell
