"""Tunables keep the conditions of the effects and functions that use them: at their defaults and where the scene sets them isoc sees
to it, in a run the plant."""
import pathlib
import random
import re

import numpy as np
import pytest
from harness.plants import other_effect

SCENE = pathlib.Path('tests/isoc/plant/tunables/conditions.scene').read_text()
NAMES = ['hard', 'bounce', 'top', 'free']


def followed(plant, seed, scene, *options, real='double'):
    """Random changes in each of 2000 ticks, some of which break a condition: whether the plant goes on with those that keep all, and
    with what it had in the place of others; how many are taken, and how many it counts as refused and should."""
    p, r = plant(scene, *options, real=real), random.Random(seed)
    p.start()
    places = [p.places['p'][name] for name in NAMES]
    kept, good, refused, is_same = p.now['p'][0].copy(), 0, 0, p.now['p'][0, places[0]] == 20000
    for tick in range(2000):
        values = [r.uniform(-2e3, 2e4), r.uniform(-0.1, 1.1), r.uniform(0, 5), 0.0 if tick % 7 == 0 else r.uniform(0.1, 2)]
        hard, bounce, top, free = map(p.number, values)
        p.now['p'][0, places] = values
        if hard > 0 and p.number(0.01) <= bounce <= 1 and top >= bounce and free > 0:
            kept, good = p.now['p'][0].copy(), good + 1
        else:
            refused += 1
        assert p.go(1, first=tick)[1] == 1, 'the plant goes on'
        is_same = is_same and np.array_equal(kept, p.now['p'][0])
    facts = p.facts
    return is_same and facts.parameters_held == refused and facts.parameters_clamped == facts.outputs_held == 0, good, refused


@pytest.mark.parametrize('real', ['double', 'float'])
@pytest.mark.parametrize('method', ['rk4', 'ab4'])
def test_a_change_that_breaks_a_condition_is_refused_with_all_of_its_tick_and_counted_once(plant, seed, method, real):
    holds, good, refused = followed(plant, seed, SCENE, '--method', method, real=real)
    assert holds and good > 100 and refused > 100


def test_an_effect_and_a_scene_without_these_conditions_are_found(plant):
    assert not followed(plant, 1, other_effect('stop', ' and stiffness > 0', '') + SCENE.replace('log(free)', '0'))[0]


@pytest.mark.parametrize('line, message, change', [
    ('at 1 s set hard = -1 N/m', '-1 is not above 0', None), ('at 1 s set bounce = 0', '0 is not at least 0.01', None),
    ('at 1 s set free = 0', '0 is not above 0', None),
    ('at 1 s set top = 0.7 m; at 2 s set bounce = 0.8', '0.7 is not at least 0.8', None),
    ('', "'ends' breaks what its effect requires", ('20 kN', '-20 kN')),
    ('', 'log takes a number larger than zero', ('free = 3', 'free = 0')),
    ('', 'the limits are in the wrong order', ('top = 1 m', 'top = 0.4 m'))])
def test_a_scene_that_breaks_a_condition_is_refused(isoc, line, message, change):
    made = isoc(f'{SCENE.replace(*change) if change else SCENE}{line}\n')
    assert made.refused and re.search(rf'scene:\d+:\d+: error: .*{message}', made.errors), made.errors


JOINT = 'joint j revolute { parent ground; child b; axis z; start 10 deg }'
BODY = f'body b {{ mass 1 kg; com (0, -1, 0) m }}; {JOINT}'


@pytest.mark.parametrize('unit, bad, statements', [
    ('kg', 0, f'body b {{ mass number; com (0, -1, 0) m }}; {JOINT}'), ('kg', -1, f'body b {{ sphere 5 cm of number at (0, -1, 0) m }}; {JOINT}'),
    ('m', -1, f'body b {{ box (number, 1 m, 1 m) of 2 kg }}; {JOINT}'),
    ('kg*m^2', -1, f'body b {{ mass 1 kg; inertia (number, number, number) }}; {JOINT}'),
    ('N*m*s/rad', -1, 'joint j revolute { parent ground; child b; axis z; damping number }; body b { mass 1 kg; com (0, -1, 0) m }'),
    ('N/m', -1, f'spring s {{ between ground at (1, 1, 0) m and b; stiffness number; length 1 m }}; {BODY}'),
    ('N*s/m', -1, f'spring s {{ between ground at (1, 1, 0) m and b; damping number }}; {BODY}'),
    ('m', -1, f'spring s {{ between ground at (1, 1, 0) m and b; stiffness 1 N/m; length number }}; {BODY}')])
def test_what_bodies_joints_and_springs_require_holds_for_a_change(isoc, unit, bad, statements):
    """A tunable that any of them reads may not be set to what it may not be by default."""
    scene = f'step 1 ms\ntunable number = 2 {unit}\noutput angle = position of j\n{statements}\n'
    assert 'broken(memory)' in isoc(scene).file('plant.c')
    made = isoc(scene + f'at 1 s set number = {bad} {unit}\n')
    assert made.refused
    assert re.search(rf'scene:\d+:\d+: error: this breaks a condition of the formulas: {bad} is not (at least|above) 0', made.errors), made.errors


def test_a_condition_that_only_the_rounding_of_a_float_breaks_is_refused(isoc):
    scene = f'''step 1 ms
tunable share = 0.01
{BODY}
effect e push {{ j j; share share }}
effect push {{ joint j; value share; require share * 2.9 <= 0.029; effort on j = share * (1 N*m) }}
output angle = position of j
'''
    assert isoc(scene, '--real', 'double').status == 0
    made = isoc(scene, '--real', 'float')
    assert made.refused and "scene:2:9: error: a condition on 'share' holds at the defaults, but not as a float rounds it" in made.errors
