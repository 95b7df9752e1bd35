"""The surface of a body given as an image is that of what was drawn, whatever its pixels are to the
cells."""

import math

import numpy as np
import pytest

import lapilli as lp


def seen(image: np.ndarray, pixel: float, cell: float) -> tuple[float, float]:
    """Surface (m) and heat capacity (J/K) of a still body that heat is supplied to."""
    half = 0.5 * len(image) * pixel
    bound = cell * math.ceil((half + cell) / cell)
    shape = lp.Image(values=(image * 1.0).tolist(), pixel=pixel, origin=(-half, -half))
    scene = lp.Scene(
        grid=lp.Grid(lower=[-bound] * 2, upper=[bound] * 2, cell=cell),
        bodies=[
            lp.Body(
                shape=shape,
                temperature=1.0,
                material=lp.Thermal(density=1.0, specific_heat=1.0, conductivity=1.0),
            )
        ],
        heat=lp.Heat(boundaries=[lp.Flux(value=1.0)]),
        time=lp.Time(end=1.0),
    )
    simulation = lp.Simulation(scene)
    stored = simulation.balance()[0].stored
    simulation.run_until(1e-9)
    return simulation.diagnostics()["heat/surface_area"], stored


def drawn(pixels: int, inside) -> np.ndarray:
    place = np.arange(pixels) + 0.5 - 0.5 * pixels
    return inside(*np.meshgrid(place, -place))


def square(pixels: int, side: float, degrees: float) -> np.ndarray:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return drawn(
        pixels, lambda x, y: (abs(c * x + s * y) < side / 2) & (abs(c * y - s * x) < side / 2)
    )


@pytest.mark.parametrize("per_cell", [0.5, 1, 2, 4, 10])
@pytest.mark.parametrize("seed", range(4))
def test_a_drawn_square_has_its_perimeter_at_any_angle(seed: int, per_cell: float):
    """To half a pixel a corner, which is what is drawn of it, and 2.5 % of stairs."""
    generator = np.random.default_rng(seed)
    side = 30 + 10 * generator.random()
    image = square(60, side, generator.uniform(0.0, 90.0))
    surface, stored = seen(image, 0.1, 0.1 * per_cell)
    assert surface == pytest.approx(0.4 * side, rel=0.025 + 2.0 / (4 * side))
    assert stored == pytest.approx(0.01 * image.sum(), rel=4e-3)


@pytest.mark.parametrize("per_cell", [0.5, 1, 2, 4, 10])
@pytest.mark.parametrize("radius", [7.3, 16.0, 28.6])
def test_a_drawn_disk_has_its_perimeter(radius: float, per_cell: float):
    image = drawn(60, lambda x, y: np.hypot(x, y) < radius)
    surface, stored = seen(image, 0.1, 0.1 * per_cell)
    assert surface == pytest.approx(0.2 * math.pi * radius, rel=0.03)
    assert stored == pytest.approx(0.01 * image.sum(), rel=0.015)


@pytest.mark.parametrize("per_cell", [0.3, 0.5, 1, 1.7, 4])
def test_upright_edges_are_those_of_pixels(per_cell: float):
    """A cross with arms of one and three pixels."""
    image = np.zeros((11, 11))
    image[1:10, 4:7] = 1
    image[5, :] = 1
    surface, stored = seen(image, 0.1, 0.1 * per_cell)
    assert surface == pytest.approx(4.0, rel=1e-6)
    assert stored == pytest.approx(0.35, rel=1e-9)
