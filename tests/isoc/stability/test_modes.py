"""What isoc says of stability: eigenvalues of the Jacobian, and warnings where the method does not hold them."""
import pathlib
import re

import numpy as np
import pytest

METHODS = 'euler heun rk4 semi_implicit ab4 abm4 abm4_pec abm4_pecece bdf4 rosenbrock'.split()
README = ' '.join(pathlib.Path('tools/isoc/README.md').read_text().split())
SPRING = '''method rk4
step 1 ms
constant frequency = 1 kHz
effect elastic { joint along; value stiffness N/m; effort on along = -stiffness * position of along }
body block { mass 1 kg }
joint slide prismatic { parent ground; child block; axis x; start 1 mm }
effect strap elastic { along slide; stiffness 1 kg * frequency^2 }
effect bearing friction { along slide; sliding 1 mN; creep 1 m/s }
output x = position of slide
'''


def warnings(isoc, scene, *options):
    """What isoc warns of, each with its place `LINE:COLUMN`."""
    made = isoc(scene, *options)
    assert made.status == 0, made.errors
    return re.findall(r':(\d+:\d+): warning: (.*)', made.errors)


def says(found, pattern):
    return any(re.match(pattern, said) for _, said in found)


def is_shown(found):
    """Whether tools/isoc/README.md shows what is warned of, as far as the numbers of the methods."""
    return any(' '.join(said.split())[:120] in README for _, said in found)


def spring(isoc, method, hertz, *options):
    return warnings(isoc, SPRING, '--method', method, '--set', f'frequency = {hertz} Hz', *options)


@pytest.mark.parametrize('method, below, above', [('rk4', 2800, 2856), ('semi_implicit', 1980, 2020), ('euler', 212, 216)])
def test_a_spring_is_held_up_to_the_limit_of_the_method(isoc, method, below, above):
    """rk4 sqrt(8) over the step, semi_implicit 2. Undamped oscillations grow with euler however small the step is;
    sqrt(1 + z^2) = exp(z / 10) + 1e-3 at 0.214. What swings may still grow slowly."""
    assert not any('too fast' in said for _, said in spring(isoc, method, below))
    assert says(spring(isoc, method, above), f"the effect 'strap' is too fast for {method} with a step of 1 ms: the Jacobian at the start has "
                                             rf'the eigenvalue .* \+- {above} i 1/s')


def test_no_spring_is_too_fast_for_rosenbrock(isoc):
    assert spring(isoc, 'rosenbrock', '1e6') == []


# --- what grows slowly is told with the time in which it grows by e ---


def growth(plant, method, frequency):
    """The time in which isoc says that what swings grows by e, and that of a run of five of it: the slope of the logarithm of the amplitude
    over the last four."""
    p = plant(SPRING, '--method', method, '--set', f'frequency = {frequency} Hz', '--step', '4ms')
    warned = re.search(rf"warning: the oscillation of {frequency} rad/s by the effect 'strap' grows by e in (\S+) s with {method} and a step of 4 ms",
                       p.made.errors)
    told = float(warned[1])
    x = p.follow(int(5 * told / 4e-3)).rows['x']
    late = np.arange(len(x)) >= len(x) // 5
    t, y = 4e-3 * np.flatnonzero(late), np.log(np.hypot(frequency * x[late, 0], x[late, 1]))
    return told, 1 / np.polyfit(t, y, 1)[0]


@pytest.mark.parametrize('method, frequency', [('euler', 8), ('euler', 40), ('heun', 60), ('heun', 140), ('abm4', 105), ('abm4', 160),
                                               ('abm4_pecece', 180), ('bdf4', 83), ('bdf4', 190)])
def test_what_swings_grows_as_fast_as_isoc_says(plant, method, frequency):
    """Undamped springs of frequency times step from 0.02 to 0.8, where the method is not yet too fast. What a period leaves in the slope is a
    part of 1 / (frequency time); the time is told to three digits."""
    told, measured = growth(plant, method, frequency)
    assert abs(measured / told - 1) <= 0.01


def test_what_a_method_does_not_let_grow_or_by_e_in_more_than_ten_seconds_is_not_told(isoc):
    for method in ('rk4', 'ab4', 'semi_implicit', 'rosenbrock'):
        assert spring(isoc, method, 80, '--step', '4ms') == []
    assert spring(isoc, 'euler', 6.8, '--step', '4ms') == []
    assert says(spring(isoc, 'heun', 100, '--step', '4ms'), '.* or rk4, ab4, semi_implicit, abm4_pecece, rosenbrock$')
    found = spring(isoc, 'euler', 100)
    assert says(found, '.* grows by e') and is_shown(found)


MOTOR = '''step 1 ms
method ab4
input volts V smooth
body rotor { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint shaft revolute { parent ground; child rotor; axis z; damping 0.01 N*m*s/rad }
effect bearing friction { along shaft; sliding 10 mN*m; creep 10 rad/s }
constant ohm = 8 Ohm
effect drive dc_motor { shaft shaft; supply volts; resistance ohm; inductance 20 mH; constant 1 mN*m/A }
output current = drive.current
'''


def test_the_winding_of_a_motor_is_told_with_its_line_and_the_steps_of_all_methods(isoc):
    """R / L = 400/s: ab4 holds 0.3 a step; the limit is within 1 %."""
    found = warnings(isoc, MOTOR)
    assert says(found, r"the effect 'drive' is too fast for ab4 .* the eigenvalue -400 1/s; .*euler 5 ms, heun 5 ms, rk4 6.9[67] ms, ab4 0.75. ms, "
                       '.*bdf4 any, rosenbrock any')
    assert '8:8' in dict(found) and is_shown(found)
    for method in ('bdf4', 'rosenbrock', 'euler', 'rk4'):
        assert warnings(isoc, MOTOR, '--method', method) == []
    assert warnings(isoc, MOTOR, '--set', 'ohm = 5.94 Ohm') == []
    assert says(warnings(isoc, MOTOR, '--set', 'ohm = 6.06 Ohm'), "the effect 'drive'")


def test_friction_is_steepest_at_rest_and_what_is_too_fast_is_told_one_after_the_other(isoc):
    steep = SPRING.replace('creep 1 m', 'creep 0.1 um')
    assert says(warnings(isoc, steep.replace('start 1 mm', 'start 1 mm speed 1 m/s')),
                "the effect 'bearing' is too fast for rk4 .* at rest has the eigenvalue -")
    found = warnings(isoc, steep, '--set', 'frequency = 200 kHz')
    assert len(found) == 2 and says(found, "the effect 'bearing'") and says(found, "the effect 'strap'")


@pytest.mark.parametrize('method', METHODS)
def test_no_method_is_blamed_for_what_grows_by_itself(isoc, method):
    """An inverted pendulum, whose other mode, -0.157 a step, all methods hold."""
    assert warnings(isoc, '''gravity (0, -9.81, 0) m/s^2
step 50 ms
body bob { mass 1 kg; com (0, 1, 0) m }
joint pivot revolute { parent ground; child bob; axis z; start 0.01 rad }
output angle = position of pivot
''', '--method', method) == []


def test_a_stabilisation_that_is_too_fast_is_told(isoc):
    loop = re.sub('^stabilisation.*\n', '', pathlib.Path('models/four_bar.scene').read_text(), flags=re.M)
    found = warnings(isoc, loop + 'stabilisation baumgarte { alpha 3 kHz; beta 3 kHz }\n', '--method', 'rk4')
    assert says(found, "the stabilisation of the closure 'rocker_pin'")


def test_an_implicit_method_is_refused_where_the_jacobian_is_not_finite(isoc):
    """A root has no slope at zero."""
    root = '''method rk4
step 1 ms
effect orifice { joint along; effort on along = -1 N * sign(position of along) * sqrt(abs(position of along / 1 m)) }
body block { mass 1 kg }
joint slide prismatic { parent ground; child block; axis x }
effect hole orifice { along slide }
output x = position of slide
'''
    assert warnings(isoc, root) == []
    made = isoc(root, '--method', 'bdf4')
    assert made.refused and made.printed == ''
    assert re.search(":5:7: error: the Jacobian at the start is not finite: .* by 'slide' there, and bdf4 needs it", made.errors)


# --- what is stiff in contact alone is told wherever the scene starts ---

# The scene with a stiffness `hard`, its unit, and what rk4 holds of it in MN/m: k m of 8 / h^2, with two equal inertias that meet half of it;
# with the damping k c, c 0.0091 h, that an impact has at its begin it is 8.146 / h^2.
HARD = {
    'stop': ('''body block { mass 1 kg }
joint slide prismatic { parent ground; child block; axis x }
effect ends stop { along slide; lower -0.1 m; upper 0.1 m; impact 1 m/s; stiffness hard }
output x = position of slide
''', 'N/m', 8.146),
    'backlash': ('''body a { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
body b { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
joint one revolute { parent ground; child a; axis x }
joint two revolute { parent ground; child b; axis x }
effect ends backlash { motor one; load two; gap 0.2 rad; impact 1 rad/s; stiffness hard / 2 }
output x = position of one
''', 'N*m/rad', 8.146),
    'contact': ('''gravity (0, 0, -9.81) m/s^2
body ball { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint air free { parent ground; child ball; start at (0, 0, 1) m rotate 20 deg about x }
effect ends contact { ball ball; radius 5 cm; load 1 kg; impact 1 m/s; friction 0.3; stiffness hard; grip 100 N*s/m }
output x = position of ball
''', 'N/m', 8.146),
    'limit': ('''effect limiter { joint along; value top m/s; value strength N*s/m
    effort on along = -strength * (max(speed of along - top, 0) - max(-top - speed of along, 0)) }
body block { mass 1 kg }
joint slide prismatic { parent ground; child block; axis x }
effect ends limiter { along slide; top 2 m/s; strength hard * 1 s * 2.785 / 8 / 1000 }
output x = position of slide
''', 'N/m', 8)}


@pytest.mark.parametrize('kind', HARD)
def test_what_is_too_stiff_in_contact_alone_is_told_and_what_is_held_is_not(isoc, kind):
    """Silent 1 % below the limit, told 1 % above, with the place of the use."""
    text, unit, limit = HARD[kind]
    held, told = (warnings(isoc, f'method rk4\nstep 1 ms\nconstant hard = {limit * part} M{unit}\n{text}') for part in (0.99, 1.01))
    assert held == []
    assert says(told, "the effect 'ends' is too fast for rk4 with a step of 1 ms: the Jacobian where 'ends' is steepest has the eigenvalue")
    line = 4 + [line.startswith('effect ends') for line in text.splitlines()].index(True)
    assert f'{line}:8' in dict(told)


@pytest.mark.parametrize('method', METHODS)
def test_a_stop_as_stiff_as_the_step_allows_is_held(isoc, method):
    text = HARD['stop'][0].replace('; stiffness hard', '')
    assert warnings(isoc, f'method rk4\nstep 1 ms\n{text}', '--method', method) == []


MODELS = sorted(pathlib.Path('models').glob('*.scene'))


@pytest.mark.parametrize('model', MODELS, ids=lambda path: path.stem)
def test_its_own_method_and_three_others_hold_a_model(isoc, model):
    assert isoc(model, '--inputs', 'smooth').errors == ''
    for method in ('rk4', 'semi_implicit', 'bdf4'):
        assert 'too fast' not in isoc(model, '--method', method, '--inputs', 'smooth').errors


def test_abm4_pec_does_not_hold_the_arm(isoc):
    """A run leaves its range after 237 ticks."""
    assert says(warnings(isoc, pathlib.Path('models/arm6.scene'), '--method', 'abm4_pec', '--inputs', 'smooth'),
                "the spring and damping of the joint 'pitch'")
