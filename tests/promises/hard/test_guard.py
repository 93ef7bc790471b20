"""Runs that go wrong end with a message of the guard that names state and tick, status 1, and the outputs of the last good
tick: explicit methods on a stiff bushing at 1 kHz; forces that are not a number, infinite, or 1e38; a state that is
driven out of range. An input that is not finite does not come so far. The plant is, but for a wheel at the end,
guarded.c: states are 0 free, 1 bushing, and their speeds 2 and 3."""
import functools
import re
import types

import numpy as np
import pytest

from harness.programs import LOOP, traced

MAIN = 'core/application/main.c'
NAMES = ['free', 'bushing', 'free_speed', 'bushing_speed']


def table(text):
    return np.array([[float(cell) for cell in line.split(',')] for line in text.splitlines()[1:]])


@pytest.fixture(scope='module')
def guarded(program, tmp_path_factory):
    """guarded(method, seconds, fault, real): a run of the plant with this fault (guarded.c)."""
    @functools.cache
    def built(method, real):
        return program('tests/promises/hard/guarded.c', MAIN, *LOOP, real=real,
                       flags=[f'-DISO_METHOD=ISO_{method.upper()}', f'-DISO_METHOD_NAME={method}'])

    def call(method, seconds, fault, real='float'):
        folder = tmp_path_factory.mktemp('run')
        done = traced(folder, built(method, real), f'{seconds}000000000', FAULT=fault)
        done.rows = table((folder / 'trace.csv').read_text())
        return done
    return call


def stopped(done, why='not finite', names=NAMES):
    """The state and the tick at which the guard ended the run. The table ends with finite outputs of the tick before, and
    the summary counts no more."""
    found = re.fullmatch(r'trace: guard state (\d+) (\w+) at tick (\d+): it is (.*)\n', done.errors)
    assert done.status == 1 and found and found[4] == why and found[2] == names[int(found[1])], done.errors
    tick = int(found[3])
    assert int(done.said['ticks']) == tick - 1 and len(done.rows) == tick and np.isfinite(done.rows[-1]).all()
    return types.SimpleNamespace(state=int(found[1]), tick=tick)


@pytest.mark.parametrize('method, real', [
    *((method, 'float') for method in 'euler heun rk4 ab4 semi_implicit abm4 abm4_pec abm4_pecece'.split()),
    ('euler', 'double'), ('rk4', 'double')])
def test_an_explicit_method_on_a_stiff_bushing_is_stopped(guarded, method, real):
    assert stopped(guarded(method, 1, '', real)).state in (1, 3)


@pytest.mark.parametrize('method', ['bdf4', 'rosenbrock'])
def test_control_an_implicit_method_runs_on_and_comes_to_rest(guarded, method):
    done = guarded(method, 1, '')
    assert done.status == 0 and done.rows[-1][2] ** 2 <= 1e-24


@pytest.mark.parametrize('fault', ['not_a_number', 'infinite'])
@pytest.mark.parametrize('method, state', [('euler', 3), ('heun', 1), ('rk4', 1), ('ab4', 3), ('semi_implicit', 1), ('abm4', 3),
                                           ('bdf4', 1), ('rosenbrock', 1)])
def test_the_state_that_shows_it_first(guarded, method, state, fault):
    """The speed alone, where the position follows from speeds that know nothing of it yet."""
    found = stopped(guarded(method, 1, f'soft bushing {fault}'))
    assert (found.state, found.tick) == (state, 101)


@pytest.mark.parametrize('fault', ['not_a_number', 'infinite'])
def test_an_input_is_held_at_its_last_good_value_and_counted(guarded, fault):
    done = guarded('rk4', 1, f'soft input {fault}')
    assert done.status == 0 and done.said['inputs_held'] == '900'
    assert done.said['hash'] == guarded('rk4', 1, 'soft').said['hash']


def follows(rows):
    """From 0.2 s on the free body's position is that of 1e38 N from 0.1 s on, to 0.1 % and what a method of order one lags
    behind."""
    rows = rows[rows[:, 0] > 0.2]
    t = rows[:, 0] - 0.1
    return len(rows) > 0 and (np.abs(rows[:, 1] / (0.5e38 * t * t) - 1) <= 0.001 + 0.001 / t).all()


@pytest.mark.parametrize('method', 'euler heun semi_implicit ab4 abm4 bdf4 rosenbrock'.split())
def test_an_enormous_force_is_followed_until_the_position_is_beyond_float(guarded, method):
    """1e38 N on 1 kg: the position passes 3.4e38 m after 2.61 s; six times a speed, the sum of a method's slopes, before."""
    done = guarded(method, 4, 'soft enormous')
    found = stopped(done)
    assert found.state == 0 and found.tick <= 2710 and follows(done.rows)


def test_six_times_the_force_is_beyond_float_so_that_rk4_stops_at_once(guarded):
    found = stopped(guarded('rk4', 4, 'soft enormous'))
    assert (found.state, found.tick) == (2, 101)
    assert follows(guarded('rk4', 4, 'soft enormous', 'double').rows), 'control: in double there is room for it'


WHEEL = '''step 1 ms
body rotor {{ mass 1 kg; com (0, 0.1, 0) m }}
joint shaft revolute {{ parent ground; child rotor; axis z; speed {} rad/s; {} }}
output angle = position of shaft
'''


@pytest.fixture
def wheel(isoc, program, tmp_path):
    """wheel(speed, option, method): a wheel that turns evenly, its angle in the sine of an unbalance."""
    def call(speed, option, method):
        made = isoc(WHEEL.format(speed, option), '--method', method, '--real', 'float')
        done = traced(tmp_path, program(made, MAIN, *LOOP), '20000000')
        done.rows = table((tmp_path / 'trace.csv').read_text())
        return done
    return call


@pytest.mark.parametrize('speed, method', [(950000, 'rk4'), (950000, 'ab4'), (950000, 'bdf4'), (950000, 'adams'), (-950000, 'rk4')])
def test_an_angle_beyond_10000_rad_is_out_of_range(wheel, speed, method):
    """950 rad in a tick: the 10th ends at 9500, the 11th at 10450 rad, beyond the domain of the sine."""
    assert stopped(wheel(speed, '', method), 'out of range', ['shaft']).tick == 11


def test_control_a_continuous_joint_turns_on(wheel):
    done = wheel(950000, 'continuous', 'rk4')
    assert done.status == 0 and done.said['ticks'] == '20'
