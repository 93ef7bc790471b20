"""A joint that turns without limit and may turn far in a step: later stages of a method take its sines from earlier
ones (core/methods/explicit.h), at any speed as exactly as from the angle.

A slide is pushed by k (sin^2 + cos^2) of the rotor's angle, which is k, and another one by k sin of it. The rotor turns
at a constant speed, so that the exact values at the stages are known: those of the method, with the sines of numpy.
"""
import math
import pathlib
import random
import re

import numpy as np
import pytest

SCENE = '''gravity (0, 0, 0) m/s^2
step 1 ms
method {method}
body rotor {{ mass 1 kg; inertia (1, 1, 1) kg*m^2 }}
body one {{ mass 1 kg }}
body two {{ mass 1 kg }}
joint axle revolute {{ parent ground; child rotor; axis z; continuous; start {start!r} rad; speed {speed!r} rad/s }}
joint steady prismatic {{ parent ground; child one; axis x }}
joint shaken prismatic {{ parent ground; child two; axis y }}
effect push {{
    joint on
    joint by
    effort on on = 4 N * (sin(position of by)^2 + cos(position of by)^2)
}}
effect shake {{
    joint on
    joint by
    effort on on = 4 N * sin(position of by)
}}
effect pushed push {{ on steady; by axle }}
effect shaking shake {{ on shaken; by axle }}
output push = speed of steady
output shake = speed of shaken
output angle = position of axle
'''
# The weights of the stages' sines, by their times in the step.
WEIGHTS = {'heun': {0: 1 / 2, 1: 1 / 2}, 'rk4': {0: 1 / 6, 0.5: 4 / 6, 1: 1 / 6}}
TICKS, STEP = 50, 1e-3


def errors(plant, method, real, start, speed, change=None):
    """By how much the speeds are off at most, in epsilons of their number type over the steps and 4 N."""
    rows = plant(SCENE.format(method=method, start=start, speed=speed), real=real, change=change).outputs(TICKS)
    ticks = np.arange(TICKS + 1)
    angle = start + speed * STEP * ticks
    shakes = sum(weight * np.sin(angle + at * speed * STEP) for at, weight in WEIGHTS[method].items())
    shake = 4 * STEP * np.concatenate([[0], np.cumsum(shakes)[:-1]])
    scale = 4 * STEP * TICKS * np.finfo('f4' if real == 'float' else 'f8').eps
    return (np.abs(rows.push.astype(float) - 4 * STEP * ticks).max() / scale, np.abs(rows.shake.astype(float) - shake).max() / scale)


@pytest.mark.seeds(4, 2)
@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('method', sorted(WEIGHTS))
def test_any_speed(plant, method, real, seed):
    """From a thousandth of a turn in a step to three turns. The angle is exact to an epsilon of pi, and so far off are
    its sines; each stage adds a few roundings. The reference itself rounds the way in double."""
    chance = random.Random(seed)
    for turns in (0.001, 0.03, 0.3, 0.5, 1.0, 3.0):
        speed = chance.choice((-1, 1)) * turns * chance.uniform(0.8, 1.0) * 2 * math.pi / STEP
        if real == 'float':
            speed = float(np.float32(speed))
        start = float(np.float32(chance.uniform(-3, 3)))
        push, shake = errors(plant, method, real, start, speed)
        assert push < 8, f'{turns} turns in a step: the sum of squares is off by {push:.3g}'
        assert shake < 8 * (1 + abs(speed) * STEP), f'{turns} turns in a step: the sine is off by {shake:.3g}'


def test_found(plant):
    """Control: the sines of a joint that turns little are wrong at half a turn in a step, and right at a hundredth of a
    radian."""
    flag = re.compile(r'static const bool spins\[\d+\] = \{true')
    little = lambda text: flag.sub('static const bool spins[1] = {false', text)
    for real in ('float', 'double'):
        assert errors(plant, 'rk4', real, 1.0, 3000.0, change=little)[0] > 100
    assert errors(plant, 'rk4', 'float', 1.0, 10.0, change=little)[0] < 8


GEARED = '''gravity (0, 0, 0) m/s^2
step 1 ms
method rk4
body one { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
body two { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
joint first revolute { parent ground; child one; axis z; continuous; start 0 rad; speed 40 rad/s }
joint second revolute { parent ground at (1, 0, 0) m; child two; axis z; continuous; speed 20 rad/s }
close pair gear { first first; second second; ratio 2 }
output angle = position of first
'''


def test_rests(isoc):
    """What rounding takes from an angle is kept where it can turn steadily, not where the projection of a loop of bodies
    sets it."""
    kept = {name: len(re.findall(r'^    iso_turn\(', isoc(scene).file('plant.c'), flags=re.M)) for name, scene in (
        ('rotor', pathlib.Path('tests/promises/hard/rotor.scene')), ('four_bar', pathlib.Path('models/four_bar.scene')),
        ('geared', GEARED))}
    assert kept == {'rotor': 1, 'four_bar': 0, 'geared': 2}
