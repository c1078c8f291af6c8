#!/usr/bin/env python3
"""Writes tests/LabRaytracer.Tests/Geometry/Data/rays.csv: rays against shapes, decided in 60-digit arithmetic.

Every input is a double and taken as exact. Columns: class, shape, gap, t, local x, y, z, ray (6), shape numbers.
gap: how far the decision is from changing, relative to the shape's size (the test may demand the decision only above a bound).
t: exact ray parameter of the first hit with t > 0, or "miss". local: the hit in the shape's unit form.
Needs mpmath. Run: python3 geometry_rays.py
"""
import pathlib
import random

import mpmath as mp

mp.mp.dps = 60
rng = random.Random(20240607)
rows = []


def vec(*values):
    return [mp.mpf(v) for v in values]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def at(o, d, t):
    return [x + t * y for x, y in zip(o, d)]


def unit():
    while True:
        v = [rng.uniform(-1, 1) for _ in range(3)]
        n = sum(x * x for x in v) ** 0.5
        if 0.1 < n < 1:
            return [x / n for x in v]


def perpendicular(v):
    w = unit()
    k = sum(x * y for x, y in zip(v, w))
    p = [y - k * x for x, y in zip(v, w)]
    n = sum(x * x for x in p) ** 0.5
    return [x / n for x in p]


def emit(kind, shape, gap, t, local, o, d, numbers):
    text = [kind, shape, mp.nstr(gap, 5)]
    text += ["miss", "0", "0", "0"] if t is None else [mp.nstr(t, 18)] + [mp.nstr(x, 17) for x in local]
    rows.append(",".join(text + [repr(float(x)) for x in list(o) + list(d) + list(numbers)]))


def sphere(kind, o, d, c, r):
    f, e = sub(vec(*o), vec(*c)), vec(*d)
    a, b = dot(e, e), dot(f, e)
    disc = b * b - a * (dot(f, f) - mp.mpf(r) ** 2)
    gap = abs(disc) / (a * mp.mpf(r) ** 2)
    surface = abs(dot(f, f) / mp.mpf(r) ** 2 - 1)
    if disc < 0:
        return emit(kind, "sphere", gap, None, None, o, d, list(c) + [r])
    root = mp.sqrt(disc)
    hits = [t for t in ((-b - root) / a, (-b + root) / a) if t > 0]
    gap = min(gap, surface)
    if not hits:
        return emit(kind, "sphere", gap, None, None, o, d, list(c) + [r])
    emit(kind, "sphere", gap, hits[0], [x / r for x in at(f, e, hits[0])], o, d, list(c) + [r])


def cylinder(kind, o, d, c, r, height):
    f, e = sub(vec(*o), vec(*c)), vec(*d)
    half = mp.mpf(height) / 2
    a, b = e[0] ** 2 + e[2] ** 2, f[0] * e[0] + f[2] * e[2]
    disc = b * b - a * (f[0] ** 2 + f[2] ** 2 - mp.mpf(r) ** 2)
    numbers = list(c) + [r, height]
    if a == 0 or disc < 0:
        return emit(kind, "cylinder", mp.mpf(1) if a == 0 else -disc / (a * mp.mpf(r) ** 2), None, None, o, d, numbers)
    gap, root = disc / (a * mp.mpf(r) ** 2), mp.sqrt(disc)
    for t in ((-b - root) / a, (-b + root) / a):
        p = at(f, e, t)
        gap = min(gap, abs(abs(p[1]) / half - 1), abs(t) / (abs(t) + mp.mpf(r)))
        if t > 0 and abs(p[1]) <= half:
            return emit(kind, "cylinder", gap, t, [p[0] / r, p[1] / half, p[2] / r], o, d, numbers)
    emit(kind, "cylinder", gap, None, None, o, d, numbers)


def plane(kind, o, d, q, n):
    """The plane is exact: the normal is used as given, and must be a unit vector that the library keeps."""
    m, e = vec(*n), vec(*d)
    approach = dot(m, e)
    t = dot(m, sub(vec(*q), vec(*o))) / approach
    emit(kind, "plane", mp.mpf(1), t if t > 0 else None, sub(at(vec(*o), e, t), vec(*q)), o, d, list(q) + list(n))


def flat(kind, shape, o, d, corner, x, z):
    """A parallelogram (corner, edges) or, for disks, centre and two axes of length r along the coordinate axes."""
    e = vec(*d)
    axis_x, axis_z = vec(*x), vec(*z)
    if shape == "quad":
        axis_x, axis_z = [v / 2 for v in axis_x], [v / 2 for v in axis_z]
        center = [c + a + b for c, a, b in zip(vec(*corner), axis_x, axis_z)]
    else:
        center = vec(*corner)
    n = cross(axis_z, axis_x)
    numbers = list(corner) + list(x) + list(z)
    if dot(n, e) == 0:
        return emit(kind, shape, mp.mpf(1), None, None, o, d, numbers)
    f = sub(vec(*o), center)
    t = -dot(n, f) / dot(n, e)
    p = at(f, e, t)
    u, v = dot(p, cross(n, axis_z)) / dot(axis_x, cross(n, axis_z)), dot(p, cross(axis_x, n)) / dot(axis_z, cross(axis_x, n))
    reach = max(abs(u), abs(v)) if shape == "quad" else mp.sqrt(u * u + v * v)
    gap = abs(reach - 1)
    emit(kind, shape, gap, t if t > 0 and reach <= 1 else None, [u, mp.mpf(0), v], o, d, numbers)


def box(kind, o, d, low, high):
    half = [(mp.mpf(h) - mp.mpf(l)) / 2 for l, h in zip(low, high)]
    center = [(mp.mpf(h) + mp.mpf(l)) / 2 for l, h in zip(low, high)]
    f, e = sub(vec(*o), center), vec(*d)
    near, far = mp.mpf("-inf"), mp.mpf("inf")
    for k in range(3):
        if e[k] == 0:
            if abs(f[k]) > half[k]:
                return emit(kind, "box", abs(abs(f[k]) / half[k] - 1), None, None, o, d, list(low) + list(high))
            continue
        a, b = sorted(((-half[k] - f[k]) / e[k], (half[k] - f[k]) / e[k]))
        near, far = max(near, a), min(far, b)
    size = max(half) / mp.sqrt(dot(e, e))
    gap = min(abs(far - near), abs(near), abs(far)) / size
    t = None if near > far else near if near > 0 else far if far > 0 else None
    local = None if t is None else [x / h for x, h in zip(at(f, e, t), half)]
    emit(kind, "box", gap, t, local, o, d, list(low) + list(high))


def triangle(kind, o, d, a, b, c):
    p, e = vec(*o), vec(*d)
    v0, v1, v2 = sub(vec(*a), p), sub(vec(*b), p), sub(vec(*c), p)
    w = [dot(e, cross(v2, v1)), dot(e, cross(v0, v2)), dot(e, cross(v1, v0))]
    total, numbers = sum(w), list(a) + list(b) + list(c)
    if total == 0:
        return emit(kind, "triangle", mp.mpf(1), None, None, o, d, numbers)
    w = [x / total for x in w]
    n = cross(sub(v1, v0), sub(v2, v0))
    t = dot(n, v0) / dot(n, e)
    gap = min(abs(x) for x in w)
    emit(kind, "triangle", gap, t if t > 0 and min(w) >= 0 else None, [w[1], w[2], mp.mpf(0)], o, d, numbers)


def towards(center, size, distance, offset):
    """A ray from a distance (in sizes) whose line passes the centre at an offset (in sizes)."""
    v = unit()
    p = perpendicular(v)
    o = [c - x * distance * size + y * offset * size for c, x, y in zip(center, v, p)]
    return o, v


def classes():
    """Kind, ray maker's distance and offset, size, reach of the centre, length of the direction."""
    for _ in range(30):
        yield "generic", rng.uniform(1.5, 10), rng.uniform(0, 1.3), 1.0, 3, 1
    for i in range(26):
        yield "grazing", rng.uniform(2, 8), 1 + (-1) ** i * 10.0 ** -rng.uniform(3, 12), 1.0, 0, 1
    for i in range(10):
        for power in (3, 6, 9, 12):
            yield f"far{power}", 10.0 ** power, rng.uniform(0, 0.95), 1.0, 0 if i % 2 else 2, 1
    for _ in range(12):
        yield "tiny", rng.uniform(2, 10), rng.uniform(0, 1.2), 1e-6, 1e-6, 1
        yield "huge", rng.uniform(2, 10), rng.uniform(0, 1.2), 1e6, 1e6, 1
        yield "inside", rng.uniform(0, 0.5), rng.uniform(0, 0.4), 1.0, 2, 1
        yield "behind", -rng.uniform(2, 10), rng.uniform(0, 0.9), 1.0, 2, 1
        yield "nonunit", rng.uniform(2, 10), rng.uniform(0, 1.2), 1.0, 2, 10.0 ** rng.uniform(-3, 3)


def main():
    for kind, distance, offset, size, reach, length in classes():
        c = [rng.uniform(-reach, reach) for _ in range(3)]

        def ray(scale=1.0):
            o, v = towards(c, size, distance, offset * scale)
            return o, [x * length for x in v]

        o, d = ray()
        sphere(kind, o, d, c, size)
        if kind == "grazing":
            v = [rng.uniform(-1, 1), 0.0, rng.uniform(-1, 1)]
            k = (v[0] ** 2 + v[2] ** 2) ** 0.5
            o = [-v[0] / k * distance + v[2] / k * offset, 0.25, -v[2] / k * distance - v[0] / k * offset]
            cylinder(kind, o, [v[0] / k, rng.uniform(-0.05, 0.05), v[2] / k], c, 1.0, 2.0)
            continue
        cylinder(kind, *ray(), c, size, 2 * size * rng.uniform(0.5, 1.5))
        box(kind, *ray(), [x - size * rng.uniform(0.4, 1) for x in c], [x + size * rng.uniform(0.4, 1) for x in c])
        u, w = unit(), unit()
        flat(kind, "quad", *ray(), [x - size * (a + b) for x, a, b in zip(c, u, w)], [2 * size * x for x in u], [2 * size * x for x in w])
        flat(kind, "disk", *ray(), c, [size, 0, 0], [0, 0, size])
        triangle(kind, *ray(0.2), *[[x + size * y for x, y in zip(c, unit())] for _ in range(3)])
        axis = rng.choice([[0.0, 1.0, 0.0], [0.6, 0.8, 0.0], [0.0, -0.8, 0.6]])
        plane(kind, *ray(), c, axis)
    for _ in range(20):
        # Nearly along the axis, along the plane, in the plane's neighbourhood.
        e = 10.0 ** -rng.uniform(2, 10)
        o = [rng.uniform(-0.9, 0.9), rng.uniform(-5, -2), rng.uniform(-0.3, 0.3)]
        cylinder("parallel", o, [(1 - o[0]) / (2 - o[1]) if _ % 2 else e, 1.0, e * rng.uniform(-1, 1)], [0, 0, 0], 1.0, 3.0)
        plane("parallel", [rng.uniform(-5, 5) for _ in range(3)], [0.8, -0.6 + e, rng.uniform(-1, 1)], [rng.uniform(-1, 1) for _ in range(3)], [0.6, 0.8, 0.0])
        q = [rng.uniform(-9, 9) for _ in range(3)]
        h = 10.0 ** -rng.uniform(1, 12)
        plane("near", [q[0] + 0.8 + h, q[1] - 0.6, q[2] + 2], unit(), q, [0.6, 0.8, 0.0])
    path = pathlib.Path(__file__).resolve().parent.parent / "Geometry" / "Data" / "rays.csv"
    path.parent.mkdir(exist_ok=True)
    path.write_text("\n".join(rows) + "\n")
    print(len(rows), "rows,", path.stat().st_size, "bytes")


main()
