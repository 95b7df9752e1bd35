"""Objects of every class are copied and pickled, or refuse to be: nothing ends the interpreter."""

import copy
import inspect
import pickle
import subprocess
import sys

import numpy as np
import pytest

import lapilli as lp
from lapilli import _core

CLASSES = sorted(
    name
    for name, one in vars(_core).items()
    if inspect.isclass(one) and not issubclass(one, BaseException)
)
# Each class in one interpreter of all: where one ends it, the last line names the class.
PROGRAM = """
import copy, pickle, sys
from lapilli import _core
for name in sys.argv[1:]:
    print(name, flush=True)
    cls = getattr(_core, name)
    for make in (lambda: cls.__new__(cls), lambda: cls()):
        try:
            one = make()
        except Exception:
            continue
        ways = [lambda protocol=protocol: pickle.loads(pickle.dumps(one, protocol))
                for protocol in range(6)]
        for way in [*ways, one.__reduce__, lambda: copy.copy(one), lambda: copy.deepcopy(one)]:
            try:
                way()
            except (TypeError, AttributeError, KeyError, ValueError, pickle.PicklingError):
                pass
print("all")
"""


def test_no_class_ends_the_interpreter() -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, *CLASSES], capture_output=True, text=True, timeout=60
    )
    assert done.stdout.split()[-1] == "all", done.stdout.split()[-1]
    assert done.returncode == 0


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_scenes_come_back_in_every_protocol(protocol: int, ring: lp.Scene) -> None:
    back = pickle.loads(pickle.dumps(ring, protocol))
    assert back == ring
    assert back.bodies[0].shape == ring.bodies[0].shape
    points = lp.Points(np.eye(2), np.ones(2))
    assert pickle.loads(pickle.dumps(points, protocol)) == points


def test_copies_are_as_before(ring: lp.Scene) -> None:
    assert copy.copy(ring) == copy.deepcopy(ring) == ring
    assert copy.copy(ring).grid is ring.grid
    assert copy.deepcopy(ring).grid is not ring.grid


NUMBERS = [np.complex128(1 + 2j), np.complex64(1), 1j, np.True_, np.bool_(0), np.array(1j),
           np.array(True)]  # fmt: skip


@pytest.mark.parametrize("number", NUMBERS)
def test_numbers_of_another_kind_are_refused(number: object, ring: lp.Scene) -> None:
    for owner, member in (
        (ring.grid, "cell"),
        (ring.bodies[0], "temperature"),
        (ring.bodies[0], "seed"),
        (ring.heat.boundaries[0], "coefficient"),
    ):
        with pytest.raises((TypeError, ValueError)):
            setattr(owner, member, number)
    with pytest.raises((TypeError, ValueError)):
        lp.Stage(set={"grid.cell": number})


@pytest.mark.parametrize("kind", [np.float32, np.float64, np.int64, np.uint8, np.array])
def test_numbers_of_numpy_are_taken(kind: type, ring: lp.Scene) -> None:
    ring.grid.cell = kind(2)
    assert ring.grid.cell == 2.0
