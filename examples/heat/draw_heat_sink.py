"""Draws heat_sink.stl: a base of 40 x 40 x 4 mm with seven fins of 2 mm, 16 mm high, in millimetres."""

import struct

WIDTH, DEPTH, BASE, HEIGHT, FINS, FIN = 40.0, 40.0, 4.0, 20.0, 7, 2.0
GAP = (WIDTH - FINS * FIN) / (FINS - 1)


def profile() -> list[tuple[float, float, float]]:
    """Columns of the section in x and z: left, right, top."""
    columns = []
    for k in range(FINS):
        left = k * (FIN + GAP)
        columns.append((left, left + FIN, HEIGHT))
        if k < FINS - 1:
            columns.append((left + FIN, left + FIN + GAP, BASE))
    return columns


def quad(a, b, c, d):
    """Two triangles of a rectangle, seen anticlockwise from outside."""
    return [(a, b, c), (a, c, d)]


def surface():
    """All triangles; every edge is shared by two."""
    triangles = []
    columns = profile()
    for k, (x0, x1, top) in enumerate(columns):
        layers = [(0.0, BASE)] + ([(BASE, top)] if top > BASE else [])
        for z0, z1 in layers:
            front = [(x0, 0.0, z0), (x1, 0.0, z0), (x1, 0.0, z1), (x0, 0.0, z1)]
            back = [(x, DEPTH, z) for x, _, z in front]
            triangles += quad(*front) + quad(*back[::-1])
            if z0 == BASE or k == 0:
                triangles += quad(front[0], front[3], back[3], back[0])
            if z0 == BASE or k == len(columns) - 1:
                triangles += quad(front[1], back[1], back[2], front[2])
        triangles += quad((x0, 0.0, 0.0), (x0, DEPTH, 0.0), (x1, DEPTH, 0.0), (x1, 0.0, 0.0))
        triangles += quad((x0, 0.0, top), (x1, 0.0, top), (x1, DEPTH, top), (x0, DEPTH, top))
    return triangles


if __name__ == "__main__":
    faces = surface()
    with open("heat_sink.stl", "wb") as file:
        file.write(b"heat sink, millimetres".ljust(80) + struct.pack("<I", len(faces)))
        for corners in faces:
            numbers = [0.0, 0.0, 0.0, *(x for corner in corners for x in corner)]
            file.write(struct.pack("<12fH", *numbers, 0))
