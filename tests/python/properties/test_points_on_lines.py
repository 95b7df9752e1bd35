"""Heat of points on lines of the grid, where shape functions end: nothing is lost there."""

import numpy as np
import pytest

import lapilli as lp

CELL = 0.2


def scene_of(offset: float, shape_function: str, integration: str, source: float) -> lp.Scene:
    """10 x 10 points of spacing half a cell, the first on a node where the offset is 0."""
    line = 1.0 + 0.5 * CELL * np.arange(10) + offset
    places = np.stack(np.meshgrid(line, line), -1).reshape(-1, 2)
    volumes = np.full(len(places), (0.5 * CELL) ** 2)
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 4), cell=CELL, shape_function=shape_function),
        bodies=[
            lp.Body(
                points=lp.Points(places, volumes),
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
                source=source,
            )
        ],
        heat=lp.Heat(time_integration=integration),
        time=lp.Time(end=0.02, step=0.005),
    )


@pytest.mark.parametrize("integration", ["explicit", "implicit"])
@pytest.mark.parametrize("shape_function", ["linear", "gimp", "bspline"])
@pytest.mark.parametrize("offset", [0.0, 0.05, 0.1, 1e-13, 1e-16 + 0.1])
def test_a_source_heats_all_points_alike(
    offset: float, shape_function: str, integration: str
) -> None:
    result = lp.run(scene_of(offset, shape_function, integration, 3.0), progress=False)
    assert result["temperature"] == pytest.approx(0.06, rel=1e-9)
    assert abs(result.balance["heat"].residual) < 1e-12
