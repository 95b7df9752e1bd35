"""Drawn scenes of explicit mechanics whose answers must not belong to the numerics: to the step,
the stiffness of what does not deform, the place, angle, motion and units of the frame, or the order
of the bodies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import lapilli as lp

SCENES = range(4)


@dataclass(frozen=True)
class Frame:
    """How a drawn scene is set up, without changing what happens in it."""

    safety: float = 0.5
    stiffer: float = 1.0
    shift: tuple[float, float] = (0.0, 0.0)  # m
    degrees: float = 0.0
    velocity: tuple[float, float] = (0.0, 0.0)  # over that of the impact
    mirror: bool = False
    swapped: bool = False
    wall: bool = False  # one body against an obstacle, not two bodies
    length: float = 1.0  # new metres a metre
    time: float = 1.0  # new seconds a second


def impact(seed: int, frame: Frame) -> dict[str, Any]:
    """Two elastic bodies meet in flight; centre and velocity of each and the energy after it, in
    the frame of the draw."""
    draw = np.random.default_rng(seed)
    angle = np.radians(frame.degrees)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    if frame.mirror:
        turn = turn @ np.diag([-1.0, 1.0])
    young, speed = 10 ** draw.uniform(4, 7) * frame.stiffer, frame.length / frame.time
    poisson, density = draw.uniform(0, 0.45), 10 ** draw.uniform(2, 4)
    wave = np.sqrt(young / density)
    fast = draw.uniform(0.03, 0.08) * wave
    frame_velocity = fast * np.array(frame.velocity)
    offset = draw.uniform(-0.4, 0.4, 2)
    bodies = []
    for side in (-1,) if frame.wall else (-1, 1):
        centre = turn @ (np.array([side * 0.75, 0.3 * side]) + offset) + frame.shift
        velocity = turn @ np.array([-side * fast, 0.2 * side * fast]) + frame_velocity
        bodies.append(
            lp.Body(
                name=f"body {side}",
                shape=lp.Disk(center=tuple(centre * frame.length), radius=0.6 * frame.length),
                material=lp.Elastic(
                    density=density / frame.length**2,
                    youngs_modulus=young / frame.time**2,
                    poissons_ratio=poisson,
                ),
                velocity=tuple(velocity * speed),
            )
        )
    if frame.swapped:
        bodies.reverse()
    obstacles = []
    if frame.wall:
        place = turn @ offset + frame.shift
        obstacles.append(
            lp.Obstacle(
                shape=lp.HalfSpace(point=tuple(place * frame.length), normal=tuple(turn @ (-1, 0))),
                contact="slip",
                velocity=tuple(frame_velocity * speed),
            )
        )
    middle = np.round(np.array(frame.shift) / 0.2) * 0.2
    end = 0.8 / fast
    scene = lp.Scene(
        grid=lp.Grid(
            lower=tuple((middle - 3) * frame.length),
            upper=tuple((middle + 3) * frame.length),
            cell=0.2 * frame.length,
        ),
        bodies=bodies,
        dynamics=lp.Dynamics(courant=frame.safety, obstacles=obstacles),
        time=lp.Time(end=end * frame.time),
    )
    simulation = lp.Simulation(scene)
    simulation.run_until(end * frame.time)
    order = (0,) if frame.wall else (1, 0) if frame.swapped else (0, 1)
    mass = simulation["density"] * simulation["volume"]
    found = []
    for body in order:
        own = simulation["body"] == body
        weight = mass[own] / mass[own].sum()
        centre = weight @ simulation["position"][own] / frame.length
        drift = weight @ simulation["velocity"][own] / speed
        found.append(turn.T @ (centre - frame.shift - frame_velocity * end))
        found.append(turn.T @ (drift - frame_velocity) * end)
    return {"state": np.array(found), "size": fast * end}


def same(seed: int, one: Frame, other: Frame, share: float) -> None:
    """Both frames see the same but for a share of how far the bodies go."""
    first, second = impact(seed, one), impact(seed, other)
    assert np.abs(first["state"] - second["state"]).max() < share * first["size"]


@pytest.mark.parametrize("seed", SCENES)
def test_an_impact_does_not_depend_on_the_step(seed: int):
    same(seed, Frame(safety=0.5), Frame(safety=0.05), 0.02)


@pytest.mark.parametrize("seed", SCENES)
def test_nor_on_a_shift_by_whole_cells(seed: int):
    same(seed, Frame(), Frame(shift=(0.4, -0.8)), 1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("seed", SCENES)
def test_two_bodies_hardly_see_the_grid(seed: int):
    """Two disks of six cells: at most .017 for the place, .056 for the angle, .054 for a uniform
    velocity, which lets their vibration fade; at ten cells place and angle are below .02
    (tests/cpp/dynamics/test_contacts.cpp)."""
    same(seed, Frame(), Frame(shift=(0.037, 0.051)), 0.03)
    same(seed, Frame(), Frame(degrees=31.0), 0.08)
    same(seed, Frame(), Frame(velocity=(0.9, -0.7)), 0.08)


@pytest.mark.parametrize("seed", SCENES)
def test_a_bounce_hardly_depends_on_the_step(seed: int):
    """At six cells across contact is of first order in the step: the default rebounds up to 10 %
    faster than steps of a tenth, never faster than it came."""
    same(seed, Frame(wall=True), Frame(wall=True, safety=0.05), 0.12)
    for safety in (0.9, 0.5, 0.25):
        bounce = impact(seed, Frame(wall=True, safety=safety))
        assert abs(bounce["state"][1, 0]) <= bounce["size"]


@pytest.mark.parametrize("seed", SCENES)
def test_nor_on_a_shift_by_parts_of_a_cell(seed: int):
    """Found up to .076 on six cells: where the lattice of the points lies to the wall."""
    same(seed, Frame(wall=True), Frame(wall=True, shift=(0.037, 0.051)), 0.09)


@pytest.mark.parametrize("seed", SCENES)
def test_nor_on_its_angle_to_the_grid(seed: int):
    """Found up to .052 on six cells."""
    same(seed, Frame(wall=True), Frame(wall=True, degrees=31.0), 0.08)


@pytest.mark.parametrize("seed", SCENES)
def test_nor_on_a_uniform_velocity(seed: int):
    """Found up to .073 on six cells, for the reason of the shift (.03 where contact begins at half
    the spacing of the points); with the slivers of the fill alone before the wall it was .82."""
    same(seed, Frame(wall=True), Frame(wall=True, velocity=(0.9, -0.7)), 0.09)


@pytest.mark.parametrize("seed", SCENES)
def test_nor_on_mirror_order_and_units(seed: int):
    same(seed, Frame(), Frame(mirror=True), 1e-6)
    same(seed, Frame(), Frame(swapped=True), 1e-6)
    same(seed, Frame(), Frame(length=1e-3, time=60.0), 1e-6)
