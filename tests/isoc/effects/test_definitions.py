"""Constants, functions and repeats in definitions: the plant has the bytes of the one whose definition says all of it
by hand."""
import re

import pytest

CART = '''step 1 ms
constant scale = 2
tunable loose = 3
body b { mass 1 kg }
joint rail prismatic { parent ground; child b; axis x; start 0.1 m; speed 1 m/s }
'''
SHORT = CART + '''effect wall {
  signal hot K
  value conductance 1/s
  constant width = 0.3 * scale
  function flow(a, b) = conductance * (a - b)
  function twice(a) = flow(a, 0 K) * 2 * width
  repeat i from 1 to 2 * scale {
    state T[i] K = (300 + i) * 1 K
    output T[i]
  }
  memory m[1] = 0; next m[1] = m[1] + T[1] / 1 K
  rate T1 = flow(hot, T1) - flow(T1, T2)
  repeat i from 2 to 3 { rate T[i] = flow(T[i - 1], T[i]) - flow(T[i], T[i + 1]) }
  rate T4 = flow(T3, T4)
  output far = twice(T4) + m[1] * 1 K/s
}
effect w wall { hot 400 K; conductance 5 1/s }
'''
LONG = CART + '''effect wall {
  signal hot K
  value conductance 1/s
  state T1 K = 301 K
  output T1
  state T2 K = 302 K
  output T2
  state T3 K = 303 K
  output T3
  state T4 K = 304 K
  output T4
  memory m1 = 0; next m1 = m1 + T1 / 1 K
  rate T1 = conductance * (hot - T1) - conductance * (T1 - T2)
  rate T2 = conductance * (T1 - T2) - conductance * (T2 - T3)
  rate T3 = conductance * (T2 - T3) - conductance * (T3 - T4)
  rate T4 = conductance * (T3 - T4)
  output far = conductance * (T4 - 0 K) * 2 * 0.6 + m1 * 1 K/s
}
effect w wall { hot 400 K; conductance 5 1/s }
'''
OUTPUTS = 'output third = w.T[3]\noutput far = w.far\n'


def statements(made):
    """Without comments, which quote lines of the scene."""
    return re.sub(r'\s*\n', '\n', re.sub(r'/\*.*?\*/', '', made.file('plant.c'), flags=re.S))


def test_the_plant_is_the_one_that_is_written_by_hand(isoc, plant):
    short, long = isoc(SHORT + OUTPUTS), isoc(LONG + OUTPUTS)
    assert statements(short) == statements(long) != statements(isoc(LONG.replace('- 0 K', '- 1 K') + OUTPUTS))
    assert (plant(SHORT + OUTPUTS).outputs(20).rows == plant(LONG + OUTPUTS).outputs(20).rows).all()


@pytest.mark.parametrize('line, message', [
    ('constant c = T1', "the constant 'c' depends on what can change: 'let c = ...'"),
    ('let c = loose', "this effect has no 'loose', and sees of the scene what its use gives: write 'value loose'"),
    ('let c = flow(hot)', "'flow' has 2 arguments; here are 1"),
    ('let c = flaw(hot, hot)', "no function is called 'flaw'"),
    ('function f(a) = g(a); function g(a) = f(a); let c = f(hot)', "the function 'f' needs itself"),
    ('function f(a) = a + previous(hot); let c = f(hot)', "each 'previous' is one number, and a function may be called often"),
    ('function f(a) = a + noise(1) * 1 K; let c = f(hot)', "each 'noise' is one number"),
    ('function sin(a) = a; let c = sin(hot)', "'sin' is a function already: choose another name"),
    ('function f(a, a) = a', "a second argument 'a'"),
    ('function f = 2', r'expected \( and the names of the arguments'),
    ('function f(a) = a + q; let q = a', "this effect has no 'a'"),
    ('repeat i from 1 to hot { let c[i] = i }', 'the last index must be made of whole numbers'),
    ('repeat i from 1 to 2 { let c = i }\n  output c', ''),
    ('repeat i from 1 to 2 { state c[i] K = 1 m }', r"'c1' is in K; this is in m.*\n?"),
])
def test_what_is_wrong_is_told_at_its_place(isoc, line, message):
    made = isoc(SHORT.replace('  rate T4', f'  {line}\n  rate T4') + OUTPUTS)
    assert not message or (made.refused and re.search(message, made.errors)), made.errors


def test_a_let_that_a_function_reads_does_not_see_its_arguments(plant):
    scene = CART + '''effect e { signal x; let y = x + 1; function f(x) = x + y; output z = f(10) }
effect a e { x 5 }
output z = a.z'''
    assert plant(scene).outputs(1).z[0] == 16
