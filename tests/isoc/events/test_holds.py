"""Holds: what sticks has no speed to the last bit, changes at its time, and settles with the others as a reference does
that shares no code with isoc or core."""
import math

import numpy as np
import pytest

import held_chain
from exact import Event, Run
from harness.plants import replaced
from harness.project import ROOT

BELT = '''gravity (0, 0, -9.81) m/s^2
body load { mass 1 kg }
joint rail prismatic { parent ground; child load; axis x }
effect belt { joint along; state drawn m = 0 m; rate drawn = 0.1 m/s
    effort on along = 20 N/m * (drawn - position of along) }
effect b belt { along rail }
hold grip on rail up to 3 N then 2 N
output x = position of rail
output v = speed of rail
'''
CLUTCH = '''body motor { mass 1 kg; inertia (20, 20, 20) g*m^2 }
body load { mass 1 kg; inertia (50, 50, 50) g*m^2 }
joint shaft revolute { parent ground; child motor; axis z; speed 3 rad/s }
joint out revolute { parent ground; child load; axis z }
effect turning {
    joint shaft
    joint out
    state now s = 0 s
    rate now = 1
    effort on shaft = 1 N*m * sin(9 rad/s * now)
    effort on out = -0.3 N*m * sin(5 rad/s * now)
}
effect t turning { shaft shaft; out out }
hold plates between shaft and out up to 0.6 N*m then 0.5 N*m
output x = speed of shaft
output v = speed of out
'''


def belt(time):
    """Where the load on the belt is at a time, and its speed, in closed form: it breaks at 3 N, and slips half a period
    and more of 20 N/m and 1 kg about the middle where 2 N are left."""
    w = math.sqrt(20)
    place, begin = 0.0, 0.0
    slip = (2 * math.pi - 2 * math.atan(w * 0.05 / 0.1)) / w
    while True:
        breaks = (3 / 20 + place) / 0.1
        if breaks > time:
            return place, 0.0
        ends = min(time, breaks + slip)
        phase = w * (ends - breaks)
        ahead = 0.05 * math.cos(phase) + 0.1 / w * math.sin(phase)
        place = 0.1 * ends - ahead - 0.1
        if time < breaks + slip:
            return place, 0.1 + 0.05 * w * math.sin(phase) - 0.1 * math.cos(phase)
        assert breaks > begin
        begin = breaks


def clutch():
    """The clutch as states: both speeds, the time and the mode."""
    def efforts(x):
        return math.sin(9 * x[2]), -0.3 * math.sin(5 * x[2])

    def held(x):
        first, second = efforts(x)
        return (0.02 * second - 0.05 * first) / 0.07

    def rates(x):
        first, second = efforts(x)
        effort = held(x) if x[3] == 0 else -x[3] * 0.5
        return [(first + effort) / 0.02, (second - effort) / 0.05, 1.0, 0.0]

    def sticks(x):
        both = (0.02 * x[0] + 0.05 * x[1]) / 0.07
        return [both, both, x[2], 0.0]
    stop = Event(lambda x: x[3] * (x[0] - x[1]) if x[3] else 1.0, sticks, True)
    part = Event(lambda x: 0.6 - abs(held(x)) if x[3] == 0 else 1.0,
                 lambda x: [x[0], x[1], x[2], -math.copysign(1, held(x))], True)
    return Run(rates, [stop, part], [3.0, 0.0, 0.0, 1.0], 1e-4)


def truth_of(name, end, looks):
    if name == 'belt':
        return np.array([belt(end * k / looks) for k in range(1, looks + 1)])
    run = clutch()
    found = np.array([run.until(end * k / looks)[:2] for k in range(1, looks + 1)])
    assert len(run.fired) > 6
    return found


@pytest.mark.parametrize('name, end', [('belt', 6.4), ('clutch', 3.2)])
@pytest.mark.parametrize('method, rest, least', [('rk4', 'rk4', 3.6), ('rk4', 'heun', 2.4), ('heun', 'heun', 1.8)])
def test_orders(plant, name, end, method, rest, least):
    truth, counts, errors = truth_of(name, end, 16), [320 * 2 ** k for k in range(5)], []
    for count in counts:
        text = f'step {end / count * 1e9:.0f} ns\nmethod {method}\nevents 1 rest {rest}\n' + {'belt': BELT, 'clutch': CLUTCH}[name]
        rows = plant(text).outputs(count, every=count // 16)
        errors.append(np.sqrt(np.mean((np.stack([rows.x, rows.v], axis=1)[1:] - truth) ** 2)))
    order = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    print(name, method, rest, ' '.join(f'{e:.1e}' for e in errors), f'{order:.2f}')
    assert order > least


def chain_parts(seed, ratio):
    """Rods of the chain, static and sliding limits, and efforts, by chance."""
    by_chance = np.random.default_rng(seed)
    static = [9.0, 4.0, 1.3]
    most = [float(most * share) for most, share in zip([14.0, 6.5, 2.3], by_chance.uniform(0.5, 0.9, 3))]
    w, phases, angles = ([float(v) for v in by_chance.uniform(low, high, 3)] for low, high in ((2, 9), (0, 6), (-.5, .5)))
    return ([1.0, 0.8, 0.6], [1.0, 0.8, 0.5], static, [limit / ratio for limit in static], most, w, phases), angles


def compared(plant, parts, angles, seconds, options, change=None):
    """The largest error of states, and the rows of 1.25 ms in which modes differ from the reference."""
    count = round(seconds / 2.5e-3)
    course = held_chain.Course(held_chain.Chain(*parts), angles, 2.5e-3)
    states, modes = held_chain.rows(course, 2.5e-3, count)
    text = held_chain.scene(parts, angles, '1250 us', f'method rk4\n{options}')
    rows = plant(text, change=change).outputs(2 * count, every=2).rows[1:]
    assert np.all(rows[:, 3:6][rows[:, 6:9] == 0] == 0), 'what sticks moves'
    return np.abs(rows[:, :6] - states).max(), np.flatnonzero((rows[:, 6:9] != modes).any(axis=1)), len(course.times)


# The error grows with the sensitivity of the motion: these seeds have little of it for 20 s.
@pytest.mark.parametrize('ratio, draw', [(1.0, 3), (1.5, 11)])
def test_chain_of_three(plant, ratio, draw):
    """20 s of a chain with friction in every joint: modes in every row, and states to 1e-6."""
    parts, angles = chain_parts(draw, ratio)
    error, wrong, changes = compared(plant, parts, angles, 20.0, 'events 2 rest rk4')
    print(f'static/sliding {ratio}: {changes} changes, error {error:.1e}')
    assert len(wrong) == 0 and changes > 100 and error < 1e-6


@pytest.mark.seeds(2)
@pytest.mark.parametrize('ratio', [1.0, 1.5])
def test_chains(plant, seed, ratio):
    parts, angles = chain_parts(1000 + seed, ratio)
    error, wrong, changes = compared(plant, parts, angles, 3.0, 'events 3 rest rk4')
    print(f'seed {seed}, static/sliding {ratio}: {changes} changes, error {error:.1e}')
    assert len(wrong) == 0 and error < 1e-5


def planted(pattern, by):
    """A change of core/methods/hold.h in the plant, which then needs none of its own."""
    text = (ROOT / 'core/methods/hold.h').read_text()
    return lambda source: replaced('#include "core/methods/event.h"',
                                   lambda _: replaced(pattern, by, text) + '#include "core/methods/event.h"', source)


@pytest.mark.parametrize('pattern, by', [
    (r'const size_t passes = .*', 'const size_t passes = 0;'),
    (r'-iso_side\(at->effort\[i\]\)', 'iso_side(at->effort[i])')])
def test_a_rule_left_out_is_found(plant, pattern, by):
    parts, angles = chain_parts(3, 1.0)
    error, wrong, _ = compared(plant, parts, angles, 3.0, 'events 2 rest rk4', change=planted(pattern, by))
    assert len(wrong) > 0 or error > 1e-4


@pytest.mark.parametrize('real', ['float', 'double'])
def test_a_block_on_a_slope_stays(plant, real):
    """A slope of 30 degrees: the block of 1 kg needs 4.905 N. 1e5 steps."""
    scene = '''gravity (4.905, 0, -8.4957) m/s^2
step 1 ms
body block { mass 1 kg }
joint slope prismatic { parent ground; child block; axis x; start 0.3 m }
hold grip on slope up to LIMIT N then 4 N
output x = position of slope
output v = speed of slope
output grip = grip
output effort = effort of grip
'''
    found = plant(scene.replace('LIMIT', '5'), real=real).outputs(100000, every=100)
    assert np.all(found.v == 0) and np.all(found.x == found.x[0]) and np.all(found.grip == 0)
    assert np.allclose(found.effort, -4.905, atol=1e-6)
    slides = plant(scene.replace('LIMIT', '4.9'), real=real).outputs(1000)
    assert slides.grip[0] == 1 and abs(slides.v[-1] - 0.905) < 1e-4


def test_an_impulse_breaks_what_sticks(plant):
    """A double pendulum whose elbow sticks meets a wall: the elbow's momentum stays as if it were free, for friction has
    no impulse; behind it the elbow slips in the direction of its new speed."""
    scene = '''gravity (0, -9.81, 0) m/s^2
step 1 us
body upper { rod 1 m of 1 kg at (0, -0.5, 0) m rotate 90 deg about x }
body lower { rod 1 m of 0.5 kg at (0, -0.5, 0) m rotate 90 deg about x }
joint shoulder revolute { parent ground; child upper; axis z; start 20 deg; speed -3 rad/s }
joint elbow revolute { parent upper at (0, -1, 0) m; child lower; axis z; start 40 deg }
hold grip on elbow up to 20 N*m
when position of shoulder < 10 deg { set speed of shoulder = -0.5 * speed of shoulder }
output b = position of elbow
output da = speed of shoulder
output db = speed of elbow
output grip = grip
'''
    lost = plant(scene, change=planted(r'strikes \| iso_is_nonzero', 'iso_is_nonzero')).outputs(80000)
    found = plant(scene).outputs(80000)
    assert np.all(lost.grip == 0)  # the control
    k = int(np.argmax(found.da > 0))
    assert 10 < k and np.all(found.db[:k] == 0) and np.all(found.grip[:k] == 0)
    # M of two rods; the momentum of the elbow is its second row.
    c, d = 0.5 * 1 * 0.5, 0.5 / 3
    momentum = lambda i: (d + c * math.cos(found.b[i])) * found.da[i] + d * found.db[i]
    assert abs(momentum(k) - momentum(k - 1)) < 1e-4 and abs(found.db[k]) > 1
    assert found.grip[k] == np.sign(found.db[k])


def test_more_holds_than_speeds(plant):
    """Two brakes and a clutch on two shafts: one more than there are speeds. The effort that turns the first shaft is
    borne up to 1 N*m by its brake and up to 2 N*m through the clutch."""
    scene = '''step 1 ms
method rk4
events 3
body first { mass 1 kg; inertia (20, 20, 20) g*m^2 }
body second { mass 1 kg; inertia (50, 50, 50) g*m^2 }
joint a revolute { parent ground; child first; axis z }
joint b revolute { parent ground; child second; axis z }
effect ramp { joint along; state effort N*m = 0 N*m; rate effort = 1 N*m/s; effort on along = effort; output effort }
effect r ramp { along a }
hold brake_a on a up to 1 N*m
hold brake_b on b up to 5 N*m
hold plates between a and b up to 2 N*m
output a = speed of a
output b = speed of b
output effort = r.effort
output ma = brake_a
output mb = brake_b
output mp = plates
'''
    for real in ('double', 'float'):
        found = plant(scene, real=real).outputs(4000)
        moves = int(np.argmax(found.a > 0))
        assert abs(found.effort[moves] - 3.0) < 2e-3 and np.all(found.b == 0)
        assert found.ma[-1] == 1 and found.mp[-1] == 1 and found.mb[-1] == 0


def test_the_power_of_holds_is_in_the_account(plant):
    found = plant((ROOT / 'tests/isoc/events/holds.scene').read_text()).outputs(3000)
    assert np.abs(found.balance).max() < 1e-8
    for column in (found.brake, found.rub, found.plates):
        assert set(column) <= {-1.0, 0.0, 1.0} and len(set(column)) > 1
    assert np.all(found.slip[found.plates == 0] == 0) and np.any(found.plates == 0)
    slips = found.rub != 0
    assert np.allclose(found.effort[slips], -found.rub[slips]) and np.abs(found.effort[~slips]).max() < 1.53  # an input has jumped
