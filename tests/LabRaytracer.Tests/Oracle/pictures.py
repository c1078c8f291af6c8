"""Rows of AnalyticPictureTests: light of a lit sphere, and where a ray meets the floor below a glass plate. Needs mpmath."""
from mpmath import asin, mp, mpf, nstr, radians, sin, sqrt, tan

mp.dps = 40


def code(light):
    """8-bit sRGB code: IEC 61966-2-1."""
    encoded = light * mpf('12.92') if light <= mpf('0.0031308') else mpf('1.055') * light ** (mpf(5) / 12) - mpf('0.055')
    exact = 255 * encoded
    assert abs(exact - int(exact) - mpf('0.5')) > mpf('0.001')
    return int(exact + mpf('0.5'))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def sphere(column, row, diffuse, specular, shininess):
    """Unit sphere, orthographic view along -z, 25 x 25 pixels of 0.1; lamp of intensity 1 at (2, 3, 4): Phong's model."""
    x, y = (mpf(column) - 12) / 10, (12 - mpf(row)) / 10
    n = [x, y, sqrt(1 - x * x - y * y)]
    to_light = [a - b for a, b in zip([2, 3, 4], n)]
    length = sqrt(dot(to_light, to_light))
    light = [a / length for a in to_light]
    cosine = dot(n, light)
    mirrored = 2 * cosine * n[2] - light[2]
    return mpf(0) if cosine <= 0 else diffuse * cosine + (specular * mirrored ** shininess if mirrored > 0 else 0)


for at in [(12, 12), (15, 9), (16, 13), (12, 3), (7, 16), (18, 18), (16, 7), (14, 10), (5, 8)]:
    matte, shiny = sphere(*at, mpf(3) / 4, 0, 1), sphere(*at, mpf(1) / 2, mpf(1) / 4, 20)
    print(f'[InlineData({at[0]}, {at[1]}, {nstr(matte, 17)}, {code(matte)}, {nstr(shiny, 17)}, {code(shiny)})]')

for degrees in [5, 30, 45, 60, 70]:
    for index in [mpf(3) / 2, mpf(5) / 4]:
        # Plate from y = 0 to -1/4, floor at -1/2: x = tan b / 4 + tan a / 4 with sin a = index sin b; v = (x + 1) / 2.
        a = radians(mpf(degrees))
        v = (tan(asin(sin(a) / index)) / 4 + tan(a) / 4 + 1) / 2
        print(f'[InlineData({degrees}, {nstr(index, 3)}, {nstr(v, 17)}, {code(v)})]')
