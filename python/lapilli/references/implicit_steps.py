"""TR-BDF2 for the linear system M dT/dt = load - K T, M diagonal, K sparse and symmetric.

One step is a trapezoidal stage to t + gamma dt and a BDF2 stage to t + dt, gamma = 2 - sqrt 2, so
that both solve with the same matrix M + (gamma/2) dt K. Second order and L-stable: a sudden start
is damped, not echoed. Source: Bank et al., IEEE Trans. Electron Devices 32 (1985) 1992; Hosea &
Shampine, Appl. Numer. Math. 20 (1996) 21.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import csc_array, diags_array
from scipy.sparse.linalg import splu

from lapilli.references.arrays import Array

GAMMA = 2 - np.sqrt(2)
SIZES = 4  # the first steps are smaller by 4^4
STEPS_PER_SIZE = 6  # while starting, a step is at most a sixth of the time passed


def integrate(
    mass: Array, stiffness: csc_array, load: Array, start: Array, times: Array, step: float
) -> Array:
    """The solution at ascending times, shape (m, n).

    mass, load, start: (n,). step: the largest step; each stretch between outputs uses an equal
    number of steps not larger than it. The first stretch begins with small steps that grow by
    factors of four, so that a start that does not match the boundary keeps the second order.
    """
    frames, now, state = [], 0.0, start.copy()
    for time in times:
        stretch = float(time) - now
        if stretch < 0:
            raise ValueError(f"times must ascend from 0, got {times}")
        if stretch > 0:
            count = int(np.ceil(stretch / step - 1e-9))
            if now == 0:
                first = stretch * min(1.0, STEPS_PER_SIZE / count)
                state = _start(mass, stiffness, load, state, first)
                count = max(0, count - STEPS_PER_SIZE)
                stretch -= first
            if count > 0:
                state = _repeat(mass, stiffness, load, state, stretch / count, count)
            now = float(time)
        frames.append(state.copy())
    return np.stack(frames)


def _start(mass: Array, stiffness: csc_array, load: Array, state: Array, end: float) -> Array:
    """From 0 to end: stretches [0, e], [e, 4 e], [4 e, 16 e] ... up to end, each in equal steps."""
    reached = end / 4**SIZES
    state = _repeat(mass, stiffness, load, state, reached / STEPS_PER_SIZE, STEPS_PER_SIZE)
    for _ in range(SIZES):
        state = _repeat(mass, stiffness, load, state, reached / STEPS_PER_SIZE, 3 * STEPS_PER_SIZE)
        reached *= 4
    return state


def _repeat(
    mass: Array, stiffness: csc_array, load: Array, state: Array, dt: float, count: int
) -> Array:
    half = 0.5 * GAMMA * dt
    solve = splu(
        csc_array(diags_array(mass) + half * stiffness),
        permc_spec="MMD_AT_PLUS_A",
        options={"SymmetricMode": True},
    ).solve
    old, new = (1 - GAMMA) ** 2 / (GAMMA * (2 - GAMMA)), 1 / (GAMMA * (2 - GAMMA))
    for _ in range(count):
        middle = solve(mass * state + half * (2 * load - stiffness @ state))
        # (1 - gamma)/(2 - gamma) = gamma/2 for this gamma: the same matrix
        state = solve(mass * (new * middle - old * state) + half * load)
    return state
