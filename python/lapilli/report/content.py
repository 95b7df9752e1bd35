"""The parts of a report, from a run record."""

from __future__ import annotations

import html
import json
from typing import Any

from lapilli import _core
from lapilli._core import Scene
from lapilli.components import typeset
from lapilli.console import finite
from lapilli.html import table
from lapilli.note import notes_in

Record = dict[str, Any]


def status_line(record: Record) -> str:
    """How the run ended."""
    line = f"{record['status']} at {record['time']:g} s of {record['end']:g} s"
    line += f", {record['points']:,} points, {record['steps']:,} steps"
    if record["message"]:
        line += f": {record['message']}"
    return f"{line}. Written {record['written']} by lapilli {record['lapilli']}."


def warnings_of(record: Record) -> str:
    """What a user should know, as a list."""
    said = [
        ("warning", one)
        for physics in record["physics"]
        for one in notes_in(physics, "warnings", "warning_codes")
    ]
    said += [("note", one) for one in notes_in(record, "notes", "note_codes")]
    items = "".join(
        f'<li class="{kind}">{kind}: {html.escape(one.line)}</li>' for kind, one in said
    )
    return f"<ul>{items}</ul>" if items else ""


def models(record: Record) -> str:
    """What the scene models and what it does not; the bodies and their volumes."""
    try:
        check = json.loads(_core.check_json(Scene.parse(record["scene"])))
        rows = [
            ("modelled", ", ".join(check["modelled"])),
            ("not modelled", ", ".join(check["not_modelled"])),
            ("grid", " x ".join(map(str, check["cells"])) + f" cells, {check['nodes']:,} nodes"),
        ]
        rows += [
            (
                f"stage {one['name']}",
                f"{one['start']:g} to {one['end']:g} s; {', '.join(one['changes'])}",
            )
            for one in check["stages"]
        ]
    except (ValueError, OSError) as error:
        rows = [("modelled", f"the scene cannot be built again: {error}")]
    unit = ("m", "m²", "m³")[record["dimension"] - 1]
    bodies = [
        (
            body["name"],
            f"{body['points']:,}",
            f"{body['volume']:.6g} {unit}",
            f"{body['volume_of_shape']:.6g} {unit}" if "volume_of_shape" in body else "",
        )
        for body in record["bodies"]
    ]
    return table(("", ""), rows) + table(("body", "points", "volume", "of its shape"), bodies)


def balance_rows(record: Record) -> str:
    """Each balance with its entries."""
    tables = []
    for physics in record["physics"]:
        for one in physics["balances"]:
            rows = [("at the start", one["initial"])]
            rows += [(entry["name"], entry["in"]) for entry in one["entries"]]
            rows += [("supplied in all", one["supplied"]), ("stored at the end", one["stored"])]
            lines = [(name, f"{value:.6g}") for name, value in rows]
            lines.append(("residual (relative)", f"{one['residual']:.1e}"))
            tables.append(
                table((f"{physics['name']}: {one['quantity']}", typeset(one["unit"])), lines)
            )
    return "".join(tables)


def cost_rows(record: Record) -> list[tuple[str, str]]:
    """Steps, time, memory, versions."""
    return [
        ("steps", f"{record['steps']:,}"),
        ("size of a step", f"{record['smallest_step']:.4g} to {record['largest_step']:.4g} s"),
        ("iterations of implicit solves", f"{record['iterations']:,}"),
        ("wall time", f"{record['wall_seconds']:.3g} s"),
        ("processor time, all threads", f"{record['cpu_seconds']:.3g} s"),
        ("threads", str(record["threads"])),
        ("throughput", f"{record['point_steps_per_second']:.3g} point-steps/s"),
        ("largest memory", f"{record['peak_memory_bytes'] / 1e6:.0f} MB"),
        ("started", record["started"]),
        ("lapilli", record["lapilli"]),
        ("compiler", record["compiler"]),
        ("kernel set", record.get("kernel_set", "not recorded")),
        ("fingerprint of the scene", str(record["fingerprint"])),
    ]


def charts(record: Record) -> list[dict[str, Any]]:
    """Columns of the history in groups that share what they belong to and their unit."""
    times = record["history"]["time"]
    groups: dict[tuple[str, str], list[dict[str, Any]]] = {}
    for column in record["history_columns"]:
        # What a stage does not have is no number, and JSON has no word for it.
        said = record["history"][column["name"]]
        values = finite([None if one is None else float(one) for one in said])
        numbers = [value for value in values if value is not None]
        if not numbers or (len(set(numbers)) == 1 and numbers[0] == 0):
            continue  # nothing happened there
        owner = column["name"].partition("/")[0] if "/" in column["name"] else "probes"
        curve = {"name": column["name"], "meaning": column["meaning"], "values": values}
        groups.setdefault((owner, typeset(column["unit"])), []).append(curve)
    first = sorted(groups.items(), key=lambda group: group[0][0] != "probes")
    return [
        {"title": owner, "unit": unit, "times": times, "curves": curves}
        for (owner, unit), curves in first
    ]
