"""States whose derivative is one number throughout a step (steady, core/methods/equations.h): isoc finds those of bodies that nothing
accelerates, and no others; and they move as these say."""
import re

import numpy as np
import pytest
from harness.plants import replaced

BODY = 'output energy = energy\nbody b { mass 2 kg; inertia (1, 2, 3) kg*m^2 }\n'
FREE = BODY + 'joint space free { parent ground; child b; speed (0.1, -0.3, 0.7) m/s; spin (0.01, 5, 0.01) rad/s }\n'


def slide(more=''):
    return f'{BODY}joint rail prismatic {{ parent ground; child b; axis x; start 0.1 m; speed 0.3 m/s{more} }}\n'


PLACES = {'space_x', 'space_y', 'space_z'}


def steady_of(text):
    table = re.search(r'^static const bool steady.*\n((?:    \[PLANT_X_\w+\] = true,\n)*)', text, re.M)
    return {name.lower() for name in re.findall(r'PLANT_X_(\w+)', table[1])} if table else set()


def moves_steadily(p, names):
    """Whether the derivatives keep their bits, and the states are where these take them: a step rounds its product and its sum, each of
    at most the largest size on the way."""
    ticks = 2000
    rows = p.follow(ticks).rows
    slopes = p.slopes_at(rows, rows['x'])[0]
    for place in (p.places['x'][name] for name in names):
        begin, moved = float(rows['x'][0, place]), ticks * p.step_size * float(slopes[0, place])
        if (slopes[:, place] != slopes[0, place]).any() or \
                abs(rows['x'][-1, place] - begin - moved) > ticks * p.ulp * (abs(begin) + abs(moved)):
            return False
    return True


@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('scene, method, found', [(FREE, 'rk4', PLACES), (FREE, 'heun', PLACES), (slide(''), 'rk4', {'rail'})])
def test_what_nothing_accelerates_moves_steadily(plant, scene, method, found, real):
    p = plant(f'step 1 ms\nmethod {method}\n{scene}', real=real)
    assert steady_of(p.made.file('plant.c')) == found and moves_steadily(p, found)
    assert not moves_steadily(p, {'space_turn_x_speed'}) if scene is FREE else True, 'found: a state that does not'


@pytest.mark.parametrize('scene, method, found', [
    ('gravity (0, 0, -9.81) m/s^2\n' + FREE, 'rk4', {'space_x', 'space_y'}), (slide('; damping 1 N*s/m'), 'rk4', set()),
    ('input push\n' + slide('; drive push'), 'rk4', set()), (FREE + 'effect air drag { on b; area 1 m^2 }\n', 'rk4', set()),
    (FREE, 'euler', set()), (FREE, 'ab4', set()), (FREE, 'bdf4', set())])
def test_no_others_are_steady(isoc, scene, method, found):
    assert steady_of(isoc(f'step 1 ms\nmethod {method}\n{scene}').file('plant.c')) == found


def test_a_spin_that_is_called_steady_is_found(plant):
    def called(text):
        return replaced('^static const bool steady.*$', r'\g<0>\n    [PLANT_X_SPACE_TURN_X_SPEED] = true,', text)

    p = plant(f'step 1 ms\nmethod rk4\n{FREE}', change=called)
    assert np.isfinite(p.follow(10).rows['x']).all() and not moves_steadily(p, {'space_turn_x_speed'})
