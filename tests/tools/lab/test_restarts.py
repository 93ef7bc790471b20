"""The longest steps of the table of restarts: no other motion has a longer one. By turns one of the two kinds of
discontinuities is tried, and one of three tolerances of adams."""
import functools
import re

import pytest

from harness.plants import replaced
from harness.project import ROOT, turn
from lab import cost, counts
from lab.counts import Counts
from lab.forced import forced

TOLERANCES = '1e-4', '1e-6', '1e-8'
METHODS = 'ab4', 'abm4', 'abm4_pec', 'abm4_pecece', 'bdf4'
PENDULUM = ROOT / 'models/pendulum.scene'


def skip_unless_due(cases, case):
    now = turn(6)
    if now is not None and cases.index(case) != now % len(cases):
        pytest.skip(f'the turn is {now}')


@pytest.mark.parametrize('cause', ('announced', 'detected'))
@pytest.mark.parametrize('method', METHODS)
def test_a_restart_has_one_number_of_instructions_for_every_motion(laboratory, method, cause):
    """From the horizontal, and from 10 deg with a push."""
    skip_unless_due(('announced', 'detected'), cause)
    double = ROOT / 'models/double_pendulum.scene'
    pushed = laboratory / 'pushed.scene'
    pushed.write_text(double.read_text().replace('start 90 deg', 'start 10 deg\n    speed 3 rad/s', 1))
    one, other = (cost.longest_step(f'{scene.stem}-{method}', scene, method, cause) for scene in (double, pushed))
    assert one == other > 0


NOISE = '''\
extern real noise_size;
real noise_size = R({size});
static real noise(void)
{{
    static uint32_t bits = 1;
    bits ^= bits << 13;
    bits ^= bits >> 17;
    bits ^= bits << 5;
    return noise_size * (real)(int32_t)bits / (real)(UINT32_C(1) << (bits >> 8) % 32);
}}

'''


BACK = '''\
    if (noise_size > R(0.0)) {
        memory->x[0] = memory->x[1] = R(1.0);
    }
'''


def noisy(size):
    """Changes a plant: discontinuities, and noise of many sizes in its derivatives; where there is any, each tick begins
    at the same place, since the sum would leave the domain of the sine. Marsaglia (2003), Xorshift RNGs."""
    def change(plant):
        place = plant.index('static void derivative(')
        plant = plant[:place] + NOISE.format(size=size) + plant[place:]
        plant = replaced(r'^( *dx\[.*);$', r'\1 + noise();', forced(plant, 'announced'))
        return replaced(r'(^static void forced\([^{]*\{\n.*\n)', r'\1' + BACK, plant)
    return change


def adams(folder, *statements, change=None, seconds=2):
    text = re.sub('^method .*\n', '', PENDULUM.read_text(), flags=re.M)
    text += '\n'.join(['method adams', 'tunable forced = 1', *statements]) + '\n'
    change = change or (lambda plant: forced(plant, 'announced'))
    return Counts(folder, text, change=change, seconds=seconds).longest_step


@functools.cache
def limits():
    """What the budget used in vain takes, and with the noise itself, which takes the same in every evaluation, of size
    0; and the limits: those of a sub-step more."""
    vain, more = ['tolerance 1e-30'], ['tolerance 1e-30', 'substeps 9']
    return [(adams('vain', *of), adams('silent', *of, change=noisy('0.0'), seconds=5)) for of in (vain, more)]


def test_a_sub_step_more_is_dearer_than_the_budget_used_in_vain(laboratory):
    (vain, silent), (more, more_silent) = limits()
    assert 0 < vain < more and 0 < silent < more_silent


@pytest.mark.parametrize('tolerance', TOLERANCES)
def test_no_motion_of_adams_takes_longer(laboratory, tolerance):
    skip_unless_due(TOLERANCES, tolerance)
    (vain, _), (_, limit) = limits()
    assert 0 < adams('met', f'tolerance {tolerance}') <= vain
    for size in '1e-10', '1e-8', '1e-7':
        assert 0 < adams('noisy', f'tolerance {tolerance}', change=noisy(size), seconds=5) <= limit


class Summary:
    folder = 'build/cost/planted'

    def __init__(self, **summary):
        self.summary = summary


def test_steps_that_differ_are_refused():
    assert counts.one(Summary(instructions_per_step='65'), 'instructions_per_step') == 65
    with pytest.raises(cost.build.Wrong, match='not one instructions_per_step'):
        counts.one(Summary(instructions_per_step='65 66'), 'instructions_per_step')
    with pytest.raises(cost.build.Wrong, match='no margin'):
        counts.tick(Summary(instructions_per_step='65', step='0.001'))
    with pytest.raises(cost.build.Wrong, match='no restart_execution'):
        counts.longest_step(Summary(execution='65 65.0 65 instructions'))
