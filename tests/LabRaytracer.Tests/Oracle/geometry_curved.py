#!/usr/bin/env python3
"""Writes ../Geometry/Data/curved.csv: rays against tori and cones, by the roots of their polynomials to 60 digits. Needs mpmath.

kind, shape, gap (how near hit or miss is to being decided the other way, relative to the shape), t or miss, local point, origin, direction, centre, two radii or radius and height, caps
"""
import random

import mpmath as mp

mp.mp.dps = 60


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def torus_roots(o, d, ring, tube):
    # (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2)
    dd, od, oo = dot(d, d), dot(o, d), dot(o, o)
    k = oo + ring ** 2 - tube ** 2
    a, b, c = d[0] ** 2 + d[2] ** 2, o[0] * d[0] + o[2] * d[2], o[0] ** 2 + o[2] ** 2
    coefficients = [dd ** 2, 4 * dd * od, 2 * dd * k + 4 * od ** 2 - 4 * ring ** 2 * a, 4 * od * k - 8 * ring ** 2 * b, k ** 2 - 4 * ring ** 2 * c]
    return mp.polyroots(coefficients, maxsteps=400, extraprec=400)


def torus(o, d, ring, tube):
    # Seen from the nearest point, so that the roots are of the size of the torus.
    shift = -dot(o, d) / dot(d, d)
    near = [x + shift * y for x, y in zip(o, d)]
    roots = torus_roots(near, d, ring, tube)
    size = ring / mp.sqrt(dot(d, d))
    real = sorted(shift + mp.re(z) for z in roots if abs(mp.im(z)) <= mp.mpf(10) ** -25 * size)
    hits = [t for t in real if t > 0]
    # A pair of complex roots is as far from touching as their imaginary part squared; two real ones as the square of half their distance.
    gap = min([mp.im(z) ** 2 / size ** 2 for z in roots if mp.im(z) != 0 and shift + mp.re(z) > -size] + [((b - a) / size / 2) ** 2 for a, b in zip(real, real[1:])] + [abs(t) / size for t in real] + [mp.mpf(1)])
    return (hits[0] if hits else None), gap


def cone(o, d, radius, height, closed):
    # Seen from the apex, whose place is centre + height / 2 rounded to double.
    y = o[1]
    k = (radius / height) ** 2
    a = d[0] ** 2 + d[2] ** 2 - k * d[1] ** 2
    b = o[0] * d[0] + o[2] * d[2] - k * y * d[1]
    c = o[0] ** 2 + o[2] ** 2 - k * y ** 2
    discriminant = b * b - a * c
    size = (radius + height) / mp.sqrt(dot(d, d))
    gaps = [mp.mpf(1)]
    hits = []
    scale = k * ((o[0] * d[1] - y * d[0]) ** 2 + (o[2] * d[1] - y * d[2]) ** 2) + (o[0] * d[2] - o[2] * d[0]) ** 2
    gaps.append(abs(discriminant) / (scale if scale else 1))
    if discriminant >= 0 and a != 0:
        for sign in (-1, 1):
            t = (-b + sign * mp.sqrt(discriminant)) / a
            at = y + t * d[1]
            gaps += [abs(at) / height, abs(at + height) / height, abs(t) / size]
            if -height <= at <= 0 and t > 0:
                hits.append(t)
    if closed and d[1] != 0:
        t = (-height - y) / d[1]
        distance = mp.sqrt((o[0] + t * d[0]) ** 2 + (o[2] + t * d[2]) ** 2)
        gaps += [abs(distance - radius) / radius, abs(t) / size]
        if distance <= radius and t > 0:
            hits.append(t)
    return (min(hits) if hits else None), min(gaps)


def unit(rng):
    while True:
        v = [rng.uniform(-1, 1) for _ in range(3)]
        n = sum(c * c for c in v) ** 0.5
        if 0.01 < n < 1:
            return [c / n for c in v]


def surface(rng, shape, a, b):
    """A point of the surface and its normal, around the centre."""
    phi = rng.uniform(0, 2 * mp.pi)
    s, c = float(mp.sin(phi)), float(mp.cos(phi))
    if shape == "torus":
        psi = rng.uniform(0, 2 * mp.pi)
        n = [float(mp.cos(psi)) * s, float(mp.sin(psi)), float(mp.cos(psi)) * c]
        return [a * s + b * n[0], b * n[1], a * c + b * n[2]], n
    below = rng.uniform(0.05, 1)
    length = (a * a + b * b) ** 0.5
    return [a * below * s, b / 2 - b * below, a * below * c], [b * s / length, a / length, b * c / length]


def rows(rng):
    for i in range(420):
        shape = ("torus", "cone")[i % 2]
        size = 10.0 ** rng.uniform(-3, 3) if i % 3 == 0 else 1.0
        if shape == "torus":
            a, b = size, size * rng.choice((0.25, 0.9, 0.5, 0.01, rng.uniform(0.05, 0.95)))
        else:
            a, b = size * rng.uniform(0.2, 2), size * rng.uniform(0.2, 3)
        closed = rng.random() < 0.5
        center = [0.0] * 3 if i % 4 < 2 else [rng.uniform(-10, 10) * size for _ in range(3)]
        kind = rng.choice(("generic", "generic", "far", "grazing", "inside", "surface", "axis"))
        p, n = surface(rng, shape, a, b)
        d = unit(rng)
        if kind == "grazing":
            up = sum(x * y for x, y in zip(d, n))
            d = [x - up * y for x, y in zip(d, n)]
            lift = b * 10.0 ** rng.uniform(-13, -3) * rng.choice((-1, 1))
            p = [x + lift * y for x, y in zip(p, n)]
        if kind == "axis":
            d = [0.0, -1.0, 0.0] if rng.random() < 0.5 else [d[0], 1e-9, d[2]]
        away = size * {"far": 10.0 ** rng.uniform(3, 9), "surface": 0.0, "inside": 0.0}.get(kind, rng.uniform(1, 20))
        if kind == "inside":
            p = [x - 0.3 * min(a, b) * y for x, y in zip(p, n)]
        if kind == "generic":
            p = [x + rng.uniform(-0.5, 0.5) * size for x in p]
        o = [c + x - away * y for c, x, y in zip(center, p, d)]
        if i % 5 == 0:
            d = [x * 3.7 for x in d]
        yield kind, shape, center, a, b, closed, o, d


def text(x):
    return mp.nstr(x, 20)


def main():
    rng = random.Random(31415)
    out = []
    for kind, shape, center, a, b, closed, o, d in rows(rng):
        origin = [center[0], center[1] + b / 2, center[2]] if shape == "cone" else center
        oo, dd = [mp.mpf(x) - mp.mpf(c) for x, c in zip(o, origin)], [mp.mpf(x) for x in d]
        A, B = mp.mpf(a), mp.mpf(b)
        t, gap = torus(oo, dd, A, B) if shape == "torus" else cone(oo, dd, A, B, closed)
        if t is None:
            local = [mp.mpf(0)] * 3
        else:
            p = [x + t * y for x, y in zip(oo, dd)]
            local = [x / A for x in p] if shape == "torus" else [p[0] / A, 1 + p[1] / (B / 2), p[2] / A]
        out.append(",".join([kind, shape, mp.nstr(gap, 3), "miss" if t is None else text(t)] + [text(x) for x in local] + [repr(x) for x in o + d + center + [a, b]] + [str(int(closed))]))
    with open("../Geometry/Data/curved.csv", "w") as file:
        file.write("\n".join(out) + "\n")


if __name__ == "__main__":
    main()
