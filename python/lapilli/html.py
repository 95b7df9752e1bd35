"""Scenes and results as notebooks show them."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from lapilli import _core

if TYPE_CHECKING:
    from lapilli._core import Body, Scene
    from lapilli.frames import Frames
    from lapilli.result import Result
    from lapilli.study.table import Table

PHYSICS = ("heat", "dynamics", "quasi_static", "peridynamics")


def show_in_notebooks() -> None:
    """Give the compiled classes that notebooks show their HTML."""
    shown: tuple[tuple[Any, Any], ...] = (
        (_core.Scene, scene_as_html),
        (_core.Table, table_as_html),
    )
    for made, as_html in shown:
        made._repr_html_ = as_html


def table(head: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """An HTML table; every cell is escaped."""
    titles = "".join(f"<th>{html.escape(title)}</th>" for title in head)
    lines = "".join(
        "<tr>" + "".join(f"<td>{html.escape(str(cell))}</td>" for cell in row) + "</tr>"
        for row in rows
    )
    return f"<table><thead><tr>{titles}</tr></thead><tbody>{lines}</tbody></table>"


def details(title: str, text: str) -> str:
    """A text that opens on a click."""
    return (
        f"<details><summary>{html.escape(title)}</summary><pre>{html.escape(text)}</pre></details>"
    )


def scene_as_html(scene: Scene) -> str:
    """What a scene holds, and all of it as TOML."""
    grid, time = scene.grid, scene.time
    span = " x ".join(f"{b - a:g}" for a, b in zip(grid.lower, grid.upper, strict=True))
    rows = [("grid", f"{span} m, cells of {grid.cell:g} m")]
    rows += [
        (f"bodies[{k}] {body.name}".strip(), said(body)) for k, body in enumerate(scene.bodies)
    ]
    rows += [(name, described(scene, name)) for name in PHYSICS if getattr(scene, name) is not None]
    rows += [
        (f"probe {probe.name}", f"{probe.field} at {probe.position}") for probe in scene.probes
    ]
    rows.append(("time", f"to {time.end:g} s"))
    try:
        whole = details("as TOML", scene.to_toml())
    except ValueError:  # functions and arrays, which no file holds
        whole = details("as Python", repr(scene))
    return table(("Scene", scene.title), rows) + whole


def table_as_html(given: _core.Table) -> str:
    """The times and values of a table in time."""
    return table(("time (s)", "value"), zip(given.times, given.values, strict=True))


def said(body: Body) -> str:
    """What a body is made of, in one line."""
    shape = body.shape
    source = (body.points_file or "points") if shape is None else type(shape).__name__
    materials = body.material if isinstance(body.material, (list, tuple)) else [body.material]
    return f"{source}; " + ", ".join(type(one).__name__ for one in materials if one is not None)


def described(scene: Scene, physics: str) -> str:
    """The members of a section that say something, by number or value."""
    section = getattr(scene, physics)
    lists = {name: value for name, value in vars(section).items() if isinstance(value, list)}
    return ", ".join(f"{len(value)} {name}" for name, value in lists.items() if value) or "modelled"


def frames_as_html(frames: Frames) -> str:
    """Times and fields with their units."""
    rows = [(name, frames.units[name]) for name in frames.fields]
    title = f"{len(frames)} frames, {frames.times[0]:g} to {frames.times[-1]:g} s, in {frames.path}"
    return f"<p>{html.escape(title)}</p>" + table(("field", "unit"), rows)


def result_as_html(result: Result) -> str:
    """How a run ended: its fields with their ranges, its balances."""
    simulation = result.simulation
    fields = []
    for name in (name for name in simulation.fields if name not in ("id", "body")):
        values = simulation[name]
        if values.ndim == 1 and len(values):
            ends = f"{values.min():.6g}", f"{values.max():.6g}"
            fields.append((name, *ends, result.unit(name)))
    balances = [
        (name, f"{one.supplied:.6g}", f"{one.stored:.6g}", one.unit, f"{one.residual:.1e}")
        for name, one in result.balance.items()
    ]
    said = [*result.summary.notes, *result.warnings]
    return (
        f"<p>{html.escape(repr(result)[1:-1])}, {result.summary.steps} steps</p>"
        + table(("field", "smallest", "largest", "unit"), fields)
        + table(("balance", "supplied", "stored", "unit", "residual"), balances)
        + "".join(f"<p>{html.escape(note.line)}</p>" for note in said)
    )


def study_as_html(study: Table) -> str:
    """One row for each setting; * marks the Pareto front."""
    paths = [path for path, _ in study.rows[0].setting.changes] if study.rows else []
    head = [
        *paths,
        f"RMS error ({study.unit})" if study.unit else "RMS error",
        "CPU s",
        "steps",
        "",
    ]
    rows = [
        [value for _, value in row.setting.changes]
        + (
            [row.reason, "", "", ""]
            if row.error is None
            else [
                f"{row.error:.3g}",
                f"{row.cpu_seconds:.3g}",
                row.steps,
                "*" if row.on_front else "",
            ]
        )
        for row in study.rows
    ]
    return table(head, rows) + f"<p>{html.escape(study.advice())}</p>"
