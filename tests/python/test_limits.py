"""Scenes that cannot be built are refused before they take time or memory."""

import json
import subprocess
import sys
import time
from pathlib import Path

import pytest

import lapilli as lp
from lapilli import _core

THERMAL = lp.Thermal(density=1, specific_heat=1, conductivity=1)
ELASTIC = lp.Elastic(density=1000, youngs_modulus=1e9, poissons_ratio=0.3)


def scene(upper=(4, 4), cell=0.1, shape=None, **more):
    body = {"shape": shape or lp.Box(lower=(1, 1), upper=(2, 2)), "material": THERMAL}
    body |= more.pop("body", {})
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=upper, cell=cell),
        bodies=[lp.Body(**body)],
        time=more.pop("time", lp.Time(end=1)),
        **({"heat": lp.Heat()} | more),
    )


FAR = 1e6
HOPELESS = {
    "a grid of 1e9 cells": lambda: scene(upper=(32000, 32000), cell=1),
    "a grid of 1e18 cells": lambda: scene(cell=4e-9),
    "a box far out": lambda: scene(shape=lp.Box(lower=(0, 0), upper=(FAR, 4))),
    "a box below": lambda: scene(shape=lp.Box(lower=(0, -FAR), upper=(4, 4))),
    "a corner far out": lambda: scene(shape=lp.Polygon(vertices=[(0, 0), (4, 0), (12345, 4)])),
    "a turned box far out": lambda: scene(
        shape=lp.Rotated(shape=lp.Box(lower=(0, 0), upper=(FAR, 4)), degrees=20)
    ),
    "cut cells far out": lambda: scene(
        shape=lp.Box(lower=(0, 0), upper=(4e99, 4)),
        body={"material": ELASTIC},
        heat=None,
        quasi_static=lp.QuasiStatic(),
        time=lp.Time(end=1, steps=1),
    ),
    "1e12 points": lambda: scene(cell=2e-6),
}


@pytest.mark.parametrize("name", HOPELESS)
def test_a_hopeless_scene_is_refused_at_once(name):
    given = HOPELESS[name]()
    for work in (lp.Simulation, _core.check_text, _core.check_json):
        before, begun = _core.peak_memory(), time.process_time()
        with pytest.raises((ValueError, MemoryError), match=r"grid|memory|points"):
            work(given)
        assert time.process_time() - begun < 2
        assert _core.peak_memory() - before < 1e8


def test_check_describes_a_large_scene_without_building_it():
    given = scene(cell=2e-3, shape=lp.Disk(center=(2, 2), radius=1))
    before, begun = _core.peak_memory(), time.process_time()
    text = _core.check_text(given)
    assert time.process_time() - begun < 2
    assert _core.peak_memory() - before < 1e8
    assert "not built" in text
    # pi r^2 / cell^2 times four points, from samples 1/48 of the box apart
    assert _core.check_json(given).count("not built") >= 1
    points = float(text.split("about ")[-1].split(" points")[0])
    assert points == pytest.approx(3.1416 / 2e-3**2 * 4, rel=0.02)


RUN = """
import sys, lapilli as lp
def peak():  # of this process alone; that of resource is at least its parent's
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith("VmHWM"))
before = peak()
lp.run(lp.Scene.load(sys.argv[1]), sys.argv[2], progress=False)
print(peak() - before)
"""


def large(method: str, dim: int) -> lp.Scene:
    """Some ten thousand points or more of one method for a few steps."""
    unit = lp.Thermal(density=1, specific_heat=1, conductivity=1)
    soil = lp.MohrCoulomb(density=2e3, youngs_modulus=1e6, poissons_ratio=0.3, friction_angle=30)
    stone = lp.Elastic(density=2e3, youngs_modulus=1e6, poissons_ratio=0.3)
    low, high = (0.1,) * dim, (0.9,) * dim
    body = lp.Body(shape=lp.Box(lower=low, upper=high), material=unit)
    cells = {2: 200, 3: 36}[dim]
    grid = lp.Grid(lower=(0,) * dim, upper=(1,) * dim, cell=1 / cells)
    scene = lp.Scene(grid=grid, bodies=[body], time=lp.Time(end=1e-4))
    down = (0.0,) * (dim - 1) + (-1.0,)
    if method == "heat":
        scene.heat = lp.Heat(boundaries=[lp.Convection(coefficient=1, ambient=1)])
    elif method == "soil":
        body.material = soil
        scene.dynamics = lp.Dynamics(gravity=down)
    elif method == "static":
        scene.grid.cell = {2: 1 / 100, 3: 1 / 20}[dim]
        body.material = stone
        floor = lp.Support(name="floor", shape=lp.Box(lower=(0.05,) * dim, upper=(*high[1:], 0.1)))
        scene.quasi_static = lp.QuasiStatic(body_force=down, supports=[floor])
        scene.time = lp.Time(end=1, steps=1)
    else:
        scene.grid.cell = {2: 1 / 250, 3: 1 / 40}[dim]
        body.points_per_cell = 1
        scene.peridynamics = lp.Peridynamics(heat=lp.PeridynamicHeat())
        scene.time = lp.Time(end=1e-5)
    return scene


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("method", ["heat", "soil", "static", "peridynamics"])
def test_the_estimate_is_what_a_run_takes(method: str, dim: int, tmp_path: Path) -> None:
    """Within a factor of two either way: what is refused for want of memory would not have fitted,
    and what is let run does."""
    scene = tmp_path / "scene.toml"
    scene.write_text(large(method, dim).to_toml())
    told = json.loads(_core.check_json(lp.Scene.load(scene)))["memory"]
    command = [sys.executable, "-c", RUN, str(scene), str(tmp_path / "run.vtkhdf")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert 0.5 < told / float(done.stdout) < 2.0


def test_nesting_of_a_file_has_a_limit_that_is_named():
    text = "shape = " + '{kind = "union", shapes = [' * 500 + "]}" * 500
    with pytest.raises(ValueError, match=r"nest|depth"):
        lp.Scene.parse("[[bodies]]\n" + text)


def test_reading_takes_time_in_proportion_to_the_file():
    def seconds(count):
        vertices = ", ".join(f"[{k}.0, {k * k % 7}.0]" for k in range(count))
        text = f'[[bodies]]\nshape = {{kind = "polygon", vertices = [{vertices}]}}\n'
        best = []
        for _ in range(3):
            begun = time.process_time()
            with pytest.raises(ValueError, match=r"needs|missing"):
                lp.Scene.parse(text)
            best.append(time.process_time() - begun)
        return min(best)

    assert seconds(40_000) < 3 * 4 * max(seconds(10_000), 1e-3)


def test_a_box_that_is_larger_than_its_shape_is_no_reason_to_refuse() -> None:
    """The box of a difference is that of what is cut."""
    long = lp.Box(lower=(-10, -1), upper=(10, 1))
    ends = [lp.Box(lower=(-11, -2), upper=(-1, 2)), lp.Box(lower=(1, -2), upper=(11, 2))]
    rest = lp.Difference(shape=long, minus=lp.Union(shapes=ends))

    def scene(shape: lp.Shape) -> lp.Scene:
        unit = lp.Thermal(density=1, specific_heat=1, conductivity=1)
        return lp.Scene(
            grid=lp.Grid(lower=(-2, -2), upper=(2, 2), cell=0.25),
            bodies=[lp.Body(shape=shape, material=[unit])],
            heat=lp.Heat(),
            time=lp.Time(end=0.1),
        )

    simulation = lp.Simulation(scene(rest))
    assert simulation["volume"].sum() == pytest.approx(4.0)
    with pytest.raises(ValueError, match="reaches far outside of the grid: along x"):
        lp.Simulation(scene(long))
    with pytest.raises(ValueError, match="it spans 290 to 310 m"):
        lp.Simulation(scene(lp.Translated(shape=rest, by=(300, 0))))
