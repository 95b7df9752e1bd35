"""A resume goes on with the same problem, or says key by key what differs."""

import json

import numpy as np
import pytest

import lapilli as lp

AXIS = np.arange(10) * 0.1 + 1.05
POSITIONS = np.stack(np.meshgrid(AXIS, AXIS), -1).reshape(-1, 2)


def scene(end, positions=POSITIONS, volume=0.01, ambient=1.0, cell=0.2):
    return lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(4, 4), cell=cell),
        bodies=[
            lp.Body(
                points=lp.Points(positions, np.full(len(positions), volume)),
                material=lp.Thermal(density=1, specific_heat=1, conductivity=1),
            )
        ],
        heat=lp.Heat(boundaries=[lp.Convection(coefficient=1, ambient=ambient)]),
        time=lp.Time(end=end),
    )


@pytest.mark.parametrize(
    ("changed", "named"),
    [
        ({"volume": 0.008}, r"bodies\.0\.points \(volumes\)"),
        ({"positions": POSITIONS + 0.4}, r"bodies\.0\.points \(positions\)"),
        ({"ambient": 2.0}, r"heat\.boundaries\.0\.ambient was 1 and is 2"),
        ({"cell": 0.1}, r"grid\.cell was 0\.2 and is 0\.1"),
    ],
    ids=["volumes", "positions", "ambient", "cell"],
)
def test_another_problem_is_refused_by_its_key(tmp_path, changed, named):
    output = tmp_path / "run.vtkhdf"
    lp.run(scene(0.1), output, 0.05, progress=False)
    before = output.read_bytes()
    with pytest.raises(ValueError, match=named):
        lp.run(scene(0.2, **changed), output, 0.05, progress=False, resume=True)
    assert output.read_bytes() == before


def test_a_later_end_and_other_frames_are_the_same_problem(tmp_path):
    output = tmp_path / "run.vtkhdf"
    lp.run(scene(0.1), output, 0.05, progress=False)
    resumed = lp.run(scene(0.2), output, 0.02, progress=False, resume=True, threads=1)
    whole = lp.run(scene(0.2), progress=False)
    assert resumed.time == whole.time == 0.2
    assert abs(resumed.balance["heat"].residual) < 1e-9


def test_another_image_under_the_same_name_is_refused(tmp_path):
    def image(rows):
        (tmp_path / "mask.pgm").write_text(f"P2\n4 4\n1\n{rows}\n")

    text = """
[grid]
lower = [0.0, 0.0]
upper = [4.0, 4.0]
cell = 0.5
[[bodies]]
shape = {kind = "image", file = "mask.pgm", origin = [0.0, 0.0], pixel = 1.0}
material = {kind = "thermal", density = 1.0, specific_heat = 1.0, conductivity = 1.0}
[heat]
[time]
end = 0.1
"""
    (tmp_path / "scene.toml").write_text(text)
    output = tmp_path / "run.vtkhdf"
    image("0 0 1 1\n" * 4)
    lp.run(str(tmp_path / "scene.toml"), output, progress=False)
    image("1 1 0 0\n" * 4)
    with pytest.raises(ValueError, match=r"file mask\.pgm was \d+ bytes"):
        lp.run(str(tmp_path / "scene.toml"), output, progress=False, resume=True)


def test_functions_are_listed_as_not_compared(tmp_path):
    output = tmp_path / "run.vtkhdf"
    result = lp.run(scene(0.1, ambient=lambda p, s, t: 1.0), output, progress=False)
    assert result.record["not_compared"] == ["heat.boundaries.0.ambient"]
    record = json.loads((tmp_path / "run.json").read_text())
    assert not any("checkpoint" in note for note in record["notes"])
