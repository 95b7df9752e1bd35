"""d'Alembert's solution: equation of motion, ends, energy, period, modes."""

import numpy as np
import pytest

from lapilli.references.bar_wave import Bar, standing_wave


def bump(x):
    # smooth, zero with its derivatives at both ends of [0, 2]
    return np.sin(np.pi * x / 2) ** 4 * np.cos(3 * x)


def bar(left_fixed, right_fixed, **more):
    return Bar(
        length=2.0,
        young=9.0,
        density=4.0,
        left_fixed=left_fixed,
        right_fixed=right_fixed,
        velocity=bump,
        strain=lambda x: 0.3 * bump(2 - x),
        **more,
    )


ENDS = [(True, True), (True, False), (False, True), (False, False)]


@pytest.mark.parametrize(("left_fixed", "right_fixed"), ENDS)
def test_momentum_and_compatibility(left_fixed, right_fixed):
    # rho dv/dt = ds/dx and ds/dt = E dv/dx, central differences of fourth order
    b = bar(left_fixed, right_fixed)
    x, h = np.linspace(0.1, 1.9, 37), 1e-3
    weights = np.array([1, -8, 0, 8, -1]) / (12 * h)
    for t in (0.2, 1.7, 9.1):
        in_time = [b.state(x, t + k * h) for k in range(-2, 3)]
        in_space = [b.state(x + k * h, t) for k in range(-2, 3)]
        v_t, s_t = (sum(w * s[i] for w, s in zip(weights, in_time, strict=True)) for i in (0, 1))
        v_x, s_x = (sum(w * s[i] for w, s in zip(weights, in_space, strict=True)) for i in (0, 1))
        assert 4.0 * v_t == pytest.approx(s_x, abs=1e-6)
        assert s_t == pytest.approx(9.0 * v_x, abs=1e-6)


@pytest.mark.parametrize(("left_fixed", "right_fixed"), ENDS)
def test_ends(left_fixed, right_fixed):
    b = bar(left_fixed, right_fixed)
    for t in (0.31, 2.9, 17.3):
        velocity, stress = b.state([0.0, 2.0], t)
        for end, fixed in enumerate((left_fixed, right_fixed)):
            quiet = velocity[end] if fixed else stress[end]
            assert quiet == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(("left_fixed", "right_fixed"), ENDS)
def test_energy_and_period(left_fixed, right_fixed):
    b = bar(left_fixed, right_fixed)
    x = np.linspace(0, 2, 2001)  # the trapezoid rule is spectral for these smooth profiles

    def energy(t):
        velocity, stress = b.state(x, t)
        return np.trapezoid(2.0 * velocity**2 + stress**2 / 18.0, x)

    assert energy(3.3) == pytest.approx(energy(0.0), rel=1e-9)
    assert energy(71.0) == pytest.approx(energy(0.0), rel=1e-9)
    # like ends: back after 2 L/c; unlike ends: turned after 2 L/c, back after 4 L/c
    turn = 2 * 2.0 / b.speed
    sign = 1 if left_fixed == right_fixed else -1
    for now, before in zip(b.state(x, 0.4 + turn), b.state(x, 0.4), strict=True):
        assert now == pytest.approx(sign * before, abs=1e-10)


@pytest.mark.parametrize("right_fixed", [True, False])
def test_standing_wave_is_its_closed_form(right_fixed):
    b = standing_wave(Bar(length=25.0, young=100.0, right_fixed=right_fixed), 2, 0.1)
    beta = (2.0 if right_fixed else 1.5) * np.pi / 25.0
    x = np.linspace(0, 25, 60)
    for t in (0.0, 1.3, 44.0):
        velocity, stress = b.state(x, t)
        exact = 0.1 * np.sin(beta * x) * np.cos(beta * 10.0 * t)
        assert velocity == pytest.approx(exact, abs=1e-12)
        exact = 100.0 * 0.1 / 10.0 * np.cos(beta * x) * np.sin(beta * 10.0 * t)
        assert stress == pytest.approx(exact, abs=1e-11)


def test_sudden_end_stress():
    # nothing ahead of the front, the full stress behind it, twice the stress after the wall
    b = Bar(length=1.0, young=4.0, density=1.0, end_stress=0.5)
    velocity, stress = b.state([0.4, 0.6], 0.25)  # front at x = 0.5
    assert stress == pytest.approx([0.0, 0.5])
    assert velocity == pytest.approx([0.0, 0.5 / 2.0])  # sigma/(rho c)
    velocity, stress = b.state([0.1, 0.6], 0.6)  # reflected front at x = 0.2
    assert stress == pytest.approx([1.0, 0.5])
    assert velocity == pytest.approx([0.0, 0.25])
    with pytest.raises(ValueError, match="end_stress needs"):
        Bar(right_fixed=True, end_stress=1.0)
