"""The cases of Yu & Zhao 2026, the virtual heat flux method.

Every case is run twice. "Literal" is the paper's algorithm: particle normals, the surface from
volume fractions, FLIP, linear shape functions, explicit exchange; Tables 1 to 3 of the paper look
at its fields one step late, and so do those rows. "Default" is what lapilli does unless it is told
otherwise, compared with exact solutions.
"""
