"""What an effect is: the same as the words of joints and bodies that it replaces, as the definition of the library that it names,
and nothing where it is not used."""
import pathlib

import numpy as np
import pytest
from harness.plants import replaced

LIBRARY = pathlib.Path('models/effects')
ROAD = pathlib.Path('tests/isoc/plant/inputs/road.csv').resolve()


def states(plant, scene, *options, ticks=2000):
    return plant(scene, *options).follow(ticks).rows['x']


def are_same(plant, one, other, *options):
    return np.array_equal(states(plant, one, *options), states(plant, other, *options))


# --- definitions of the library ---

MOTOR = pathlib.Path('tests/isoc/effects/motor.scene').read_text()
USES = replaced(r'^effect dc_motor \{(.|\n)*?^\}\n', '', MOTOR)


def test_an_effect_of_the_library_is_its_definition_in_the_scene(isoc):
    own = isoc((LIBRARY / 'dc_motor.scene').read_text() + USES)
    assert isoc(USES).files() == own.files()
    assert isoc(USES.replace('5 mH', '6 mH')).files() != own.files()


def test_what_an_effect_of_the_library_requires_is_told_with_its_line(isoc):
    made = isoc(USES.replace('2 Ohm', '0 Ohm - 2 Ohm'))
    assert made.refused
    line = [n for n, text in enumerate((LIBRARY / 'dc_motor.scene').read_text().splitlines(), 1) if 'require resistance >= 0' in text]
    assert f'requires in line {line[0]} of models/effects/dc_motor.scene: require resistance >= 0' in made.errors


# --- words of a joint, and effects that do the same ---

PENDULUM = '''gravity (0, -9.81, 0) m/s^2
step 1 ms
body bob { mass 1 kg; com (0, -1, 0) m }
output angle = position of pivot
'''
JOINT = 'joint pivot revolute { parent ground; child bob; axis z; start 1 rad'
VISCOUS = 'effect viscous { joint along; value factor N*m*s/rad; effort on along = -factor * speed of along }\n'
OWN = {
    'drive push': ('input push = 0.3 N*m * sin(2 Hz)\n', 'effect driven { joint along; signal by like effort of along; effort on along = by }\n'
                   'effect motor driven { along pivot; by push }\n'),
    'spring 5 N*m/rad rest 10 deg': ('', '''effect elastic {
    joint along; value stiffness N*m/rad; value rest like position of along
    effort on along = -stiffness * (position of along - rest)
}
effect coil elastic { along pivot; stiffness 5 N*m/rad; rest 10 deg }
'''),
    'damping 0.1 N*m*s/rad': ('', VISCOUS + 'effect bearing viscous { along pivot; factor 0.1 N*m*s/rad }\n'),
}


@pytest.mark.parametrize('method', ['rk4', 'semi_implicit', 'bdf4'])
@pytest.mark.parametrize('words', OWN)
def test_words_of_a_joint_have_the_bits_of_an_effect(plant, words, method):
    head, effect = OWN[words]
    assert are_same(plant, f'{PENDULUM}{head}{JOINT}; {words} }}\n', f'{PENDULUM}{head}{JOINT} }}\n{effect}', '--method', method)


def test_a_tenth_more_damping_is_found(plant):
    more = VISCOUS + 'effect bearing viscous { along pivot; factor 0.11 N*m*s/rad }\n'
    assert not are_same(plant, f'{PENDULUM}{JOINT}; damping 0.1 N*m*s/rad }}\n', f'{PENDULUM}{JOINT} }}\n{more}', '--method', 'bdf4')


def test_a_definition_that_is_not_used_leaves_the_plant_as_it_is(isoc):
    damped = f'{PENDULUM}{JOINT}; damping 0.1 N*m*s/rad }}\n'
    assert isoc(damped).files() == isoc(damped + VISCOUS).files()


DRIVEN = 'effect driven { joint along; signal by; effort on along = 0.3 N*m * by }\n'
USE = 'effect motor driven { along pivot; by push }\n'


@pytest.mark.parametrize('of', ['time / 1 s', 'step(0.3 s)', 'square(7 Hz)', 'prbs(7, 10 ms)', 'chirp(1 Hz, 9 Hz, 1 s)', f'file "{ROAD}"'])
def test_a_function_of_time_in_a_formula_is_that_of_an_input(plant, of):
    """With the same new starts of a method with a history."""
    head = f'{PENDULUM}method ab4\n{JOINT} }}\n'
    by_input = f'{head}input push = {of}\n{DRIVEN}{USE}'
    assert are_same(plant, by_input, f'{head}effect driven {{ joint along; effort on along = 0.3 N*m * ({of}) }}\n'
                    'effect motor driven { along pivot }\n'), 'in a definition'
    assert are_same(plant, by_input, f'{head}{DRIVEN}signal push = {of}\n{USE}'), 'in a signal'
    assert not are_same(plant, by_input, f'{head}{DRIVEN}signal push = 1.01 * ({of})\n{USE}')


# --- forces, moments, and vectors ---

DRONE = '''gravity (0, 0, -9.81) m/s^2
step 1 ms
input thrust N = 10 N + 4 N * sin(1 Hz)
body frame { mass 1 kg; com (0.01, 0.02, 0) m; inertia (10, 12, 14) g*m^2 }
joint air free { parent ground; child frame; start rotate 20 deg about x; spin (1, 2, 3) rad/s }
output place = position of frame
'''
STATEMENT = 'force rotor { body frame at (0.2, 0.1, 0) m; axis z; drive thrust; moment 16 mm }\n'


def rotor(forces):
    return f'''{DRONE}effect rotor {{
    body on; signal thrust N; value lever m
    {forces}
}}
effect first rotor {{ on frame at (0.2, 0.1, 0) m; thrust thrust; lever 16 mm }}
'''


def test_a_force_in_the_axes_of_its_body_is_that_of_the_statement_force(plant):
    in_body = rotor('force on on in body = (0, 0, thrust); moment on on in body = (0, 0, lever * thrust)')
    assert are_same(plant, DRONE + STATEMENT, in_body)
    assert not are_same(plant, DRONE + STATEMENT, in_body.replace('lever 16', 'lever 16.1'))


@pytest.mark.parametrize('factor, is_near', [('1', True), ('1.000001', False)])
def test_so_is_one_in_the_axes_of_the_ground_to_rounding(plant, factor, is_near):
    """From body to ground and back: two products of matrices whose rows have length one, and the lever."""
    one = plant(DRONE + STATEMENT)
    other = plant(rotor(f'force on on = {factor} * thrust * z_axis of on; moment on on in ground = lever * thrust * z_axis of on'))
    r = one.follow(500).rows[1:]
    a, b = one.slopes_at(r, r['x'])[0], other.slopes_at(other.follow(500).rows[1:], r['x'])[0]
    assert (np.abs(a - b).max() <= 40 * one.ulp * np.abs(a).max()) == is_near


def pulled(kept):
    return DRONE + 'effect pull {\n    body on\n' + kept + '''}
force first { body frame; axis x; drive thrust }
effect pulled pull { on frame at (0.1, 0, 0) m }
'''


PARTS = ''.join(f'''    memory far_{axis} m = {i} m; next far_{axis} = far_{axis} + 0.01 * dot(position of on, {unit})
    state slow_{axis} m/s = {1 - min(i, 1)} m/s; rate slow_{axis} = (dot(velocity of on, {unit}) - slow_{axis}) / 20 ms
''' for i, (axis, unit) in enumerate(zip('xyz', ('(1, 0, 0)', '(0, 1, 0)', '(0, 0, 1)')))) + \
    '    force on on = -1 N/m * (far_x, far_y, far_z) - 2 N*s/m * (slow_x, slow_y, slow_z)\n'
WHOLE = '''    memory far m = (0, 1, 2) m; next far = far + 0.01 * position of on
    state slow m/s = (1, 0, 0) m/s; rate slow = (velocity of on - slow) / 20 ms
    force on on = -1 N/m * far - 2 N*s/m * slow
'''


def test_a_vector_that_is_kept_has_the_bits_of_three_numbers(plant):
    assert are_same(plant, pulled(PARTS), pulled(WHOLE))
    assert not are_same(plant, pulled(PARTS), pulled(WHOLE.replace('(0, 1, 2) m', '(0, 1, 2.01) m')))


# --- what is measured ---


def largest(a):
    return np.abs(a).max()


def test_what_passes_through_a_joint_is_mass_times_specific_force(plant):
    """Both are sums of some hundred products of numbers of this size. A memory has the accelerations at the end of its tick."""
    p = plant(pathlib.Path('tests/isoc/effects/measured.scene'))
    y = p.follow(1000).y
    seen = np.stack([y[axis] for axis in 'xyz'], 1)[1:]
    assert largest(seen - y.force[1:]) <= 200 * p.ulp * largest(y.force)
    assert (y.along == y.across)[1:].all() and (y.turning == y.acceleration)[1:].all()


PLATE = '''body plate { mass 0.4 kg; com (10, 0, 30) mm; inertia (1e-3, 2e-3, 1.5e-3) kg*m^2 }
joint mount fixed { parent BODY at (0, 0, 56) mm rotate 30 deg about x; child plate }
'''
CELL = pathlib.Path('tests/isoc/effects/cell.scene').read_text()


def cell(plant, model, joint, connection, body, real, of_cell=CELL):
    """Load cells in a joint and in another connection of a model, to which a plate is welded: how far they are off what the outputs
    of the scene show of the same, over what is allowed: sums of some hundred products, which may be shared and ordered otherwise
    where other values are computed too."""
    scene = pathlib.Path(f'models/{model}.scene').read_text() + PLATE.replace('BODY', body) + \
        of_cell.replace('JOINT', joint).replace('CONNECTION', connection)
    p = plant(scene, real=real)
    r = p.named(p.follow(200).rows[1:]).y
    assert (r.now == r.force_y).all() and (r.in_scene == r.force_y).all(), 'a formula of an output is the output'
    assert largest(r.force) > 0 and largest(r.through_y) > 0
    return np.array([largest(r.felt - r.force) / largest(r.force), largest(r.turned - r.moment) / (largest(r.force) + largest(r.moment)),
                     largest(r.passed - r.through_y) / largest(r.through_y)]) / (200 * p.ulp)


@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('place', [('arm6', 'elbow', 'mount', 'flange'), ('four_bar', 'motor_shaft', 'rocker_pin', 'rocker')])
def test_load_cells_take_what_the_outputs_show(plant, place, real):
    assert (cell(plant, *place, real) <= 1).all()


def test_a_load_cell_a_millionth_off_and_a_moment_on_the_other_side_are_found(plant):
    other = CELL.replace('next felt = ', 'next felt = 1.000001 * ').replace('next turned = ', 'next turned = -') \
        .replace('next passed = ', 'next passed = 1.000001 * ')
    assert (cell(plant, 'arm6', 'elbow', 'mount', 'flange', 'double', other) > 1).all()
