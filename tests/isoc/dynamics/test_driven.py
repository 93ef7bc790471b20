"""Motions and speeds that are prescribed as functions of time, and the efforts that they take, against formulas by hand, at every step of a
second; and reactions at rest, by hand."""
import pathlib
import re
import subprocess

import numpy as np
import pytest
from harness.plants import replaced

SCENE = pathlib.Path('tests/isoc/dynamics/driven.scene').read_text()
PLACES, EFFORTS = ['slider', 'lift', 'speed', 'table', 'angle', 'swing', 'mate'], ['torque', 'pull', 'drive', 'tooth', 'twist']
G, TURN = 10.0, 2 * np.pi


def rise(t, start, end):
    """The 3-4-5 polynomial of cams from 0 to 1 between two times; its rate and second derivative."""
    length = end - start
    c = np.clip((t - start) / length, 0, 1)
    return np.array([c**3 * (10 - 15 * c + 6 * c * c), 30 * c * c * (1 - c)**2 / length, 60 * c * (1 - c) * (1 - 2 * c) / length**2])


def mass_power(mass, x, y):
    """What it takes to move a mass: m (a - g) . v; of places, their rates and second derivatives."""
    return mass * (x[2] * x[1] + (y[2] + G) * y[1])


def circle(angle, of):
    """cos and sin of an angle with its derivatives, times a length."""
    c, s = np.cos(angle[0]), np.sin(angle[0])
    return (of * np.array([c, -s * angle[1], -c * angle[1]**2 - s * angle[2]]), of * np.array([s, c * angle[1], -s * angle[1]**2 + c * angle[2]]))


def wanted(t):
    """All outputs at these times; an input pushes the disc, of 2 kg m^2. The effort of the crank is its power over its speed: what moves takes
    m (a - g) . v and I alpha omega, its damper d v^2."""
    r, l, speed = 0.3, 0.5, 10 * np.pi
    theta = np.array([np.pi / 2 + speed * t, np.full_like(t, speed), np.zeros_like(t)])
    along, across = circle(theta, r)
    # l sin phi = -r sin theta, and what follows of it by differentiation.
    phi = -np.arcsin(across[0] / l)
    cosine = l * np.cos(phi)
    rate = -across[1] / cosine
    rod = np.array([phi, rate, (l * np.sin(phi) * rate**2 - across[2]) / cosine])
    slider = along + circle(rod, l)[0]
    of_rod, zero = circle(rod, 0.2), np.zeros_like(slider)
    power = (mass_power(1, *circle(theta, 0.1)) + mass_power(2, slider, zero) + mass_power(0.5, slider - of_rod[0], -of_rod[1])
             + 0.003 * rod[2] * rod[1] + 3 * slider[1]**2)
    height = 0.2 * rise(t, 0.125, 0.25) - 0.3 * rise(t, 0.25, 0.5)
    # The axle turns by the integral of its speed; a tooth of the spindle, which is -2 times as fast, pushes it back.
    axle, c = 20 * np.pi * rise(t, 0, 0.5), np.minimum(t / 0.5, 1)
    angle = 20 * np.pi * (0.5 * c**4 * (2.5 - 3 * c + c * c) + np.maximum(t - 0.5, 0))
    tooth = -2 * (0.005 * axle[1] + 0.002 * axle[0])
    w = 4 * np.pi
    return {'slider': slider[0], 'torque': power / speed, 'lift': height[0], 'pull': 2 * (height[2] + G), 'speed': axle[0], 'angle': angle,
            'mate': -2 * angle, 'tooth': tooth, 'drive': 0.02 * axle[1] + 0.01 * axle[0] - 2 * tooth,
            'table': 1.5 * t * t + 0.2 * np.cos(w * t + np.pi / 6), 'twist': 0.02 * (3 - 0.2 * w * w * np.cos(w * t + np.pi / 6)),
            'swing': (1 - 3 * rise(t, 0.1234, 0.4321)[0] + 3 * t) / 2}


def errors(p, ahead=0):
    """The largest in a second, of what is larger than 1 relative to that; where time runs so many ticks ahead."""
    ticks = round(1 / p.step_size)
    y = p.named(p.run(ticks, first=ahead)).y
    t = np.arange(1, ticks + 1) / ticks
    found = {}
    for name, want in wanted(t).items():
        off = y[name][1:].astype(float) - want + (TURN * y.turns[1:] if name == 'angle' else 0)
        off = (off + np.pi) % TURN - np.pi if name == 'mate' else off
        found[name] = (np.abs(off) / np.maximum(1, np.abs(want))).max()
    return found


def driven(plant, step, *options, scene=SCENE, real='double'):
    return plant(scene, '--step', step, *options, real=real)


@pytest.mark.parametrize('real, step, place, effort', [('float', '1ms', 1e-6, 1e-3), ('double', '125us', 1e-8, 1e-8)])
def test_motions_are_those_of_their_functions_and_efforts_those_that_they_take(plant, real, step, place, effort):
    """In double, eight digits. In float a speed keeps the roundings of the last 1/(alpha h) = 20 steps, some 10 epsilons of at most 9 m/s,
    of which the stabilisation makes 2 alpha times that: 6e-4 N or N m, of 0.6 kg at the crank and 2 kg in the lift. The control has time
    that runs a tick ahead."""
    p = driven(plant, step, real=real)
    most = {**dict.fromkeys(PLACES, place), **dict.fromkeys(EFFORTS, effort)}
    off, ahead = errors(p), errors(p, 1)
    assert {name for name in most if not off[name] <= most[name]} == set()
    assert {name for name in most if not ahead[name] > most[name]} == set()


@pytest.mark.parametrize('real, step, most', [('float', '1ms', 1e-6), ('double', '125us', 1e-8)])
def test_a_day_later_the_slider_is_where_it_was(plant, real, step, most):
    """The crank has turned a whole number of times; the states that are time are the tick's, and no sum of steps."""
    crank = SCENE.split('body cage')[0] + 'stabilisation baumgarte { alpha 50 Hz; beta 50 Hz }\noutput slider = position of guide\n'
    p = driven(plant, step, scene=crank.replace('tunable gain = 2\n', ''), real=real)
    ticks = round(1 / p.step_size)
    slider = p.run(ticks, first=86400 * ticks)['y'][1:, 0]
    assert np.abs(slider - wanted(np.arange(1, ticks + 1) / ticks)['slider']).max() <= most


@pytest.mark.parametrize('method, order, steps, names', [
    ('rk4', 4, ('250us', '125us'), ['slider', 'lift', 'pull', 'speed', 'twist']), ('abm4', 4, ('500us', '250us'), ['slider', 'table', 'twist']),
    ('ab4', 4, ('250us', '125us'), ['table', 'twist']), ('bdf4', 4, ('500us', '250us'), ['slider', 'table', 'twist']),
    ('rosenbrock', 3, ('500us', '250us'), ['slider', 'table', 'twist'])])
def test_each_method_has_its_order(plant, method, order, steps, names):
    """Half the step divides an error by 2^order, to a quarter of that. The curvature of a ramp has corners at its points. Steps that end
    there keep the order of a one-step method that does not look ahead; any other has order four, or three, only where there are none."""
    whole, half = (errors(driven(plant, step, '--method', method)) for step in steps)
    for name in names:
        assert 0.75 * 2**order < whole[name] / half[name] < 1.25 * 2**order, name


def test_a_ramp_whose_points_lie_between_the_steps_is_off(plant):
    assert errors(driven(plant, '160us'))['lift'] > 100 * errors(driven(plant, '250us'))['lift']


@pytest.mark.parametrize('ratio, least, most', [('-2', 0, 1e-8), ('-2.0000001', 0.009, 0.011)])
def test_a_gear_of_whole_numbers_holds_the_angles_of_continuous_joints(plant, ratio, least, most):
    """Up to whole turns; any other only their speeds, so that what is pulled off, by 0.01 rad, stays off. In the second after, the
    stabilisation, with 50/s, takes what is pulled back by a factor of 1e20."""
    p = driven(plant, '250us', scene=SCENE.replace('ratio -2 ', f'ratio {ratio} '))
    ticks = round(1 / p.step_size)
    p.run(ticks)
    p.now['x'][0, p.places['x']['spindle']] += 0.01
    y = p.named(p.go(ticks, first=ticks)[0]).y
    off = (y.mate[-1] - wanted(np.array([2.0]))['mate'][0] + np.pi) % TURN - np.pi
    assert least <= abs(off) <= most


METHODS = re.findall(r'^\| ([a-z0-9_]+) \| \d ', subprocess.run(['build/isoc', '--methods'], capture_output=True, text=True).stdout, re.M)
OWN_GAINS = replaced('^stabilisation.*', 'stabilisation baumgarte', SCENE)


@pytest.mark.parametrize('method', METHODS)
def test_no_method_is_unstable_with_gains_that_follow_the_step(plant, method):
    """Euler's speed, at up to 240 rad/s^2, lags by that many rad/s times 1 ms; what grows passes any limit."""
    assert errors(driven(plant, '1ms', '--method', method, scene=OWN_GAINS))['speed'] <= 0.24


def test_twice_the_gain_is_too_much_for_the_method_that_is_least_stable(plant):
    strong = driven(plant, '1ms', '--method', 'abm4_pec', scene=replaced('^stabilisation.*', 'stabilisation baumgarte { alpha 200 Hz; beta 100 Hz }', SCENE))
    rows, ended = strong.start() or strong.go(1000)
    assert ended < 1000 or not errors(strong)['speed'] <= 0.24


# What the outputs of statics.scene are, by hand, and why.
STATICS = [
    ('rope', [0, 0, 20], 'a weight of 2 kg hangs'), ('wall', [0, 0, 40], 'a wall bears a beam of 3 kg with a lamp of 1 kg'),
    ('wall_moment', [0, -25, 0], 'their moment, 0.5 m and 1 m out'), ('bracket', [0, 0, 10], 'the lamp alone'),
    ('bracket_moment', [0, 0, 0], 'the lamp has no lever'), ('sling', [10, 0, 5], 'a stone is whirled along x: m r omega^2 inwards'),
    ('sling_moment', [0, 1, 0], "the stone's weight at its lever"), ('shaft', 10, "a driven rotor's weight"),
    ('shaft_moment', 3, 'the torque that drives it'), ('left', [0, 0, 30], 'a bridge of 4 kg, three quarters on the nearer support'),
    ('right', [0, 0, 10], 'and a quarter on the other'), ('hoist', 20, 'a gear lifts 2 kg evenly'),
    ('motor', 3, 'its motor, at a lever of 0.1 m, turns at 2 rad/s against 0.5 N m s/rad'),
    ('motor_moment', 0, 'the motor less the damping and the gear: nothing is sped up')]


@pytest.mark.parametrize('real', ['float', 'double'])
def test_reactions_at_rest_are_those_by_hand(plant, real):
    """Sums of some ten products of numbers up to 40."""
    p = plant(pathlib.Path('tests/isoc/dynamics/statics.scene'), real=real)
    y = p.follow(1).y
    assert sum(np.size(value) for _, value, _ in STATICS) == len(p.places['y'])
    for name, value, why in STATICS:
        assert np.abs(y[name][0] - value).max() <= 16 * 40 * p.ulp, why
