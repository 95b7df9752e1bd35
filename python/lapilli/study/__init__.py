"""Error against cost over the settings of a scene.

    study = tradeoff(scene, vary={"grid.cell": [0.4, 0.2, 0.1]}, reference="radial", times=[1.0])
    print(study.advice(target_error=1e-2))

| module | does |
|---|---|
| settings | which settings are tried |
| reference | what errors are measured against |
| shipped | the package's own references, set up from the scene |
| measure | one run of one setting: errors and cost |
| runner | where the runs happen: a pool of processes, behind one small interface |
| tradeoff | runs all settings, keeps what was measured, resumes |
| table | median and spread, CSV, JSON, the Pareto front and the advice |
| picture | log-log picture |
"""

from lapilli.study.measure import Cost, Measurement
from lapilli.study.reference import Reference
from lapilli.study.runner import LocalPool, Runner
from lapilli.study.settings import Setting, parse_variation, settings_of
from lapilli.study.table import Row, Table
from lapilli.study.tradeoff import tradeoff

__all__ = [
    "Cost",
    "LocalPool",
    "Measurement",
    "Reference",
    "Row",
    "Runner",
    "Setting",
    "Table",
    "parse_variation",
    "settings_of",
    "tradeoff",
]
