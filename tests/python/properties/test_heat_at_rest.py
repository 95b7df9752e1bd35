"""Heat in bodies at rest on scenes nobody tuned: any pose, any size on the grid, any exchange.

Round bodies and boxes are held to exact solutions; the others to themselves, moved and turned.
Bars: the heat taken up within 1 % (1.25 where it is less than three cells deep, 2 at two) and the
field within 1 % of the span from 12 cells across on (twice that below), nothing beyond the range.
"""

import numpy as np
import pytest

import lapilli as lp
from lapilli.references.radial import RadialProblem, RadialSolution
from lapilli.references.slab import convective_box, convective_box_mean
from lapilli.references.thermal import Convection, Medium, Prescribed


def grid_around(reach, cell, rng):
    """A grid whose lines lie anywhere under a body within `reach` of the origin."""
    lower = -reach - (2.2 + rng.uniform(0, 1, 2)) * cell
    cells = np.ceil((2 * reach + 4.4 * cell) / cell) + 1
    return lp.Grid(lower=list(lower), upper=list(lower + cells * cell), cell=cell)


def simulate(scene, end):
    """The state at the end, and how far the temperatures ever left the range."""
    simulation = lp.Simulation(scene)
    low, high = np.inf, -np.inf
    took = 0.0
    while simulation.time + 1.5 * took < end:
        before = simulation.time
        simulation.step()
        took = simulation.time - before
        if simulation.step_index % 5 == 0 or simulation.step_index < 20:
            values = simulation["temperature"]
            low, high = min(low, values.min()), max(high, values.max())
    simulation.run_until(end)
    return simulation, low, high


def drawn(seed):
    """A shape at rest at 0 K in surroundings at 1 K: the scene, where it ends and what is exact."""
    rng = np.random.default_rng(seed)
    kind = ("disk", "annulus", "box")[seed % 3]
    held = seed % 4 == 3
    cells = rng.integers(6, 21)  # across the smallest feature
    scale = 10 ** rng.uniform(-3, 3)
    medium = Medium(
        density=10 ** rng.uniform(0, 4),
        specific_heat=10 ** rng.uniform(1, 3),
        conductivity=10 ** rng.uniform(-2, 2),
    )
    biot = 10 ** rng.uniform(-2, 3)
    coefficient = biot * medium.conductivity / scale
    if kind == "disk":
        feature, reach = 2.0, 1.0
    elif kind == "annulus":
        inner = rng.uniform(0.25, 0.6)
        feature, reach = 1.0 - inner, 1.0
    else:
        half = np.array([1.0, rng.uniform(0.3, 1.0)])
        feature, reach = 2 * half.min(), np.hypot(*half)
        held = False
    cell = feature / cells
    # From when the heat is two cells deep to when half of it is in.
    shallow = (2 * cell) ** 2
    fourier = np.exp(rng.uniform(np.log(shallow), np.log(max(shallow, 0.1 * feature**2))))
    end = fourier * scale**2 / medium.diffusivity
    centre = rng.uniform(-0.5, 0.5, 2) * cell
    angle = rng.uniform(0, 360)
    shape = {
        "disk": lambda: lp.Disk(center=list(scale * centre), radius=scale),
        "annulus": lambda: lp.Annulus(
            center=list(scale * centre), inner=scale * inner, outer=scale
        ),
        "box": lambda: lp.Box(lower=list(-scale * half), upper=list(scale * half)),
    }[kind]()
    law = (
        lp.PrescribedTemperature(value=1.0)
        if held
        else lp.Convection(coefficient=coefficient, ambient=1.0)
    )
    body = lp.Body(
        shape=shape,
        material=lp.Thermal(
            density=medium.density,
            specific_heat=medium.specific_heat,
            conductivity=medium.conductivity,
        ),
    )
    if kind == "box":
        body.rotation = angle
        body.translation = list(scale * centre)
    scene = lp.Scene(
        grid=grid_around(scale * (reach + cell), scale * cell, rng),
        bodies=[body],
        heat=lp.Heat(boundaries=[law]),
        time=lp.Time(end=end),
    )
    if rng.uniform() < 0.3:
        scene = scene.set("heat.time_integration=implicit").set("time.steps=60")

    def exact(position):
        x = position - scale * centre
        if kind == "box":
            turn = np.radians(angle)
            axes = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
            local = np.clip(x @ axes, -scale * half, scale * half)
            widths = scale * half
            field = convective_box(
                local, end, half_widths=widths, coefficient=coefficient, medium=medium
            )
            mean = convective_box_mean(
                end, half_widths=widths, coefficient=coefficient, medium=medium
            )
            return field, float(mean) * 4 * np.prod(widths) * medium.capacity
        wall = (
            Prescribed(temperature=1.0) if held else Convection(coefficient=coefficient, ambient=1)
        )
        round_body = RadialProblem(
            inner=0.0 if kind == "disk" else scale * inner,
            outer=scale,
            dimension=2,
            at_outer=wall,
            medium=medium,
            **({} if kind == "disk" else {"at_inner": wall}),
        )
        solution = RadialSolution(round_body)
        radius = np.clip(np.hypot(*x.T), round_body.inner, scale)
        return solution.temperature(radius, end), float(solution.heat_content(end))

    exchange = "held" if held else f"Biot {biot:.3g}"
    about = f"{kind}, {cells} cells, {exchange}, Fourier number {fourier:.3g}"
    return scene, end, exact, cells, about


@pytest.mark.parametrize(
    "seed", [*range(12), *(pytest.param(k, marks=pytest.mark.slow) for k in range(12, 48))]
)
def test_drawn_bodies_take_up_their_heat(seed):
    scene, end, exact, cells, about = drawn(seed)
    simulation, low, high = simulate(scene, end)
    balance = simulation.balance()[0]
    field, heat = exact(simulation["position"])
    bar = 0.01 if cells >= 12 else 0.02
    # Heat two cells deep is resolved to 1.2 or 1.3 % however small the steps (seeds 2 and 13); 27
    # explicit steps add .6 % to that (seed 13).
    material = scene.bodies[0].material
    diffusivity = material.conductivity / (material.density * material.specific_heat)
    deep = np.sqrt(diffusivity * end) / scene.grid.cell
    of_heat = bar * (2.0 if deep < 2.05 else 1.25 if deep < 3 else 1.0)
    assert abs(balance.residual) <= 1e-12, about
    assert abs((balance.stored - balance.initial) / heat - 1) <= of_heat, about
    assert np.sqrt(np.mean((simulation["temperature"] - field) ** 2)) <= bar, about
    assert low >= -0.02, about
    assert high <= 1.02, about


@pytest.mark.parametrize("degrees", [0.0, 20.0, 45.0])
@pytest.mark.parametrize("ratio", [0.1, 2.0, 10.0])
def test_layers_in_series_conduct_as_they_should(degrees: float, ratio: float):
    """Two bars end to end, the interface anywhere in its cells: the flux of the exact resistances
    within 2 % (.8 % at 20, 1.5 % at 45 degrees; it was 5 % with functions that have no kink)."""
    first, second, height, cell = 0.43, 0.57, 0.5, 0.05
    thin = 1e-3 * cell

    def box(left: float, right: float, margin: float = 0.0) -> lp.Shape:
        lower, upper = (0.013 + left, 0.027 - margin), (0.013 + right, 0.027 + height + margin)
        return lp.Rotated(shape=lp.Box(lower=lower, upper=upper), degrees=degrees)

    end = first + second
    scene = lp.Scene(
        grid=lp.Grid(lower=(-1.0, -0.5), upper=(1.5, 2.0), cell=cell),
        bodies=[
            lp.Body(
                shape=box(left, right),
                material=lp.Thermal(density=1.0, specific_heat=1.0, conductivity=conductivity),
                temperature=0.5,
            )
            for left, right, conductivity in ((0.0, first, 1.0), (first, end, ratio))
        ],
        heat=lp.Heat(
            boundaries=[
                lp.PrescribedTemperature(name="hot", value=1.0, region=box(-thin, thin, 1.0)),
                lp.PrescribedTemperature(
                    name="cold", value=0.0, region=box(end - thin, end + thin, 1.0)
                ),
            ]
        ),
        time=lp.Time(end=3.0),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(2.9)
    before = simulation.balance()[0].entries
    simulation.run_until(3.0)
    after = simulation.balance()[0].entries
    exact = 0.1 * height / (first + second / ratio)
    for name, sign in (("hot", 1.0), ("cold", -1.0)):
        assert sign * (after[name] - before[name]) == pytest.approx(exact, rel=0.02)


def warmed_box(degrees: float, cell: float, law: object) -> float:
    """The mean temperature at last, over the exact one, of a box 10.3 m by 7.1 m with a source of
    1 W/m3, held at 0 all round."""
    long, high, reach = 10.3, 7.1, 9.0
    box = lp.Box(lower=(0.2 - long / 2, 0.1 - high / 2), upper=(0.2 + long / 2, 0.1 + high / 2))
    scene = lp.Scene(
        grid=lp.Grid(lower=(-reach, -reach), upper=(reach, reach), cell=cell),
        bodies=[
            lp.Body(
                shape=lp.Rotated(shape=box, degrees=degrees),
                source=1.0,
                material=lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0),
            )
        ],
        heat=lp.Heat(boundaries=[law]),
        time=lp.Time(end=150.0),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    mean = np.average(simulation["temperature"], weights=simulation["volume"])
    odd = np.pi * np.arange(1, 400, 2)
    m, n = np.meshgrid(odd, odd)
    return mean / np.sum(64 / ((m * n) ** 2 * ((m / long) ** 2 + (n / high) ** 2)))


@pytest.mark.parametrize("degrees", [0.0, 17.0, 33.0, 45.0])
def test_a_surface_that_is_held_does_not_lock(degrees: float) -> None:
    """At 7 and 14 cells across; found .08 to .8 %, and 0 to .1 %. Held through 1e-4 cells it was
    0.6 to 17 %, and .1 to 5 %."""
    held = lp.PrescribedTemperature(value=0.0)
    coarse, fine = (abs(warmed_box(degrees, cell, held) - 1) for cell in (1.0, 0.5))
    assert coarse < 0.012
    assert fine < 0.002


def test_exchange_beyond_all_bounds_is_a_held_temperature() -> None:
    """Whatever the coefficient; at 1e8 it was 9 % colder than with 1e3."""
    held = warmed_box(45.0, 1.0, lp.PrescribedTemperature(value=0.0))
    for coefficient in (1e4, 1e6, 1e9, 1e12):
        found = warmed_box(45.0, 1.0, lp.Convection(coefficient=coefficient, ambient=0.0))
        assert found == pytest.approx(held, abs=3 / coefficient + 1e-6)


@pytest.mark.parametrize("biot", [0.3, 3.0, 30.0, 300.0])
def test_exchange_is_one_law_from_weak_to_held(biot: float) -> None:
    """The layer takes over at a coefficient of 5 conductivity / cell, Biot 32 here: the heat of a
    disk of 6.3 cells radius against the series; found .02 to .3 % (.9 % through 1e-4 cells)."""
    radius = 6.3
    for coefficient in (biot / radius, 1.2 * biot / radius):
        scene = lp.Scene(
            grid=lp.Grid(lower=(-8, -8), upper=(8, 8), cell=1.0),
            bodies=[
                lp.Body(
                    shape=lp.Disk(center=(0.37, 0.21), radius=radius),
                    material=lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0),
                )
            ],
            heat=lp.Heat(boundaries=[lp.Convection(coefficient=coefficient, ambient=1.0)]),
            time=lp.Time(end=0.2 * radius**2),
        )
        simulation = lp.Simulation(scene)
        simulation.run_until(simulation.end)
        found = next(one for one in simulation.balance() if one.quantity == "heat").stored
        law = Convection(coefficient=coefficient, ambient=1.0)
        exact = RadialSolution(
            RadialProblem(inner=0.0, outer=radius, dimension=2, at_outer=law)
        ).heat_content(simulation.end)
        assert found == pytest.approx(float(exact), rel=5e-3)
