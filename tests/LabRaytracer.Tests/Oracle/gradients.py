#!/usr/bin/env python3
"""Writes gradients-double.txt: points and the gradients of u and v there, by differentiating the mappings' formulas with 60 digits. Needs mpmath."""
import random

import mpmath as mp

from rows import DOUBLE, write

HALF = mp.mpf(1) / 2
MAPPINGS = {
    "rectangular": (lambda x, y, z: (z + 1) * HALF, lambda x, y, z: (x + 1) * HALF),
    "cylindrical": (lambda x, y, z: mp.atan2(x, z) / (2 * mp.pi), lambda x, y, z: (y + 1) * HALF),
    "disk": (lambda x, y, z: mp.atan2(x, z) / (2 * mp.pi), lambda x, y, z: mp.sqrt(x * x + z * z)),
    "spherical": (lambda x, y, z: mp.atan2(x, z) / (2 * mp.pi), lambda x, y, z: 1 - mp.atan2(mp.sqrt(x * x + z * z), y) / mp.pi),
}


def points(rng):
    for _ in range(30):
        yield tuple(rng.uniform(-1, 1) for _ in range(3))
    for side in (-1, 1):
        # Both sides of the seam, and near the axis but farther than where the gradient has its bound.
        yield side * 1e-3, 0.4, 0.8
        yield side * 1e-5, -0.4, 0.5
        yield side * 1e-4, 1.0, 1e-4
        yield 1e-5, side * 1.0, side * 1e-5
    yield 30.0, 40.0, -50.0


def turned(function, point):
    """Gradient in a frame turned by half a turn where the arctangent jumps."""
    x, y, z = (mp.mpf(c) for c in point)
    size = min(abs(c) for c in (x, z) if c != 0) / 1000
    return [mp.diff(lambda t: function(*[c + (t if k == axis else 0) for k, c in enumerate((x, y, z))]), 0, h=size * mp.mpf(10) ** -15) for axis in range(3)]


def main():
    rng = random.Random(99)
    lines = []
    for name, functions in MAPPINGS.items():
        for point in points(rng):
            results = [DOUBLE.result(g) if g != 0 else f"{DOUBLE.text(0.0)} +0.000" for f in functions for g in turned(f, point)]
            lines.append(" ".join([name, *[DOUBLE.text(c) for c in point], *results]))
    write("gradients-double.txt", "mapping x y z, then the gradients of u and v: nearest number, exact minus nearest in ulp", lines)


if __name__ == "__main__":
    main()
