"""Where the defaults lie: error against cost of scenes of all methods, defaults beside the rest.

    python bench/fronts.py [--only ring] [--workers 2] [--output build/fronts]

For each scene of fronts.toml writes NAME.csv and NAME.png; fronts.json holds what the defaults cost
over the cheapest setting of the same error. Measurements are kept in NAME.jsonl: a scan that was
stopped goes on. The exit code is 1 where a default costs more than 1.5 times the front. --manual
takes the pictures and fronts.json over into the manual.
"""

from __future__ import annotations

import argparse
import itertools
import json
import math
import platform
import shutil
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import tomllib

from lapilli import Scene, examples
from lapilli.study import LocalPool, tradeoff
from lapilli.study.settings import Setting
from lapilli.study.show import report
from lapilli.study.table import Table, cost_of, error_of
from lapilli.study.variants import variants_of
from lapilli.whole_file import write_text

SCENES = Path(__file__).with_suffix(".toml")
DOCS = Path(__file__).resolve().parents[1] / "docs"
BAR = 1.5  # of the cost of the front

Curve = list[tuple[float, float]]  # error and cost, coarse to fine


def scenes() -> dict[str, dict[str, Any]]:
    """What is scanned, by name."""
    return tomllib.loads(SCENES.read_text())


def changes_of(texts: Sequence[str]) -> dict[str, list[str]]:
    """Paths with one value each, from "path=value"."""
    return {path: [value] for path, _, value in (text.partition("=") for text in texts)}


def measured(given: dict[str, Any], store: Path, workers: int, repeats: int) -> Table:
    """The default and every other setting of a scene on all of its cells."""
    scene = Scene.load(str(examples.path(given["scene"])))
    for change in given.get("set", []):
        scene = scene.set(change)
    cells = {"grid.cell": given["cells"]}
    others = [{path: [value] for path, value in one.changes} for one in variants_of(scene)]
    others += [changes_of(texts) for texts in given.get("others", [])]
    return tradeoff(
        scene,
        [cells, *(cells | one for one in others)],
        given.get("reference"),
        quantities=[given.get("quantity", "temperature")],
        repeats=repeats,
        runner=LocalPool(workers),
        store=store,
        report=report,
    )


def curves_of(table: Table) -> dict[Setting, Curve]:
    """Error and cost along the cells, by the rest of the setting; the default has none."""
    curves: dict[Setting, Curve] = {}
    for row in table.rows:
        curve = curves.setdefault(Setting(row.setting.changes[1:]), [])
        if row.error is not None and row.cpu_seconds:
            curve.append((error_of(row), cost_of(row)))
    return curves


def cost_at(curve: Curve, error: float) -> float:
    """What an error costs along a curve, between its cells on logarithms; infinite beyond."""
    best = min((cost for found, cost in curve if found <= error), default=math.inf)
    for (coarse, cheap), (fine, dear) in itertools.pairwise(curve):
        if fine < error < coarse:
            share = math.log(coarse / error) / math.log(coarse / fine)
            best = min(best, cheap * (dear / cheap) ** share)
    return best


def compared(table: Table) -> list[dict[str, Any]]:
    """Every cell of the default beside the cheapest curve at its error."""
    curves = curves_of(table)
    default = Setting(())
    rows = []
    for row in table.rows:
        if row.setting.changes[1:] or row.error is None:
            continue
        costs = {setting: cost_at(curve, error_of(row)) for setting, curve in curves.items()}
        best = min(costs, key=lambda setting: costs[setting])
        rows.append(
            {
                "cell": float(dict(row.setting.changes)["grid.cell"]),
                "error": row.error,
                "cpu_seconds": cost_of(row),
                "over_front": costs[default] / costs[best],
                "best": str(best) or "default",
            }
        )
    return rows


def main() -> int:
    """Scan the scenes that were asked for."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--only", choices=scenes(), action="append", help="scenes; all if none")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--output", type=Path, default=Path("build/fronts"))
    parser.add_argument("--manual", action="store_true", help="renew the page of the manual")
    given = parser.parse_args()
    given.output.mkdir(parents=True, exist_ok=True)
    found = []
    for name in given.only or scenes():
        print(f"{name}:", file=sys.stderr, flush=True)
        table = measured(
            scenes()[name], given.output / f"{name}.jsonl", given.workers, given.repeats
        )
        table.to_csv(given.output / f"{name}.csv")
        table.picture(given.output / f"{name}.png")
        rows = compared(table)
        words = {key: scenes()[name][key] for key in ("title", "choose")}
        found.append({"name": name, **words, "rows": rows})
        for row in rows:
            print(
                f"{name:16} cell {row['cell']:<8.3g} error {row['error']:9.3g} "
                f"{row['cpu_seconds']:8.3g} CPU s  {row['over_front']:5.2f} x the front: "
                f"{row['best']}",
                flush=True,
            )
    told = {"bar": BAR, "processor": processor(), "scenes": found}
    write_text(given.output / "fronts.json", json.dumps(told, indent=1) + "\n")
    if given.manual:
        take_over(given.output, [one["name"] for one in found])
    return int(any(row["over_front"] > BAR for one in found for row in one["rows"]))


def processor() -> str:
    """The name of the processor."""
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.processor()


def take_over(folder: Path, names: Sequence[str]) -> None:
    """Put what was measured where the manual is made from."""
    pictures = DOCS / "pictures" / "fronts"
    pictures.mkdir(parents=True, exist_ok=True)
    shutil.copy(folder / "fronts.json", DOCS)
    for name in names:
        shutil.copy(folder / f"{name}.png", pictures)


if __name__ == "__main__":
    sys.exit(main())
