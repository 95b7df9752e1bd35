"""Draws fan.pgm: a hub with four swept blades, 400 x 400 pixels of 0.025 m, dark on white."""

from pathlib import Path

import numpy as np

PIXELS, PIXEL = 400, 0.025  # count, m
HUB, TIP = 1.0, 4.5  # m, radii
BLADES, SWEEP = 4, 0.9  # count, radians from hub to tip

middle = (np.arange(PIXELS) + 0.5 - PIXELS / 2) * PIXEL
x, y = np.meshgrid(middle, middle[::-1])
radius, angle = np.hypot(x, y), np.arctan2(y, x)

way_out = np.clip((radius - HUB) / (TIP - HUB), 0.0, 1.0)
centre_line = SWEEP * way_out
half_width = 0.30 + 0.12 * np.sin(np.pi * way_out)  # radians
pitch = 2 * np.pi / BLADES
off_centre = (angle - centre_line + pitch / 2) % pitch - pitch / 2
fan = (radius <= HUB) | ((np.abs(off_centre) <= half_width) & (radius <= TIP))

image = np.where(fan, 0, 255).astype(np.uint8)
header = f"P5 {PIXELS} {PIXELS} 255\n".encode()
(Path(__file__).parent / "fan.pgm").write_bytes(header + image.tobytes())
