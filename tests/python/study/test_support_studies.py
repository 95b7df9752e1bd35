"""Error against cost of supports: fields with components, and the shipped functions."""

from pathlib import Path

import numpy as np
import pytest

from lapilli.references import supports
from lapilli.reproduce.ib import cantilever
from lapilli.study import tradeoff

EXAMPLES = Path(__file__).parents[3] / "examples" / "ib"


@pytest.mark.parametrize(("name", "ratio"), [("block", 0.0), ("annulus", 2.5)])
def test_examples_against_their_exact_fields(name: str, ratio: float) -> None:
    """The block is exact to rounding; the ring converges at nearly second order: 2.5 from 4 to
    2 mm, where cells cut to slivers still leave a part of first order."""
    cells = [0.004, 0.002] if name == "annulus" else [0.02, 0.01]
    table = tradeoff(
        EXAMPLES / f"{name}.toml",
        {"grid.cell": cells},
        getattr(supports, name),
        field="displacement",
        repeats=1,
    )
    coarse, fine = (row.error for row in table.rows)
    assert coarse is not None
    assert fine is not None
    if ratio:
        assert coarse / fine >= ratio
    else:
        assert max(coarse, fine) <= 1e-13


def test_the_cantilever_function_is_that_of_its_scene() -> None:
    """Deflection of the free end: finite elements of 0.25 mm against 2 mm, 1.4 % apart."""
    found = supports.cantilever(np.array([[0.0, 0.0]]), 1.0)
    state = cantilever.balance(cantilever.cantilever_scene(45, 0.002, 3, cantilever.SMALL))
    near = np.linalg.norm(state.start, axis=1) < 0.002
    np.testing.assert_allclose(found[0], state.displacement[near].mean(axis=0), rtol=0.03)
