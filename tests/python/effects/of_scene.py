"""Keys of grid, clock, bodies and output."""

from __future__ import annotations

import scenes
import variants as v
from effect import (
    Effect,
    centre,
    mean,
    points,
    size,
    steps,
    supplied,
    volume,
)

VELOCITY = size("velocity")
D = scenes.disk
F = scenes.falling_block
P = scenes.pressed_block

EFFECTS: dict[str, Effect] = {
    "Grid.lower": Effect(F, "grid.lower", (0, 0), (0, -1), VELOCITY, "!="),
    "Grid.cell": Effect(D, "grid.cell", 0.25, 0.125, points, "x", 4.0, 0.1, steps=False),
    "Grid.shape_function": Effect(F, "grid.shape_function", "gimp", "linear", VELOCITY, "!="),
    "Time.end": Effect(D, "time.end", 0.05, 0.1, mean("temperature"), ">"),
    "Time.step": Effect(D, "time.step", 0.005, 0.0025, steps, "x", 2.0),
    "Time.steps": Effect(P, "time.steps", 2, 4, steps, "x", 2.0),
    "Body.shape": Effect(D, "bodies[0].shape.radius", 1.3, 1.0, volume, "<", steps=False),
    "Body.points_per_cell": Effect(
        D, "bodies[0].points_per_cell", 4, 9, points, "x", 2.25, 0.1, steps=False
    ),
    "Body.fill": Effect(
        v.box_plate, "bodies[0].fill", "lattice", "exact", volume, "!=", steps=False
    ),
    "Body.jitter": Effect(D, "bodies[0].jitter", 0.0, 0.3, size("position"), "!=", steps=False),
    "Body.random": Effect(D, "bodies[0].random", False, True, size("position"), "!=", steps=False),
    "Body.seed": Effect(v.shaken_disk, "bodies[0].seed", 1, 2, size("position"), "!=", steps=False),
    "Body.rotation": Effect(
        v.box_plate, "bodies[0].rotation", 0.0, 20.0, size("position"), "!=", steps=False
    ),
    "Body.rotation_center": Effect(
        v.rotated_box, "bodies[0].rotation_center", (0, 0), (0.1, 0.3), centre(0), ">", steps=False
    ),
    "Body.translation": Effect(
        v.box_plate, "bodies[0].translation", (0, 0), (0.3, 0), centre(0), ">", steps=False
    ),
    "Body.temperature": Effect(D, "bodies[0].temperature", 0.0, 2.0, supplied("heat"), "<"),
    "Body.source": Effect(D, "bodies[0].source", 0.0, 3.0, mean("temperature"), ">"),
    "Body.velocity": Effect(F, "bodies[0].velocity", (0.5, -1), (-0.5, -1), centre(0), "<"),
    "Body.spin": Effect(F, "bodies[0].spin", 1.0, 2.0, VELOCITY, "!="),
    "Body.spin_center": Effect(
        v.spinning_block, "bodies[0].spin_center", (1.5, 0.5), (0, 0), centre(1), ">"
    ),
}
