#!/usr/bin/env python3
"""Prints the rows of Cameras/CameraTests.cs: ray directions in 50-digit arithmetic. Needs mpmath. Run: python3 geometry_cameras.py"""
import mpmath as mp

mp.mp.dps = 50


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    n = mp.sqrt(sum(x * x for x in a))
    return [x / n for x in a]


def text(values):
    return ", ".join(mp.nstr(x, 18) for x in values)


def perspective(x, y, width, height):
    """Eye (1, 2, 3), target (-2, 0.5, -4), 50 degrees, up +Y."""
    f = unit([mp.mpf(-3), mp.mpf("-1.5"), mp.mpf(-7)])
    r = unit(cross(f, [0, 1, 0]))
    u = cross(r, f)
    half = mp.tan(mp.radians(25))
    aside, above = (2 * mp.mpf(x) / width - 1) * half * width / height, (1 - 2 * mp.mpf(y) / height) * half
    print(f"[InlineData({x}, {y}, {text(unit([p + q * aside + s * above for p, q, s in zip(f, r, u)]))})]")


def spherical(x, y, width, height):
    phi, theta = 2 * mp.pi * mp.mpf(x) / width, mp.pi * mp.mpf(y) / height
    print(f"[InlineData({x}, {y}, {text([mp.sin(theta) * mp.sin(phi), mp.cos(theta), mp.sin(theta) * mp.cos(phi)])})]")


for at in ((0.5, 0.5), (319.5, 239.5), (320, 240), (639.5, 100.5), (17.25, 479.75)):
    perspective(*at, 640, 480)
for at in ((0.5, 0.5), (511.5, 255.5), (768, 256), (1023.5, 511.5), (100.5, 300.5)):
    spherical(*at, 1024, 512)
