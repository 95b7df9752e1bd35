"""Independent references for every verification: NumPy and SciPy only, never the compiled module.

A reference that shares code with the solver proves nothing; a test reads this folder's imports.

| module | problem | method |
|---|---|---|
| rod | semi-infinite rod, constant flux or convection | closed form |
| radial | slab, disc, ring, ball, shell; flux, convection, prescribed | Galerkin, exact in time |
| slab | slab, rectangle, cube with convection; slab with prescribed faces | series and images |
| finite_difference | ring, sphere, square | the heat paper's own schemes, misprints undone |
| plane | any union of cells in the plane, the L-shape | finite volumes, TR-BDF2 |
| elastic | thick cylinder, annulus, column under its weight, contained block | closed form |
| bar_wave | waves in an elastic bar with fixed or free ends | d'Alembert |
| plane_strain | rectangle under a body force: deep beam, cantilever | bilinear finite elements |
| granular | run-out of a collapsing column | published fits to experiments |
| cavity | steady Boussinesq flow, heated side wall or floor | differences, Newton |
| supports | displacements of the scenes in `examples/ib` | closed form, finite elements |
| swirl | heated disc whose circles turn at their own speeds | exact motion, radial conduction |
"""
