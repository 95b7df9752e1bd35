"""What a cavity of 40 x 40 points does at the ends of its settings, over 2,000 steps.

Nothing may become no number, leave the temperatures of the walls or unbalance the books; a run may
stop only by naming a density that varies too much. Noise and density variation are no bars here: at
these times Ra 1e8 is still starting up (noise 0.67, variation 0.4 %).
"""

import numpy as np
import pytest

import lapilli as lp
from lapilli.extremes.fluid import cavity

ROWS, STEPS = 40, 2000
SCENES = {
    **{f"Pr {pr:g}": {"rayleigh": 1e4, "prandtl": pr} for pr in (0.01, 0.1, 1, 10, 100)},
    **{f"Ra {ra:g}": {"rayleigh": ra, "flow": {}} for ra in (0, 1, 1e2, 1e6, 1e7, 1e8)},
    **{f"fluid horizon {h:g}": {"rayleigh": 1e4, "flow": {"horizon": h}} for h in (2, 4, 5)},
    **{f"thermal horizon {h:g}": {"rayleigh": 1e4, "heat": {"horizon": h}} for h in (1.2, 3, 5)},
    **{
        f"sound speed factor {f:g}": {"rayleigh": 1e4, "flow": {"sound_speed_factor": f}}
        for f in (3, 10, 20)
    },
    "random points": {"rayleigh": 1e4, "random": True},
    "jitter 0.5": {"rayleigh": 1e4, "jitter": 0.5},
}


@pytest.mark.parametrize(
    "name", [n if n == "random points" else pytest.param(n, marks=pytest.mark.slow) for n in SCENES]
)
def test_extreme_cavity_runs(name):
    simulation = lp.Simulation(cavity(rows=ROWS, **SCENES[name]))
    for _ in range(STEPS):
        simulation.step()
    temperature = simulation.by_id("temperature")
    assert np.all(np.isfinite(simulation.by_id("velocity")))
    assert -1e-9 <= temperature.min() <= temperature.max() <= 1 + 1e-9
    assert abs(simulation.balance()[0].residual) <= 1e-12
    numbers = simulation.diagnostics()
    assert numbers["flow/greatest_density_variation"] <= 0.1
    assert numbers["flow/least_density_variation"] >= -0.1


@pytest.mark.slow
@pytest.mark.parametrize("horizon", [1.2, 1.515])
def test_a_fluid_horizon_that_is_too_short_stops_by_name(horizon):
    """Four or eight neighbours do not hold a fluid: points pass between each other."""
    simulation = lp.Simulation(cavity(1e4, rows=ROWS, flow={"horizon": horizon}))
    with pytest.raises(lp.RunError, match=r"density of point .* raise sound_speed_factor"):
        simulation.run_until(0.03)
