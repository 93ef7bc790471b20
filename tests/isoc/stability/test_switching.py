"""Effects that switch faster than the step follows: what isoc says of them, and by how much a jump within a step is misplaced.

A jump within a step is misplaced by up to half of it. With n steps between two jumps of J, of a quantity whose mean size is A, that is a
share of J / (2 A n). Of a voltage or an effort that is reversed it is 1 / n; of pulses over a part d of the time, with two jumps in a
period of 2 n steps, 1 / (2 d n). A current's rate is larger than the half jump, behind a jump up to twice."""
import math
import pathlib
import random
import re

import pytest

HERE = pathlib.Path('tests/isoc/stability')
SPEED = 100.0
DEFINITIONS = '''
effect winding { joint shaft; value pairs; state i A = 0 A
    rate i = (12 V * (2 * (sin(pairs * position of shaft) > 0) - 1) - 2 Ohm * i) / 2 mH }
effect cogging { joint shaft; value pairs; let n = pairs * position of shaft / pi
    effort on shaft = 1 mN*m * (1 - 2 * (floor(n) - 2 * floor(n / 2))) }
effect relay { joint shaft; value pairs; effort on shaft = 1 mN*m * sign(sin(pairs * position of shaft)) }
effect pulses { joint shaft; value level; signal wave; effort on shaft = 1 mN*m * (wave > level) }
effect chopped { state i A = 0 A; signal volts V; rate i = (volts - 2 Ohm * i) / 2 mH }
effect wall { joint shaft; value pairs
    let depth = sin(pairs * position of shaft)
    effort on shaft = if(depth > 0, 1 mN*m * depth, 0 N*m) }
'''
KINDS = ['winding', 'cogging', 'relay', 'pulses', 'chopped', 'on ticks', 'wall']


def draw(r, step, kind, i):
    """A use of the kind, its steps between two jumps, the share; 0: it is silent whatever its frequency."""
    n = 10**r.uniform(1, 2.7)
    pairs, hertz = math.pi / (n * step * SPEED), 1 / (2 * n * step)
    if kind == 'pulses':
        level = r.uniform(-0.8, 0.8)
        part = 0.5 - math.asin(level) / math.pi
        return f'input w{i} = sin({hertz:.9g} Hz)\neffect e{i} pulses {{ shaft shaft; level {level:.6f}; wave w{i} }}', n, 1 / (2 * part * n)
    if kind == 'chopped':
        return f'input w{i} V = 12 V * square({hertz:.9g} Hz)\neffect e{i} chopped {{ volts w{i} }}', n, 1 / n
    if kind == 'on ticks':
        period = 2 * r.randint(5, 100) * step
        return f'input w{i} V = 12 V * square(1 / {period:.9g} s)\neffect e{i} chopped {{ volts w{i} }}', n, 0
    return f'effect e{i} {kind} {{ shaft shaft; pairs {pairs:.9g} }}', n, 0 if kind == 'wall' else 1 / n


def family(seed, method, step_us):
    """A scene of 24 effects of random frequencies, and these."""
    r, uses, step = random.Random(f'{seed}{step_us}{method}'), [], 1e-6 * step_us
    while len(uses) < 24:
        kind = KINDS[len(uses) % 7]
        line, n, share = draw(r, step, kind, len(uses))
        if not 0.008 < share < 0.02 and n < 400:
            uses.append((kind, line, n, share))
    scene = f'step {step_us} us\nmethod {method}\n{DEFINITIONS}body b {{ mass 1 kg; inertia (1e15, 1e15, 1e15) kg*m^2 }}\n' \
        f'joint shaft revolute {{ parent ground; child b; axis z; continuous; speed {SPEED} rad/s }}\n'
    return scene + '\n'.join(line for _, line, *_ in uses) + '\noutput speed = speed of shaft\n', uses


def differs(scene, uses, errors, step_us):
    """What isoc should have said of the family and has not."""
    lines, told = scene.split('\n'), {}
    for found in re.finditer(r"scene:(\d+):8: warning: the effect 'e(\d+)' jumps every (\S+) steps .* here (\S+) %.*a step of (\S+) ms", errors):
        told[int(found[2])] = [float(found[k]) for k in (3, 4, 5)]
        if not lines[int(found[1]) - 1].startswith(f'effect e{found[2]} '):
            return f'e{found[2]} is told of at line {found[1]}'
    for i, (kind, line, n, share) in enumerate(uses):
        if (i in told) != (share > 0.01):
            return line, n, share, told.get(i)
        if i in told:
            # A window of 2000 steps has one jump more or less; a part is told to two digits.
            steps, part, longest = told[i]
            jump = n / 2000
            least = 0.45 if kind in ('winding', 'chopped') else 0.94 - jump
            if not (abs(steps / n - 1) < jump + 0.01 and least * share < part / 100 < (1.06 + 2 * jump) * share
                    and abs(longest * part / step_us - 1 / 1000) < 0.08 / 1000):
                return line, n, share, told[i]
    return None if 2 < len(told) < 22 else f'{len(told)} are told of'


@pytest.mark.parametrize('step_us', [100, 7])
@pytest.mark.parametrize('method', ['rk4', 'ab4', 'heun', 'euler'])
def test_effects_that_switch_are_told_where_half_a_step_at_a_jump_is_more_than_one_per_cent(isoc, seed, method, step_us):
    """The controls: one that is missing, and another number of steps."""
    scene, uses = family(seed, method, step_us)
    errors = isoc(scene).errors
    assert differs(scene, uses, errors, step_us) is None
    assert differs(scene, uses, errors.replace('warning: the effect', 'information: the effect', 1), step_us)
    assert differs(scene, uses, re.sub(r'jumps every \S+', 'jumps every 30.1', errors), step_us)


def misplaced(plant, method):
    """By how many steps at most a jump is misplaced: the current of a winding whose voltage is reversed by an angle, against its exact
    solution, which is an exponential between two jumps. What a jump adds to the error is the jump of the rate times that time."""
    most, decay, between = 6.0, 10.0, math.pi / 1325
    p = plant(HERE / 'winding.scene', '--method', method)
    h, jump = p.step_size, 2 * most * decay
    current = p.follow(int(400 * between / h) + 1).rows['x'][:, 1]
    exact, error, times = 0.0, 0.0, []
    for i in range(400):
        # In the middle between two jumps, on a tick, where a method with a history has settled.
        end, begins = most if i % 2 == 0 else -most, i * between
        middle = int((begins + between / 2) / h)
        found = current[middle] - end - (exact - end) * math.exp(-decay * (middle * h - begins))
        times.append(abs(found - error * math.exp(-decay * between)) / (jump * h))
        error, exact = found, end + (exact - end) * math.exp(-decay * between)
    return max(times[1:])


@pytest.mark.parametrize('method, least, most', [('rk4', 0.32, 0.335), ('heun', 0.48, 0.505), ('ab4', 0.48, 0.52), ('euler', 0.97, 1.01)])
def test_a_jump_is_misplaced_by_a_part_of_the_step(plant, method, least, most):
    """euler sees a jump at the next step, half a step late in the mean."""
    assert least <= misplaced(plant, method) <= most


def test_six_step_commutation_is_told_with_its_line_and_the_step_which_follows_it(isoc):
    said = isoc(HERE / 'six_step.scene').errors
    warning = re.search(r"six_step\.scene:36:8: warning: the effect 'motor' jumps every 29 steps of 0\.05 ms .* here 3\.4 % .* a step of 0\.015 ms", said)[0]
    assert warning in ' '.join(pathlib.Path('tools/isoc/README.md').read_text().split())
    assert "'motor' jumps every 71.4 steps" in isoc(HERE / 'six_step.scene', '--step', '20us').errors
    assert isoc(HERE / 'six_step.scene', '--step', '10us').errors == ''


@pytest.mark.parametrize('pulses', [1, 2])
def test_one_pulse_in_a_window_is_no_frequent_switching_and_two_are(isoc, pulses):
    """Of ten steps; one has two jumps."""
    said = isoc(f'''step 1 ms
body b {{ mass 1 kg; inertia (1e15, 1e15, 1e15) kg*m^2 }}
joint shaft revolute {{ parent ground; child b; axis z; speed 100 rad/s }}
effect pulse {{ joint along; value pulses; let n = floor((position of along - 5 rad) / 1 rad)
    effort on along = 1 mN*m * (n == 0 or n == 2 and pulses == 2) }}
effect e pulse {{ along shaft; pulses {pulses} }}
output rate = speed of shaft
''').errors
    assert said.count("'e' jumps every") == pulses - 1


def test_no_model_switches_so_often(isoc):
    for path in pathlib.Path('models').glob('*.scene'):
        assert 'jumps every' not in isoc(path).errors, path
