"""Units as isoc prints them, read again: for random dimensions, and for the fields' own units.

units.py SCENE FOLDER BASE: the scene of a plant that has tunables of these dimensions, in base units.
units.py AGAIN FOLDER HEADER: from the units in the plant's header, the scene in which each stands in a sum with the same
dimension in base units; and what each must be. The exit status is 1 where a unit of the table below is printed otherwise.
"""
import random
import re
import sys

BASES = ('kg', 'm', 's', 'rad', 'A', 'K')
SEED, COUNT = 20261122, 400

# What a field writes: motors, damping, springs, heat, fluids, batteries, magnets.
FIELDS = {
    'kg': 'kg', 'N': 'kg*m/s^2', 'N*m': 'kg*m^2/s^2', 'W': 'kg*m^2/s^3', 'Pa': 'kg/m/s^2', 'kg*m^2': 'kg*m^2',
    'N/m': 'kg/s^2', 'N*s/m': 'kg/s', 'N*m/rad': 'kg*m^2/s^2/rad', 'N*m*s/rad': 'kg*m^2/s/rad', 'N*s': 'kg*m/s',
    'N*m*s': 'kg*m^2/s', 'rad/s': 'rad/s', 'rad/s^2': 'rad/s^2', 'm/s': 'm/s', 'm/s^2': 'm/s^2', 'Hz': '1/s',
    'V': 'kg*m^2/s^3/A', 'Ohm': 'kg*m^2/s^3/A^2', 'H': 'kg*m^2/s^2/A^2', 'F': 'A^2*s^4/kg/m^2', 'T': 'kg/s^2/A',
    'N*m/A': 'kg*m^2/s^2/A', 'V*s/rad': 'kg*m^2/s^2/A/rad', 'rad/s/V': 'rad*A*s^2/kg/m^2', 'A*s': 'A*s', 'V/m': 'kg*m/s^3/A',
    'W/K': 'kg*m^2/s^3/K', 'K/W': 'K*s^3/kg/m^2', 'W/m/K': 'kg*m/s^3/K', 'W/m^2/K': 'kg/s^3/K', 'J/K': 'kg*m^2/s^2/K',
    'J/kg/K': 'm^2/s^2/K', 'm^3/s': 'm^3/s', 'Pa*s': 'kg/m/s', 'm^3': 'm^3', 'kg/m^3': 'kg/m^3', '1/m': 'm^-1', '1/s^2': 's^-2',
    '1/Ohm': 'A^2*s^3/kg/m^2', 'm/N': 's^2/kg', 'rad/N/m': 'rad*s^2/kg/m^2', 'N/A': 'kg*m/s^2/A', 'kg/m': 'kg/m',
    'N*m*s^2/rad^2': 'kg*m^2/rad^2', 'N^2': 'kg^2*m^2/s^4', 'V/K': 'kg*m^2/s^3/A/K',
}


def in_bases(powers):
    return '*'.join(f'{b}^{n}' for b, n in zip(BASES, powers) if n)


def dimensions():
    """Mostly of few powers, as a formula has; some of any that a dimension can have."""
    pick = random.Random(SEED)
    drawn = [in_bases([pick.choice((0, 0, 1, -1, 2, -2, 3, -3)) for _ in BASES]) for _ in range(COUNT)]
    drawn += [in_bases([pick.randint(-60, 60) for _ in BASES]) for _ in range(COUNT)]
    drawn = [text for text in drawn if text]
    roots = [''.join(f'{pick.choice("*/")}sqrt({b})' for b in BASES if pick.random() < 0.3) for _ in range(COUNT)]
    return drawn + [text + root for text, root in zip(drawn, roots) if root] + list(FIELDS.values())


BEGIN = '''step 1 ms
body b { mass 2 kg; inertia (0.1, 0.2, 0.3) kg*m^2 }
joint j revolute { parent ground; child b; axis z }
output place = position of j
'''


def scene(path):
    with open(path, 'w') as out:
        out.write(BEGIN)
        out.writelines(f'tunable v{i} = 1 {unit}\n' for i, unit in enumerate(dimensions()))


def again(path, header):
    text = open(header).read()
    printed = dict(re.findall(r'_P_V(\d+), /\* (.*) \*/', text))
    good = True
    with open(path, 'w') as out:
        out.write(BEGIN)
        for i, unit in enumerate(dimensions()):
            out.write(f'constant c{i} = 1 {unit}\ntunable v{i} = c{i} + 1 {printed[str(i)]}\n')
    for i, (wanted, _) in enumerate(FIELDS.items(), len(dimensions()) - len(FIELDS)):
        if printed[str(i)] != wanted:
            print(f'# {wanted} is printed as {printed[str(i)]}', file=sys.stderr)
            good = False
    return good


if sys.argv[1] == 'SCENE':
    scene(sys.argv[2])
elif not again(sys.argv[2], sys.argv[3]):
    sys.exit(1)
