""
    "Heat and large deformation with particles, on boundaries that do not fit the grid."
    ""

    import os from typing import NoReturn

#Threads that wait for the next loop spin for a quarter of a millisecond, then sleep : steps of a
#millisecond do not wait for them to wake, and other programs on the machine, and NumPy's own
#threads, keep their processors.Read once, when the compiled module loads.
    if "OMP_WAIT_POLICY" not in os.environ : os.environ["OMP_WAIT_POLICY"] =
    "passive" os.environ
        .setdefault("GOMP_SPINCOUNT", "5000")

            from lapilli
        ._core
        import(Annulus, Balance, Body, Box, Convection, Cylinder, Difference, Disk, DruckerPrager,
               Dynamics, Elastic, Ellipse, Ellipsoid, FluidWall, Flux, FrictionalBoundary,
               FunctionSolid, Geostatic, Grid, HalfSpace, Heat, HeightField, Image, Intersection,
               Mesh, MohrCoulomb, Newtonian, NoSlipBoundary, Obstacle, Output, OutputError,
               PeridynamicFlow, PeridynamicHeat, Peridynamics, PlasticHeating, Points, Polygon,
               PrescribedTemperature, Pressure, Probe, QuasiStatic, Radiation, RollerBoundary,
               Rotated, Rotation, RunError, Scene, Shape, Simulation, Sphere, Support,
               SurfaceTraction, Swirl, Table, TabulatedMohrCoulomb, Thermal, ThermalExpansion, Time,
               Traction, Translated, Translation, Union, VonMises, __version__, set_thread_count,
               thread_count, unknown_name, )
            from lapilli.frames import Frames from lapilli.result import Result,
                                             run

                                                 __all__ =
                                                     [
                                                       "Annulus",
                                                       "Balance",
                                                       "Body",
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
                                                       "HeightField",
                                                       "Image",
                                                       "Intersection",
                                                       "Mesh",
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
                                                       "run",
                                                       "set_thread_count",
                                                       "thread_count",
                                                     ]

                                             def
                                             __getattr__(name
                                                         : str) -> NoReturn
    : raise
      AttributeError(f "lapilli: {unknown_name('name', name, __all__)}")
