#!/usr/bin/env python3
"""Writes functions-double.txt and functions-float.txt: elementary functions at points of a fixed seed. Needs mpmath."""
import random

import mpmath as mp

from rows import DOUBLE, FLOAT, write


def rows(rng, kind):
    def row(name, arguments, exact):
        arguments = [kind.round(a) for a in arguments]
        value = exact(*[mp.mpf(a) for a in arguments])
        if value == 0 or kind.ulp(value) > mp.mpf(2) ** (-kind.smallest):
            return None
        return " ".join([name] + [kind.text(a) for a in arguments + [0.0] * (2 - len(arguments))] + [kind.result(value)])

    sine = lambda t: mp.sinpi(2 * t)
    cosine = lambda t: mp.cospi(2 * t)
    for _ in range(200):
        t = rng.choice((rng.uniform(-1, 1), rng.uniform(-0.125, 0.125), rng.uniform(-1000, 1000), 10 ** rng.uniform(-30, 0)))
        yield row("sin", [t], sine)
        yield row("cos", [t], cosine)
    if kind is DOUBLE:
        for _ in range(150):
            d = rng.choice((rng.uniform(-90, 90), rng.uniform(-720, 720), float(rng.randrange(-360, 361)), rng.uniform(-1e6, 1e6)))
            yield row("sindeg", [d], lambda a: sine(a / 360))
            yield row("cosdeg", [d], lambda a: cosine(a / 360))
            yield row("tandeg", [d], lambda a: mp.mpf(0) if cosine(a / 360) == 0 else sine(a / 360) / cosine(a / 360))
    limit = 1020 if kind is DOUBLE else 125
    for _ in range(200):
        yield row("exp2", [rng.choice((rng.uniform(-1, 1), rng.uniform(-limit, limit), rng.uniform(-limit - 20, -limit)))], lambda a: mp.mpf(2) ** a)
        x = rng.choice((rng.uniform(0.5, 2), 1 + rng.uniform(-1, 1) * 10 ** rng.uniform(-7, -1), 2 ** rng.uniform(-limit - 20, limit)))
        yield row("log2", [x], lambda a: mp.log(a, 2))
    size = 300 if kind is DOUBLE else 37
    for _ in range(110):
        yield row("hypot", [10 ** rng.uniform(-size, size)] * 2 if rng.random() < 0.2 else [rng.uniform(-1, 1), rng.uniform(-1, 1)], mp.hypot)
    for _ in range(400):
        x = rng.choice((rng.uniform(0, 1), 1 - 10 ** rng.uniform(-7, -1), 10 ** rng.uniform(-6, 0)))
        x = kind.round(x)
        most = (limit - 1) / max(1e-9, -float(mp.log(x, 2)))
        y = min(1e5, rng.choice((rng.uniform(0, 4), float(rng.randrange(1, 300)), 10 ** rng.uniform(-3, 5), most * rng.uniform(0.5, 1))))
        if y <= most:
            yield row("pow", [x, y], lambda a, b: a ** b)


def main():
    for kind in (DOUBLE, FLOAT):
        rng = random.Random(1729)
        lines = [line for line in rows(rng, kind) if line]
        write(f"functions-{kind.name}.txt", "function, two arguments, then the result: nearest number, exact minus nearest in ulp", lines)


if __name__ == "__main__":
    main()
