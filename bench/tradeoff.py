"""Error against cost of the heat scenes: boundary methods, transfers, shape functions and grids.

    python bench/tradeoff.py [--only ring] [--quick] [--output build/bench]

writes NAME.csv, NAME.json and NAME.png for each scene and prints the Pareto fronts. What was
measured is kept in NAME.jsonl: a bench that was stopped goes on.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lapilli import Scene
from lapilli.study import LocalPool, tradeoff
from lapilli.study.show import print_table, report

SCENES = Path(__file__).resolve().parents[1] / "examples" / "vhfm"
METHODS = ["virtual", "paper", "particle"]
TRANSFERS = ["nodal", "flip", "pic"]
SHAPES = ["gimp", "linear"]


@dataclass(frozen=True)
class Study:
    """One scene, what is varied and against what errors are measured."""

    scene: str
    reference: str
    times: Sequence[float]
    cells: Sequence[float]
    methods: Sequence[str] = tuple(METHODS)
    shapes: Sequence[str] = ("gimp",)  # on lattice points GIMP and linear weights are the same
    change: str = ""

    def load(self) -> Scene:
        """The scene, changed where the study asks for it."""
        scene = Scene.load(str(SCENES / f"{self.scene}.toml"))
        return scene.set(self.change) if self.change else scene

    def vary(self, quick: bool) -> dict[str, Sequence[Any]]:
        """The cell comes first: it is the axis along which the picture draws its lines."""
        return {
            "grid.cell": self.cells[:2] if quick else self.cells,
            "heat.method": self.methods,
            "heat.transfer": TRANSFERS,
            "grid.shape_function": self.shapes,
        }


STUDIES = {
    "rod": Study("rod", "radial", [1.0], [0.2, 0.1, 0.05], (*METHODS, "node")),
    "ring": Study("ring", "radial", [1.0], [0.4, 0.2, 0.1, 0.05]),
    "square": Study(
        "square", "slab", [5.0], [0.4, 0.2, 0.1], shapes=SHAPES, change="bodies.0.rotation=30"
    ),
    "sphere": Study("sphere", "radial", [2.5], [0.8, 0.4, 0.2]),
}


def main() -> None:
    """Run the studies that were asked for."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--only", choices=STUDIES, action="append", help="scenes; all if none")
    parser.add_argument("--quick", action="store_true", help="two grids, one repeat")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--output", type=Path, default=Path("build/bench"))
    given = parser.parse_args()
    given.output.mkdir(parents=True, exist_ok=True)
    for name in given.only or STUDIES:
        study = STUDIES[name]
        print(f"{name}: error at t = {study.times[0]:g} s", file=sys.stderr, flush=True)
        table = tradeoff(
            study.load(),
            study.vary(given.quick),
            study.reference,
            times=study.times,
            repeats=1 if given.quick else given.repeats,
            runner=LocalPool(1),
            store=given.output / f"{name}.jsonl",
            report=report,
        )
        table.to_csv(given.output / f"{name}.csv")
        table.to_json(given.output / f"{name}.json")
        table.picture(given.output / f"{name}.png")
        print_table(table)
        print(table.advice())


if __name__ == "__main__":
    main()
