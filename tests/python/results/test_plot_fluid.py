"""Pictures of fluids and of the walls that hold them."""

from pathlib import Path

import numpy as np
import pytest

import lapilli as lp

pytest.importorskip("matplotlib")
from lapilli import plot
from lapilli.plot import Style
from lapilli.plot.view import view_of


def test_walls_of_a_fluid_are_grey(tmp_path: Path) -> None:
    scene = lp.Scene(
        grid=lp.Grid(lower=(-0.5, -0.5), upper=(1.5, 1.5), cell=0.1),
        bodies=[
            lp.Body(
                name="air",
                shape=lp.Box(lower=(0, 0), upper=(1, 1)),
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
                temperature=1.0,
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            walls=[
                lp.FluidWall(
                    name="left",
                    shape=lp.Box(lower=(-0.3, -0.3), upper=(0, 1.3)),
                    heat="temperature",
                    temperature=5.0,
                )
            ],
        ),
        time=lp.Time(end=0.001),
    )
    result = lp.run(scene, tmp_path / "air.vtkhdf", progress=False)
    assert result.frames.body_names == ["air", "left"]
    view = view_of(result.frames[0], "temperature", Style())
    assert len(view.walls) > 0
    assert len(view.rows) == len(result.body("air"))
    figure = plot.draw(result.frames)
    assert figure.axes[0].collections[1].get_clim()[1] < 5


def test_a_fluid_is_drawn_without_gaps_and_within_its_walls(tmp_path: Path) -> None:
    """Points that have left their rows: a belt has dragged them along."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    sides = {
        "left": ((-0.3, -0.3), (0, 1.3)),
        "right": ((1, -0.3), (1.3, 1.3)),
        "floor": ((0, -0.3), (1, 0)),
        "belt": ((0, 1), (1, 1.3)),
    }
    walls = [lp.FluidWall(name=k, shape=lp.Box(lower=a, upper=b)) for k, (a, b) in sides.items()]
    walls[-1].velocity = (1.0, 0.0)
    scene = lp.Scene(
        grid=lp.Grid(lower=(-0.5, -0.5), upper=(1.5, 1.5), cell=0.1),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0, 0), upper=(1, 1)),
                material=lp.Newtonian(density=1, viscosity=0.05),
            )
        ],
        peridynamics=lp.Peridynamics(flow=lp.PeridynamicFlow(), walls=walls),
        time=lp.Time(end=2.0),
    )
    frames = lp.run(scene, tmp_path / "lid.vtkhdf", progress=False).frames
    figure = plot.draw(frames, "velocity", style=Style(colours="bone", limits=(-1.0, 1.2)))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    image = np.asarray(canvas.buffer_rgba())[::-1, :, :3]
    axes = figure.axes[0]

    def pixels(left: float, right: float) -> np.ndarray:
        ends = axes.transData.transform([(left, 0.02), (right, 0.98)]).round().astype(int)
        (x0, y0), (x1, y1) = ends
        return image[y0:y1, x0:x1].reshape(-1, 3)

    assert (pixels(0.02, 0.98) == 255).all(axis=1).mean() < 2e-3  # white; it was .02
    assert (pixels(-0.15, -0.02) == 204).all()  # the grey of a wall
