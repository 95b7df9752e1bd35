"""Turned bars with regions at their ends, for heat against closed forms along them."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

import lapilli as lp

Array = npt.NDArray[np.float64]


class Bar:
    """A turned bar whose axis runs from `start`; its ends are regions of their own."""

    def __init__(self, length: float, width: float, degrees: float, cell: float) -> None:
        self.length, self.width, self.degrees, self.cell = length, width, degrees, cell
        self.shift = np.array([0.31, 0.17]) * cell
        angle = np.radians(degrees)
        self.axis = np.array([np.cos(angle), np.sin(angle)])

    def piece(self, begin: float, end: float, half: float | None = None) -> lp.Translated:
        half = self.width / 2 if half is None else half
        box = lp.Box(lower=(begin, -half), upper=(end, half))
        turned = lp.Rotated(shape=box, degrees=self.degrees, center=(0, 0))
        return lp.Translated(shape=turned, by=tuple(self.shift))

    def end(self, at: float) -> lp.Translated:
        """The face at one end, and next to nothing of the sides."""
        inside, outside = 1e-6 * self.cell, self.cell
        begin, end = (at - outside, at + inside) if at == 0 else (at - inside, at + outside)
        return self.piece(begin, end, half=self.width)

    def along(self, positions: Array) -> Array:
        return np.asarray((positions - self.shift) @ self.axis)

    def scene(self, bodies: list[lp.Body], end: float, **heat: object) -> lp.Scene:
        reach = self.cell * np.ceil((self.length + self.width) / self.cell + 3)
        return lp.Scene(
            grid=lp.Grid(lower=(-reach, -reach), upper=(reach, reach), cell=self.cell),
            bodies=bodies,
            heat=lp.Heat(**heat),
            time=lp.Time(end=end),
        )


def solved(scene: lp.Scene) -> tuple[Array, Array, lp.Simulation]:
    """Positions and temperatures at the end, by point."""
    simulation = lp.Simulation(scene)
    simulation.run_until(simulation.end)
    balance = simulation.balance()[0]
    assert abs(balance.residual) < 1e-9
    return simulation.position, simulation["temperature"], simulation
