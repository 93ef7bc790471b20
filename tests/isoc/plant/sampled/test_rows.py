"""Sampled time (tools/isoc/README.md): what rows 0 to 7 have of memories, pasts, starts, functions of time and settings,
worked out by hand."""
import re

import pytest

CART = 'body b { mass 1 kg }; joint j prismatic { parent ground; child b; axis x; start 1 m; speed 1 m/s }\n'
COUNTER = CART + 'effect counter { memory n = 5; next n = n + 1; output n }; effect c counter { }\n'

# A name, the scene, and its rows: the outputs of each.
CASES = {
    'previous, delay and sample of a memory': (COUNTER + '''
output n = c.n; output p = previous(c.n); output d = delay(c.n, 2 ms); output s = sample(c.n, every 3 ms)
''', '5 5 5 5, 6 5 5 5, 7 6 5 5, 8 7 6 8, 9 8 7 8, 10 9 8 8, 11 10 9 11'),
    'with a start of their own': (COUNTER + '''signal m = previous(c.n, 0); signal count = 1 + previous(count, 0)
output a = m; output p = previous(m, 1); output d = delay(m, 2 ms, 2); output s = sample(c.n, every 3 ms, 3); output c = count
''', '0 1 2 3 1, 5 0 2 3 2, 6 5 0 3 3, 7 6 5 8 4, 8 7 6 8 5'),
    'of each other, and in a next': (COUNTER + '''
effect follow { signal x; memory m = x; next m = sample(x, every 3 ms); output m }
effect f follow { x c.n }
output n = c.n; output pp = previous(previous(c.n)); output ds = delay(sample(c.n, every 3 ms), 2 ms)
output sp = sample(delay(c.n, 1 ms) + 1 - 1 * (c.n < 6), every 3 ms)
''', '5 5 5 5, 6 5 5 5, 7 5 5 5, 8 6 5 8, 9 7 5 8, 10 8 8 8, 11 9 8 11'),
    'functions of time and a setting are those of the row': (CART + '''tunable k = 1
effect sum { signal x; memory s = 0; next s = s + x; output s }
effect all sum { x time / 1 ms }
at 2 ms set k = 2
output now = time / 1 ms; output s = all.s; output k = k; output late = delay(time / 1 ms, 2 ms)
''', '0 0 1 0, 1 1 1 0, 2 3 2 0, 3 6 2 1, 4 10 2 2'),
    'starts follow from one another': ('''tunable two = 2
body b { mass 1 kg }; joint j prismatic { parent ground; child b; axis x; start 1 m }
effect chain { joint along; value k; memory c = b + a; next c = c; memory b = a + k; next b = b
  memory a = position of along / 1 m; next a = a
  state z = k * 1; rate z = 0 Hz; output a; output b; output c; output z }
effect e chain { along j; k two }
output a = e.a; output b = e.b; output c = e.c; output z = e.z
''', '1 3 4 2, 1 3 4 2, 1 3 4 2'),
}


def rows_of(plant):
    return [' '.join(f'{value:.9g}' for value in row) for row in plant.outputs(7).rows]


@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('case', CASES)
def test_rows_are_those_worked_out_by_hand(plant, case, real):
    scene, rows = CASES[case]
    expected = rows.split(', ')
    assert rows_of(plant('step 1 ms\n' + scene, real=real))[:len(expected)] == expected


SENSORS = '''step 1 ms
body b { mass 2 kg; inertia (0.1, 0.2, 0.3) kg*m^2 }
joint j revolute { parent ground; child b; axis z; start 200 deg; speed 1 rad/s }
input i A = 2 A
effect c current_sense { current i; range 5 V }
effect a adc { input i; lower -10 A; upper 10 A }
effect e encoder { shaft j; lines 500 }
effect u imu { on b at (0.5, 0, 0) m }
output c = c.value; output a = a.value; output e = e.count; output fx = u.force_x
'''
SENSED = ['1.99951172 2.00195312 1111 -0.5'] * 2


def test_sensors_begin_with_what_they_sense(plant):
    assert rows_of(plant(SENSORS, real='float'))[:2] == SENSED


def test_sensors_without_their_starts_are_found(plant):
    def planted(text):
        return text.replace('    begin_1(memory);', '    (void)memory, (void)begin_1;')

    assert rows_of(plant(SENSORS, real='float', change=planted))[:2] != SENSED


@pytest.mark.parametrize('scene, place', [
    ('effect a { signal x; memory m = x; next m = x; output m }\n'
     'effect one a { x two.m }; effect two a { x one.m }; output m = one.m', ''),
    ('signal m = 1 + sample(m, every 5 ms, 0)\noutput m = m', ':3:.*')])
def test_starts_that_need_each_other_are_refused(isoc, scene, place):
    made = isoc('step 1 ms\n' + CART + scene)
    assert made.refused and re.search(place + 'algebraic loop', made.errors)


@pytest.mark.parametrize('shown, memories, has_derivative', [
    ('unit.spin_z', 1, False), ('unit.spin_z + unit.force_x / (1 m/s)', 2, True)])
def test_of_a_unit_only_what_is_read_is_there(isoc, shown, memories, has_derivative):
    made = isoc(f'''gravity (0, -9.81, 0) m/s^2
step 1 ms
body bob {{ mass 1 kg; com (0, -1, 0) m }}
joint pivot revolute {{ parent ground; child bob; axis z; start 90 deg }}
effect unit imu {{ on bob at (0, -1, 0) m }}
output shown = {shown}''')
    assert int(made.summary['memories']) == memories
    assert ('derivative(dx' in made.file('plant.c')) == has_derivative
