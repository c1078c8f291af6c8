#!/usr/bin/env python3
"""Prints the polynomial coefficients of src/LabRaytracer/Numerics/Elementary*.cs.

Minimax by the Remez exchange algorithm in 60-digit arithmetic; the leading coefficient is kept at its Taylor value, so that its
rounding error can be carried separately. Needs mpmath. Run: python3 coefficients.py
"""
import struct

import mpmath as mp

mp.mp.dps = 60


def single(value):
    """The float nearest to a number, as a double (the double rounding on the way is far below the polynomial's error)."""
    return struct.unpack("f", struct.pack("f", float(value)))[0]


def remez(function, start, end, count, fixed):
    """Coefficients c[0..count) of the polynomial of least relative error to function(s) on [start, end], with the first ones given."""
    start = mp.mpf(start)
    size = (mp.mpf(end) - start) / 2
    skip = len(fixed)
    free = count - skip
    points = [start + size * (1 - mp.cos(mp.pi * (i + mp.mpf(1) / 2) / (free + 1))) for i in range(free + 1)]
    for _ in range(20):
        matrix = mp.matrix(free + 1, free + 1)
        right = mp.matrix(free + 1, 1)
        for i, s in enumerate(points):
            value = function(s)
            for k in range(free):
                matrix[i, k] = s ** (k + skip) / value
            matrix[i, free] = (-1) ** i
            right[i] = 1 - sum(c * s ** k for k, c in enumerate(fixed)) / value
        solution = mp.lu_solve(matrix, right)
        found = list(fixed) + [solution[k] for k in range(free)]
        samples = [start + size * (1 - mp.cos(mp.pi * mp.mpf(i) / (60 * (free + 2)))) for i in range(60 * (free + 2) + 1)]
        errors = [(s, mp.polyval(found[::-1], s) / function(s) - 1) for s in samples]
        extrema = []
        for s, error in errors:
            if extrema and (extrema[-1][1] > 0) == (error > 0):
                if abs(error) > abs(extrema[-1][1]):
                    extrema[-1] = (s, error)
            else:
                extrema.append((s, error))
        while len(extrema) > free + 1:
            extrema.pop(0 if abs(extrema[0][1]) < abs(extrema[-1][1]) else -1)
        worst = max(abs(error) for _, error in errors)
        if len(extrema) < free + 1 or worst / abs(solution[free]) - 1 < mp.mpf("1e-4"):
            break
        points = [s for s, _ in extrema]
    return found, worst


def show(name, function, start, end, count, fixed, kind):
    found, worst = remez(function, start, end, count, fixed)
    rounded = [single(c) if kind == "float" else float(c) for c in found]
    print(f"{name}, {kind}, {count} coefficients, relative error {mp.nstr(worst, 3)}")
    for k, c in enumerate(rounded):
        print(f"  {k}: {c!r}")
    for k in range(len(fixed)):
        rest = found[k] - mp.mpf(rounded[k])
        print(f"  rest of {k}: {(single(rest) if kind == 'float' else float(rest))!r}")


def series(function, first):
    return lambda s: first if s == 0 else function(mp.sqrt(s))


def main():
    tau = 2 * mp.pi
    atan = series(lambda r: mp.atan(r) / (tau * r), 1 / tau)
    end = mp.tan(mp.pi / 8) ** 2 * mp.mpf("1.0001")
    show("atan(sqrt s) / (2 pi sqrt s)", atan, 0, end, 6, [1 / tau], "float")
    show("atan(sqrt s) / (2 pi sqrt s)", atan, 0, end, 12, [1 / tau], "double")

    sine = series(lambda r: mp.sin(tau * r) / r, tau)
    cosine = series(lambda r: (mp.cos(tau * r) - 1) / (r * r), -tau ** 2 / 2)
    eighth = mp.mpf(1) / 64 * mp.mpf("1.0001")
    show("sin(2 pi sqrt s) / sqrt s", sine, 0, eighth, 4, [tau], "float")
    show("sin(2 pi sqrt s) / sqrt s", sine, 0, eighth, 7, [tau], "double")
    show("(cos(2 pi sqrt s) - 1) / s", cosine, 0, eighth, 4, [-tau ** 2 / 2], "float")
    show("(cos(2 pi sqrt s) - 1) / s", cosine, 0, eighth, 7, [-tau ** 2 / 2], "double")

    ln2 = mp.log(2)
    log2 = series(lambda r: 2 * mp.atanh(r) / (r * ln2), 2 / ln2)
    end = ((mp.sqrt(2) - 1) / (mp.sqrt(2) + 1)) ** 2 * mp.mpf("1.0001")
    show("2 atanh(sqrt s) / (ln 2 sqrt s)", log2, 0, end, 5, [2 / ln2], "float")
    show("2 atanh(sqrt s) / (ln 2 sqrt s)", log2, 0, end, 10, [2 / ln2], "double")

    half = mp.mpf("0.50005")
    exp2 = lambda r: ln2 ** 2 / 2 if abs(r) < mp.mpf("1e-25") else ((mp.mpf(2) ** r - 1) / r - ln2) / r
    show("((2^r - 1) / r - ln 2) / r", exp2, -half, half, 5, [], "float")
    show("((2^r - 1) / r - ln 2) / r", exp2, -half, half, 11, [], "double")


if __name__ == "__main__":
    main()
