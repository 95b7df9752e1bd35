"""What hangs from an obstacle that lets nothing go: said where nothing damps it."""

import pytest

import lapilli as lp
from lapilli import _core


@pytest.mark.parametrize(("damping", "separation"), [(0.0, False), (0.3, False), (0.0, True)])
def test_undamped_hanging_is_noted(damping: float, separation: bool) -> None:
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(2, 2), cell=0.2),
        bodies=[
            lp.Body(
                shape=lp.Box(lower=(0.5, 0.5), upper=(1.5, 1.0)),
                material=lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3),
            )
        ],
        dynamics=lp.Dynamics(
            gravity=(0, -10),
            local_damping=damping,
            obstacles=[
                lp.Obstacle(
                    name="lid",
                    shape=lp.Box(lower=(0.2, 1.0), upper=(1.8, 1.4)),
                    separation=separation,
                )
            ],
        ),
        time=lp.Time(end=0.1),
    )
    said = "dynamics.obstacles.0 (lid) holds what has touched it" in _core.check_text(scene)
    assert said == (damping == 0.0 and not separation)
