"""A contained cube turned about three axes: the patch test in space, beyond the paper."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from lapilli._core import Box, Grid, HalfSpace, Rotated, Scene, Shape, Support
from lapilli.references.elastic import Elastic
from lapilli.reproduce.case import Case, Row, example, within
from lapilli.reproduce.ib.balance import MODES, balance, in_mode, section
from lapilli.reproduce.ib.frame import ramp
from lapilli.reproduce.rows import near, rows_of
from lapilli.reproduce.states import Array

NAME = "ib/block3d"
SIZE, CELL = 0.4, 0.1  # m
STRAIN = 0.01
CORNER = np.array([0.031, 0.017, 0.023])  # m
TURNS = {
    "not turned": (0.0, 0.0, 0.0),
    "30 degrees about z": (0.0, 0.0, 30.0),
    "20, 30, 40 degrees about x, y, z": (20.0, 30.0, 40.0),
}
MATERIAL = Elastic(young=1e9, poisson=0.3)
BAR, VOLUME_BAR = 1e-8, 1e-12

row = rows_of(NAME)


def turn(degrees: tuple[float, float, float]) -> Array:
    """The rotation about x, then y, then z, as a matrix."""
    matrix: Array = np.eye(3)
    for axis, angle in enumerate(np.deg2rad(degrees)):
        about, c, s = np.eye(3), np.cos(angle), np.sin(angle)
        i, j = (axis + 1) % 3, (axis + 2) % 3
        about[i, i], about[i, j], about[j, i], about[j, j] = c, -s, s, c
        matrix = about @ matrix
    return matrix


def cube_scene(degrees: tuple[float, float, float]) -> Scene:
    """The example turned otherwise."""
    scene = example(NAME)
    sides = turn(degrees)
    bits = np.array([[k & 1, k >> 1 & 1, k >> 2 & 1] for k in range(8)])
    corners = CORNER + SIZE * bits @ sides.T
    lower = CELL * (np.floor(corners.min(axis=0) / CELL + 1e-9) - 1)
    upper = CELL * (np.ceil(corners.max(axis=0) / CELL - 1e-9) + 1)
    scene.grid = Grid(lower=list(lower), upper=list(upper), cell=CELL, shape_function="linear")
    shape: Shape = Box(lower=list(CORNER), upper=list(CORNER + SIZE))
    for axis, angle in enumerate(degrees):
        unit = [float(axis == k) for k in range(3)]
        shape = Rotated(shape=shape, degrees=angle, center=list(CORNER), axis=unit)
    scene.bodies[0].shape = shape
    walls = []
    for axis in range(3):
        for end, name in ((0, "near"), (1, "far")):
            face = HalfSpace(
                point=list(CORNER + end * SIZE * sides[:, axis]),
                normal=list((1 - 2 * end) * sides[:, axis]),
            )
            walls.append(Support(name=f"{'xyz'[axis]} {name}", kind="roller", shape=face))
    walls[1].displacement = ramp(STRAIN * SIZE * sides[:, 0])
    section(scene).supports = walls
    return scene


def turn_rows(name: str, mode: str) -> list[Row]:
    """Errors of displacement and stress, and the volume of the points."""
    sides = turn(TURNS[name])
    state = balance(in_mode(cube_scene(TURNS[name]), mode))
    there = STRAIN * ((state.start - CORNER) @ sides[:, :1]) * sides[:, 0]
    apart = np.linalg.norm(state.displacement - there, axis=1) / (STRAIN * SIZE)
    normal = np.array([MATERIAL.confined, MATERIAL.lame, MATERIAL.lame]) * STRAIN
    difference = np.zeros(len(state.start))
    for i in range(3):
        for j in range(3):
            exact = normal[i] if i == j else 0.0
            difference += (state.along(sides[:, i], sides[:, j]) - exact) ** 2
    displacement = state.mean(apart)
    stress = state.mean(np.sqrt(difference)) / float(np.linalg.norm(normal))
    volume = float(state.volume.sum())
    setting = f"{name}, {mode}"
    bar = near(volume / SIZE**3, 1, VOLUME_BAR)
    return [
        row(setting, "mean error of displacement", displacement, within(displacement, BAR)),
        row(setting, "mean error of stress", stress, within(stress, BAR)),
        row(setting, "volume of the points", volume, bar, unit="m³", reference=SIZE**3),
    ]


def run(quick: bool) -> list[Row]:
    """Three orientations in both modes."""
    return [r for mode in MODES for name in TURNS for r in turn_rows(name, mode)]


def plot(folder: Path, quick: bool) -> list[Path]:
    """The points of the turned cube and their displacement."""
    from lapilli.plot import require_matplotlib
    from lapilli.reproduce.figures import save

    require_matplotlib()
    import matplotlib.pyplot as plt

    state = balance(cube_scene(TURNS["20, 30, 40 degrees about x, y, z"]))
    figure = plt.figure(figsize=(5, 4.4), layout="constrained")
    axes = figure.add_subplot(projection="3d")
    size = 1e3 * np.linalg.norm(state.displacement, axis=1)
    drawn = axes.scatter(*state.position.T, c=size, s=4)
    axes.set_aspect("equal")
    axes.set_title("displacement (mm)")
    figure.colorbar(drawn, ax=axes, shrink=0.7)
    return [save(figure, folder / "ib_block3d.png")]


CASE = Case(name=NAME, title="contained cube turned about three axes", run=run, plot=plot)
