"""Figures 5 and 6: the rod's temperatures, errors and convergence."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from lapilli.reproduce.figures import convergence, new_figure, save, slope
from lapilli.reproduce.states import Array, changed, states
from lapilli.reproduce.vhfm.literal import literal
from lapilli.reproduce.vhfm.rod import (
    FINEST,
    LAWS,
    default_errors,
    exact_temperature,
    literal_errors,
    rod_scene,
)
from lapilli.reproduce.vhfm.tables import TABLE_2, TIMES


def draw(folder: Path, quick: bool) -> list[Path]:
    """Both figures."""
    return [draw_profiles(folder), draw_convergence(folder, quick)]


def draw_profiles(folder: Path) -> Path:
    """Fig. 5: temperature at 0.1 and 0.5 s, and the errors of the ways to impose the flux."""
    figure, axes = new_figure(2, 2)
    for column, law in enumerate(LAWS):
        x = np.linspace(0, 5, 400)
        for k, time in enumerate((0.1, 0.5)):
            axes[0, column].plot(
                x, exact_temperature(law, x, time), "k", lw=1, label="exact" if k == 0 else None
            )
        for conforming, marker, color in ((True, "o", "tab:blue"), (False, "x", "tab:orange")):
            words = "conforming" if conforming else "not conforming"
            for time, place, value in profiles(law, conforming):
                axes[0, column].plot(
                    place,
                    value,
                    marker,
                    ms=4,
                    markevery=2,
                    color=color,
                    label=words if time == 0.1 else None,
                )
        axes[0, column].set(
            xlim=(0, 5), title=f"{law}, 0.1 and 0.5 s", xlabel="x (m)", ylabel="temperature (K)"
        )
        axes[0, column].legend(fontsize=8)
        for label, place, error in error_profiles(law):
            axes[1, column].semilogy(place, np.abs(error) + 1e-12, label=label, lw=1)
        axes[1, column].set(
            xlim=(0, 5), ylim=(1e-7, 3e-2), xlabel="x (m)", ylabel="|error| at 0.5 s (K)"
        )
        axes[1, column].legend(fontsize=8)
    return save(figure, folder / "rod_profiles.png")


def profiles(law: str, conforming: bool) -> list[tuple[float, Array, Array]]:
    """Time, places and temperatures of the default settings."""
    scene = changed(rod_scene(law, 0.1, conforming), "time.step=0.001")
    return [
        (state.time, state.position[:, 0], state.temperature) for state in states(scene, (0.1, 0.5))
    ]


def error_profiles(law: str) -> list[tuple[str, Array, Array]]:
    """Errors at 0.5 s: the paper's three ways, and the default."""
    found = []
    for label, method, conforming in (
        ("literal: nodes", "node", True),
        ("literal: points", "particle", True),
        ("literal: virtual flux, not conforming", "paper", False),
    ):
        scene = literal(rod_scene(law, 0.1, conforming), 1e-3, method)
        state = next(states(scene, [0.5], late=1e-3))
        x = state.position[:, 0]
        found.append((label, x, state.temperature - exact_temperature(law, x, 0.5)))
    for time, x, value in profiles(law, False):
        if time == 0.5:
            found.append(("default, not conforming", x, value - exact_temperature(law, x, time)))
    return found


def draw_convergence(folder: Path, quick: bool) -> Path:
    """Fig. 6: errors at the last time over the grid."""
    figure, axes = new_figure(1, 2)
    for column, law in enumerate(LAWS):
        cells = [cell for cell in TABLE_2[law, "VHFM"] if not quick or cell > FINEST]
        for method, name in (("paper", "literal: virtual flux"), ("particle", "literal: points")):
            errors = [literal_errors(law, method, cell, False)[-1] for cell in cells]
            convergence(axes[0, column], cells, errors, name)
        kept = [default_errors(law, cell, False, "nodal")[-1] for cell in cells]
        convergence(axes[0, column], cells, kept, "default", "s-")
        slope(axes[0, column], cells, 2 * kept[0], 2)
        axes[0, column].set_title(f"{law}, {TIMES[law][-1]:g} s, not conforming")
        axes[0, column].legend(fontsize=8)
    return save(figure, folder / "rod_convergence.png")
