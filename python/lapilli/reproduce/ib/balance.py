"""Run the load steps of a scene, and what is kept of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from lapilli._core import QuasiStatic, Scene, Simulation
from lapilli.reproduce.states import Array, changed

MODES: dict[str, tuple[str, ...]] = {
    "literal": ("quasi_static.enforcement=literal",),
    "default": (),
}
FORMS = ("mean-gap", "pointwise", "nitsche", "penalty")


@dataclass(frozen=True)
class Balance:
    """Copies of what the points hold after a load step, in the order of their ids."""

    time: float  # s
    start: Array  # (n, dimension), positions before the first step, m
    position: Array  # (n, dimension), m
    displacement: Array  # (n, dimension), m
    stress: Array  # (n, 6): xx, yy, zz, xy, yz, xz, Pa
    volume: Array  # (n,), m^dimension
    report: dict[str, float]

    def along(self, first: Array, second: Array) -> Array:
        """first . stress . second at every point, Pa."""
        x, y = np.zeros(3), np.zeros(3)
        x[: len(first)], y[: len(second)] = first, second
        mixed = [x[i] * y[j] + x[j] * y[i] for i, j in ((0, 1), (1, 2), (0, 2))]
        product: Array = self.stress @ np.array([*(x * y), *mixed])
        return product

    def mean(self, values: Array) -> float:
        """Mean over the volume."""
        return float(np.average(values, weights=self.volume))

    def wall_force(self, wall: str) -> Array:
        """Force of a wall on the material, N (per metre in the plane)."""
        axes = "xyz"[: self.position.shape[1]]
        return np.array([self.report[f"force_of_wall_{wall}_along_{axis}"] for axis in axes])


def balances(scene: Scene) -> Iterator[Balance]:
    """The scene after each of its load steps, `time.steps` of them."""
    simulation = Simulation(scene)
    start = simulation.by_id("position").copy()
    steps = scene.time.steps or 1
    for step in range(1, steps + 1):
        simulation.run_until(scene.time.end * step / steps)
        report = {
            name.removeprefix("quasi_static/"): value
            for name, value in simulation.diagnostics().items()
        }
        yield Balance(
            simulation.time,
            start,
            simulation.by_id("position"),
            simulation.by_id("displacement"),
            simulation.by_id("stress"),
            simulation.by_id("volume"),
            report,
        )


def balance(scene: Scene) -> Balance:
    """The scene after its last load step."""
    *_, last = balances(scene)
    return last


def section(scene: Scene) -> QuasiStatic:
    """The [quasi_static] of a scene that has one."""
    if scene.quasi_static is None:
        raise ValueError("the scene has no [quasi_static]")
    return scene.quasi_static


def in_mode(scene: Scene, mode: str) -> Scene:
    """The scene in one of the two named modes."""
    return changed(scene, *MODES[mode])


def in_form(scene: Scene, form: str, bandwidth: float | None = None) -> Scene:
    """The scene with another form of its walls, and the bandwidth of the stiff constraint."""
    scene = changed(scene, f"quasi_static.enforcement={form}")
    return scene if bandwidth is None else changed(scene, f"quasi_static.bandwidth={bandwidth!r}")
