"""The exact state of rest of the water in the four tanks.

Water compressed by its own weight has a volume smaller by about g H/c0^2 only:
it is taken as incompressible here.
"""

import numpy as np

GRAVITY = 9.81
LEVEL = 0.5  # asked for in constant/ulphProperties [m]
RADIUS, CENTRE = 0.1, np.array([0.5, 0.25])  # of the cylinder [m]


def outline(tank):
    """Corners of the tank in the x-y plane (n, 2) [m]."""
    if tank == "step":
        return np.array([[0, 0], [0.6, 0], [0.6, 0.2], [1, 0.2], [1, 0.8], [0, 0.8]])
    box = np.array([[0, 0], [1, 0], [1, 0.8], [0, 0.8]])
    if tank != "turned":
        return box
    c, s = np.cos(np.pi / 6), np.sin(np.pi / 6)
    return box @ np.array([[c, s], [-s, c]])


def below(corners, level):
    """The part of a polygon below a level (Sutherland and Hodgman)."""
    kept = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        if a[1] <= level:
            kept.append(a)
        if (a[1] <= level) != (b[1] <= level):
            kept.append(a + (b - a) * (level - a[1]) / (b[1] - a[1]))
    return np.array(kept)


def areaAndHeight(tank, level):
    """Area [m2] and height of the centroid [m] of the water up to a level."""
    x, y = below(outline(tank), level).T
    x1, y1 = np.roll(x, -1), np.roll(y, -1)
    cross = x * y1 - x1 * y
    area, moment = cross.sum() / 2, (cross * (y + y1)).sum() / 6
    if tank == "cylinder":
        hole = np.pi * RADIUS**2
        area, moment = area - hole, moment - hole * CENTRE[1]
    return area, moment / area
