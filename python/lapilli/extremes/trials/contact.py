"""Obstacles and bodies in contact: planes at any angle, stiff and light partners, free bodies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from math import cos, radians, sin
from typing import Any

import numpy as np

import lapilli as lp
from lapilli.extremes.trials.numbers import (
    balance_of,
    energy_gained,
    energy_of,
    in_spans,
    momentum_residual,
)
from lapilli.extremes.trials.trial import Mark, Trial

# Cell, density and weight are 1.
MODULUS = 1e5  # in weights of a cell
BLOCK = (6.0, 3.0)
CENTER = (20.3, 12.2)
GAIN_BAR = 0.01  # of the largest energy
MOMENTUM_BAR = 1e-9  # 2e-10 where the stone has a millionth of the mass


def contact_trials() -> Iterator[Trial]:
    """Sliding and sticking, dropping and hitting."""
    for degrees in (0.0, 7.0, 23.0, 37.0, 80.0):
        for friction in (0.0, 0.3, 2.0):
            if degrees < 60.0 or friction < 1.0:  # it would topple
                yield slide(degrees, friction)
    for modulus in (1e3, 1e8):
        yield slide(23.0, 0.3, modulus)
    for mass in (1e-3, 1.0, 1e5):
        yield drop(mass)
    for heavier in (1.0, 1e-3, 1e3):
        for stiffer in (1.0, 1e-3, 1e3):
            yield meet(heavier, stiffer)
    for speed in (1e-5, 0.1):
        yield meet(1.0, 1.0, speed)


def slide(degrees: float, friction: float, modulus: float = MODULUS) -> Trial:
    """A block on a plane that is turned against the grid, its weight turned on slowly."""
    along = np.array((cos(radians(degrees)), -sin(radians(degrees))))
    up = np.array((-along[1], along[0]))
    ground = lp.Rotated(
        shape=lp.Box(lower=(-60.0, CENTER[1] - 20.0), upper=(90.0, CENTER[1])),
        degrees=-degrees,
        center=CENTER,
    )
    block = lp.Rotated(
        shape=lp.Box(
            lower=(CENTER[0] - 0.5 * BLOCK[0], CENTER[1]),
            upper=(CENTER[0] + 0.5 * BLOCK[0], CENTER[1] + BLOCK[1]),
        ),
        degrees=-degrees,
        center=CENTER,
    )
    scene = lp.Scene(
        grid=lp.Grid(lower=(0.0, 0.0), upper=(44.0, 24.0), cell=1.0),
        bodies=[lp.Body(shape=block, material=[_elastic(modulus=modulus)])],
        dynamics=lp.Dynamics(
            gravity=(0.0, -1.0),
            gravity_factor=lp.Table(times=[0.0, 1.0], values=[0.0, 1.0]),
            obstacles=[lp.Obstacle(name="plane", shape=ground, friction=friction)],
        ),
        time=lp.Time(end=4.0),
    )
    slope = sin(radians(degrees)) - friction * cos(radians(degrees))
    name = f"plane at {degrees:g} degrees, friction {friction:g}, modulus {modulus:g}"
    judge = partial(judge_slide, along, up, max(0.0, slope))
    return Trial("contact", name, scene, judge, ("energy gained",))


def judge_slide(along: Any, up: Any, expected: float, scene: lp.Scene) -> Sequence[Mark]:
    """Speed along the plane over the time of the full weight, and what sinks in."""
    simulation = lp.Simulation(scene)
    speeds = []
    for time in (2.0, scene.time.end):
        simulation.run_until(time)
        speeds.append(float((simulation["velocity"] @ along).mean()))
    found = (speeds[1] - speeds[0]) / (scene.time.end - 2.0)
    foot = (simulation.position - np.array(CENTER)) @ up
    return [
        Mark("error of the acceleration", abs(found - expected), 0.01),
        Mark("depth of a point, cells", max(0.0, -float(foot.min())), 0.25),
        gain_of(simulation),
    ]


def drop(mass: float) -> Trial:
    """A disk of any mass that falls on a block of mass 48."""
    block = lp.Body(shape=lp.Box(lower=(16.3, 4.0), upper=(28.3, 8.0)), material=[_elastic()])
    stone = lp.Obstacle(
        name="stone",
        shape=lp.Disk(center=(20.1, 11.7), radius=2.5),
        mass=mass,
        velocity=(0.0, -0.02 * MODULUS**0.5),
        friction=0.5,
    )
    scene = lp.Scene(
        grid=lp.Grid(lower=(-20.0, -40.0), upper=(64.0, 64.0), cell=1.0),
        bodies=[block],
        dynamics=lp.Dynamics(gravity=(0.0, -1e-6), obstacles=[stone]),
        time=lp.Time(end=1.5),
    )
    name = f"stone of {mass:g} on a block of 48"
    return Trial("contact", name, scene, judge_meeting, ("energy gained",))


def meet(heavier: float, stiffer: float, speed: float = 0.02) -> Trial:
    """Two disks that hit each other askew, at a share of the wave speed of the softer one."""
    fast = speed * min(MODULUS, MODULUS * stiffer / heavier) ** 0.5
    disks = [
        lp.Body(
            name=name,
            shape=lp.Disk(center=center, radius=5.0),
            material=[_elastic(modulus, density)],
            velocity=velocity,
        )
        for name, center, modulus, density, velocity in (
            ("one", (15.3, 20.0), MODULUS, 1.0, (fast, 0.0)),
            ("other", (25.7, 21.3), MODULUS * stiffer, heavier, (0.0, 0.0)),
        )
    ]
    scene = lp.Scene(
        grid=lp.Grid(lower=(-20.0, -20.0), upper=(64.0, 64.0), cell=1.0),
        bodies=disks,
        dynamics=lp.Dynamics(contacts=[lp.BodyContact(friction=0.3)]),
        time=lp.Time(end=4.0 / fast),
    )
    name = f"disks, density x {heavier:g}, modulus x {stiffer:g}, {speed:g} of the wave speed"
    return Trial("contact", name, scene, judge_meeting, ("energy gained",))


def judge_meeting(scene: lp.Scene) -> Sequence[Mark]:
    """Energy that nothing put in, and momentum."""
    simulation = lp.Simulation(scene)
    worst = Mark("energy gained", 0.0, GAIN_BAR)
    for _ in in_spans(simulation, scene.time.end / 40):
        worst = max(worst, gain_of(simulation), key=lambda mark: mark.value)
    return [worst, Mark("momentum", momentum_residual(simulation), MOMENTUM_BAR)]


def gain_of(simulation: lp.Simulation) -> Mark:
    """Energy that nothing put in, over what moves and strains and what was lost."""
    entries = balance_of(simulation, "energy").entries
    size = energy_of(simulation) + sum(abs(value) for value in entries.values())
    return Mark("energy gained", energy_gained(simulation) / size, GAIN_BAR)


def _elastic(modulus: float = MODULUS, density: float = 1.0) -> lp.Elastic:
    return lp.Elastic(density=density, youngs_modulus=modulus, poissons_ratio=0.3)
