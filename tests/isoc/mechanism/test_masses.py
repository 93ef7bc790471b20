"""Masses that states of effects give: fuel that burns, a tank that is filled. What leaves has the velocity of the body there."""
import math
import random

import numpy as np
import pytest

ROCKET = '''
gravity (0, 0, -9.81) m/s^2
step 10 ms
body rocket { mass 1 kg + tank.fuel }
joint up prismatic { parent ground; child rocket; axis z }
effect engine {
    joint along
    value flow kg/s
    value speed m/s
    state fuel kg = 2 kg
    rate fuel = -flow
    effort on along = flow * speed
    work = flow * speed * speed of along
    loss = 0 W
    output fuel
}
effect tank engine { along up; flow 0.8 kg/s; speed 60 m/s }
output rate = speed of up
output balance = balance
'''


def test_rocket(plant):
    """Tsiolkovsky's equation, to rk4's error: (h / 1.5 s)^5 of a step, 200 of them, of 60 m/s."""
    rows = plant(ROCKET).outputs(200)
    want = 60 * math.log(3 / (3 - 0.8 * 2)) - 9.81 * 2
    assert rows.rate[-1] == pytest.approx(want, abs=1e-7) and np.abs(rows.balance).max() < 1e-10
    other = 60 * math.log(3 / (3 - 0.8 * 2.01)) - 9.81 * 2
    assert abs(rows.rate[-1] - other) > 1e-3  # the control


def test_bits_of_the_board(isochron, tmp_path):
    scene = tmp_path / 'rocket.scene'
    scene.write_text(ROCKET)
    host, board = (isochron('run', scene, '--target', target, '--seconds', '1').said for target in ('host', 'cortex-m4f'))
    assert host['hash'] == board['hash'] and len(board['instructions_per_step'].split()) == 1


FILLING = '''
effect filling { value first kg; value flow kg/s; state m kg = first; rate m = flow; output m }
'''


def mechanism(seed, closed):
    """A random chain of solids, or a loop in a plane; {i} stands for the mass of body i, the start of its speeds is given."""
    r = random.Random(seed)

    def vector(size):
        return '(' + ', '.join(f'{r.uniform(-size, size):.4f}' for _ in range(3)) + ')'
    lines, parent = ['gravity (1, -9, 3) m/s^2', 'step 1 ms'], 'ground'
    if closed:
        for i, (length, start) in enumerate(((0.1, 'start 90 deg; speed 20 rad/s'), (0.26, 'start about -67 deg'))):
            lines.append(f'body b{i} {{ rod {length} m of {{{i}}} at ({length / 2}, 0, 0) m rotate 90 deg about y }}')
            at = '' if i == 0 else ' at (0.1, 0, 0) m'
            lines.append(f'joint j{i} revolute {{ parent {parent}{at}; child b{i}; axis z; {start} }}')
            parent = f'b{i}'
        lines.append('body b2 { rod 0.25 m of {2} at (0.125, 0, 0) m rotate 90 deg about y }')
        lines.append('joint j2 revolute { parent ground at (0.39, 0, 0) m; child b2; axis z; start about 127 deg }')
        lines.append('close pin line { parent b2 at (0.25, 0, 0) m; child b1 at (0.26, 0, 0) m; axis z }')
        count = 3
    else:
        count = r.randint(2, 4)
        for i in range(count):
            shape = r.choice(('box (0.3, 0.2, 0.1) m', 'sphere 0.1 m', 'rod 0.4 m'))
            lines.append(f'body b{i} {{ {shape} of {{{i}}} at {vector(0.3)} m; sphere 0.05 m of 0.3 kg at {vector(0.3)} m }}')
            kind = r.choice(('revolute', 'prismatic', 'spherical'))
            moves = {'revolute': 'axis %s; start %.3f deg; speed %.3f rad/s', 'prismatic': 'axis %s; start %.3f cm; speed %.3f m/s',
                     'spherical': 'spin %s rad/s'}[kind]
            moves = moves % ((vector(1),) if kind == 'spherical' else (vector(1), r.uniform(-50, 50), r.uniform(-3, 3)))
            lines.append(f'joint j{i} {kind} {{ parent {parent} at {vector(0.5)} m; child b{i}; {moves} }}')
            parent = f'b{i}'
    shown = [f'output a{i} = {"acceleration of j%d" % i if closed else "specific_force of b%d" % i}' for i in range(count)]
    masses = [(r.uniform(0.5, 3), r.uniform(-1, 1)) for _ in range(count)]
    return '\n'.join(lines + shown + ['output balance = balance', 'output force = force of j0']) + '\n', masses


def varied(text, masses):
    uses = ''.join(f'effect e{i} filling {{ first {first!r} kg; flow {flow!r} kg/s }}\n' for i, (first, flow) in enumerate(masses))
    return replaced(text, [f'e{i}.m' for i in range(len(masses))]) + FILLING + uses


def replaced(text, masses):
    for i, mass in enumerate(masses):
        text = text.replace('{%d}' % i, mass)
    return text


@pytest.mark.seeds(8)
@pytest.mark.parametrize('closed', [False, True])
def test_a_mechanism_accelerates_as_one_of_these_masses(plant, seed, closed):
    """Row 0, by every formulation; and the account of energy is closed while the masses change."""
    text, masses = mechanism(seed, closed)
    still = plant(replaced(text, [f'{first!r} kg' for first, _ in masses])).outputs(1)
    for options in ([],) if closed else (['--formulation', 'composite'], ['--formulation', 'articulated']):
        p = plant(varied(text, masses), *options)
        rows = p.outputs(50)
        size = np.abs(still.rows[0]).max()
        names = [name != 'balance' for name in p.names]
        np.testing.assert_allclose(rows.rows[0, names], still.rows[0, names], atol=1e-11 * size)
        power = size * size * sum(first for first, _ in masses)
        assert np.abs(rows.balance).max() < 1e-11 * power
        heavier = plant(varied(text, [(first + 0.01, flow) for first, flow in masses]), *options).outputs(1)
        assert np.abs(heavier.rows[0, names] - still.rows[0, names]).max() > 1e-6  # the control


@pytest.mark.parametrize('closed', [False, True])
@pytest.mark.parametrize('method, order', [('heun', 2), ('ab4', 4), ('rosenbrock', 3), ('bdf4', 4)])
def test_methods_keep_their_order(plant, method, order, closed):
    """Against rk4 in steps of a sixteenth: an implicit method whose Jacobian left out the masses would lose its order."""
    text, masses = mechanism(3, closed)
    scene = varied(text, masses)
    exact = plant(scene, '--step', '125us').run(1600, every=1600)['x'][-1]
    errors = [np.abs(plant(scene, '--method', method, '--step', f'{us}us').run(200000 // us, every=200000 // us)['x'][-1] - exact).max()
              for us in (1000, 500)]
    assert math.log2(errors[0] / errors[1]) > order - 0.5, errors


@pytest.mark.parametrize('change, says', [
    (('mass 1 kg + tank.fuel', 'mass s'), 'let a state follow that'),
    (('mass 1 kg + tank.fuel', 'mass 1 kg * (2 + sin(tank.fuel / 1 s))'), 'unit'),
    (('mass 1 kg + tank.fuel', 'mass 1 m + tank.fuel'), 'cannot be added'),
    (('mass 1 kg + tank.fuel', 'mass 1 kg + tank.full'), "has no output 'full'"),
    (('state fuel kg = 2 kg', 'state fuel kg = 2 kg + 1 kg / 1 m * position of along'), 'it starts with constants and tunables')])
def test_refused(isoc, change, says):
    made = isoc(ROCKET.replace(*change) + 'signal s = 2 kg + 1 kg/s * time\n')
    assert made.refused and says in made.errors, made.errors


def test_mujoco_is_told_the_mass_at_the_start(isoc):
    printed = isoc(ROCKET, '--mjcf', writes=False).printed
    assert 'mass="3"' in printed and 'how masses change' in printed


def test_the_inertia_of_a_joint_is_that_of_the_start(isoc):
    stop = 'effect s stop { along up; lower -1 m; upper 50 m; impact 3 m/s }\n'
    stable = [isoc(text + stop).summary['stable'] for text in (ROCKET, ROCKET.replace('1 kg + tank.fuel', '3 kg'))]
    assert stable[0] == stable[1]
