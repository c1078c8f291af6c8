"""Literals of ColorEncodingTests: the sRGB curve of IEC 61966-2-1 with 60 digits. Run: python3 srgb.py"""
import struct
from mpmath import mp, mpf
from mpmath.libmp import mpf_pos, to_float

mp.dps = 60


def decode(encoded):
    if encoded <= mpf("0.04045"):
        return encoded / mpf("12.92")
    return ((encoded + mpf("0.055")) / mpf("1.055")) ** mpf("2.4")


def float_bits(value, rounding):
    """Bits of the float32 next to a value: 'n' nearest, 'c' not below."""
    rounded = to_float(mpf_pos(value._mpf_, 24, rounding))
    return struct.unpack("<I", struct.pack("<f", rounded))[0]


def fnv(words):
    """FNV-1a, 64 bits, over 32-bit words."""
    value = 0xCBF29CE484222325
    for word in words:
        value = ((value ^ word) * 0x100000001B3) & (2**64 - 1)
    return value


for top in (255, 65535):
    table = [float_bits(decode(mpf(k) / top), "n") if k else 0 for k in range(top + 1)]
    thresholds = [float_bits(decode((mpf(k) - mpf("0.5")) / top), "c") for k in range(1, top + 1)]
    print(f"max {top}: decode table 0x{fnv(table):016X}, thresholds 0x{fnv(thresholds):016X}")
    for k in (1, 10, 11, 128, 188, 254, 255):
        code = k * (top // 255)
        print(f"  code {code}: decode 0x{table[code]:08X}, threshold 0x{thresholds[code - 1]:08X}")
x = mpf(0.3)  # the double nearest to 0.3
for power in (0.2, 2.2, 5.0, 1 / 2.4):
    print(f"double 0.3 ** double {power!r} = {mp.nstr(x ** mpf(power), 20)}")
