"""--set gives a constant or a tunable another value of its own unit. Any other unit is an error where the option has it, not where the
scene uses the name: each unit against each."""
import re

import pytest

UNITS = 'kg m s rad A K N/m N*m kg*m^2 V 1/s'.split()
SCENE = '''step 1 ms
body b { mass 1 kg }
joint j prismatic { parent ground; child b; axis z }
output x = position of j
''' + ''.join(f'constant c{i} = 2 {unit}\ntunable t{i} = 2 {unit}\nconstant d{i} = 3 * t{i}\n' for i, unit in enumerate(UNITS)) + '''
constant plain = 2
tunable vacant = 0
constant arm = (1, 2, 3) m
'''


def is_told(isoc, settings, pattern, number=1):
    """Whether each of so many settings has its error at the value of the option, and each error matches."""
    made = isoc(SCENE, '--set', settings)
    errors = re.findall(r'^(\S+): error: (.*)$', made.errors, re.M)
    return made.refused and len(errors) == len({place for place, _ in errors}) == number and all(
        re.match(r'--set:1:\d+$', place) and re.match(pattern, said) for place, said in errors)


def accepts(isoc, settings):
    return isoc(SCENE, '--set', settings).status == 0


@pytest.mark.parametrize('letter', ['c', 't'])
@pytest.mark.parametrize('shift', range(len(UNITS) + 1))
def test_each_unit_at_each_name(isoc, letter, shift):
    """The units in a circle, with one place in it for none. Where names and units meet they are accepted, and by no other shift of the
    circle. isoc shows 20 errors: constants and tunables have a call each."""
    circle = UNITS + ['']
    settings = '; '.join(f'{letter}{i} = 5 {circle[(i + shift) % len(circle)]}' for i in range(len(UNITS)))
    assert accepts(isoc, settings) if shift == 0 else is_told(isoc, settings, f"'{letter}\\d+' is in .* in the scene; this ", len(UNITS))


def test_zero_has_any_unit_and_a_vector_its_components(isoc):
    assert accepts(isoc, '; '.join(f'c{i} = 0; t{i} = 0' for i in range(len(UNITS)))) and accepts(isoc, 'vacant = 2 m')
    assert is_told(isoc, 'plain = 2 m', "'plain' has no unit in the scene; this is in m")
    assert is_told(isoc, 'arm = 2 m', r"'arm' is a vector \(x, y, z\); this is one number")
    assert is_told(isoc, 'plain = (1, 2, 3)', "'plain' is one number; this is a vector")


def test_the_scene_decides_and_not_an_option_before(isoc):
    assert accepts(isoc, 't0 = 2 kg; t0 = 3 kg') and is_told(isoc, 't0 = 2 kg; t0 = 3 m', "'t0' is in kg in the scene; this is in m")
