"""The algorithm of the paper, as its tables show it was run."""

from __future__ import annotations

from lapilli._core import Scene
from lapilli.reproduce.states import changed


def literal(scene: Scene, step: float, method: str = "paper") -> Scene:
    """The scene as the paper ran it, on its own steps: compare with the exact field of one step
    before. `method` "node" and "particle" are the other two columns of Table 1.
    """
    return changed(
        scene,
        f"heat.method={method}",
        "heat.transfer=flip",
        "heat.surface_fraction=0.55",
        "heat.implicit_robin=false",
        "grid.shape_function=linear",
        f"time.step={step!r}",
        *(f"bodies.{k}.fill=lattice" for k in range(len(scene.bodies))),
    )
