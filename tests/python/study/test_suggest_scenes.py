"""lapilli suggest over scenes of all methods, each against a reference that it does not know."""

import pytest

import lapilli as lp
from lapilli import examples
from lapilli.study import InProcess, suggest
from lapilli.study.measure import Task
from lapilli.study.truth import truth_of

WIDE = ("grid.lower=[-8,-8]", "grid.upper=[8,8]")
TURNED = ("bodies.0.rotation=30", "time.end=5", "grid.cell=0.4", *WIDE)
THETA = ("heat.time_integration=implicit", "heat.theta=1", "time.steps=10")
COLUMN = ("time.end=0.15", "bodies.0.points_per_cell=4", "grid.cell=0.2")
ANNULUS = "lapilli.references.supports:annulus"

# scene, changes, reference, field
SCENES = {
    "ring": ("vhfm/ring", ("time.end=1", "grid.cell=0.4"), "radial", "temperature"),
    "ring early": ("vhfm/ring", ("time.end=0.05", "grid.cell=0.4"), "radial", "temperature"),
    "ring, theta": ("vhfm/ring", ("time.end=1", "grid.cell=0.4", *THETA), "radial", "temperature"),
    "flux": ("vhfm/ring_flux", ("time.end=1", "grid.cell=0.4"), "radial", "temperature"),
    "prescribed": ("vhfm/ring_temperature", ("grid.cell=0.4",), "radial", "temperature"),
    "turned": ("vhfm/square", TURNED, "slab", "temperature"),
    "Biot 100": (
        "vhfm/square", (*TURNED, "heat.boundaries.0.coefficient=100"), "slab", "temperature",
    ),
    "turning": (
        "vhfm/square_rotating", ("time.end=1", "grid.cell=0.8", *WIDE), "slab", "temperature",
    ),
    "sphere": ("vhfm/sphere", ("time.end=2", "grid.cell=0.7"), "radial", "temperature"),
    "rod": ("vhfm/rod_convection", ("grid.cell=0.2",), "radial", "temperature"),
    "annulus": ("ib/annulus", ("grid.cell=0.016",), ANNULUS, "displacement"),
    "conduction": ("pd/conduction", ("grid.cell=0.1",), "plates", "temperature"),
    "conduction, early": (
        "pd/conduction", ("grid.cell=0.05", "time.end=0.02"), "plates", "temperature",
    ),
    "column, T": ("vhfm/column", COLUMN, "finer:grid.cell=0.025", "temperature"),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("target", [2e-2, 4e-3])
def test_suggestions_are_right_or_say_that_they_cannot_tell(target: float) -> None:
    """Relative errors within the target, and within a factor of two of what was said, for all
    suggestions but one; at most two scenes without any."""
    silent, wrong, checked = [], [], 0
    for name, (example, changes, reference, field) in SCENES.items():
        scene: lp.Scene = examples.load(example)
        for change in changes:
            scene = scene.set(change)
        found = suggest(
            scene, target, quantity=field, norm="relative", budget=20, runner=InProcess()
        )
        if found.grade is None:
            silent.append(name)
            continue
        times, kinds = (scene.time.end,), ((field, True),)
        applied = found.setting.apply(scene)
        base = scene if reference.startswith("finer") else applied
        truth = truth_of(reference, base, kinds, times, [found.setting])
        error = Task(scene, found.setting, 0, truth, kinds, times, 1, "relative")().error
        assert error is not None
        checked += 1
        if not (0.5 <= error / found.grade.error <= 2 and error <= 1.2 * target):
            wrong.append(f"{name}: {found.grade.error:.3g} said, {error:.3g} true")
    assert len(wrong) <= 1, wrong
    assert len(silent) <= 2, silent
