"""Constants below the least normal float, 1.2e-38, that follow from numbers that a float holds: random products, quotients and sums against
fractions."""
import random
from fractions import Fraction

import pytest
from harness.plants import replaced

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


def scene_of(seed):
    draw = random.Random(seed)
    cases = [(draw.choice(sorted(VALUES)), number(draw, -34, -8), number(draw, -30, -8)) for _ in range(FORMULAS)]
    lines = ['effect tiny {', '    signal s'] + [f'    output f{i} = {formula.format(a=a, b=b)}' for i, (formula, a, b) in enumerate(cases)]
    lines += ['}', 'step 1 ms', 'body b { mass 1 kg }', 'joint j prismatic { parent ground; child b; axis z }',
              f'input v = 1 + {number(draw, 2, 30)} * time / (1 s)', 'effect e tiny { s v }', 'output s = v']
    return '\n'.join(lines + [f'output f{i} = e.f{i}' for i in range(FORMULAS)]) + '\n', cases


def off(plant, seed, change=None):
    """The formulas that are rounded otherwise in rows 0 to 10."""
    scene, cases = scene_of(seed)
    found = set()
    for s, *shown in plant(scene, real='float', change=change).follow(10).rows['y'].tolist():
        for case, got in zip(cases, shown, strict=True):
            formula, a, b = case
            exact = VALUES[formula](Fraction(a), Fraction(b), Fraction(s))
            if abs(Fraction(got) - exact) > Fraction(201, 100) * UNIT * abs(exact) + FLOOR:
                found.add(case)
    return found


@pytest.mark.seeds(3)
def test_formulas_with_tiny_constants_are_rounded_as_others_are(plant, seed):
    assert off(plant, seed) == set()


def test_a_scale_that_is_left_out_is_found(plant):
    assert off(plant, 3, lambda text: replaced(r' \* R\(1\.1754944e-38\)', '', text))


@pytest.mark.parametrize('formula', ['s / (1e-20 * 1e-20)', '1e-20 * 1e-20 + 1e-35 * s'])
def test_a_tiny_divisor_and_a_sum_that_is_as_small_are_refused(isoc, formula):
    """A divisor has no scale, and such a sum has fewer digits."""
    scene = replaced('^    output f0 = .*', f'    output f0 = {formula}', scene_of(3)[0])
    made = isoc(replaced('^input v = .*', 'input v = 1e-9 * (1 + time / (1 s))', scene))
    assert made.refused and 'the equations contain' in made.errors
