"""What isoc says of effects that are too fast for the step: of what the motion comes to, and nothing of rounding."""
import math
import pathlib
import random

import pytest

BOX = '''
gravity (0, 0, -9.81) m/s^2
step 1 ms
method rk4
body box {{ box ({0!r}, {1!r}, {2!r}) cm of {3!r} kg }}
joint air free {{ parent ground; child box; start at (0, 0, 0.5) m rotate {4!r} deg about ({5!r}, 2, {6!r}); spin (3, 1, 2) rad/s }}
repeat i from 0 to 1 {{ repeat j from 0 to 1 {{ repeat k from 0 to 1 {{
    effect c[i][j][k] contact {{ ball box at ((i - 0.5) * {0!r} cm, (j - 0.5) * {1!r} cm, (k - 0.5) * {2!r} cm); impact 2 m/s
        rest 0.4; friction 0.5 {stiff} }}
}} }} }}
output height = z_axis of box
output energy = energy
output place = position of box
'''
STOPS = '''
step 1 ms
body cart {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child cart; axis x; speed 1 m/s }}
effect bumper {{ joint along; value stiffness N/m; value place m
    effort on along = -stiffness * max(position of along - place, 0) }}
effect soft bumper {{ along rail; stiffness 1 kN/m; place 0.1 m }}
effect hard bumper {{ along rail; stiffness {} kN/m; place 0.12 m }}
output place = position of rail
'''


def boxed(seed, stiff=''):
    of = random.Random(seed)
    return BOX.format(*(of.uniform(5, 30) for _ in range(3)), of.uniform(0.2, 5), of.uniform(5, 85), of.uniform(-2, 2), of.uniform(-2, 2),
                      stiff=stiff)


@pytest.mark.seeds(10, 4)
def test_box_with_corners(isoc, plant, seed):
    """A box that is thrown on the ground: as steep as the step allows, it is told nothing, and it comes to rest."""
    run = plant(boxed(seed), real='float')
    assert 'too fast' not in run.made.errors
    rows = run.outputs(10000, every=1000)
    assert rows.energy[-1] < rows.energy[0] and abs(rows.rows[-1] - rows.rows[-2]).max() < 1e-2
    assert 0 < rows.place_z[-1] < 0.3


@pytest.mark.seeds(4)
def test_stiff_corners(isoc, seed):
    """The same, with corners that are ten times too fast."""
    assert 'too fast' in isoc(boxed(seed, '; stiffness 1e9 N/m')).errors


ARM = '''
gravity (0, 0, -9.81) m/s^2
step 1 ms
body ball {{ sphere 5 cm of 0.2 kg }}
joint arm revolute {{ parent ground; child ball at (0, 0, {1!r}) m; axis y; start {0!r} deg }}
effect land contact {{ ball ball; radius 5 cm; impact 1 m/s; rest 0.3; friction 0.5; load {2!r} kg
    normal (sin({3!r} deg), 0, cos({3!r} deg)); height {4!r} m {stiff} }}
output place = position of arm
'''


@pytest.mark.seeds(20, 6)
def test_ball_on_an_arm(isoc, seed):
    """A ball that swings into a plane, from near its highest place, where secants lead astray: an angle finds the plane, and
    no speed is asked to."""
    of = random.Random(seed)
    length, mass = of.uniform(0.3, 1), 0.2
    load = mass + 0.4 * mass * 0.05**2 / length**2
    tilt = of.uniform(-90, 90)
    at = (tilt + of.uniform(-20, 20), -length, load, tilt, of.uniform(-0.8, 0.7) * length - 0.05)
    assert 'too fast' not in isoc(ARM.format(*at, stiff='')).errors
    assert 'too fast' in isoc(ARM.format(*at, stiff='; stiffness 1e9 N/m')).errors


def test_stop_behind_a_stop(isoc):
    """A hard stop behind a soft one is looked at, though the soft one is pushed in there."""
    assert 'too fast' not in isoc(STOPS.format(1)).errors
    told = isoc(STOPS.format(1e5)).errors
    assert "the effect 'hard' is too fast" in told and "'soft' is too fast" not in told


def test_stops_at_one_place(isoc):
    """Two stops that are met together count together: of a cart of 1 kg rk4 follows up to 8000 kN/m at 1 ms."""
    alone, together = STOPS.format(5000), STOPS.format(5000).replace('1 kN/m; place 0.1 m', '5000 kN/m; place 0.12 m')
    assert 'too fast' not in isoc(alone).errors and 'too fast' in isoc(together).errors


TANKS = '''
step 0.5 ms
effect tanks {{
    value area m^2
    state level1 m = {0!r} m
    state level2 m = {1!r} m
    state phase = 0
    rate phase = 250 1/s
    let drop = 1e4 Pa/m * (level1 - level2)
    let flow = {2}
    rate level1 = -flow / area
    rate level2 = flow / area
    output level1; output level2
}}
body dummy {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child dummy; axis x }}
effect t tanks {{ area {3!r} m^2 }}
output level1 = t.level1
'''


@pytest.mark.seeds(10, 4)
def test_tanks_at_rest(isoc, seed):
    """Two tanks that come to rest: what switches there by rounding is no jump. A flow that is reversed 40 times a second, in 25
    steps, is one."""
    of = random.Random(seed)
    levels, area = (of.uniform(0.2, 1), of.uniform(0.2, 1)), of.uniform(0.5, 2)
    smooth = f'sign(drop) * min(abs(drop), 20 Pa) / {of.uniform(10, 40)!r} Pa * 1 m^3/s'
    assert 'jumps every' not in isoc(TANKS.format(*levels, smooth, area)).errors
    assert 'jumps every' in isoc(TANKS.format(*levels, 'sign(sin(phase)) * 0.5 m^3/s', area)).errors


SWITCHED = '''
step 0.5 ms
effect tank {{
    state level m = 1 m
    state phase = 0
    rate phase = 250 1/s
    rate level = {rate} * 0.5 m/s
    {event}
    output level
}}
body dummy {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child dummy; axis x }}
effect t tank {{ }}
output level = t.level
'''


def test_the_cure_of_jumps(isoc, plant):
    """With a mode that a `when` sets, as the warning says, nothing is told, and the level is that of the times of all
    jumps; with the comparison it is off by a part of a step. With a method that has no events it names none."""
    by_sign = SWITCHED.format(rate='sign(sin(phase))', event='')
    by_when = SWITCHED.format(rate='side', event='mode side = 1; when phase > pi { set phase = phase - pi; set side = -side }')
    cure = 'a mode that a `when` sets at the time of the jump, or share(A < B)'
    assert cure in isoc(by_sign).errors
    with_history = isoc(by_sign + 'method ab4').errors
    assert 'jumps every' in with_history and cure not in with_history
    assert 'warning' not in isoc(by_when).errors
    half = math.pi / 250
    truth = [1 + 0.5 * (t % half if t // half % 2 == 0 else half - t % half) for t in (0.5e-3 * i for i in range(2001))]
    off = [abs(plant(scene).outputs(2000).level - truth).max() for scene in (by_sign, by_when)]
    assert off[0] > 0.1 * 0.5 * 0.5e-3 and off[1] < 1e-11


def test_reproducers(isoc):
    for name in ('tanks', 'box'):
        assert 'warning' not in isoc(pathlib.Path(f'tests/isoc/stability/{name}.scene'), '--real', 'double').errors


@pytest.mark.parametrize('pulses', [1, 3])
def test_few_jumps(isoc, pulses):
    """A pulse of 10 steps jumps twice: in a window of 2000 steps that is a start, and no switching; 3 pulses are."""
    train = ' + '.join(f'(beyond > {0.2 + 0.3 * i!r}) * (beyond < {0.21 + 0.3 * i!r})' for i in range(pulses))
    scene = f'''step 1 ms
body cart {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child cart; axis x }}
effect pulse {{ joint along; state beyond = 0; rate beyond = 1 1/s; effort on along = 1 N * ({train}) }}
effect e pulse {{ along rail }}
output place = position of rail
'''
    assert ('jumps every' in isoc(scene).errors) == (pulses > 1)


WITHIN = '''
step 1 ms
effect relay {{
    state warm K = 0 K
    state other = 0
    {own}
    rate warm = (on * 40 K - warm) / {lag!r} ms
    rate other = ({other} - other) / 50 ms
    output warm
}}
body dummy {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child dummy; axis x }}
effect r relay {{ }}
{events}
output warm = r.warm
'''
BY_MEMORY = 'memory on = 1; next on = if(warm > 21 K, 0, if(warm < 19 K, 1, on))'
BY_MODE = 'mode on = 1; when warm > 21 K and on == 1 { set on = 0 }; when warm < 19 K and on == 0 { set on = 1 }'
BY_COMPARISON = '(sin(2 * pi * warm / 1.3 K) > 0)'
LATE = 'a memory compares once a step'


@pytest.mark.seeds(6)
def test_a_relay_by_a_memory(isoc, seed):
    """It is told where its jumps are more than 1 % of a step late, by when and by share, and not where they are less, nor by
    a mode; so is a comparison beside a mode, in a scene with events."""
    lag = random.Random(seed).uniform(50, 250)
    fast, slow = (isoc(WITHIN.format(own=BY_MEMORY, lag=by * lag, other=0, events='')).errors for by in (1, 40))
    assert "the effect 'r' jumps" in fast and LATE in fast and '`when`' in fast and 'share(A < B)' in fast and slow == ''
    assert isoc(WITHIN.format(own=BY_MODE, lag=lag, other=0, events='')).errors == ''
    both = isoc(WITHIN.format(own=BY_MODE, lag=lag, other=BY_COMPARISON, events='')).errors
    assert "the effect 'r' jumps" in both and LATE not in both
    elsewhere = isoc(WITHIN.format(own='let on = 0.5', lag=lag, other='(sin(400 1/s * time) > 0)',
                                   events='when position of rail > 1 m { set speed of rail = 0 m/s }')).errors
    assert "the effect 'r' jumps" in elsewhere


def test_a_controller_is_no_alarm(isoc):
    """What a memory gives as an effort from row to row is sampled by its nature."""
    scene = '''step 1 ms
body cart { mass 1 kg }
joint rail prismatic { parent ground; child cart; axis x; start 1 m }
effect bang { joint along; memory push N = 0 N
    next push = if(position of along + 0.1 s * speed of along > 0 m, -20 N, 20 N)
    effort on along = push }
effect e bang { along rail }
output place = position of rail
'''
    assert isoc(scene).errors == ''


THYRISTOR = '''step 50 us
method rk4
effect thyristor {
    signal source V
    state i A = 0 A
    state phase rad = 0 rad
    rate phase = 100 * pi * 1 rad/s
    memory on = 0
    next on = if(sin(phase) > 0.87, 1, if(i > LIMIT, on, 0))
    let forward = source - 10 Ohm * i
    rate i = if(on > 0, max(forward, -200 V/A * i), -200 V/A * i) / 20 mH
    output i
}
body dummy { mass 1 kg }
joint rail prismatic { parent ground; child dummy; axis x }
input u V = 325 V * sin(50 Hz)
effect t thyristor { source u }
output i = t.i
'''


def test_a_thyristor_that_never_turns_off(isoc):
    told = [isoc(THYRISTOR.replace('LIMIT', limit)).errors for limit in ('0 A', '1 mA')]
    assert 'do not pass each other' in told[0] and '`when`' in told[0] and 'do not pass' not in told[1]
