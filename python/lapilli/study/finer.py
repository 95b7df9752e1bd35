"""A run finer than all settings of a study, to judge them by."""

from __future__ import annotations

from collections.abc import Sequence

from lapilli._core import Scene
from lapilli.study.fitting import with_cell
from lapilli.study.settings import Setting

FINER = 2.0  # the reference's cells and steps are shorter by this
TIGHTEST = 1e-8  # tolerance of steps in time


def finer_setting(scene: Scene, settings: Sequence[Setting]) -> Setting:
    """Half of the smallest cell tried, half of the shortest step; all else as in the scene."""
    tried = [setting.applied(scene) for setting in settings]
    scenes = [one for one in tried if one is not None] or [scene]
    smallest = min(scenes, key=lambda one: one.grid.cell)
    finer = with_cell(smallest, smallest.grid.cell / FINER)
    changes = [("grid.cell", repr(finer.grid.cell))]
    if list(finer.grid.upper) != list(scene.grid.upper):
        changes.append(("grid.upper", str(list(finer.grid.upper))))
    steps = [number for one in scenes if isinstance(number := one.time.steps, int)]
    sizes = [size for one in scenes if isinstance(size := one.time.step, float | int)]
    if steps:
        changes.append(("time.steps", str(round(FINER * max(steps)))))
    elif sizes:
        changes.append(("time.step", repr(min(sizes) / FINER**2)))  # explicit limits go with cell^2
    elif scene.heat is not None and scene.heat.time_integration == "auto":
        tolerances = [one.heat.tolerance for one in scenes if one.heat is not None]
        finest = max(min(tolerances) / FINER**2, TIGHTEST)
        changes.append(("heat.tolerance", f"{finest:.3g}"))
    return Setting(tuple(changes))
