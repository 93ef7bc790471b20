"""Units in scenes: names that are units too, roots and large powers, and the units that isoc prints."""
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
