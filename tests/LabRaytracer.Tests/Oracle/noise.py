#!/usr/bin/env python3
"""Writes patterns.txt: lattice noises, their sums and cell distances at points of a fixed seed, by exact arithmetic. Needs mpmath.

The definitions are those of the documentation, written again: hash of cells, improved Perlin gradients, Catmull-Rom cubics, feature points of cells.
"""
import itertools
import random
import sys
from fractions import Fraction
from math import floor

import mpmath as mp

M = 0xFFFFFFFF


def mix(h):
    h = ((h ^ (h >> 16)) * 0x7FEB352D) & M
    h = ((h ^ (h >> 15)) * 0x846CA68B) & M
    return h ^ (h >> 16)


def key(seed, layer):
    return mix((mix(seed & M) + layer * 0x9E3779B1) & M)


def bits(cell, k):
    x, y, z = (c % 2**24 for c in cell)
    column = mix((x * 0x9E3779B1 + k) & M)
    return mix(column ^ ((y * 0x85EBCA77 + z * 0xC2B2AE3D) & M))


# Improved Perlin: u is x or y, v is y, x or z, with two signs.
def slope(h, d):
    h >>= 28
    x, y, z = d
    u = x if h < 8 else y
    v = y if h < 4 else (x if h in (12, 14) else z)
    return (u if h % 2 == 0 else -u) + (v if h & 2 == 0 else -v)


def fade(t):
    return t ** 3 * (6 * t ** 2 - 15 * t + 10)


def corners(p):
    base = [floor(c) for c in p]
    inside = [c - b for c, b in zip(p, base)]
    return base, inside


def gradient(p, k):
    base, f = corners(p)
    total = 0
    for step in itertools.product((0, 1), repeat=3):
        weight = 1
        for s, t in zip(step, f):
            weight *= fade(t) if s else 1 - fade(t)
        total += weight * slope(bits([b + s for b, s in zip(base, step)], k), [t - s for t, s in zip(f, step)])
    return total


def number(cell, k):
    return Fraction(bits(cell, k) >> 8, 2 ** 23) - 1


def linear(p, k):
    base, f = corners(p)
    total = 0
    for step in itertools.product((0, 1), repeat=3):
        weight = 1
        for s, t in zip(step, f):
            weight *= t if s else 1 - t
        total += weight * number([b + s for b, s in zip(base, step)], k)
    return total


def catmull_rom(t, step):
    # The cubic kernel with a = -1/2 at the distance |t - step|.
    x = abs(t - step)
    if x < 1:
        return Fraction(3, 2) * x ** 3 - Fraction(5, 2) * x ** 2 + 1
    return -Fraction(1, 2) * x ** 3 + Fraction(5, 2) * x ** 2 - 4 * x + 2


def cubic(p, k):
    base, f = corners(p)
    total = 0
    for step in itertools.product((-1, 0, 1, 2), repeat=3):
        weight = 1
        for s, t in zip(step, f):
            weight *= catmull_rom(t, s)
        total += weight * number([b + s for b, s in zip(base, step)], k)
    return max(-1, min(1, total))


# Simplex: cells of the lattice squeezed along the diagonal, the four corners of the tetrahedron that the order of the fractions names.
def simplex(p, k):
    skew = sum(p) / 3
    base, f = corners([c + skew for c in p])
    order = sorted(range(3), key=lambda axis: -f[axis])
    total, step = 0, [0, 0, 0]
    for i in range(4):
        corner = [b + s for b, s in zip(base, step)]
        unskew = Fraction(sum(corner), 6)
        d = [a - (c - unskew) for a, c in zip(p, corner)]
        weight = max(0, Fraction(1, 2) - sum(c * c for c in d))
        total += weight ** 4 * slope(bits(corner, k), d)
        if i < 3:
            step[order[i]] += 1
    return Fraction(7688, 100) * total


def octaves(kind, p, seed, count, lacunarity, gain, absolute):
    total = weights = 0
    for i in range(count):
        n = kind([c * lacunarity ** i for c in p], key(seed, i))
        total += gain ** i * (abs(n) if absolute else n)
        weights += gain ** i
    return total / weights


METRICS = {
    "euclidean": lambda d: mp.sqrt(mp.mpf(sum(c * c for c in d).numerator) / sum(c * c for c in d).denominator),
    "manhattan": lambda d: sum(abs(c) for c in d),
    "chebyshev": lambda d: max(abs(c) for c in d),
}


def feature(cell, k):
    h = bits(cell, k)
    return [c + Fraction((h >> s) & 1023, 1024) for c, s in zip(cell, (22, 12, 2))]


# Four cells on every side: more than any of the three distances can reach.
def worley(p, k, metric, flat):
    base = [floor(c) for c in p]
    reach = range(-4, 5)
    found = []
    for step in itertools.product(reach, reach, (0,) if flat else reach):
        point = feature([b + s for b, s in zip(base, step)], k)
        d = [a - b for a, b in zip(point, p)]
        found.append(METRICS[metric](d[:2] if flat else d))
    found.sort()
    return found[0], found[1]


def text(value):
    if isinstance(value, Fraction):
        value = mp.mpf(value.numerator) / value.denominator
    return mp.nstr(mp.mpf(value), 17)


def points(rng, flat, count):
    for i in range(count):
        reach = (3, 3, 100, 1000000)[i % 4]
        p = [Fraction(rng.uniform(-reach, reach)) for _ in range(3)]
        if flat:
            p[2] = Fraction(0)
        yield p


def rows(rng):
    for name, kind in (("gradient", gradient), ("value", linear), ("cubic", cubic)):
        for i, p in enumerate(points(rng, False, 40)):
            yield [name, 1, "fbm", i] + [repr(float(c)) for c in p] + [text(kind(p, key(i, 0)))]
        for sum_, absolute in (("fbm", False), ("turbulence", True)):
            for i, p in enumerate(points(rng, False, 12)):
                yield [name, 4, sum_, i] + [repr(float(c)) for c in p] + [text(octaves(kind, p, i, 4, 2, Fraction(1, 2), absolute))]
    for metric in METRICS:
        for flat in (False, True):
            for i, p in enumerate(points(rng, flat, 24)):
                first, second = worley(p, key(i, 0), metric, flat)
                yield [metric, int(flat), "worley", i] + [repr(float(c)) for c in p] + [text(first), text(second)]


def simplex_rows(rng):
    for i, p in enumerate(points(rng, False, 40)):
        yield ["simplex", 1, "fbm", i] + [repr(float(c)) for c in p] + [text(simplex(p, key(i, 0)))]
    for sum_, absolute in (("fbm", False), ("turbulence", True)):
        for i, p in enumerate(points(rng, False, 12)):
            yield ["simplex", 4, sum_, i] + [repr(float(c)) for c in p] + [text(octaves(simplex, p, i, 4, 2, Fraction(1, 2), absolute))]


def main():
    mp.mp.prec = 200
    rng = random.Random(20260707)
    with open("patterns.txt", "w") as out:
        out.write("# lattice noise, octaves, sum, seed, x, y, z, value; or metric, flat, worley, seed, x, y, z, F1, F2\n")
        for row in itertools.chain(rows(rng), simplex_rows(rng)):
            out.write(" ".join(str(word) for word in row) + "\n")


if __name__ == "__main__":
    main()
