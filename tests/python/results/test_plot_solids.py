"""Obstacles and the walls of fluids are painted where they are, not where points happen to lie."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp

pytest.importorskip("matplotlib")
from lapilli import plot
from lapilli.plot.solids import placed, scene_of

ROCK = lp.Elastic(density=2000, youngs_modulus=1e5, poissons_ratio=0.3)


def ground(obstacle: lp.Obstacle) -> lp.Scene:
    """A shallow block with room for an obstacle above it."""
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(2, 2), cell=0.1),
        bodies=[lp.Body(shape=lp.Box(lower=(0, 0), upper=(2, 0.3)), material=ROCK)],
        dynamics=lp.Dynamics(
            gravity=(0, -9.81),
            grid_boundaries=[lp.NoSlipBoundary(face="y_lower"), lp.RollerBoundary(face="x_lower"),
                             lp.RollerBoundary(face="x_upper")],
            obstacles=[obstacle],
        ),
        time=lp.Time(end=0.2),
    )  # fmt: skip


def at(scene: lp.Scene, path: Path, time: float, place: tuple[float, float]) -> float:
    """The distance from the obstacle of a run at a time."""
    frames = lp.run(scene, path / "run.vtkhdf", every=0.1, progress=False).frames
    again = scene_of(frames)
    assert again is not None
    assert again.dynamics is not None
    shape = placed(again.dynamics.obstacles[0], frames, time)
    assert shape is not None
    return float(shape.distance([place])[0])


def test_an_obstacle_in_prescribed_motion(tmp_path: Path) -> None:
    """A bar that gains speed, and turns by a quarter meanwhile."""
    bar = lp.Obstacle(
        name="bar",
        shape=lp.Box(lower=(0.9, 0.95), upper=(1.1, 1.05)),
        velocity=(2.0, 1.0),
        center=(1.0, 1.0),
        revolutions_per_second=2.5,
        factor=lp.Table(times=[0.0, 0.2], values=[0.0, 1.0]),
    )
    middle = (1.0 + 0.2, 1.0 + 0.1)  # half of .2 s at the full speed
    scene = ground(bar)
    assert at(scene, tmp_path, 0.2, (middle[0], middle[1] + 0.1)) == pytest.approx(0, abs=1e-9)
    assert at(scene, tmp_path, 0.2, (middle[0] + 0.05, middle[1])) == pytest.approx(0, abs=1e-9)


def test_an_obstacle_that_falls(tmp_path: Path) -> None:
    ball = lp.Obstacle(name="ball", shape=lp.Disk(center=(1, 1.5), radius=0.2), mass=10.0)
    fallen = 0.5 * 9.81 * 0.2**2
    found = at(ground(ball), tmp_path, 0.2, (1.0, 1.3 - fallen))
    assert found == pytest.approx(0.0, abs=2e-3)


def pixels(figure: object) -> np.ndarray:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas = FigureCanvasAgg(figure)  # type: ignore[arg-type, no-untyped-call]
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].astype(int)


def is_solid(pixel: np.ndarray) -> bool:
    """Whether it has the grey of what is solid."""
    return bool(np.abs(pixel - 204).max() <= 1)


def test_an_obstacle_is_seen(tmp_path: Path) -> None:
    """Beside a step: .3 m by .3 m of a picture of some 2 m by 1 m."""
    block = lp.Obstacle(name="block", shape=lp.Box(lower=(1.3, 0.5), upper=(1.6, 0.8)))
    scene = ground(block)
    step = [(0, 0), (2, 0), (2, 0.3), (1, 0.3), (1, 1), (0, 1)]
    scene.bodies[0].shape = lp.Polygon(vertices=step)
    frames = lp.run(scene, tmp_path / "run.vtkhdf", progress=False).frames
    figure = plot.draw(frames, "velocity")
    image = pixels(figure)
    axes = figure.axes[0]
    for place, is_grey in (((1.35, 0.55), True), ((1.55, 0.75), True), ((1.65, 0.65), False)):
        column, row = axes.transData.transform(place)
        pixel = image[image.shape[0] - 1 - round(row), round(column)]
        assert is_solid(pixel) == is_grey


def test_a_round_wall_is_round(tmp_path: Path) -> None:
    """Its points are a staircase with a hole; painted is the disk that was drawn."""
    hot = lp.Disk(center=(0.51, 0.47), radius=0.25)
    box = lp.Box(lower=(0, 0), upper=(1, 1))
    outer = lp.Difference(shape=lp.Box(lower=(-0.5, -0.5), upper=(1.5, 1.5)), minus=box)
    scene = lp.Scene(
        grid=lp.Grid(lower=(-0.5, -0.5), upper=(1.5, 1.5), cell=0.1),
        bodies=[
            lp.Body(
                shape=lp.Difference(shape=box, minus=hot),
                points_per_cell=1,
                temperature=0.5,
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            walls=[
                lp.FluidWall(name="hot", shape=hot, heat="temperature", temperature=1.0),
                lp.FluidWall(name="cold", shape=outer, heat="temperature"),
            ],
        ),
        time=lp.Time(end=0.01),
    )
    figure = plot.draw(lp.run(scene, tmp_path / "run.vtkhdf", progress=False).frames)
    image = pixels(figure)
    axes = figure.axes[0]
    for angle in np.linspace(0, 2 * math.pi, 24, endpoint=False):
        for radius, is_grey in ((0.22, True), (0.29, False)):
            place = np.array(hot.center) + radius * np.array([math.cos(angle), math.sin(angle)])
            column, row = axes.transData.transform(place)
            pixel = image[image.shape[0] - 1 - round(row), round(column)]
            assert is_solid(pixel) == is_grey
