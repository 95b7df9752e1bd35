"""Solids from end to end: state in frames and checkpoints, tables, and laws written in Python."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import lapilli as lp

SAND = {"density": 2000.0, "youngs_modulus": 1e6, "poissons_ratio": 0.3}


def column(material: object, end: float = 0.2, cell: float = 0.1) -> lp.Scene:
    """A column of soil, as high as its half is wide, let go on a rough floor."""
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 1.5), cell=cell),
        bodies=[lp.Body(name="sand", shape=lp.Box(lower=(0, 0), upper=(1, 1)), material=material)],
        dynamics=lp.Dynamics(
            gravity=(0, -9.81),
            grid_boundaries=[
                lp.RollerBoundary(face="x_lower"),
                lp.NoSlipBoundary(face="y_lower"),
            ],
        ),
        time=lp.Time(end=end),
    )


def finished(scene: lp.Scene) -> lp.Simulation:
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    return simulation


SOLIDS = [
    lp.DruckerPrager(**SAND, friction_angle=30, cohesion=100),
    lp.VonMises(**SAND, yield_stress=(2e3, 4e3), plastic_strain=(0, 0.1)),
    lp.TabulatedMohrCoulomb(
        **SAND, plastic_strain=(0, 0.1), friction_angle=(35, 30), dilatancy_angle=(10, 0)
    ),
]


@pytest.mark.parametrize("solid", SOLIDS, ids=lambda one: type(one).__name__)
def test_plastic_strain_is_in_frames_and_goes_on_after_a_resume(
    solid: object, tmp_path: Path
) -> None:
    scene = column(solid, end=0.1, cell=0.25)
    scene.output = lp.Output(path=str(tmp_path / "whole.vtkhdf"), every=0.05)
    lp.run(scene, progress=False)
    whole = lp.Frames(tmp_path / "whole.vtkhdf")[-1]
    assert whole["plastic_strain"].max() > 1e-4
    scene.output.path = str(tmp_path / "half.vtkhdf")
    scene.time.end = 0.05
    lp.run(scene, progress=False)
    scene.time.end = 0.1
    lp.run(scene, progress=False, resume=True)
    half = lp.Frames(tmp_path / "half.vtkhdf")[-1]
    for name in ("position", "stress", "plastic_strain"):
        assert np.array_equal(half[name], whole[name])


@pytest.mark.parametrize("solid", SOLIDS, ids=lambda one: type(one).__name__)
def test_solids_read_back_from_toml(solid: object) -> None:
    scene = column(solid)
    assert lp.Scene.parse(scene.to_toml()).bodies[0].material == solid


def test_a_plastic_strain_of_two_solids_is_one_field() -> None:
    scene = column(SOLIDS[0], end=0.02, cell=0.25)
    scene.bodies.append(
        lp.Body(shape=lp.Box(lower=(2, 0), upper=(3, 1)), material=lp.Elastic(**SAND))
    )
    simulation = finished(scene)
    assert simulation["plastic_strain"][simulation.position[:, 0] > 1.8].max() == 0.0


def test_dilatancy_ends_at_the_critical_state() -> None:
    """Column with a dilatancy of 15 degrees that fades over a plastic strain of 0.05: the volume at
    rest is that of one without dilatancy (1.080, what has come apart at the surface) to 2 %
    (measured 0.8 %)."""
    fading = lp.TabulatedMohrCoulomb(
        **SAND, plastic_strain=(0, 0.05), friction_angle=30, dilatancy_angle=(15, 0)
    )
    volume = finished(column(fading, end=1.5))["volume"].sum()
    plain = lp.MohrCoulomb(**SAND, friction_angle=30)
    assert volume == pytest.approx(finished(column(plain, end=1.5))["volume"].sum(), abs=0.02)


# Laws in Python.


def elastic_law(strain: np.ndarray, stress: np.ndarray, state: np.ndarray, step: float) -> object:
    shear = SAND["youngs_modulus"] / 2.6
    bulk = SAND["youngs_modulus"] * 0.3 / (1.3 * 0.4)
    added = 2 * shear * strain
    added[:, :3] += bulk * strain[:, :3].sum(axis=1, keepdims=True)
    return stress + added


def test_an_elastic_law_in_python_is_the_built_in_one() -> None:
    written = finished(column(lp.FunctionSolid(**SAND, function=elastic_law), end=0.05))
    built_in = finished(column(lp.Elastic(**SAND), end=0.05))
    assert written.step_index == built_in.step_index
    scale = np.abs(built_in["stress"]).max()
    assert np.abs(written["stress"] - built_in["stress"]).max() < 1e-11 * scale
    assert np.abs(written.position - built_in.position).max() < 1e-13


def test_a_law_in_python_keeps_its_state_and_knows_the_step() -> None:
    def law(strain: np.ndarray, stress: np.ndarray, state: np.ndarray, step: float) -> object:
        assert strain.shape == stress.shape == (len(state), 6)
        return elastic_law(strain, stress, state, step), state + np.array([step, 2 * step])

    solid = lp.FunctionSolid(**SAND, function=law, state=["age", "twice"])
    simulation = finished(column(solid, end=0.02, cell=0.25))
    assert simulation["age"] == pytest.approx(0.02, rel=1e-12)
    assert simulation["twice"] == pytest.approx(0.04, rel=1e-12)


def failing(function: object, **rest: object) -> lp.Simulation:
    return lp.Simulation(column(lp.FunctionSolid(**SAND, function=function, **rest), cell=0.25))


def test_an_error_in_a_law_keeps_its_type_and_names_the_body() -> None:
    def law(*_: object) -> None:
        raise KeyError("my own")

    with pytest.raises(KeyError, match="my own") as caught:
        failing(law).step()
    if hasattr(caught.value, "__notes__"):
        assert "body 'sand'" in caught.value.__notes__[0]


@pytest.mark.parametrize(
    ("law", "says"),
    [
        (lambda strain, stress, state, step: stress[:-1], "shape"),
        (lambda strain, stress, state, step: stress[:, :4], "4"),
        (lambda strain, stress, state, step: stress * np.nan, "nan for stress xx of point 0"),
        (lambda strain, stress, state, step: "no", "no numbers"),
        (lambda strain, stress, state, step: (stress, state), "no numbers|shape"),
    ],
)
def test_what_a_law_must_not_answer_is_named(law: object, says: str) -> None:
    with pytest.raises(lp.RunError, match=says) as caught:
        failing(law).step()
    assert "body 'sand'" in str(caught.value)


def test_a_state_that_is_not_finite_or_missing_is_named() -> None:
    with pytest.raises(lp.RunError, match="inf for wear of point 0"):
        failing(lambda e, s, state, dt: (s, state + np.inf), state=["wear"]).step()
    with pytest.raises(lp.RunError, match="a pair"):
        failing(lambda e, s, state, dt: s, state=["wear"]).step()


def test_a_law_in_python_is_for_motion_only_and_its_words_are_checked() -> None:
    with pytest.raises(ValueError, match="taken already"):
        failing(elastic_law, state=["stress"])
    with pytest.raises(ValueError, match="words"):
        failing(elastic_law, state=["two words"])
    with pytest.raises(TypeError, match="a function"):
        lp.FunctionSolid(**SAND, function=3.0)


def test_a_subclass_of_a_solid_is_refused() -> None:
    class Mine(lp.Elastic):
        pass

    with pytest.raises(TypeError, match="Elastic"):
        lp.Body(shape=lp.Box(lower=(0, 0), upper=(1, 1)), material=Mine(**SAND))
