#!/usr/bin/env python3
"""Writes sphere-double.txt and sphere-float.txt: points and their exact spherical texture coordinates. Needs mpmath."""
import math
import random

import mpmath as mp

from rows import DOUBLE, FLOAT, write


def direction(rng):
    y = rng.uniform(-1, 1)
    phi = rng.uniform(0, 2 * math.pi)
    r = math.sqrt(1 - y * y)
    return r * math.sin(phi), y, r * math.cos(phi)


def points(rng, kind):
    small, large = (-320, 300) if kind is DOUBLE else (-44, 37)
    for _ in range(400):
        yield "sphere", direction(rng)
    for _ in range(120):
        factor = 1 + rng.choice((-1, 1)) * 10 ** rng.uniform(-16 if kind is DOUBLE else -7, -3)
        yield "off", [factor * c for c in direction(rng)]
    for _ in range(150):
        size = 10 ** rng.uniform(small, -1)
        phi = rng.uniform(0, 2 * math.pi)
        yield "pole", (size * math.sin(phi), rng.choice((-1, 1)) * rng.choice((1, 1, 1 + 2 ** -23)), size * math.cos(phi))
    for _ in range(120):
        yield "seam", (rng.choice((-1, 1)) * 10 ** rng.uniform(small, -3), rng.uniform(-1, 1), rng.choice((1, rng.uniform(0, 1))))
    for x in (-1.0, -0.0, 0.0, 1.0):
        for y in (-1.0, -0.0, 0.0, 1.0):
            for z in (-1.0, -0.0, 0.0, 1.0):
                yield "axis", (x, y, z)
    for _ in range(100):
        yield "above", (10 ** rng.uniform(-9, -5) * rng.choice((-1, 1)), 1 + 2 ** -22, 10 ** rng.uniform(-9, -5))
    for _ in range(150):
        size = 10 ** rng.uniform(small, large)
        yield "scale", [size * c for c in direction(rng)]
    for _ in range(150):
        yield "mixed", [rng.choice((-1, 1)) * 10 ** rng.uniform(small, large) for _ in range(3)]
    for _ in range(120):
        phi = 2 * math.pi * rng.randrange(8192) / 8192
        theta = math.pi * rng.randrange(4096) / 4096
        yield "texel", (math.sin(theta) * math.sin(phi), math.cos(theta), math.sin(theta) * math.cos(phi))


def exact(x, y, z):
    x, y, z = mp.mpf(x), mp.mpf(y), mp.mpf(z)
    u = mp.mpf(0) if x == 0 and z == 0 else mp.atan2(x, z) / (2 * mp.pi)
    radius = mp.sqrt(x * x + z * z)
    v = mp.mpf("0.5") if radius == 0 and y == 0 else mp.atan2(radius, -y) / mp.pi
    return u + 1 if u < 0 else u, v


def main():
    for kind in (DOUBLE, FLOAT):
        rng = random.Random(4711)
        lines = []
        for name, point in points(rng, kind):
            p = [math.copysign(kind.round(c), c) for c in point]
            u, v = exact(*p)
            lines.append(" ".join([name] + [kind.text(c) for c in p] + [kind.result(u), kind.result(v)]))
        write(f"sphere-{kind.name}.txt", "set x y z, then u and v: nearest number, exact minus nearest in ulp", lines)


if __name__ == "__main__":
    main()
