"""The swirling disc: exact motion against integration, volume, heat balance in the moving frame."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from lapilli.references.swirl import Swirl


@pytest.fixture
def points():
    rng = np.random.default_rng(7)
    r, angle = np.sqrt(rng.uniform(0, 1, 40)), rng.uniform(0, 2 * np.pi, 40)
    return np.array([0.3, -0.2]) + 1.6 * np.stack([r * np.cos(angle), r * np.sin(angle)], axis=-1)


@pytest.fixture
def swirl():
    return Swirl(radius=1.6, speed=2.0, shear=0.4, centre=(0.3, -0.2))


def test_trajectories_solve_the_equation_of_motion(swirl, points):
    path = solve_ivp(
        lambda t, x: swirl.velocity(x.reshape(-1, 2)).ravel(),
        (0.0, 3.0),
        points.ravel(),
        rtol=1e-11,
        atol=1e-12,
    )
    assert swirl.positions(points, 3.0) == pytest.approx(path.y[:, -1].reshape(-1, 2), abs=1e-8)


def test_motion_keeps_radius_and_reverses(swirl, points):
    moved = swirl.positions(points, 5.0)
    before = np.linalg.norm(points - swirl.centre, axis=1)
    assert np.linalg.norm(moved - swirl.centre, axis=1) == pytest.approx(before, rel=1e-13)
    assert swirl.positions(moved, -5.0) == pytest.approx(points, abs=1e-12)


def test_rim_and_centre_speeds(swirl):
    assert swirl.angular_velocity([0.0, 1.6]) == pytest.approx([2.8, 2.0])


def test_gradients_against_differences(swirl, points):
    # central differences, step 1e-5: truncation 1e-10 times third derivatives of order ten
    h = 1e-5
    for axis in range(2):
        shift = h * np.eye(2)[axis]
        slope = (swirl.velocity(points + shift) - swirl.velocity(points - shift)) / (2 * h)
        assert swirl.velocity_gradient(points)[:, :, axis] == pytest.approx(slope, abs=1e-8)
        ahead, behind = (swirl.positions(points + s, 0.9) for s in (shift, -shift))
        slope = (ahead - behind) / (2 * h)
        assert swirl.deformation_gradient(points, 0.9)[:, :, axis] == pytest.approx(slope, abs=1e-8)


def test_volume_is_kept(swirl, points):
    assert np.linalg.det(swirl.deformation_gradient(points, 7.0)) == pytest.approx(1.0, abs=1e-11)
    assert np.trace(swirl.velocity_gradient(points), axis1=1, axis2=2) == pytest.approx(
        0, abs=1e-14
    )


def test_rim_strain_of_the_notes():
    # one revolution per second and disc radius 8 h, h = 0.2, t = 6 h^2: shear strain r Omega' t of
    # the notes is 1.2 in size at the rim
    swirl = Swirl(radius=1.6)
    gradient = swirl.deformation_gradient([[1.6, 0.0]], 6 * 0.04)[0]
    strain = 2 * swirl.shear * swirl.speed * 6 * 0.04
    stretch = gradient.T @ gradient
    assert abs(stretch[0, 1]) == pytest.approx(strain, rel=1e-12)
    assert strain == pytest.approx(1.2, abs=0.05)


def test_temperature_is_carried_and_conducts_radially(swirl, points):
    # material derivative = alpha Laplacian, where the temperature has no angle: same at all times
    # on a circle, and the same as at the starting position
    moved = swirl.positions(points, 0.4)
    assert swirl.temperature(moved, 0.4) == pytest.approx(swirl.temperature(points, 0.4), abs=1e-10)
    start = swirl.temperature(points, [0.0, 1e3])
    assert np.all(start[0] == 0.0)
    assert start[1] == pytest.approx(1.0, abs=1e-8)


def test_stored_heat_is_what_came_in(swirl):
    radial = swirl.radial
    assert radial.heat_content(0.5) == pytest.approx(radial.heat_taken_in(0.5).sum(), rel=1e-8)
