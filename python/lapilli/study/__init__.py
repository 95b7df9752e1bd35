"""Studies of a scene: error against cost, many cases, the cheapest setting within an error.

    study = tradeoff(scene, vary={"grid.cell": [0.4, 0.2, 0.1]}, reference="radial", times=[1.0])
    print(study.advice(target_error=1e-2))

| module | does |
|---|---|
| settings, fitting | which settings are tried, with cells that fit their grid |
| observe, quantity | runs a scene and sees its fields and scalars at named times |
| cost, norms | what a run takes, how far it is from its reference |
| reference, truth, finer, series, same_scene | what errors are measured against |
| shipped, enclosure | the package's own references, set up from the scene |
| measure | one run of one setting: errors and cost |
| runner, cluster | where the runs happen: processes of this machine, a Dask scheduler |
| tradeoff, store, keys | runs all settings, keeps what was measured, resumes |
| table, picture, show | median and spread, the Pareto front, the advice, files |
| sampling, survey, results, effects, show_survey | many cases of a scene as a table |
| optimise | cases chosen by what the former ones gave: optimisation, calibration |
| ladder, variants, search, suggest, suggest_show | the cheapest setting within an error |
"""

from lapilli.study.cluster import DaskCluster
from lapilli.study.cost import Cost
from lapilli.study.measure import Measurement
from lapilli.study.optimise import minimize
from lapilli.study.reference import Reference
from lapilli.study.results import Results
from lapilli.study.runner import InProcess, LocalPool, Runner
from lapilli.study.sampling import Range, cases_in, parse_values
from lapilli.study.settings import Setting, parse_variation, settings_of
from lapilli.study.suggest import Suggestion, suggest
from lapilli.study.survey import Outcome, study
from lapilli.study.table import Row, Table
from lapilli.study.tradeoff import tradeoff

__all__ = [
    "Cost",
    "DaskCluster",
    "InProcess",
    "LocalPool",
    "Measurement",
    "Outcome",
    "Range",
    "Reference",
    "Results",
    "Row",
    "Runner",
    "Setting",
    "Suggestion",
    "Table",
    "cases_in",
    "minimize",
    "parse_values",
    "parse_variation",
    "settings_of",
    "study",
    "suggest",
    "tradeoff",
]
