"""Independent references for every verification: NumPy and SciPy only, never the compiled module.

A reference that shares code with the solver proves nothing; importing it must not even load it.

| module | problem | method |
|---|---|---|
| rod | semi-infinite rod, constant flux or convection | closed form |
| radial | slab, disc, ring, ball, shell; flux, convection, prescribed | Galerkin, exact in time |
| slab | slab, rectangle, cube with convection; slab with prescribed faces | series and images |
| finite_difference | ring, sphere, square | the heat paper's own schemes, misprints undone |
| plane | any union of cells in the plane, the L-shape | finite volumes, TR-BDF2 |
| swirl | heated disc whose circles turn at their own speeds | exact motion, radial conduction |
"""
