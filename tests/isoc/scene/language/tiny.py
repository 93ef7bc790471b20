"""Formulas with factors and terms below the least normal float, against fractions.

usage: tiny.py write SEED FILE     a scene of 60 of them; their operands are in the file FILE.cases
       tiny.py compare FILE ROWS   the outputs in the rows of tests/isoc/effects/laws/rows.c
"""
import random
import sys
from fractions import Fraction

FORMULAS = 60
# Two roundings: of the scaled factor and of the product. Below the least normal float, half a unit for each scale and
# for the factor in a sum.
UNIT = Fraction(1, 2**24)
FLOOR = 3 * Fraction(1, 2**150)

VALUES = {
    '{a} * {b} * s': lambda a, b, s: a * b * s,
    's * ({a} * {b})': lambda a, b, s: a * b * s,
    '({a} * {b}) / s': lambda a, b, s: a * b / s,
    's - {a} * {b}': lambda a, b, s: s - a * b,
    '{a} * {b} + s': lambda a, b, s: s + a * b,
    'max(s, {a} * {b})': lambda a, b, s: max(s, a * b),
    '{a} * {b}': lambda a, b, s: a * b,
}


def number(draw, low, high):
    return '%.6ge%d' % (draw.uniform(1.0, 9.9), draw.randint(low, high))


def write(seed, path):
    draw = random.Random(seed)
    cases = [(draw.choice(sorted(VALUES)), number(draw, -34, -8), number(draw, -30, -8)) for _ in range(FORMULAS)]
    with open(path, 'w', encoding='ascii') as scene, open(path + '.cases', 'w', encoding='ascii') as file:
        scene.write('effect tiny {\n    signal s\n')
        for i, (formula, a, b) in enumerate(cases):
            scene.write('    output f%d = %s\n' % (i, formula.format(a=a, b=b)))
            file.write('%s|%s|%s\n' % (formula, a, b))
        scene.write('}\nstep 1 ms\nbody b { mass 1 kg }\njoint j prismatic { parent ground; child b; axis z }\n')
        scene.write('input v = 1 + %s * time / (1 s)\neffect e tiny { s v }\noutput s = v\n' % number(draw, 2, 30))
        for i in range(FORMULAS):
            scene.write('output f%d = e.f%d\n' % (i, i))


def compare(path, rows):
    with open(path + '.cases', encoding='ascii') as file:
        cases = [line.rstrip('\n').split('|') for line in file]
    wrong = compared = 0
    with open(rows, encoding='ascii') as file:
        for row in file:
            s, *shown = (Fraction(word) for word in row.split())
            for (formula, a, b), got in zip(cases, shown, strict=True):
                exact = VALUES[formula](Fraction(a), Fraction(b), s)
                compared += 1
                if abs(got - exact) > Fraction(201, 100) * UNIT * abs(exact) + FLOOR:
                    wrong += 1
                    print('# %s with %s and %s at %g: %g, not %g' % (formula, a, b, s, got, exact))
    print('# %d compared, %d off' % (compared, wrong))
    return wrong > 0 or compared < 10 * FORMULAS


if sys.argv[1] == 'write':
    write(int(sys.argv[2]), sys.argv[3])
else:
    sys.exit(compare(sys.argv[2], sys.argv[3]))
