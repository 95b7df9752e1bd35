"""Points of one body or wall, out of a result and out of its frames."""

import numpy as np
import pytest

import lapilli as lp


@pytest.fixture(scope="module")
def slab() -> lp.Scene:
    """Fluid at 3 K between two walls that hold 3 and 5 K, which all points together would blur."""
    return lp.Scene(
        grid=lp.Grid(lower=[-0.3], upper=[1.3], cell=0.1),
        bodies=[
            lp.Body(
                name="air",
                shape=lp.Box(lower=[0.0], upper=[1.0]),
                points_per_cell=1,
                material=lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1e-6),
                temperature=3.0,
            )
        ],
        peridynamics=lp.Peridynamics(
            heat=lp.PeridynamicHeat(),
            walls=[
                lp.FluidWall(
                    name=name,
                    shape=lp.Box(lower=[low], upper=[low + 0.3]),
                    heat="temperature",
                    temperature=value,
                )
                for name, low, value in [("left", -0.3, 3.0), ("right", 1.0, 5.0)]
            ],
        ),
        time=lp.Time(end=1e-3),
    )


def test_a_mean_over_a_body_is_one_over_its_points(slab, tmp_path):
    result = lp.run(slab, output=tmp_path / "slab.vtkhdf", every=1e-3, progress=False)
    air = result.body("air")
    assert len(air) == 10
    assert air["temperature"].mean() == pytest.approx(3.0, abs=1e-6)
    assert result["temperature"].mean() > 3.1
    assert np.all(result.body("right")["temperature"] == 5.0)
    assert np.array_equal(result.body(2).position, result.body("right").position)
    frame = result.frames[-1]
    for which in ("air", 0):
        assert np.array_equal(frame.body(which)["temperature"], air["temperature"])


def test_a_body_that_is_not_there_is_named(slab):
    result = lp.run(slab, progress=False)
    with pytest.raises(KeyError, match="no bodies are called 'water'; there are 0: 'air'"):
        result.body("water")
    with pytest.raises(KeyError, match="no body 3; there are 3"):
        result.body(3)
