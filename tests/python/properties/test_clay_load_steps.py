"""Clay in load steps: its ellipse grows and its flow turns within a step."""

from __future__ import annotations

import numpy as np
import pytest

import lapilli as lp

CONFINED = 100.0  # Pa
SHEARED = 180.0


def clay(plastic_compressibility: float, preconsolidation: float) -> lp.ModifiedCamClay:
    return lp.ModifiedCamClay(
        density=1,
        youngs_modulus=2e4,
        poissons_ratio=0.3,
        critical_state_slope=1,
        plastic_compressibility=plastic_compressibility,
        preconsolidation_pressure=preconsolidation,
    )


def cube(
    material: lp.ModifiedCamClay, dimension: int, steps: int, static: lp.QuasiStatic
) -> lp.Simulation:
    scene = lp.Scene(
        grid=lp.Grid(lower=(-1,) * dimension, upper=(2,) * dimension, cell=0.5),
        bodies=[
            lp.Body(
                name="clay",
                shape=lp.Box(lower=(0,) * dimension, upper=(1,) * dimension),
                material=[material],
            )
        ],
        quasi_static=static,
        time=lp.Time(end=1, steps=steps),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(1)
    return simulation


def face(axis: int, side: int, dimension: int) -> lp.HalfSpace:
    """Beyond one side of the unit cube."""
    point, normal = np.zeros((2, dimension))
    point[axis], normal[axis] = side, 1 - 2 * side
    return lp.HalfSpace(point=tuple(point), normal=tuple(normal))


@pytest.mark.parametrize("steps", [1, 4])
def test_pressed_between_plates_a_step_is_as_good_as_a_hundred(steps: int) -> None:
    """Stresses of an oedometer within 0.1 % of 100 steps; one step was 3.1 % off."""
    supports = [
        lp.Support(
            name=f"{axis}{side}",
            kind="roller",
            shape=face(axis, side, 2),
            displacement=(0, lp.Table(times=[0, 1], values=[0, -0.015 * axis * side])),
        )
        for axis in range(2)
        for side in range(2)
    ]
    simulation = cube(clay(0.02, 60), 2, steps, lp.QuasiStatic(supports=supports))
    stress = simulation["stress"].mean(axis=0)[:3]
    np.testing.assert_allclose(stress, [-77.598, -107.383, -77.598], rtol=1e-3)


@pytest.mark.parametrize(("steps", "off"), [(8, 0.11), (20, 0.035), (50, 0.01)])
def test_a_drained_triaxial_test_follows_its_integral(steps: int, off: float) -> None:
    """Strains of confinement and shear under given stress, beside the integral of the law over q,
    of small strains: 0.05616 of the axis. Load steps differ by what the strain turns within one;
    they were 17, 7 and 2.8 % off."""
    supports = [
        lp.Support(name=f"{axis}", kind="roller", shape=face(axis, 0, 3)) for axis in range(3)
    ]
    tractions = [
        lp.SurfaceTraction(
            name=f"{axis}",
            shape=face(axis, 1, 3),
            pressure=lp.Table(
                times=[0, 0.5, 1], values=[0, CONFINED, SHEARED if axis == 2 else CONFINED]
            ),
        )
        for axis in range(3)
    ]
    static = lp.QuasiStatic(supports=supports, tractions=tractions)
    simulation = cube(clay(0.08, 120), 3, steps, static)
    place, moved = simulation.position, simulation["displacement"]
    start = place - moved
    top, bottom = (start[:, 2] > 0.5), (start[:, 2] < 0.5)
    strain = (moved[top, 2].mean() - moved[bottom, 2].mean()) / (
        start[top, 2].mean() - start[bottom, 2].mean()
    )
    assert -strain == pytest.approx(0.05616, rel=off)
