"""Scenes of users' problems: each starts without a note, steps and keeps its balances; those with
a known answer find it."""

import json
import math

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core, examples

NAMES = [
    name for name in examples.names() if name.split("/")[0] in ("heat", "soil", "static", "flow")
]
COARSE = {"heat/heat_sink": "grid.cell=0.002"}  # a tenth of a second instead of two


def shown(name: str) -> lp.Scene:
    """The scene of an example, on wider cells where its own are many."""
    scene = examples.load(name)
    return scene.set(COARSE[name]) if name in COARSE else scene


@pytest.mark.parametrize("name", NAMES)
def test_it_uses_all_that_it_says_and_starts_without_a_note(name: str) -> None:
    scene = shown(name)
    assert _core.unused_settings(scene) == []
    notes = json.loads(_core.check_json(scene))["notes"]
    # Of cells and strains, for which these are short scenes, the physics warns itself.
    assert [note for note in notes if not note.startswith("quasi_static: ")] == []


@pytest.mark.parametrize("name", NAMES)
def test_it_steps_and_keeps_its_balances(name: str) -> None:
    """At most three steps. Heat closes to the rounding of what is stored, momentum to 1e-10 of what
    turns over: each entry sums thousands of points. The balance of energy is not exact."""
    simulation = lp.Simulation(shown(name))
    while simulation.step_index < 3 and simulation.time < simulation.end:
        simulation.step()
    for balance in simulation.balance():
        if balance.quantity == "heat":
            assert balance.turnover > 0
            assert abs(balance.residual) <= 1e-12 * max(1.0, balance.stored / balance.turnover)
        elif balance.quantity.startswith("momentum"):
            assert abs(balance.residual) <= 1e-10


def test_the_pipe_ends_in_its_steady_state() -> None:
    """The heat through convection, wall and radiation is the same in steady state: the temperature
    of the outer surface by bisection, 643.1 K. After six times r^2/alpha of the wall 1e-3 of the
    step at the start is left; the probe lies 0.1 mm inside, which is 0.8 K."""
    inner, outer, conductivity = 0.06, 0.1, 1.5

    def left_over(outside: float) -> float:
        through = 2 * math.pi * outer * 0.8 * 5.670374419e-8 * (outside**4 - 300**4)
        inside = outside + through * math.log(outer / inner) / (2 * math.pi * conductivity)
        return 2 * math.pi * inner * 60 * (1100 - inside) - through

    low, high = 300.0, 1100.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if left_over(middle) > 0 else (low, middle)
    history = lp.run(examples.load("heat/pipe"), progress=False).history
    assert history["outside"][-1] == pytest.approx(low, abs=1.5)


def test_the_casting_is_solid_at_the_end() -> None:
    """Its latent heat and what it cooled by went through the contact: between the latent heat alone
    and all of its enthalpy above 300 K."""
    history = lp.run(examples.load("heat/casting"), progress=False).history
    mass, latent = 2400 * 0.06 * 0.08, 3.9e5
    assert history["heat/liquid_volume"][0] == pytest.approx(0.06 * 0.08, rel=1e-9)
    assert history["heat/liquid_volume"][-1] == 0
    passed = history["heat/heat_from_casting_to_mould"][-1]
    assert mass * latent < passed < mass * (latent + 1080 * 650)


def test_the_chip_gives_twenty_watts() -> None:
    """5e4 W/m^2 on 4 cm^2 of the flat base: the region is cut exactly."""
    scene = shown("heat/heat_sink").set("time.end=8")
    history = lp.run(scene, progress=False).history
    assert history["heat/supplied_by_chip"][-1] == pytest.approx(20 * 8, rel=1e-9)


def test_the_beam_bends_as_timoshenko_says() -> None:
    """Four cells across a beam of one tenth of its length are 5 % too stiff, at any angle."""
    plane = 2.1e11 / (1 - 0.3**2)
    shear = 2.1e11 / 2.6
    expected = 1e5 / (3 * plane * 0.1**3 / 12) + 1e5 / (5 / 6 * shear * 0.1)
    history = lp.run(examples.load("static/beam"), progress=False).history
    bent = math.hypot(history["tip_x"][-1], history["tip_y"][-1])
    assert 0.93 * expected < bent < expected
    # the reaction is the load: the line of the traction is integrated exactly
    reaction = history["quasi_static/force_of_wall_clamp_along_y"][-1]
    assert reaction == pytest.approx(1e5 * math.cos(math.radians(30)), rel=1e-3)


def test_the_footing_bears_prandtls_load() -> None:
    """(pi + 2) c over half of the strip; cells of 1/4 of the half width carry 4.3 % more, those of
    the file 2.5 %."""
    scene = examples.load("static/footing").set("grid.cell=0.25").set("time.steps=8")
    history = lp.run(scene, progress=False).history
    force = -np.asarray(history["quasi_static/force_of_wall_footing_along_y"])
    assert 1.0 < force[-1] / ((math.pi + 2) * 1e4) < 1.06
