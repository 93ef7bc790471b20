# The values of a sweep, by tools/sweep/README.md alone: compares them with its table.
#
#     interpret.py SET RUNS SEED TABLE
#
# Of SET it knows numbers, ranges, random values and words, with a unit of the list below behind the last number.
import math
import re
import sys
from decimal import Decimal
from itertools import product

MASK = (1 << 64) - 1
UNITS = {"": 1, "kg": 1, "g": "1e-3", "m": 1, "mm": "1e-3", "s": 1, "ms": "1e-3", "us": "1e-6", "N*s/m": 1}


def numbers(text):
    z = 0xCBF29CE484222325
    for byte in text.encode():
        z = ((z ^ byte) * 0x100000001B3) & MASK
    while True:
        z = (z + 0x9E3779B97F4A7C15) & MASK
        y = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        y = ((y ^ (y >> 27)) * 0x94D049BB133111EB) & MASK
        yield (((y ^ (y >> 31)) >> 12) + 0.5) / 2.0**52


def draw(law, a, b, seed, name, run):
    u = numbers(f"{seed} {name} {run}")
    if law == "uniform":
        return a + (b - a) * next(u)
    while True:
        v, w = 2 * next(u) - 1, 2 * next(u) - 1
        q = v * v + w * w
        if q < 1:
            return a + b * (v * math.sqrt(-2 * math.log(q) / q))


def si(number, unit):
    return float(Decimal(number.strip()) * Decimal(UNITS[unit.strip()]))


def listed(text):
    """The values of a part without random ones: pairs of a value and whether it was computed."""
    pieces = [piece.strip() for piece in text.split(",")]
    unit, found = "", []
    for piece in reversed(pieces):
        shape = re.fullmatch(r"(\S+) *\.\. *(\S+) *(\S*?) *by (\d+)", piece)
        single = re.fullmatch(r"([-+]?[\d.]+(?:e[-+]?\d+)?) *(\S*)", piece)
        if shape:
            unit = shape[3] or unit
            a, b, n = si(shape[1], unit), si(shape[2], unit), int(shape[4])
            found = [((a * (n - 1 - i) + b * i) / (n - 1), True) for i in range(n)] + found
        elif single:
            unit = single[2] or unit
            found = [(si(single[1], unit), False)] + found
        else:
            found = [(piece, False)] + found
    return found


def agree(cell, value, is_random):
    """A number has twelve digits; a logarithm may differ in its last bit, and so the last digit."""
    if isinstance(value[0], str):
        return cell == value[0]
    if not value[1]:
        return float(cell) == value[0]
    expected = Decimal(format(value[0], ".12g"))
    unit = Decimal(0) if not is_random else Decimal((0, (1,), expected.adjusted() - 11))
    return abs(Decimal(cell) - expected) <= unit


def main():
    varied, runs, seed, path = sys.argv[1], int(sys.argv[2]), sys.argv[3], sys.argv[4]
    names, choices = [], []
    for part in varied.split(";"):
        name, text = (side.strip() for side in part.split("=", 1))
        law = re.fullmatch(r"(uniform|normal)\((.*),(.*)\) *(\S*)", text)
        names.append(name)
        choices.append([(law[1], si(law[2], law[4]), si(law[3], law[4]))] if law else listed(text))
    with open(path) as table:
        rows = [line.rstrip("\n").split("\t") for line in table]
    points = list(product(*choices))
    if len(rows) != 1 + len(points) * runs or rows[0][: 1 + len(names)] != ["run"] + names:
        sys.exit("the table has other runs or columns")
    for run, row in enumerate(rows[1:]):
        for name, choice, cell in zip(names, points[run // runs], row[1:]):
            is_random = len(choice) == 3
            value = (draw(*choice, seed, name, run), True) if is_random else choice
            if row[0] != str(run) or not agree(cell, value, is_random):
                sys.exit(f"run {run}: {name} is {cell}, expected {value[0]!r}")


main()
