"""Slab series: roots, agreement of early and late forms, symmetry, heat balance, limits."""

import numpy as np
import pytest

from lapilli.references import rod, slab
from lapilli.references.radial import RadialProblem, RadialSolution
from lapilli.references.thermal import Convection, Medium, Prescribed

STONE = Medium(density=2.0, specific_heat=3.0, conductivity=0.5)


@pytest.mark.parametrize("biot", [1e-8, 1e-3, 0.7, 5.0, 100.0, 1e6])
def test_roots(biot):
    roots = slab.convective_roots(biot, 40)
    # each in its own bracket, and a root to the rounding of beta tan(beta) there
    assert np.all(np.floor(roots / np.pi) == np.arange(40))
    residual = roots * np.sin(roots) - biot * np.cos(roots)
    assert np.all(np.abs(residual) < 1e-13 * (1 + roots + biot) * (1 + roots))


def test_tabulated_roots():
    # Carslaw & Jaeger, appendix IV, table I (alpha tan alpha = C), four digits
    assert slab.convective_roots(1.0, 3) == pytest.approx([0.8603, 3.4256, 6.4373], abs=5e-5)
    assert slab.convective_roots(10.0, 3) == pytest.approx([1.4289, 4.3058, 7.2281], abs=5e-5)


def test_early_and_late_form_meet(monkeypatch):
    # at alpha t/a^2 = 0.02 both forms are exact: the difference is rounding
    x = np.linspace(-1, 1, 41)
    for coefficient in (0.1, 1.0, 50.0):
        values = []
        for early in (0.01, 0.03):
            monkeypatch.setattr(slab, "EARLY", early)
            values.append(
                slab.convective_slab(x, 0.02, half_thickness=1.0, coefficient=coefficient)
            )
            values.append(slab.prescribed_slab(x / 2 + 0.5, 0.02, initial=0.3, right=-2.0))
            values.append(slab.convective_box_mean(0.02, half_widths=1.0, coefficient=coefficient))
        for late, early_form in zip(values[:3], values[3:], strict=True):
            assert late == pytest.approx(early_form, abs=2e-13)


def test_slab_against_the_galerkin_solution():
    # two independent methods; the Galerkin one is good to 1e-10 here
    x = np.linspace(0, 5, 101)
    t = [0.05, 0.5, 1.0, 5.0, 40.0]
    wall = Convection(coefficient=2.0, ambient=3.0)
    radial = RadialSolution(
        RadialProblem(inner=0, outer=5, dimension=1, at_outer=wall, initial=-1.0, medium=STONE)
    )
    series = slab.convective_slab(
        x, t, half_thickness=5.0, coefficient=2.0, ambient=3.0, initial=-1.0, medium=STONE
    )
    assert series == pytest.approx(radial.temperature(x, t), abs=1e-9)
    mean = slab.convective_box_mean(
        t, half_widths=5.0, coefficient=2.0, ambient=3.0, initial=-1.0, medium=STONE
    )
    assert mean == pytest.approx(radial.mean_temperature(t), abs=1e-9)


def test_prescribed_faces_against_the_galerkin_solution():
    x = np.linspace(0, 2, 101)
    t = [1e-3, 0.05, 0.16, 1.0]
    radial = RadialSolution(
        RadialProblem(
            inner=0,
            outer=2,
            dimension=1,
            at_inner=Prescribed(temperature=1.0),
            at_outer=Prescribed(temperature=-0.5),
            initial=0.25,
        )
    )
    series = slab.prescribed_slab(x, t, thickness=2.0, left=1.0, right=-0.5, initial=0.25)
    assert series == pytest.approx(radial.temperature(x, t), abs=1e-9)


def test_prescribed_faces_reach_the_linear_profile():
    x = np.linspace(0, 1, 11)
    assert slab.prescribed_slab(x, 10.0) == pytest.approx(1 - x, abs=1e-15)


def test_box_satisfies_the_plane_heat_equation():
    # fourth-order differences with steps of 1 % of the body: truncation about 1e-8 of the rate
    h, dt, t = 0.02, 2e-3, 0.8
    at = np.array([0.4, -0.7])
    first = np.array([1, -8, 0, 8, -1]) / 12
    second = np.array([-1, 16, -30, 16, -1]) / 12

    def box(points, time):
        return slab.convective_box(points, time, half_widths=[1.0, 1.5], coefficient=2.0)

    rate = sum(w * box(at, t + k * dt) for w, k in zip(first, range(-2, 3), strict=True)) / dt
    bend = 0.0
    for axis in range(2):
        for w, k in zip(second, range(-2, 3), strict=True):
            bend += w * box(at + k * h * np.eye(2)[axis], t) / h**2
    assert rate == pytest.approx(bend, rel=1e-6)


def test_cube_face_condition_and_symmetry():
    h = 1e-3
    inward = np.array([[1 - k * h, 0.3, -0.2] for k in range(5)])
    cube = slab.convective_box(inward, 0.3, half_widths=1.0, coefficient=2.0, ambient=4.0)
    slope = np.array([25, -48, 36, -16, 3]) @ cube / (12 * h)
    assert slope == pytest.approx(2.0 * (4.0 - cube[0]), rel=1e-9)
    swapped = inward[:, [1, 2, 0]] * [-1, 1, -1]
    again = slab.convective_box(swapped, 0.3, half_widths=1.0, coefficient=2.0, ambient=4.0)
    assert again == pytest.approx(cube, abs=1e-15)


def test_box_mean_is_the_mean_of_the_box():
    nodes, weights = np.polynomial.legendre.leggauss(60)
    grid = np.stack(np.meshgrid(nodes, nodes, indexing="ij"), axis=-1)
    for t in (0.01, 0.5):
        values = slab.convective_box(grid, t, half_widths=1.0, coefficient=3.0)
        mean = weights @ values @ weights / 4
        exact = slab.convective_box_mean(t, half_widths=[1.0, 1.0], coefficient=3.0)
        assert mean == pytest.approx(float(exact), rel=1e-10)


def test_thick_slab_is_a_rod():
    depth = np.linspace(0, 3, 20)
    thick = slab.convective_slab(50.0 - depth, 0.5, half_thickness=50.0)
    assert thick == pytest.approx(rod.convection(depth, 0.5), abs=1e-14)


def test_start_insulation_and_refusals():
    x = np.linspace(-1, 1, 5)
    assert np.all(slab.convective_slab(x, 0.0, half_thickness=1.0, initial=2.0) == 2.0)
    assert np.all(slab.convective_slab(x, 9.0, half_thickness=1.0, coefficient=0.0) == 0.0)
    with pytest.raises(ValueError, match="positions must lie within"):
        slab.convective_slab(1.1, 1.0, half_thickness=1.0)
    with pytest.raises(ValueError, match="Biot number must be positive"):
        slab.convective_roots(0.0, 3)


def test_conduction_series_as_in_the_peridynamics_paper():
    # Eq. 41 of the multi-horizon paper, start 0, with rho c for its rho_c^2
    x, t, n = np.linspace(0, 1, 33), 0.08, np.arange(1, 60)
    hot, cold = 1.0, 0.0
    series = ((cold * np.cos(n * np.pi) - hot) / n) * np.exp(-(n**2) * np.pi**2 * t)
    exact = hot + (cold - hot) * x + 2 / np.pi * np.sin(np.outer(x, n * np.pi)) @ series
    assert slab.prescribed_slab(x, t) == pytest.approx(exact, abs=1e-14)
