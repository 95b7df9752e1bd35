"""Heat and large deformation with particles, on boundaries that do not fit the grid."""

import os
from typing import NoReturn

# Threads that wait for the next loop spin for a quarter of a millisecond, then sleep: steps of a
# millisecond do not wait for them to wake, and other programs on the machine, and NumPy's own
# threads, keep their processors. Read once, when the compiled module loads.
if "OMP_WAIT_POLICY" not in os.environ:
    os.environ["OMP_WAIT_POLICY"] = "passive"
    os.environ.setdefault("GOMP_SPINCOUNT", "5000")

try:
    import lapilli._core  # noqa: F401
except ImportError as error:
    # What the loader of the C library says of a module for another processor level.
    if "ISA level" not in str(error):
        raise
    raise ImportError(
        "lapilli was built for a processor of a higher level than this one (AVX2 is missing): "
        "build it here, where it takes the level of this processor, or install the wheel, which "
        f"holds kernels for every processor ({error})"
    ) from error

from lapilli._core import (
    Annulus,
    Balance,
    Body,
    BodyContact,
    Box,
    Convection,
    Cylinder,
    Difference,
    Disk,
    DruckerPrager,
    Dynamics,
    Elastic,
    Ellipse,
    Ellipsoid,
    FluidWall,
    Flux,
    FrictionalBoundary,
    FunctionSolid,
    Geostatic,
    Grid,
    HalfSpace,
    Heat,
    HeatContact,
    HeightField,
    Image,
    Intersection,
    Mesh,
    ModifiedCamClay,
    MohrCoulomb,
    Newtonian,
    NoSlipBoundary,
    Obstacle,
    Output,
    OutputError,
    PeridynamicFlow,
    PeridynamicHeat,
    Peridynamics,
    PlasticHeating,
    Points,
    Polygon,
    PrescribedTemperature,
    Pressure,
    Probe,
    QuasiStatic,
    Radiation,
    RollerBoundary,
    Rotated,
    Rotation,
    RunError,
    Scene,
    Shape,
    Simulation,
    Sphere,
    Stage,
    Support,
    SurfaceTraction,
    Swirl,
    Table,
    TabulatedMohrCoulomb,
    Thermal,
    ThermalExpansion,
    Time,
    Traction,
    Translated,
    Translation,
    Union,
    VonMises,
    __version__,
    set_thread_count,
    thread_count,
    unknown_name,
)
from lapilli.accept import accept_foreign_values
from lapilli.checking import check
from lapilli.frames import Frames
from lapilli.html import show_in_notebooks
from lapilli.result import Result, run

accept_foreign_values()
show_in_notebooks()

__all__ = [
    "Annulus",
    "Balance",
    "Body",
    "BodyContact",
    "Box",
    "Convection",
    "Cylinder",
    "Difference",
    "Disk",
    "DruckerPrager",
    "Dynamics",
    "Elastic",
    "Ellipse",
    "Ellipsoid",
    "FluidWall",
    "Flux",
    "Frames",
    "FrictionalBoundary",
    "FunctionSolid",
    "Geostatic",
    "Grid",
    "HalfSpace",
    "Heat",
    "HeatContact",
    "HeightField",
    "Image",
    "Intersection",
    "Mesh",
    "ModifiedCamClay",
    "MohrCoulomb",
    "Newtonian",
    "NoSlipBoundary",
    "Obstacle",
    "Output",
    "OutputError",
    "PeridynamicFlow",
    "PeridynamicHeat",
    "Peridynamics",
    "PlasticHeating",
    "Points",
    "Polygon",
    "PrescribedTemperature",
    "Pressure",
    "Probe",
    "QuasiStatic",
    "Radiation",
    "Result",
    "RollerBoundary",
    "Rotated",
    "Rotation",
    "RunError",
    "Scene",
    "Shape",
    "Simulation",
    "Sphere",
    "Stage",
    "Support",
    "SurfaceTraction",
    "Swirl",
    "Table",
    "TabulatedMohrCoulomb",
    "Thermal",
    "ThermalExpansion",
    "Time",
    "Traction",
    "Translated",
    "Translation",
    "Union",
    "VonMises",
    "__version__",
    "check",
    "run",
    "set_thread_count",
    "thread_count",
]


def __getattr__(name: str) -> NoReturn:
    raise AttributeError(f"lapilli: {unknown_name('name', name, __all__)}")
