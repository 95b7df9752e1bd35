"""The cases of Cortis et al. 2018, implicit boundaries in the quasi-static material point method.

Two named modes. "Literal" is the paper's algorithm with a consistency term of factor 1: stiff at
every point of the wall, bandwidth 1e-6 cells, no ghost stabilisation. "Default" is what lapilli
does unless it is told otherwise: stiff on the mean gap, bandwidth 1e-3 cells, ghost 0.01.
"""
