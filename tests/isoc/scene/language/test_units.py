"""Units in scenes: names that are units too, roots and large powers, and the units that isoc prints."""
import math
import random
import re

import pytest

UNITS = ['m', 'g', 's', 'N', 'J', 'W', 'Pa', 'Hz', 'rad', 'deg', 'rev', 'rpm', 'min', 'h', 't', 'A', 'K', 'V', 'Ohm', 'H',
         'F', 'Wb', 'T', 'bar', 'L', 'Ah', 'mm', 'ks', 'kN', 'mrad']
BEGIN = '''step 1 ms
body b { mass 1 kg }
joint rail prismatic { parent ground; child b; axis x }
'''


def scene_of(name, unit, line, use):
    """An effect with something that is called like a unit, which a declaration and a number have."""
    return BEGIN + f'''effect kind {{
    signal a A*{unit}^2
    signal b {unit}/A
    value c {unit}*sqrt({unit})
    {line.format(name)}
    output shown = {use}
}}
effect e kind {{ a 3 A*{unit}^2; b 5 {unit}/A; c 2 {unit}*sqrt({unit}) }}
output shown = e.shown
'''


LINES = ['let {} = 7', 'value {} = 7', 'signal {} = 7', 'state {0} = 7\n    rate {0} = 0 1/s', 'memory {0} = 7\n    next {0} = 7']


@pytest.mark.seeds(12)
def test_names_of_units(isoc, plant, seed):
    """A name that is a unit harms no declared unit, and no number in which it stands first."""
    r = random.Random(seed)
    name, line = r.choice(UNITS), r.choice(LINES)
    row = plant(scene_of(name, name, line, f'{name} * 2 + 1 {name} / (1 {name})')).outputs(1).rows[0]
    assert row.tolist() == [15]


@pytest.mark.seeds(12)
def test_a_name_that_a_number_has_as_unit(isoc, seed):
    """2 N * m could be both: the error stands at the name. The control is another name."""
    r = random.Random(seed)
    name, line = r.choice(UNITS), r.choice(LINES)
    use = r.choice([f'2 A*{name}', f'2 A * {name}', f'(1, 2, 3) A/{name}', f'2 A*sqrt({name})', f'2 A*sqrt(K/{name})'])
    made = isoc(scene_of(name, name, line, use))
    place = re.search(r'scene:(\d+):(\d+): error: (.*)', made.errors)
    text = scene_of(name, name, line, use).splitlines()[int(place[1]) - 1]
    assert text[int(place[2]) - 1:].startswith(name) and text == '    ' + line.format(name).splitlines()[0]
    at = 9 + line.count('\n')
    assert place[3] == f"'{name}' is a unit, as in line {at}: choose another name"
    assert made.errors.count('error') == 1
    assert isoc(scene_of('other', name, line, use)).status == 0


def test_units_that_formulas_have(isoc):
    """Powers of a base unit beyond 9, roots of any unit; read again as they are printed."""
    for number, unit in (('2 V^3/s', 'kg^3*m^6/s^10/A^3'), ('2 m^3/s/sqrt(Pa)', 'm^3/s/sqrt(Pa)'), ('2 sqrt(N)', 'sqrt(N)'),
                         ('sqrt(2 N)', 'sqrt(N)'), ('2 m^12', 'm^12'), ('2 1/sqrt(Hz)', '1/sqrt(Hz)'),
                         ('2 V/sqrt(s)', 'V*Hz/sqrt(Hz)'), ('2 A^2*sqrt(kg)/sqrt(K)', None), ('2 Ohm^2*sqrt(m^3/s)', None)):
        made = isoc(BEGIN + f'output shown = {number}\n')
        assert made.status == 0, made.errors
        shown = re.search(r'\{"shown", "([^"]*)"', made.file('plant.h'))[1]
        assert unit in (None, shown, 'V*Hz/sqrt(Hz)'), shown
        again = isoc(BEGIN + f'output shown = {number} - 1 {shown}\n')
        assert again.status == 0, again.errors
        assert isoc(BEGIN + f'output shown = {number} - 1 {shown}*m\n').status == 1


def test_the_value_of_roots(plant):
    """sqrt of a unit scales by the root of its size: 1 kPa is 1000 Pa."""
    y = plant(BEGIN + 'output a = 2 m/sqrt(kPa)\noutput b = 2 sqrt(mm^2*km^2)\noutput c = 1 cm^3/s/sqrt(bar)\n').outputs(1).rows[0]
    assert y.tolist() == pytest.approx([2 / 1000**0.5, 2, 1e-6 / 1e5**0.5], rel=1e-6)


@pytest.mark.parametrize('joint, inertia, unit', [('revolute', 'inertia (1, 1, 1) kg*m^2', 'N*m/rad'), ('prismatic', '', 'N/m')])
def test_the_stiffness_of_a_stop(isoc, joint, inertia, unit):
    """It is as steep as the step allows; isoc prints it as a field writes it."""
    place, speed = ('20 deg', '3 rad/s') if joint == 'revolute' else ('20 mm', '3 m/s')
    for words in (f'stop {{ along j; lower -{place}; upper {place}; impact {speed}', f'bumper {{ along j; place {place}; impact {speed}'):
        scene = f'step 1 ms\nbody b {{ mass 1 kg; {inertia} }}\njoint j {joint} {{ parent ground; child b; axis y }}\noutput a = position of j\n'
        made = isoc(scene + f'effect s {words} }}\n')
        assert re.search(r'^stable s.stiffness \d[\d.]* ' + re.escape(unit) + '$', made.printed, re.M), made.printed + made.errors
        assert isoc(scene + f'effect s {words}; stiffness 100 {unit} }}\n').status == 0
        wrong = isoc(scene + f'effect s {words}; stiffness 100 {unit}*s }}\n')
        assert f"'stiffness' is in {unit}" in wrong.errors


def test_a_plain_number_as_unit(isoc, plant):
    """1 is the unit of a plain number, as it is printed."""
    scene = BEGIN + 'input ratio 1 in 2 to 3\neffect kind { signal a 1; state z 1 = 4; rate z = 0 1/s; output y = a * z }\n'
    scene += 'effect e kind { a ratio }\noutput y = e.y\n'
    assert plant(scene).outputs(1).rows[0].tolist() == [8]


# --- the units that isoc prints ---

BASES = ('kg', 'm', 's', 'rad', 'A', 'K')
COUNT = 400

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


def dimensions(seed):
    """Mostly of few powers, as a formula has; some of any that a dimension can have."""
    pick = random.Random(seed)
    drawn = [in_bases([pick.choice((0, 0, 1, -1, 2, -2, 3, -3)) for _ in BASES]) for _ in range(COUNT)]
    drawn += [in_bases([pick.randint(-60, 60) for _ in BASES]) for _ in range(COUNT)]
    drawn = [text for text in drawn if text]
    roots = [''.join(f'{pick.choice("*/")}sqrt({b})' for b in BASES if pick.random() < 0.3) for _ in range(COUNT)]
    return drawn + [text + root for text, root in zip(drawn, roots) if root] + list(FIELDS.values())


def printed_units(isoc, units):
    scene = BEGIN + ''.join(f'tunable v{i} = 1 {unit}\n' for i, unit in enumerate(units)) + 'output place = position of rail\n'
    printed = dict(re.findall(r'_P_V(\d+), /\* (.*) \*/', isoc(scene).file('plant.h')))
    return [printed[str(i)] for i in range(len(units))]


def test_units_of_the_fields_are_printed_as_these_write_them(isoc):
    assert dict(zip(FIELDS, printed_units(isoc, FIELDS.values()))) == {unit: unit for unit in FIELDS}


def test_every_printed_unit_is_one_of_the_same_dimension_in_base_units(isoc, seed):
    """800 random dimensions; each is 1 + 1. The control has a metre more."""
    units = dimensions(seed)
    sums = [f'constant c{i} = 1 {unit}\ntunable v{i} = c{i} + 1 {printed}\n' for i, (unit, printed) in enumerate(zip(units, printed_units(isoc, units)))]
    again = isoc(BEGIN + ''.join(sums) + 'output place = position of rail\n')
    assert again.status == 0 and again.file('plant.h').count('R(2.0)}') == len(units) > 800
    control = isoc(BEGIN + ''.join(re.sub(r'(1 \S+)\n$', r'\1*m\n', text) for text in sums) + 'output place = position of rail\n')
    assert control.refused and 'cannot be added' in control.errors


@pytest.mark.parametrize('written, value, unit', [
    ('2 mT', 0.002, 'T'), ('1.5 bar', 1.5e5, 'Pa'), ('3 mbar', 300, 'Pa'), ('250 mL', 0.00025, 'm^3'), ('2 mAh', 7.2, 'A*s'), ('20 degC', 293.15, 'K'),
    ('-40 degC', 233.15, 'K'), ('20 degC - 15 degC', 5, 'K'), ('20 degC + 2 K', 295.15, 'K'), ('(10 + 5) degC', 288.15, 'K'), ('50 1/s', 50, 'Hz'),
    ('3 1/m^2', 3, '1/m^2')])
def test_units_that_are_no_multiple_of_si_are_worth_what_they_should_be(isoc, written, value, unit):
    text = isoc(f'{BEGIN}tunable shown = {written}\noutput place = position of rail\n', '--real', 'double').file('plant.h')
    found = re.search(r'^    {"shown", "([^"]*)", .* R\((\S+)\)},$', text, re.M)
    assert (float(found[2]), found[1]) == (value, unit)


@pytest.mark.parametrize('kind', ['constant', 'tunable'])
@pytest.mark.parametrize('written, is_', [
    ('1 + 10 deg', 1 + math.pi / 18), ('sin(0.5)', math.sin(0.5)), ('2 rad/s * 1 s + 1', 3), ('atan2(1, 2) + 1', 1 + math.atan(0.5)),
    ('exp(90 deg)', math.exp(math.pi / 2)), ('max(1, 90 deg)', math.pi / 2), ('dot((1, 90 deg, 0), (0, 1, 0))', math.pi / 2)])
def test_angles_in_constants_are_numbers(isoc, plant, kind, written, is_):
    scene = BEGIN + f'{kind} c = {written}\noutput shown = 1 * c\n'
    assert plant(scene).outputs(1).rows[0, 0] == pytest.approx(is_, rel=1e-15)


def test_what_a_constant_stands_in_asks_for_its_unit(isoc):
    turning = ('step 1 ms\nbody b { mass 1 kg; inertia (1, 1, 1) g*m^2 }\nconstant a = %s\noutput y = position of j\n'
               'joint j revolute { parent ground; child b; axis z; start a }\n')
    assert 'is in rad; this has no unit' in isoc(turning % '1 + 10 deg').errors
    assert not isoc(turning % '(1 + 10 deg) * 1 rad').errors and not isoc(turning % '10 deg').errors
    assert 'm and rad cannot be added' in isoc(BEGIN + 'constant c = 1 m + 90 deg\noutput y = 1 * c').errors
