"""An obstacle that moves along a rough face takes material with it; what it leaves behind inside it
is told, with where and how deep."""

from __future__ import annotations

import functools

import numpy as np
import pytest

import lapilli as lp


@functools.cache
def pushed(
    face: str,
    *,
    unit: float = 1.0,
    end: float = -0.2,
    angle: float = 90.0,
    cell: float = 0.05,
    offset: float = 0.0,
) -> tuple[np.ndarray, float, list[str]]:
    """A wall at an angle to the floor, which reaches down to `end`, is pushed .2 m into sand;
    lengths in `unit` of a metre. How deep points lie behind its face, in cells; the force over the
    second half of the way, N; and the notes."""
    lean, start = np.tan(np.radians(90 - angle)), 0.1 + offset * cell
    floor = {
        "no_slip": lp.NoSlipBoundary(face="y_lower"),
        "rough": lp.FrictionalBoundary(face="y_lower", coefficient=1.0),
    }[face]

    def drawn(corners: list[tuple[float, float]]) -> lp.Polygon:
        return lp.Polygon(vertices=[((start + x + lean * y) / unit, y / unit) for x, y in corners])

    scene = lp.Scene(
        grid=lp.Grid(lower=(-0.6 / unit, 0), upper=(1.5 / unit, 0.8 / unit), cell=cell / unit),
        bodies=[
            lp.Body(
                name="sand",
                shape=lp.Intersection(
                    shapes=[
                        drawn([(0, 0), (3, 0), (3, 0.3), (0, 0.3)]),
                        lp.Box(lower=(-1 / unit, 0), upper=(1.5 / unit, 1 / unit)),
                    ]
                ),
                material=lp.MohrCoulomb(
                    density=1700 * unit**3,
                    youngs_modulus=1e6 * unit,
                    poissons_ratio=0.3,
                    friction_angle=32,
                    cohesion=100 * unit,
                ),
            )
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -9.81 / unit),
            grid_boundaries=[floor, lp.RollerBoundary(face="x_upper")],
            obstacles=[
                lp.Obstacle(
                    name="wall",
                    shape=drawn([(-0.5, end), (0, end), (0, 0.6), (-0.5, 0.6)]),
                    contact="frictional",
                    friction=0.3,
                    velocity=(0.5 / unit, 0),
                )
            ],
        ),
        time=lp.Time(end=0.4),
    )
    simulation = lp.Simulation(scene)
    forces = []
    for time in np.linspace(0.2, 0.4, 20):
        simulation.run_until(time)
        forces.append(-simulation.diagnostics()["dynamics/wall_force_x"])
    place = np.asarray(simulation.position) * unit
    behind = (start + 0.2 + lean * place[:, 1] - place[:, 0]) * np.sin(np.radians(angle))
    return behind[place[:, 1] > end] / cell, float(np.mean(forces)), simulation.warnings()


def told(notes: list[str]) -> list[str]:
    return [note for note in notes if "inside it" in note]


@pytest.mark.parametrize("face", ["no_slip", "rough"])
@pytest.mark.parametrize("angle", [75, 90, 120])
@pytest.mark.parametrize(("end", "offset"), [(-0.2, 0.0), (0.0, 0.4), (0.01, 0.2)])
def test_a_wall_leaves_nothing_behind(face: str, angle: float, end: float, offset: float) -> None:
    """No slip left up to 4 cells behind, 7 where the wall ended on the floor."""
    depth, _, notes = pushed(face, angle=angle, end=end, offset=offset)
    assert depth.max() < 0.4
    assert not told(notes)


@pytest.mark.parametrize("angle", [75, 90, 120])
def test_the_force_does_not_depend_on_the_cells(angle: float) -> None:
    """It fell by 8 to 20 %, and no slip took 10 to 60 % more than friction that never slips."""
    coarse, fine = (pushed("no_slip", angle=angle, cell=cell)[1] for cell in (0.05, 0.025))
    rough = pushed("rough", angle=angle, cell=0.025)[1]
    assert coarse == pytest.approx(fine, rel=0.07)
    assert fine == pytest.approx(rough, rel=0.07)


@pytest.mark.parametrize(
    ("end", "said"), [(-0.2, False), (-0.01, False), (0.0, False), (0.02, True), (0.1, False)]
)
def test_an_end_just_before_a_face_is_told(end: float, said: bool) -> None:
    """What passes under it lies up to 5 cells behind its face."""
    _, _, notes = pushed("no_slip", end=end)
    assert any("ends 0.4 cells from it" in note for note in notes) == said


@pytest.mark.parametrize("unit", [1.0, 1e-3])
def test_what_a_wedge_leaves_behind_is_told(unit: float) -> None:
    depth, _, notes = pushed("no_slip", unit=unit, angle=45)
    assert depth.max() > 0.5
    assert len(told(notes)) == 1
    assert f"wall: {(depth > 0.5).sum()} points" in told(notes)[0]
    assert f"the deepest {depth.max():.2f}"[:-1] in told(notes)[0]
