"""What the scene language computes and abbreviates, against the same scene written out in numbers."""
import math
import pathlib
import re
import subprocess

import numpy as np
import pytest


def text_of(made):
    """The plant, but for the scene's lines that comments quote."""
    assert made.status == 0, made.errors
    return [line for line in (re.sub(r'/\*.*\*/', '', line).strip() for line in made.file('plant.c').splitlines()) if line]


def are_same(isoc, one, other):
    return text_of(isoc(one, '--real', 'double')) == text_of(isoc(other, '--real', 'double'))


SPIN = '''step 1 ms
body top {{ mass 1 kg; inertia (1, 2, 3) kg*m^2 }}
body base {{ mass 1 kg }}
joint weld fixed {{ parent ground rotate 90 deg about z; child base }}
joint air free {{ parent base; child top; start quaternion (0.5, 0.5, 0.5, 0.5); spin {} }}
output spin = spin of top
'''
POINT = '''step 1 ms
body bob {{ mass 1 kg; com (0, -1, 0) m }}
joint pivot revolute {{ parent ground; child bob; axis z; start 1 rad }}
output tip = position of bob at {0}
output shift = position of bob at {0} - (1, 0, 0) m
'''
# What is short, and the same at length.
SAME = {
    'functions in values': ('''gravity (0, -9.81, 0) m/s^2
step 1 ms
tunable phi = 30 deg
constant height = sqrt((3 m)^2 + (4 m)^2)
body bob { mass exp(0) * 1 kg; com (1 m * tan(phi), -max(2 m, 500 mm, 1 m), min(0, 1 m)); inertia (1, 1, 1) g*m^2 }
joint pivot revolute {
    parent ground at (height, 1 m * cos(90 deg), abs(-tan(45 deg)) * 1 m) rotate acos(1 / 2) about x
    child bob; axis z; start atan2(1, 1); speed log(2) * 1 rad/s; drive push
}
input push = 1 N*m * sin(3 Hz) + 1 N*m * asin(0.5) / (1 rad)
output angle = position of pivot
''', '''gravity (0, -9.81, 0) m/s^2
step 1 ms
tunable phi = 30 deg
body bob { mass 1 kg; com (1 m * (sin(phi) / cos(phi)), -2 m, 0); inertia (1, 1, 1) g*m^2 }
joint pivot revolute {
    parent ground at (5, 0, 1) m rotate 1.0471975511965977462 rad about x
    child bob; axis z; start 45 deg; speed 0.69314718055994530942 rad/s; drive push
}
input push = 1 N*m * sin(3 Hz) + 0.52359877559829887308 N*m
output angle = position of pivot
'''),
    'operands that are vectors, points and components in formulas': ('''step 1 ms
gravity (0, 0, -9.81) m/s^2
body kite { mass 1 kg; com (0, 0, 1) m; inertia (1, 1, 1) g*m^2 }
joint line universal { parent ground; child kite; axis x; second y; start rotate 10 deg rotate 20 deg }
effect air {
    body on
    signal wind m/s = (0, 0, 0)
    value drag N*s/m = (0, 0, 0)
    let past = wind - velocity of on
    force on on = (1 N*s/m) * past - cross((0, 0, 1), wind) * 2 N*s/m + drag * (0 m/s)
    require dot(wind, wind) >= 0
    output past
}
input gust m/s = 1 m/s * sin(3 Hz)
signal blown = (1, 0, 0) * gust
effect up air { on kite at (0, 0, 1) m; wind blown }
effect calm air { on kite }
output z = velocity of kite at (0, 0, 1) m along z
output low = 2 * position of kite at (0, 0, -1) m along y
output past = up.past
''', '''step 1 ms
gravity (0, 0, -9.81) m/s^2
body kite { mass 1 kg; com (0, 0, 1) m; inertia (1, 1, 1) g*m^2 }
frame under { on kite at (0, 0, -1) m }
joint line universal { parent ground; child kite; axis x; second y; start rotate 10 deg rotate 20 deg }
effect up_air {
    body on
    signal x m/s
    let wind = (1, 0, 0) * x
    let past = wind - velocity of on
    force on on = (1 N*s/m) * past - cross((0, 0, 1), wind) * 2 N*s/m
    output x_past = dot(past, (1, 0, 0))
    output y_past = dot(past, (0, 1, 0))
    output z_past = dot(past, (0, 0, 1))
}
effect calm_air {
    body on
    force on on = (-1 N*s/m) * velocity of on
}
input gust m/s = 1 m/s * sin(3 Hz)
effect up up_air { on kite at (0, 0, 1) m; x gust }
effect calm calm_air { on kite }
output z = velocity of kite at (0, 0, 1) m along z
output low = 2 * dot(position of under, (0, 1, 0))
output past_x = up.x_past
output past_y = up.y_past
output past_z = up.z_past
'''),
    'frames, and a body without mass': ('''gravity (0, -9.81, 0) m/s^2; step 1 ms; tunable reach = 1 m; input push
body arm { mass 1 kg; com (0, -0.5, 0) m; inertia (1, 1, 1) g*m^2 }
body fore { mass 1 kg; com (0, -0.5, 0) m; inertia (1, 1, 2) g*m^2 }
body cross { mass 0 }
frame last { on tip at (0, -10, 0) mm rotate 10 deg about x }
frame tip { on fore at (0, -reach, 0) }
frame base { on ground at (0, 1, 0) m rotate 90 deg about x }
frame end { on arm at (0, -1, 0) m rotate 30 deg about z }
joint shoulder revolute { parent base; child arm; axis z }
joint wrist_first revolute { parent end; child cross; axis x; start 20 deg; speed 1 rad/s }
joint wrist_second revolute { parent cross; child fore; axis y; start 30 deg; speed 2 rad/s }
close pin distance { parent base at (1, 0, 0) m; child last }
force kick { body last; axis y; drive push }
output place = position of last
output velocity = velocity of tip
output orientation = orientation of last
output spin = spin of last along y
output rest = position of base along y
output force = force of shoulder
''', '''gravity (0, -9.81, 0) m/s^2; step 1 ms; tunable reach = 1 m; input push
body arm { mass 1 kg; com (0, -0.5, 0) m; inertia (1, 1, 1) g*m^2 }
body fore { mass 1 kg; com (0, -0.5, 0) m; inertia (1, 1, 2) g*m^2 }
body hand { mass 0 }
body peg { mass 0 }
joint shoulder revolute { parent ground at (0, 1, 0) m rotate 90 deg about x; child arm; axis z }
joint wrist universal {
    parent arm at (0, -1, 0) m rotate 30 deg about z; child fore; axis x; second y
    start rotate 20 deg rotate 30 deg; spin (1, 2) rad/s
}
joint glue fixed { parent fore at (0, -reach - 10 mm, 0) rotate 10 deg about x; child hand }
joint nail fixed { parent ground at (0, 1, 0) m rotate 90 deg about x; child peg }
close pin distance { parent peg at (1, 0, 0) m; child hand }
force kick { body hand; axis y; drive push }
output place = position of hand
output velocity = velocity of fore at (0, -reach, 0)
output orientation = orientation of hand
output spin = spin of hand along y
output rest = position of peg along y
output force = force of shoulder
'''),
    'a body of several solids, and bodies welded together': ('''gravity (0, -9.81, 0) m/s^2; step 1 ms; tunable load = 2 kg
body arm {
    box (10, 20, 30) mm of load at (0, -0.3, 0) m rotate 30 deg about x rotate 10 deg about y
    cylinder (1, 30) cm of 1 kg at (0.1, 0, 0) m rotate 90 deg about y
    lump (3, 4, 5; 0.1, 0.2, 0.3) g*m^2 of 300 g at (0, 0, 5) mm
}
joint pivot spherical { parent ground; child arm; spin (1, 2, 3) rad/s }
output place = position of arm at (0, 1, 0) m
output energy = energy
''', '''gravity (0, -9.81, 0) m/s^2; step 1 ms; tunable load = 2 kg
body arm { mass 0 }
body a1 { box (10, 20, 30) mm of load }
body a2 { mass 1 kg; inertia ((0.01 m)^2 / 4 + (0.3 m)^2 / 12, (0.01 m)^2 / 4 + (0.3 m)^2 / 12, (0.01 m)^2 / 2) * (1 kg) }
body a3 { mass 300 g; inertia (3, 4, 5; 0.1, 0.2, 0.3) g*m^2 }
joint pivot spherical { parent ground; child arm; spin (1, 2, 3) rad/s }
joint f1 fixed { parent arm at (0, -0.3, 0) m rotate 30 deg about x rotate 10 deg about y; child a1 }
joint f2 fixed { parent arm at (0.1, 0, 0) m rotate 90 deg about y; child a2 }
joint f3 fixed { parent arm at (0, 0, 5) mm; child a3 }
output place = position of arm at (0, 1, 0) m
output energy = energy
'''),
    'a spin in the axes of the ground, which the frame and the start turn: x, y, z to -x, z, y': (SPIN.format('(1, 2, 3) rad/s in ground'), SPIN.format('(-1, 3, 2) rad/s')),
    'the point of a quantity, a product, or a sum in parentheses': (POINT.format('2 * (0, -1, 0) m'), POINT.format('((0, -1, 0) m + (0, -1, 0) m)')),
}


@pytest.mark.parametrize('what', SAME)
def test_what_is_short_gives_the_plant_that_it_gives_at_length(isoc, what):
    short, long = SAME[what]
    assert are_same(isoc, short, long)
    assert not are_same(isoc, short, re.sub(r'-(\d)', r'-1\1', long)), 'found: other numbers'


def n_four_bar(windows):
    """What models/n_four_bar.scene is in the short, written out: benchmark A02 of the IFToMM library of multibody problems."""
    lines = ['gravity (0, -9.81, 0) m/s^2\nstep 1 ms\nmethod rk4\nstabilisation lagrangian']

    def rod(name, parent, hinge, start, speed):
        lines.append(f'body {name} {{ mass 1 kg; com (0.5, 0, 0) m; inertia (0, 1, 1) * (1 kg * (1 m)^2 / 12) }}\n'
                     f'joint {hinge} revolute {{ parent {parent}; child {name}; axis z; start {start} deg; speed {speed} rad/s }}')

    for i in range(windows + 1):
        rod(f'upright{i}', f'ground at ({i}, 0, 0) m', f'hinge{i}', 90, -1)
    for i in range(windows):
        rod(f'bar{i}', f'upright{i} at (1, 0, 0) m', f'corner{i}', -90, 1)
        lines.append(f'close window{i} line {{ parent upright{i + 1} at (1, 0, 0) m; child bar{i} at (1, 0, 0) m; axis z }}')
    return '\n'.join(lines) + '''
output angle = position of hinge0
output b0 = position of upright0 at (1, 0, 0) m
output b0_velocity = velocity of upright0 at (1, 0, 0) m
output violation = violation
output energy = energy
'''


def test_a_repeat_is_what_it_stands_for(isoc):
    model = pathlib.Path('models/n_four_bar.scene').read_text()
    assert 'constant windows = 2' in model
    assert are_same(isoc, model.replace('constant windows = 2', 'constant windows = 3'), n_four_bar(3))
    assert not are_same(isoc, model, n_four_bar(3))


def test_repeats_in_one_another_and_files_that_are_included_in_them(isoc, tmp_path):
    """Names with a rest, an index after a digit, and a file for each turn; --files lists them."""
    (tmp_path / 'parts').mkdir()
    (tmp_path / 'parts/arm.scene').write_text('''include "../mass.scene"
joint arm[i] universal { parent ground at (i, 0, 0) m; child bob2[i]; axis x; second y; start rotate 10 deg rotate (i) deg }
output a[i]_rate = speed of arm[i]_first
''')
    (tmp_path / 'mass.scene').write_text('body bob2[i] { mass i * weight; com (0, 0, -1) m; inertia (1, 1, 1) g*m^2 }\n')
    short = tmp_path / 'plant.scene'
    short.write_text(REPEATS)
    assert are_same(isoc, short, REPEATED)
    files = subprocess.run(['build/isoc', short, '--files'], capture_output=True, text=True).stdout.split()
    assert files == [f'{tmp_path}/{name}' for name in ['plant.scene'] + ['parts/arm.scene', 'parts/../mass.scene'] * 2]


REPEATS = '''step 1 ms
gravity (0, 0, -9.81) m/s^2
constant weight = 100 g; constant most = 1 + 1
repeat i from 1 to most { include "parts/arm.scene" }
repeat i from 1 to 0 { step 2 ms }
repeat i from 0 to 1 { repeat j from 2 * i to 2 {
    output p[i][j] = position of bob2[i + 1] at (j, 0, 0) m along z } }
'''
REPEATED = '''step 1 ms
gravity (0, 0, -9.81) m/s^2
body bob2_1 { mass 100 g; com (0, 0, -1) m; inertia (1, 1, 1) g*m^2 }
joint arm1 universal { parent ground at (1, 0, 0) m; child bob2_1; axis x; second y; start rotate 10 deg rotate 1 deg }
output a1_rate = speed of arm1_first
body bob2_2 { mass 200 g; com (0, 0, -1) m; inertia (1, 1, 1) g*m^2 }
joint arm2 universal { parent ground at (2, 0, 0) m; child bob2_2; axis x; second y; start rotate 10 deg rotate 2 deg }
output a2_rate = speed of arm2_first
output p0_0 = position of bob2_1 at (0, 0, 0) m along z
output p0_1 = position of bob2_1 at (1, 0, 0) m along z
output p0_2 = position of bob2_1 at (2, 0, 0) m along z
output p1_2 = position of bob2_2 at (2, 0, 0) m along z
'''

# An axis, the moment about it, and the body: a turn about an axis through the centre takes one over it.
MOMENTS = [
    ('x', 13 / 12 * 3, 'box (1, 2, 3) m of 3 kg'), ('y', 10 / 12 * 3, 'box (1, 2, 3) m of 3 kg'), ('z', 5 / 12 * 3, 'box (1, 2, 3) m of 3 kg'),
    ('z', 5 / 12 * 3 + 3 * (0.25 + 4), 'box (1, 2, 3) m of 3 kg at (0.5, 2, 1) m'),
    ('x', 2 * (3 * 0.04 + 0.25) / 12, 'cylinder (0.2, 0.5) m of 2 kg'), ('z', 2 * 0.04 / 2, 'cylinder (0.2, 0.5) m of 2 kg'),
    ('x', 2 * 0.04 / 2, 'cylinder (0.2, 0.5) m of 2 kg rotate 90 deg about y'), ('y', 0.4 * 2 * 0.09, 'sphere 0.3 m of 2 kg'),
    ('x', 4 / 12 * 5, 'rod 2 m of 5 kg'), ('x', 4 / 12 * 5 + 5, 'rod 2 m of 5 kg at (0, 0, 1) m'),
    ('x', 4 / 12 * 5 * 0.75, 'rod 2 m of 5 kg rotate 30 deg about y rotate 0 deg about x; sphere 0 m of 1 kg'),
    ('z', 2 * (0.09 + 0.04) / 2, 'tube (0.3, 0.2, 1) m of 2 kg'), ('y', 2 * (3 * (0.09 + 0.04) + 1) / 12, 'tube (0.3, 0.2, 1) m of 2 kg'),
    ('x', 1 * 0.75 + 2 * 0.25, 'lump (1, 2, 2) kg*m^2 of 1 kg rotate 30 deg about z'), ('z', 2, 'lump (1, 2, 2) kg*m^2 of 1 kg rotate 30 deg about z'),
    ('x', 1 * 0.75 + 2 * 0.25, 'mass 1 kg; inertia (1, 2, 2) kg*m^2 rotate 30 deg about z'),
    ('x', 2 * 0.4 * 2 * 0.01 + 2 * 2 * 0.25 + 1 / 12,
     'sphere 0.1 m of 2 kg at (0, 0, 0.5) m; sphere 10 cm of 2 kg at (0, 0, -0.5) m; rod 1 m of 1 kg'),
    ('z', 2 * 0.4 * 2 * 0.01, 'sphere 0.1 m of 2 kg at (0, 0, 0.5) m; sphere 10 cm of 2 kg at (0, 0, -0.5) m; rod 1 m of 1 kg')]


def test_moments_of_inertia_of_solids_are_those_by_hand(plant):
    """Some ten roundings of 1.1e-16 each."""
    bodies = ''.join(f'body b{i} {{ {words} }}\njoint j{i} revolute {{ parent ground; child b{i}; axis {axis}; drive torque }}\n'
                     f'output a{i} = acceleration of j{i}\n' for i, (axis, _, words) in enumerate(MOMENTS))
    p = plant('step 1 ms\ninput torque = 1 N*m\n' + bodies)
    found = p.follow(1).rows['y'][1]
    assert np.abs(found * [moment for _, moment, _ in MOMENTS] - 1).max() < 2e-15


# --- files that are included ---


def told(isoc, scene):
    made = isoc(scene)
    return [line.replace(f'{scene.parent}/', '') for line in made.errors.splitlines() if ': error: ' in line] if made.status == 1 else None


def test_a_circle_a_missing_file_and_errors_by_the_file_they_are_in(isoc, tmp_path):
    (tmp_path / 'a.scene').write_text('include "b.scene"\n')
    (tmp_path / 'b.scene').write_text('step 1 ms\ngravity (0, 0, 1) m; include "c.scene"\nbody one { mass 1 kg }\n')
    (tmp_path / 'c.scene').write_text('include "a.scene"\ninclude "none.scene"\ninclude "."\nbody one { mass 1 kg }\nstep 1 ms\n')
    assert told(isoc, tmp_path / 'a.scene') == [
        'b.scene:2:9: error: gravity is in m/s^2; this is in m',
        'c.scene:1:9: error: an include in a circle: a.scene includes b.scene, which includes c.scene, which includes a.scene',
        "c.scene:2:9: error: cannot include 'none.scene': No such file or directory",
        "c.scene:3:9: error: cannot include '.': a directory, not a scene: name a .scene file in it",
        "c.scene:4:6: error: the name 'one' is already used in line 3 of b.scene",
        "c.scene:5:1: error: a second 'step'; the first is in line 1 of b.scene"]


def test_files_are_included_sixteen_deep_and_no_deeper(isoc, tmp_path):
    for n in range(1, 21):
        (tmp_path / f'{n}.scene').write_text(f'include "{n + 1}.scene"\n')
    assert told(isoc, tmp_path / '1.scene') == ['17.scene:1:1: error: repeats and includes in one another, more than 16 deep']


# --- functions of values ---


@pytest.mark.parametrize('name, reference, least, most', [
    ('exp', np.exp, -700, 700), ('log', np.log, 1e-300, 1e300), ('log', np.log, 0.7, 1.4), ('asin', np.arcsin, -1, 1), ('acos', np.arccos, -1, 1),
    ('atan2', np.arctan2, -1e100, 1e100), ('sqrt', np.sqrt, 0, 1e300), ('^', np.power, 1e-300, 1e300)])
def test_functions_of_values_are_the_nearest_double(isoc, seed, name, reference, least, most):
    """Long double has 64 bits: its functions are within 1 ulp of theirs (glibc's manual, "Errors in Math Functions"), 2^-11 ulp of a double,
    so a result may be half an ulp and 2^-11 off."""
    draw = np.random.default_rng(seed)
    count, operands = 2000, 2 if name in ('atan2', '^') else 1
    numbers = draw.uniform(least, most, (count, operands))
    if most > 1e90:  # of any size
        numbers = np.abs(numbers) ** draw.uniform(0.001, 1, numbers.shape) * (np.sign(numbers) if name == 'atan2' else 1)
    if name == '^':
        numbers[:, 1] = draw.uniform(-600, 600, count) / np.maximum(1, np.abs(np.log(numbers[:, 0])))
    calls = [f'({x})^({y[0]})' if name == '^' else f'{name}({", ".join(map(repr, [x, *y]))})' for x, *y in numbers.tolist()]
    scene = 'step 1 ms\nbody b { mass 1 kg }\njoint j prismatic { parent ground; child b; axis x }\noutput x = position of j\n'
    scene += ''.join(f'tunable v{i} = {call}\n' for i, call in enumerate(calls))
    text = isoc(scene, '--real', 'double').file('plant.h')
    found = np.array([float(value) for value in re.findall(r'^    \{"v\d+", .* R\((\S+)\)\},$', text, re.M)])
    exact = reference(*numbers.astype(np.longdouble).T)
    ulp = np.ldexp(np.longdouble(1), np.frexp(exact)[1] - 53)
    assert len(found) == count and (np.abs(found - exact) <= (0.5 + 1 / 2048) * ulp).all()


@pytest.mark.parametrize('formula, value', [
    ('exp(0)', 1), ('log(1)', 0), ('atan2(0, 1)', 0), ('atan2(1, 0)', math.pi / 2), ('atan2(-1, 0)', -math.pi / 2), ('atan2(0, -1)', math.pi),
    ('atan2(1, 1)', math.pi / 4), ('asin(1)', math.pi / 2), ('asin(-1)', -math.pi / 2), ('acos(1)', 0), ('acos(-1)', math.pi), ('acos(0)', math.pi / 2),
    ('2^0.5', math.sqrt(2)), ('3^40', float(3**40))])
def test_corners_are_exact(isoc, formula, value):
    scene = f'step 1 ms\nbody b {{ mass 1 kg }}\njoint j prismatic {{ parent ground; child b; axis x }}\noutput x = position of j\ntunable v = {formula}\n'
    made = isoc(scene, '--real', 'double')
    assert made.status == 0, made.errors
    assert float(re.search(r'^    \{"v", .* R\((\S+)\)\},$', made.file('plant.h'), re.M)[1]) == value
