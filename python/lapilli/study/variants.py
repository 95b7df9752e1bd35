"""Other settings of a scene that may reach the same error for less."""

from __future__ import annotations

from collections.abc import Iterator

from lapilli._core import Scene
from lapilli.study.settings import Setting

Changes = tuple[tuple[str, str], ...]


def variants_of(scene: Scene) -> list[Setting]:
    """Settings worth a try beside those of the scene: points per cell, integration in time,
    transfer, enforcement, load steps, sound speed; each alone, and points with integration."""
    points = list(points_per_cell(scene))
    time = list(integrations(scene))
    kinds = list(methods(scene))
    both = [few + one for few in points[:1] for one in time]
    seen = dict.fromkeys([*points, *time, *kinds, *both])
    return [Setting(one) for one in seen]


def points_per_cell(scene: Scene) -> Iterator[Changes]:
    """One, 2^d, 3^d points, for every body; particles of a flow are one each."""
    if scene.peridynamics is not None:
        return
    dimension = len(scene.grid.lower)
    shaped = [k for k, body in enumerate(scene.bodies) if body.shape is not None]
    for count in (1, 2**dimension, 3**dimension):
        # One point per cell cannot carry the modes of a moving or deforming body.
        if count == 1 and (scene.heat is None or scene.dynamics is not None):
            continue
        if any(scene.bodies[k].points_per_cell != count for k in shaped):
            yield tuple((f"bodies.{k}.points_per_cell", str(count)) for k in shaped)


def integrations(scene: Scene) -> Iterator[Changes]:
    """Looser tolerances, or explicit or implicit steps, for heat alone; fewer load steps."""
    steps = scene.time.steps
    if scene.heat is not None and scene.dynamics is None:
        if scene.heat.time_integration == "auto":
            for factor in (10.0, 100.0):
                yield (("heat.tolerance", f"{min(factor * scene.heat.tolerance, 0.1):.3g}"),)
            yield (("heat.time_integration", "explicit"),)
        else:
            for count in (10, 25, 50, 100):
                yield (
                    ("heat.time_integration", "implicit"),
                    ("heat.theta", "0.5"),
                    ("time.steps", str(count)),
                )
    elif scene.quasi_static is not None and isinstance(steps, int) and steps > 1:
        yield (("time.steps", str(max(1, steps // 2))),)


def methods(scene: Scene) -> Iterator[Changes]:
    """Transfers, enforcements, sound speeds."""
    if scene.quasi_static is not None:
        for form in ("mean-gap", "nitsche"):
            if scene.quasi_static.enforcement != form:
                yield (("quasi_static.enforcement", form),)
    if scene.dynamics is not None and scene.dynamics.stress_update == "musl":
        yield (("dynamics.stress_update", "usl"),)
    if scene.peridynamics is not None and scene.peridynamics.flow is not None:
        for factor in ("3", "2"):
            yield (("peridynamics.flow.sound_speed_factor", factor),)
