"""Extreme cases drawn at random stay within bounds at the automatic step."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import lapilli as lp
from lapilli.extremes.cases import halves, square

exponents = st.floats(-6.0, 6.0)
# Places of the lattice in a cell, those within 1e-9 of a node or face among them.
shifts = st.one_of(st.floats(0.0, 1.0), st.sampled_from([0.25, 0.25 + 1e-9, 0.25 - 1e-9, 1e-9]))


def strayed(scene: lp.Scene, steps: int) -> float:
    """How far temperatures went beyond [0, 1] in some automatic steps; infinite if they broke."""
    simulation = lp.Simulation(scene.set("time.end=1e300"))
    worst = 0.0
    for _ in range(steps):
        simulation.step()
        values = simulation["temperature"]
        if not np.all(np.isfinite(values)):
            return np.inf
        worst = max(worst, float(values.max()) - 1.0, -float(values.min()))
    return worst


@settings(max_examples=25, deadline=None)
@given(
    transfer=st.sampled_from(["nodal", "pic"]),
    exponent=exponents,
    rotation=st.floats(0.0, 90.0),
    jitter=st.floats(0.0, 0.25),
    shift=shifts,
)
def test_convection_keeps_the_range(
    transfer: str, exponent: float, rotation: float, jitter: float, shift: float
) -> None:
    """Averages of averages: only rounding leads out of the range."""
    scene = square(
        transfer, 10.0**exponent, rotation=rotation, jitter=jitter, translation=[shift, shift]
    )
    assert strayed(scene, 25) <= 1e-9


@settings(max_examples=25, deadline=None)
@given(
    transfer=st.sampled_from(["nodal", "flip", "pic", "tpic", "affine"]),
    conductivity=exponents,
    capacity=exponents,
)
def test_contrasts_are_bounded(transfer: str, conductivity: float, capacity: float) -> None:
    """Two materials on one lattice, contrasts to 1e6 of both: no more than a quarter astray."""
    assert strayed(halves(transfer, 10.0**conductivity, 10.0**capacity), 40) <= 0.25
