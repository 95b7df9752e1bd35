"""Columns of the history are told by names: what would be lost behind another is refused."""

from __future__ import annotations

import itertools

import pytest

import lapilli as lp

SQUARE = lp.Box(lower=(0, 0), upper=(1, 1))
LEFT = lp.HalfSpace(point=(0.001, 0), normal=(1, 0))
RIGHT = lp.HalfSpace(point=(0.999, 0), normal=(-1, 0))


def heated(*names: str, source: float = 0.0) -> lp.Scene:
    """A square with a flux on its left, one on its right and one elsewhere."""
    regions = itertools.chain((LEFT, RIGHT), itertools.repeat(None))
    return lp.Scene(
        grid=lp.Grid(lower=(-0.2, -0.2), upper=(1.2, 1.2), cell=0.1),
        bodies=[
            lp.Body(
                shape=SQUARE,
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
                source=source,
            )
        ],
        heat=lp.Heat(
            boundaries=[
                lp.Flux(name=name, value=10.0**k, region=region)
                for k, (name, region) in enumerate(zip(names, regions, strict=False))
            ]
        ),
        time=lp.Time(end=0.01),
    )


def loaded(obstacles: list[str], tractions: list[str]) -> lp.Scene:
    return lp.Scene(
        grid=lp.Grid(lower=(-1, -1), upper=(4, 2), cell=0.25),
        bodies=[
            lp.Body(
                shape=SQUARE,
                material=lp.Elastic(density=1, youngs_modulus=1, poissons_ratio=0.3),
            )
        ],
        dynamics=lp.Dynamics(
            obstacles=[
                lp.Obstacle(name=name, shape=lp.Disk(center=(2.5 + k, 0.5), radius=0.4))
                for k, name in enumerate(obstacles)
            ],
            boundaries=[
                lp.Pressure(name=name, value=1e-6, region=region)
                for name, region in zip(tractions, (LEFT, RIGHT), strict=False)
            ],
        ),
        time=lp.Time(end=0.01),
    )


@pytest.mark.parametrize(
    ("scene", "places"),
    [
        (heated("air", "air", "rest"), ("heat.boundaries[1].name", "heat.boundaries[0].name")),
        (heated("hot air", "hot_air"), ("heat.boundaries[1].name", "heat.boundaries[0].name")),
        (heated("flux 2", "", "rest"), ("heat.boundaries[1]", "heat.boundaries[0].name")),
        (heated("", "flux 1"), ("heat.boundaries[1].name", "heat.boundaries[0]")),
        (heated("source", source=1.0), ("heat.boundaries[0].name", "the balance itself")),
        (loaded(["a", "a"], []), ("dynamics.obstacles[1].name", "dynamics.obstacles[0].name")),
        (loaded([], ["a", "a"]), ("dynamics.boundaries[1].name", "dynamics.boundaries[0].name")),
        (loaded(["a"], ["a"]), ("dynamics.obstacles[0].name", "dynamics.boundaries[0].name")),
        (loaded(["gravity"], []), ("dynamics.obstacles[0].name", "the balance itself")),
    ],
)
def test_a_name_that_is_given_twice_is_refused(scene: lp.Scene, places: tuple[str, str]) -> None:
    with pytest.raises(ValueError, match="told by their names") as error:
        lp.Simulation(scene)
    for place in places:
        assert place in str(error.value)


def test_every_condition_has_its_column() -> None:
    result = lp.run(heated("air", "", "source"), progress=False)
    columns = [name for name in result.history if "supplied_by" in name]
    assert columns == [f"heat/supplied_by_{name}" for name in ("air", "flux_2", "source")]
    given = sum(result.history[name][-1] for name in columns)
    stored = result.history["heat/stored"]
    assert given == pytest.approx(stored[-1] - stored[0], rel=1e-9)


def test_names_that_differ_are_taken() -> None:
    lp.Simulation(loaded(["a", "", "b"], ["c", ""]))
