"""What several judges ask of a run."""

from __future__ import annotations

from collections.abc import Iterator

import lapilli as lp


def in_spans(simulation: lp.Simulation, span: float) -> Iterator[None]:
    """Run to the end; once after every span, s."""
    while simulation.time < simulation.end:
        simulation.run_until(min(simulation.end, simulation.time + span))
        yield


def balance_of(simulation: lp.Simulation, quantity: str) -> lp.Balance:
    """The account of one quantity."""
    return next(one for one in simulation.balance() if one.quantity == quantity)


def momentum_residual(simulation: lp.Simulation) -> float:
    """The largest of the residuals along the axes."""
    return max(abs(one.residual) for one in simulation.balance() if "momentum" in one.quantity)


def energy_of(simulation: lp.Simulation) -> float:
    """Of motion and strain, J."""
    numbers = simulation.diagnostics()
    return numbers["dynamics/kinetic_energy"] + numbers["dynamics/elastic_energy"]


def energy_gained(simulation: lp.Simulation) -> float:
    """That nothing put in, J."""
    return simulation.diagnostics()["dynamics/energy_gained"]
