"""Loads on bodies that touch others, and on regions that the material leaves."""

from __future__ import annotations

from pathlib import Path

import pytest

import lapilli as lp


def block_on_base(density: float, height: float, law: lp.Pressure | lp.Traction) -> float:
    """Impulse of a load of 1 kPa on the side of a block that slides on a base of this density, over
    the exact one."""
    block = lp.Elastic(density=1000, youngs_modulus=1e7, poissons_ratio=0.3)
    base = lp.Elastic(density=density, youngs_modulus=1e7, poissons_ratio=0.3)
    bodies = [
        lp.Body(
            name="block",
            shape=lp.Box(lower=(0.5, 0.4), upper=(1.1, 0.4 + height)),
            material=block,
        ),
        lp.Body(name="base", shape=lp.Box(lower=(0, 0), upper=(2, 0.4)), material=base),
    ]
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(2, 1.5), cell=0.1),
        bodies=bodies,
        dynamics=lp.Dynamics(
            gravity=(0, -9.81),
            contacts=[lp.BodyContact()],
            grid_boundaries=[lp.NoSlipBoundary(face="y_lower")],
            boundaries=[law],
        ),
        time=lp.Time(end=0.05),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(0.05)
    own = simulation["body"] == 0
    mass = (simulation["density"] * simulation["volume"])[own]
    return float(mass @ simulation["velocity"][own, 0]) / (1e3 * height * 0.05)


@pytest.mark.parametrize("density", [100.0, 1000.0, 10000.0])
@pytest.mark.parametrize("height", [0.3, 0.6])
def test_a_load_acts_on_the_body_whose_surface_it_is(density: float, height: float) -> None:
    """By mass, the block got .84 to .99 of the pressure and .91 to 1.16 of the traction, by the
    density of the base. What a traction has too much is the corner at the edge of the region."""
    side = lp.Box(lower=(0.3, 0.4), upper=(0.55, 0.4 + height))
    pressure = block_on_base(density, height, lp.Pressure(value=1e3, region=side))
    assert pressure == pytest.approx(1, abs=0.02)  # 1.0005 to 1.007
    traction = block_on_base(density, height, lp.Traction(value=(1e3, 0), region=side))
    assert traction == pytest.approx(1, abs=0.07)  # 1.016 to 1.053


@pytest.mark.parametrize(("lower", "warned"), [(0.99, True), (0.7, False)])
def test_a_region_that_the_surface_leaves_is_a_warning(
    lower: float, warned: bool, tmp_path: Path
) -> None:
    """The top of a column that a load presses down by a tenth."""
    column = lp.Body(
        shape=lp.Box(lower=(0, 0), upper=(0.5, 1)),
        material=lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3),
    )
    top = lp.Box(lower=(-1, lower), upper=(2, 2))
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(0.5, 1.5), cell=0.1),
        bodies=[column],
        dynamics=lp.Dynamics(
            local_damping=0.6,
            grid_boundaries=[
                lp.RollerBoundary(face=face) for face in ("x_lower", "x_upper", "y_lower")
            ],
            boundaries=[lp.Pressure(name="load", value=1e5, region=top)],
        ),
        time=lp.Time(end=1.0),
    )
    result = lp.run(scene, output=str(tmp_path / "column.vtkhdf"), every=1.0)
    assert any("load" in note and "moved out" in note for note in result.warnings) == warned
