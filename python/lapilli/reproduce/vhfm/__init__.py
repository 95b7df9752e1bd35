"""The cases of Yu & Zhao 2026, the virtual heat flux method.

Every case is run twice. "Literal" is the paper's algorithm: particle normals, the surface from
volume fractions, FLIP, linear shape functions, explicit exchange; the paper looks at its fields
one step late, and so do these rows. "Default" is what lapilli does unless it is told otherwise,
compared with exact solutions.
"""
