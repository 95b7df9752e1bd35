"""A wall between two bodies bears the difference of what presses on its sides, however thin."""

from __future__ import annotations

import pytest

import lapilli as lp

G = 9.81


@pytest.mark.parametrize("cells", [1.6, 2.0, 2.4])
def test_a_wall_between_bodies_bears_the_earth_pressure_at_rest(cells: float) -> None:
    """Bodies two cells apart share the light node in the middle of the wall."""
    h, density, k0 = 0.1, 2000.0, 0.3 / 0.7
    half = 0.5 * cells * h
    material = lp.Elastic(density=density, youngs_modulus=1e6, poissons_ratio=0.3)

    def body(name: str, left: float, right: float, top: float) -> lp.Body:
        return lp.Body(
            name=name,
            shape=lp.Box(lower=(left, 0), upper=(right, top)),
            material=material,
            geostatic=lp.Geostatic(surface=(0, top), normal=(0, 1), k0=k0),
        )

    wall = lp.Box(lower=(1.5 - half, -0.2), upper=(1.5 + half, 1.5))
    faces = ("x_lower", "x_upper", "y_lower")
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(3, 1.6), cell=h),
        bodies=[body("left", 0, 1.5 - half, 1.2), body("right", 1.5 + half, 3, 0.6)],
        dynamics=lp.Dynamics(
            gravity=(0, -G),
            obstacles=[lp.Obstacle(name="o", shape=wall, friction=0.0)],
            grid_boundaries=[lp.RollerBoundary(face=face) for face in faces],
        ),
        time=lp.Time(end=0.3),
    )
    run = lp.Simulation(scene)
    forces = []
    for k in range(10, 31):
        run.run_until(0.01 * k)
        forces.append(run.diagnostics()["dynamics/o_force_x"])
    exact = 0.5 * k0 * density * G * (1.2**2 - 0.6**2)
    assert sum(forces) / len(forces) == pytest.approx(exact, rel=0.03)
