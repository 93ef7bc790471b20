#!/usr/bin/env python3
"""Writes sincos_table.h: arguments with the correctly rounded sine and cosine, in bits, for float and double.

Needs mpmath; only to write the table anew: python3 tests/core/numbers/sincos_table.py >tests/core/numbers/sincos_table.h
"""
import random
import struct

import mpmath

mpmath.mp.prec = 400
DOMAIN = 10000

FORMATS = {"float": ("<f", "<I", "UINT32_C(0x{:08x})"), "double": ("<d", "<Q", "UINT64_C(0x{:016x})")}


class Format:
    def __init__(self, name):
        self.real, self.word, self.literal = FORMATS[name]
        self.digits, self.lowest = (24, -149) if name == "float" else (53, -1074)

    def bits(self, x):
        """The bits of the number nearest to x (ties to even), denormals included."""
        x = mpmath.mpf(x)
        if x == 0:
            return 0
        exponent = max(mpmath.frexp(abs(x))[1] - self.digits, self.lowest)
        whole = int(mpmath.nint(mpmath.ldexp(x, -exponent)))
        return struct.unpack(self.word, struct.pack(self.real, float(mpmath.ldexp(whole, exponent))))[0]

    def number(self, bits):
        return struct.unpack(self.real, struct.pack(self.word, bits))[0]

    def neighbours(self, x):
        middle = self.bits(x)
        return [middle - 1, middle, middle + 1]


def arguments(form):
    """Bits of the arguments: all in [0, 1e4]."""
    rng = random.Random(1)
    some = {0, 1, 2, form.bits(mpmath.ldexp(1, -126 if form.digits == 24 else -1022))}
    some.add(max(some) - 1)
    half_pi = mpmath.pi / 2

    for k in [1, 2, 3, 4, 5, 6, 7, 8, 63, 1000, 4095, 6365, 6366]:
        some.update(form.neighbours(k * half_pi))
    for k in [1, 3, 5, 7, 4097, 12731]:
        some.update(form.neighbours(k * half_pi / 2))

    def distance(k):
        return abs(form.number(form.bits(k * half_pi)) - k * half_pi)

    for k in sorted(range(1, 6367), key=distance)[:8]:
        some.add(form.bits(k * half_pi))

    for exponent in range(-30, 14, 4):
        some.add(form.bits(mpmath.ldexp(rng.uniform(1, 2), exponent)))
    some.update(form.bits(rng.uniform(0, DOMAIN)) for _ in range(40))
    some.update(form.bits(rng.uniform(0, 4)) for _ in range(20))
    some.update([form.bits(DOMAIN), form.bits(DOMAIN) - 1])
    return sorted(b for b in some if form.number(b) <= DOMAIN)


def write(name):
    form = Format(name)
    print("static const sincos_row sincos_table[] = {")
    for b in arguments(form):
        x = mpmath.mpf(form.number(b))
        row = [b, form.bits(mpmath.sin(x)), form.bits(mpmath.cos(x))]
        print("    {%s}," % ", ".join(form.literal.format(v) for v in row))
    print("};")


print("/* Written by sincos_table.py: arguments and their correctly rounded sine and cosine, in bits. */")
print("#ifdef ISO_REAL_DOUBLE\n")
write("double")
print("\n#else\n")
write("float")
print("\n#endif")
