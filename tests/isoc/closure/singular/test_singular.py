"""Closed loops near singular positions: no run gains or loses energy without a word. Loops that a seeded generator draws, in double and in
float: either the energy stays within a bound of it, or the run tells of a singular position; with `near hold` it stays in either case."""
import functools
import pathlib
import re

import numpy as np
import pytest
from draw import drawn

HERE = pathlib.Path('tests/isoc/closure/singular')
NEAR = (HERE / 'near_dead.scene').read_text()
# What a run that tells nothing may lose in 5 s in double: rk4 loses up to 3e-4 of it in a passing in which the pivots change by a factor of
# 1.25 in a step, the most that is not told. The float adds its rounding, a few ulp of 1.0 in each of the steps at random: 5000^0.5 * 10 * 6e-8.
BOUND = {'double': 1e-3, 'float': 1.05e-3}
# With `near hold` the steps that are told lose nothing; those beside each of them, which are not, up to a part of 1e-4.
BESIDE = 1e-4
HOLD = 'projection { near hold }'


class Passing:
    """A run in its own steps: the largest change of the energy, its first output, over that of the start; the ticks that were told as near a
    singular position; and the guard's last word."""

    def __init__(self, plant, scene, real, stabilisation, seconds=5, formulation=None):
        options = ['--formulation', formulation] if formulation else []
        p = plant(re.sub('^stabilisation.*\n', '', scene, flags=re.M) + f'\nstabilisation {stabilisation}\n', *options, real=real)
        p.start()
        energy = p.go(round(seconds / p.step_size))[0]['y'][:, 0].astype(float)
        self.change, self.told = np.abs(energy / energy[0] - 1).max(), p.facts.near_singular
        self.guard = {p.states: 'good', p.states + 1: 'near'}.get(p.facts.guard, 'bad')

    def stays(self, bound, each=0.0):
        return self.guard != 'bad' and self.change <= bound + each * self.told


@pytest.fixture(scope='module')
def passing(plant):
    """passing(number, real): the run of a drawn loop, made once."""
    return functools.cache(lambda number, real: Passing(plant, drawn(number), real, 'projection'))


@pytest.mark.parametrize('real', ['double', 'float'])
@pytest.mark.parametrize('number', range(40))
def test_no_drawn_loop_loses_energy_without_a_word(plant, passing, number, real):
    run = passing(number, real)
    assert run.stays(BOUND[real]) or run.told
    if run.told:
        held = Passing(plant, drawn(number), real, HOLD)
        assert held.stays(BOUND[real], BESIDE) and held.guard == 'good'


def test_without_the_watch_some_of_these_runs_are_wrong_without_a_word(passing):
    runs = [passing(number, 'double') for number in range(40)]
    wrong = sum(not run.stays(BOUND['double']) for run in runs)
    assert 0 < wrong <= sum(run.told > 0 for run in runs)


def test_near_a_dead_position_energy_is_lost_and_told_held_resolved_or_stopped(plant):
    """The four-bar whose follower is 0.1 mm longer than its crank, at 1 ms; then in steps that resolve the passing."""
    lost, held = Passing(plant, NEAR, 'double', 'projection'), Passing(plant, NEAR, 'double', HOLD)
    assert not lost.stays(BOUND['double']) and lost.told and held.stays(1e-5) and held.told
    short = Passing(plant, re.sub('^(step .*)$', r'\1\nsubsteps 8', NEAR, flags=re.M), 'double', 'projection')
    assert short.stays(BOUND['double']) and not short.told
    stopped = Passing(plant, NEAR, 'double', 'projection { near stop }')
    assert stopped.guard == 'near' and stopped.stays(BOUND['double'])


FLAT = re.sub('^stabilisation.*\n', '', pathlib.Path('models/parallelogram.scene').read_text(), flags=re.M)


@pytest.mark.parametrize('stabilisation, finite', [(HOLD, 25), ('lagrangian', 25), ('projection { near count }', 0)])
def test_through_the_singular_position_itself(plant, stabilisation, finite):
    """The parallelogram in float, from 25 speeds of its start that grow to 1.6 times theirs, for 20 s; without a hold none stays finite."""
    p = plant(f'{FLAT}stabilisation {stabilisation}\n', real='float')
    stay = 0
    for k in range(25):
        p.start()
        p.now['x'][0, (p.states + 1) // 2:] *= 1 + 0.6 * k / 25
        p.library.rig_output()
        stay += p.go(round(20 / p.step_size), every=1000)[1] == round(20 / p.step_size)
    assert stay == finite


def test_a_run_tells_of_it_in_its_summary_and_ends_with_near_stop(isochron, tmp_path):
    (tmp_path / 'flat.scene').write_text(FLAT)
    told = isochron('run', tmp_path / 'flat.scene', '--seconds', '5').said['near_singular']
    assert re.fullmatch(r'\d* from 0\.\d* s in follower_pin', told)
    (tmp_path / 'stop.scene').write_text(FLAT + 'stabilisation projection { near stop }\n')
    stopped = isochron('run', tmp_path / 'stop.scene', '--seconds', '5')
    assert stopped.status and re.search(r'^trace: guard at tick \d*: near a singular position of closure follower_pin$', stopped.errors, re.M)


@pytest.mark.parametrize('name, real, seconds', [('random_loop_5', 'double', 100), ('random_tree_0', 'float', 5), ('random_tree_0', 'double', 5)])
def test_mechanisms_of_another_generator(plant, name, real, seconds):
    """A loop that gained 28 times its energy in 100 s without a word, and a tree with a gear, of many freedoms, in float."""
    run = Passing(plant, (HERE / f'{name}.scene').read_text(), real, 'projection', seconds)
    assert run.stays(BOUND[real]) or run.told


@pytest.mark.parametrize('real', ['double', 'float'])
def test_legs_have_one_quantity_that_is_watched(plant, real):
    """In the place of their pivots, as they are eliminated one by one. Of twelve light fingers the product of all pivots would leave the range of
    float."""
    legs, hand = ((HERE / f'{name}.scene').read_text() for name in ('two_legs', 'hand'))
    lost, held = (Passing(plant, legs, real, kind, formulation='legs') for kind in ('projection', HOLD))
    assert not lost.stays(BOUND[real]) and lost.told
    assert held.stays(BOUND[real], BESIDE) and held.told
    fingers = Passing(plant, hand, real, 'projection', formulation='legs')
    assert fingers.stays(BOUND[real]) and not fingers.told


@pytest.mark.parametrize('mass', ['1e-9', '1', '1e9'])
def test_six_pivots_of_closures_of_light_or_heavy_bodies(plant, mass):
    """Their product as it is would leave the range of float."""
    scaled = pathlib.Path('models/bricard.scene').read_text().replace('1 kg', f'{mass} kg')
    run = Passing(plant, scaled, 'float', 'lagrangian', 2)
    assert run.guard == 'good' and not run.told


def test_what_cannot_be_held_is_refused_and_the_option_may_be_left_out(isoc):
    bare = re.sub('^stabilisation.*\n', '', NEAR, flags=re.M)
    for kind in ('projection { iterations 2 }', 'lagrangian { penalty 1e5 kg }'):
        assert isoc(f'{bare}\nstabilisation {kind}\n').status == 0
    motion = pathlib.Path('tests/core/methods/compensated/driven.scene').read_text()
    for scene, message in [(re.sub('^method.*\n', '', bare, flags=re.M) + f'\nmethod ab4\nstabilisation {HOLD}\n', 'near hold needs a method without a history'),
                           (motion + f'stabilisation {HOLD}\n', "near hold needs closures that do no work: 'drive' is a motion"),
                           (bare + '\nstabilisation lagrangian { omega 10 Hz; near stop }\n', 'only a projection watches for singular positions')]:
        made = isoc(scene)
        assert made.refused and message in made.errors


@pytest.mark.parametrize('kind', [0, 1, 2])
def test_far_from_singular_positions_nothing_is_told(plant, kind):
    run = Passing(plant, drawn(kind, 0.3), 'double', 'projection')
    assert run.stays(BOUND['double']) and not run.told
