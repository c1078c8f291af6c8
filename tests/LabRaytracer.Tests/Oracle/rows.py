"""Exact rows for the tests: numbers as IEEE bit patterns, results as the nearest number and what is left of the exact one, in ulp."""
import struct

import mpmath as mp

mp.mp.dps = 60


class Kind:
    """A floating-point format."""

    def __init__(self, name, digits, smallest, code, bits):
        self.name, self.digits, self.smallest, self.code, self.bits = name, digits, smallest, code, bits

    def round(self, value):
        """The number of this format nearest to a real number, ties to even, as a double."""
        value = mp.mpf(value)
        if value == 0:
            return 0.0
        unit = self.ulp(value)
        return float(mp.nint(value / unit) * unit)

    def ulp(self, value):
        """Distance of neighbouring numbers at a real number."""
        value = abs(mp.mpf(value))
        exponent = self.smallest if value == 0 else max(int(mp.floor(mp.log(value, 2))) + 1 - self.digits, self.smallest)
        if value != 0 and exponent > self.smallest and mp.mpf(2) ** (exponent + self.digits) <= value:
            exponent += 1
        return mp.mpf(2) ** exponent

    def text(self, value):
        """Bit pattern in hexadecimal."""
        return struct.pack(">" + self.code, value).hex()

    def result(self, exact):
        """The nearest number and the rest, in ulp of the exact value."""
        near = self.round(exact)
        return f"{self.text(near)} {float((exact - mp.mpf(near)) / self.ulp(exact)):+.3f}"


DOUBLE = Kind("double", 53, -1074, "d", 16)
FLOAT = Kind("float", 24, -149, "f", 8)


def write(name, about, rows):
    with open(name, "w", encoding="ascii", newline="\n") as file:
        file.write(f"# {about}\n")
        file.writelines(row + "\n" for row in rows)
