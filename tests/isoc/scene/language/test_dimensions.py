"""The rule about angles in formulas: a radian is the number one, whatever the operator, the function and the order. Random formulas with
dimensions against a checker that shares no code with isoc: what is refused, and the unit of the others."""
import random
import re
from fractions import Fraction

BASES = ('kg', 'm', 's', 'rad', 'A', 'K')
RAD = 3
HALF = Fraction(1, 2)
MOST = 60
PLAIN = (0,) * 6
UNITS = {'N': (1, 1, -2, 0, 0, 0), 'V': (1, 2, -3, 0, -1, 0), 'W': (1, 2, -3, 0, 0, 0), 'Pa': (1, -1, -2, 0, 0, 0),
         'T': (1, 0, -2, 0, -1, 0), 'Ohm': (1, 2, -3, 0, -2, 0), 'H': (1, 2, -2, 0, -2, 0), 'F': (-1, -2, 4, 0, 2, 0),
         'J': (1, 2, -2, 0, 0, 0), 'Hz': (0, 0, -1, 0, 0, 0)}
UNITS.update({b: tuple(int(b == c) for c in BASES) for b in BASES})
NUMBERS = {'position of j': UNITS['rad'], 'speed of j': (0, 0, -1, 1, 0, 0), 'position of k': UNITS['m'],
           'speed of k': (0, 1, -1, 0, 0, 0), 'volts': UNITS['V'], 'c': UNITS['kg']}
VECTORS = {'velocity of b': (0, 1, -1, 0, 0, 0), 'position of b': UNITS['m'], 'x_axis of b': PLAIN,
           'spin of b': (0, 0, -1, 1, 0, 0)}
ANGLES = ('sin', 'cos', 'tan')
PLAINS = ('asin', 'acos', 'exp', 'log', 'tanh', 'floor', 'round')
pick = random.Random()
RULE = {'an angle counts': False}  # True: the control, a checker that takes the angle for a dimension


class Refused(Exception):
    pass


# --- formulas: tuples of a word and parts ---


def plus(a, b, n=1):
    return tuple(x + n * y for x, y in zip(a, b))


def small():
    """Half powers too, but not of the angle."""
    return tuple(pick.choice((0, 0, 0, 1, -1)) + (pick.choice((-HALF, HALF)) if i != RAD and pick.random() < 0.06 else 0)
                 for i, _ in enumerate(BASES))


def turned(d):
    """The same but for radians, which a formula may have anywhere."""
    return d[:RAD] + (pick.choice((d[RAD], d[RAD], 0, 1, -1, 2)),) + d[RAD + 1:]


def wrong(d):
    """Mostly what it should be."""
    return turned(plus(d, small()) if pick.random() < 0.02 else d)


def atom(d, is_vector):
    name, of = pick.choice(list((VECTORS if is_vector else NUMBERS).items()))
    return ('atom', name, round(pick.uniform(0.1, 3), 6), plus(d, of, -1))


def number(d, depth):
    """A formula that ought to be a number of this dimension."""
    if depth == 0:
        return atom(d, False)
    sub = lambda of: number(wrong(of), depth - 1)
    kinds = ['sum', 'sum', 'product', 'ratio', 'power', 'minus', 'sqrt', 'extreme', 'abs', 'clamp', 'if', 'norm', 'dot', 'table',
             'grid', 'zero']
    if d[:RAD] + d[RAD + 1:] == PLAIN[1:]:
        kinds += ['angle', 'plain', 'sign', 'atan2', 'order'] * 2
    kind = pick.choice(kinds)
    other = small()
    if kind == 'sum':
        return ('sum', pick.choice('+-'), sub(d), sub(d))
    if kind == 'zero':
        return ('sum', '+', ('zero',), sub(d)) if pick.random() < 0.5 else ('call', 'max', sub(d), ('zero',))
    if kind == 'product':
        return ('product', '*', sub(other), sub(plus(d, other, -1)))
    if kind == 'ratio':
        return ('product', '/', sub(plus(d, other)), sub(other))
    if kind == 'power':
        n = pick.choice((2, 3))
        return ('power', n, sub(tuple(x // n for x in d)))
    if kind == 'minus':
        return ('minus', sub(d))
    if kind == 'sqrt':
        return ('call', 'sqrt', sub(plus(d, d)))
    if kind == 'extreme':
        return ('call', pick.choice(('min', 'max')), *[sub(d) for _ in range(pick.choice((2, 3)))])
    if kind == 'abs':
        return ('call', 'abs', sub(d))
    if kind == 'clamp':
        return ('call', 'clamp', sub(d), sub(d), sub(d))
    if kind == 'if':
        return ('call', 'if', sub(PLAIN), sub(d), sub(d))
    if kind == 'norm':
        return ('call', 'norm', vector(wrong(d), depth - 1))
    if kind == 'dot':
        return ('call', 'dot', vector(wrong(other), depth - 1), vector(wrong(plus(d, other, -1)), depth - 1))
    if kind == 'table':
        return ('table', sub(other), turned(other), *[sub(d) for _ in range(3)])
    if kind == 'grid':
        return ('grid', sub(other), sub(PLAIN), turned(other), turned(PLAIN), *[sub(d) for _ in range(4)])
    if kind == 'angle':
        return ('call', pick.choice(ANGLES), sub(UNITS['rad']))
    if kind == 'plain':
        return ('call', pick.choice(PLAINS), sub(PLAIN))
    if kind == 'sign':
        return ('call', 'sign', sub(other))
    if kind == 'order':
        return ('order', pick.choice(('<', '<=', '>', '>=')), sub(other), sub(other))
    return ('call', 'atan2', sub(other), sub(other))


def vector(d, depth):
    sub = lambda of: vector(wrong(of), depth - 1)
    kind = pick.choice(['atom', 'parts', 'parts', 'sum', 'times', 'cross'] if depth > 0 else ['atom'])
    other = small()
    if kind == 'atom':
        return atom(d, True)
    if kind == 'parts':
        return ('vector', *[('zero',) if pick.random() < 0.2 else number(wrong(d), depth - 1) for _ in range(2)],
                number(wrong(d), depth - 1))
    if kind == 'sum':
        return ('sum', pick.choice('+-'), sub(d), sub(d))
    if kind == 'times':
        return ('product', '*', number(wrong(other), depth - 1), sub(plus(d, other, -1)))
    return ('call', 'cross', sub(other), sub(plus(d, other, -1)))


def unit_text(d):
    """With a root for each half power."""
    whole = [(b, n - (n % 1 if n > 0 else -(-n % 1))) for b, n in zip(BASES, d)]
    text = '*'.join(f'{b}^{n}' for b, n in whole if n)
    for b, n in zip(BASES, d):
        if n % 1:
            text += f'{"*" if text else ""}sqrt({b})' if n > 0 else f'{"" if text else "1"}/sqrt({b})'
    return f' {text}' if text else ''


def text_of(f):
    kind, parts = f[0], f[1:]
    if kind == 'zero':
        return '0'
    if kind == 'atom':
        return f'({parts[0]} * ({parts[1]}{unit_text(parts[2])}))'
    if kind in ('sum', 'product', 'order'):
        return f'({text_of(parts[1])} {parts[0]} {text_of(parts[2])})'
    if kind == 'power':
        return f'({text_of(parts[1])}^{parts[0]})'
    if kind == 'minus':
        return f'(-{text_of(parts[0])})'
    if kind == 'vector':
        return f'({", ".join(map(text_of, parts))})'
    if kind == 'call':
        return f'{parts[0]}({", ".join(map(text_of, parts[1:]))})'
    if kind == 'table':
        points = [f'{i - 1}{unit_text(parts[1])}: {text_of(p)}' for i, p in enumerate(parts[2:])]
        return f'table({text_of(parts[0])}, {", ".join(points)})'
    x, y, of_x, of_y, *cells = parts
    rows = [f'{i}{unit_text(of_y)}: {text_of(cells[2 * i])}, {text_of(cells[2 * i + 1])}' for i in range(2)]
    return f'table({text_of(x)}, {text_of(y)}; -1{unit_text(of_x)}, 2{unit_text(of_x)}; {"; ".join(rows)})'


# --- the checker: a dimension, or None of a plain zero ---


def bound(d):
    if any(abs(n) > MOST for i, n in enumerate(d) if i != RAD or RULE['an angle counts']):
        raise Refused
    return d if abs(d[RAD]) <= MOST else d[:RAD] + (0,) + d[RAD + 1:]


def same(*all_of):
    """The dimension of what may be any of them; without radians where they differ in these."""
    known = [d for d in all_of if d is not None]
    for d in known[1:]:
        if any(a != b for i, (a, b) in enumerate(zip(d, known[0])) if i != RAD or RULE['an angle counts']):
            raise Refused
    if not known:
        return None
    return known[0] if all(d[RAD] == known[0][RAD] for d in known) else known[0][:RAD] + (0,) + known[0][RAD + 1:]


def check(f):
    kind, parts = f[0], f[1:]
    if kind == 'zero':
        return None
    if kind == 'atom':
        return bound(plus({**NUMBERS, **VECTORS}[parts[0]], bound(parts[2])))
    if kind == 'sum':
        return same(check(parts[1]), check(parts[2]))
    if kind == 'product':
        return bound(plus(check(parts[1]), check(parts[2]), 1 if parts[0] == '*' else -1))
    if kind == 'power':
        return bound(tuple(parts[0] * n for n in check(parts[1])))
    if kind == 'minus':
        return check(parts[0])
    if kind == 'vector':
        return same(*map(check, parts))
    if kind == 'order':
        same(check(parts[1]), check(parts[2]))
        return PLAIN
    if kind == 'table':
        same(check(parts[0]), bound(parts[1]))
        return same(*map(check, parts[2:]))
    if kind == 'grid':
        same(check(parts[0]), bound(parts[2]))
        same(check(parts[1]), bound(parts[3]))
        return same(*map(check, parts[4:]))
    name, given = parts[0], [check(p) for p in parts[1:]]
    if name in ('dot', 'cross'):
        return bound(plus(*given))
    if name == 'sqrt':
        if any(n % (2 if i == RAD else 1) for i, n in enumerate(given[0]) if i != RAD or RULE['an angle counts']):
            raise Refused
        return tuple(Fraction(n) / 2 if i != RAD else n // 2 if n % 2 == 0 else 0 for i, n in enumerate(given[0]))
    if name in ANGLES:
        same(given[0], UNITS['rad'])
        return PLAIN
    if name in PLAINS:
        same(given[0], PLAIN)
        return UNITS['rad'] if name in ('asin', 'acos') else PLAIN
    if name == 'sign':
        return PLAIN
    if name == 'atan2':
        same(*given)
        return UNITS['rad']
    if name == 'if':
        same(given[0], PLAIN)
        return same(*given[1:])
    return same(*given)


def shown(d):
    """Radians that a product has gathered are not shown where it has a mass or a length."""
    return d[:RAD] + (0 if d[RAD] > 0 and (d[0] > 0 or d[1] > 0) else d[RAD],) + d[RAD + 1:]


# --- isoc ---

SCENE = '''step 1 ms
body b { mass 2 kg; inertia (1, 2, 2) kg*m^2; com (0.3, 0.2, 1) m }
body slide { mass 1 kg }
joint j revolute { parent slide; child b at (0.1, 0.2, 0.3) m; axis (1, 2, 3) }
joint k prismatic { parent ground; child slide; axis (2, -1, 3) }
input volts V
input c kg
output used = volts
output used_too = c
'''
PLACES = {
    'output': 'output shown = {}\n',
    'signal': 'signal between = {}\noutput shown = between\n',
    'effect': 'effect kind { joint j; joint k; body b; signal volts V; signal c kg; let found = {}; output found }\n'
              'effect e kind {{ j j; k k; b b; volts volts; c c }}\noutput shown = e.found\n',
}


def parsed(text):
    """The dimension of a unit as isoc writes it: m^3/s, 1/s, V/sqrt(Hz)."""
    d = PLAIN
    for sign, under, unit, power in re.findall(r'(^1/|[*/]|^)(?:sqrt\(([^)]*)\)|([A-Za-z]+)(?:\^(\d+))?)', text):
        d = plus(d, parsed(under) if under else UNITS[unit], (-1 if '/' in sign else 1) * (HALF if under else int(power or 1)))
    return d


def differing(isoc, seed, count):
    """Formulas of which isoc says something else than the checker; how many it accepts, and refuses."""
    pick.seed(seed)
    counts, found = {True: 0, False: 0}, []
    for _ in range(count):
        made = number(small(), pick.choice((1, 2, 2, 3, 4)))
        place = pick.choice(list(PLACES))
        try:
            expected = shown(check(made))
        except Refused:
            expected = None
        # A table has points apart with commas, so nothing in it is a line's end.
        said = isoc(SCENE + PLACES[place].replace('{}', text_of(made)).replace('{{', '{').replace('}}', '}'))
        unit = parsed(re.search(r'{"shown", "([^"]*)"', said.file('plant.h')).group(1)) if said.status == 0 else None
        counts[expected is not None] += 1
        if unit != expected:
            found.append((text_of(made), expected, unit, said.errors[:200]))
    return found, counts


def test_isoc_accepts_and_refuses_what_the_checker_does_and_shows_the_same_unit(isoc, seed):
    found, counts = differing(isoc, seed, 250)
    assert not found, found[:3]
    assert counts[True] >= 250 / 4 and counts[False] >= 250 / 10


def test_a_checker_for_which_an_angle_is_a_dimension_differs(isoc, monkeypatch):
    monkeypatch.setitem(RULE, 'an angle counts', True)
    assert differing(isoc, 7, 60)[0]
