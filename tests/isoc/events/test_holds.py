"""Holds: what sticks has no speed to the last bit, changes at its time, and settles with the others as a reference does
that shares no code with isoc or core."""
import contextlib
import math

import numpy as np
import pytest

import held_chain
import linkage
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


BAR = linkage.scene('start 60 deg; speed 0 rad/s') + '''
effect turning { joint along; state now s = 0 s; rate now = 1; effort on along = 9 N*m * sin(5 rad/s * now) }
effect t turning { along a }
hold grip on a up to 5 N*m then 3 N*m
output x = position of a
output v = speed of a
output grip = grip
output b = speed of b
output off = violation_rate
output effort = effort of grip
output balance = balance
'''


def bar():
    """The crank of the four-bar with friction, driven: angle, speed, time and mode."""
    def drawn(x):
        return linkage.effort(x[0], x[1]) + 9 * math.sin(5 * x[2])

    def rates(x):
        return [0.0, 0.0, 1.0, 0.0] if x[3] == 0 else [x[1], (drawn(x) - 3 * x[3]) / linkage.inertia(x[0]), 1.0, 0.0]
    stop = Event(lambda x: x[3] * x[1] if x[3] else 1.0, lambda x: [x[0], 0.0, x[2], 0.0], True)
    go = Event(lambda x: 5 - abs(drawn(x)) if x[3] == 0 else 1.0,
               lambda x: [x[0], 0.0, x[2], math.copysign(1, drawn(x))], True)
    start = math.radians(60)
    return Run(rates, [stop, go], [start, 0.0, 0.0, math.copysign(1, linkage.effort(start, 0.0))], 4e-4)


def truth_of(name, end, looks):
    if name == 'belt':
        return np.array([belt(end * k / looks) for k in range(1, looks + 1)])
    run = {'clutch': clutch, 'bar': bar}[name]()
    found = np.array([run.until(end * k / looks)[:2] for k in range(1, looks + 1)])
    assert len(run.fired) > 4
    return found


@pytest.mark.parametrize('name, end', [('belt', 6.4), ('clutch', 3.2), ('bar', 1.6)])
@pytest.mark.parametrize('method, rest, least', [('rk4', 'rk4', 3.6), ('rk4', 'heun', 2.4), ('heun', 'heun', 1.8)])
def test_orders(plant, name, end, method, rest, least):
    truth, counts, errors = truth_of(name, end, 16), [320 * 2 ** k for k in range(5)], []
    for count in counts:
        text = f'step {end / count * 1e9:.0f} ns\nmethod {method}\nevents 1 rest {rest}\n' + {'belt': BELT, 'clutch': CLUTCH, 'bar': BAR}[name]
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


def compared(plant, parts, angles, seconds, options, change=None, walls=()):
    """The largest error of states, and the rows of 1.25 ms in which modes differ from the reference."""
    count = round(seconds / 2.5e-3)
    course = held_chain.Course(held_chain.Chain(*parts), angles, 2.5e-3, walls)
    states, modes = held_chain.rows(course, 2.5e-3, count)
    text = held_chain.scene(parts, angles, '1250 us', f'method rk4\n{options}', walls)
    rows = plant(text, change=change).outputs(2 * count, every=2).rows[1:]
    assert np.all(rows[:, 3:6][rows[:, 6:9] == 0] == 0), 'what sticks moves'
    wrong = np.flatnonzero((rows[:, 6:9] != modes).any(axis=1))
    return np.abs(rows[:, :6] - states).max(), wrong, len(course.impacts if walls else course.times)


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


WALLS = [(1, -0.25, 1, 0.6), (2, 0.35, -1, 0.5)]


@pytest.mark.seeds(2)
def test_chains_that_meet_walls(plant, seed):
    """Impacts break what sticks, renew the signs of what slips, and all settle, before a contact comes to rest."""
    parts, angles = chain_parts(2000 + seed, 1.5)
    parts[4][:] = [most * 1.3 for most in parts[4]]
    course = held_chain.Course(held_chain.Chain(*parts), [0.4 * angle for angle in angles], 2.5e-3, WALLS)
    with contextlib.suppress(held_chain.ComesToRest):
        course.until(1.0)
    # Until a contact meets again within 20 ms: it comes to rest.
    ends = [first for (first, i), (second, k) in zip(course.impacts, course.impacts[1:]) if i == k and second - first < 0.02]
    seconds = 2.5e-3 * int(min(ends, default=1.0) / 2.5e-3)
    error, wrong, impacts = compared(plant, parts, [0.4 * angle for angle in angles], seconds, 'events 3 rest rk4', walls=WALLS)
    print(f'seed {seed}: {impacts} impacts in {seconds:.3f} s, error {error:.1e}')
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


@pytest.mark.parametrize('real, most', [('double', 1e-9), ('float', 2e-3)])
def test_a_hold_in_a_loop(plant, real, most):
    """The crank of a four-bar: its speed is zero to the last bit while it sticks, the other speeds are as the closures
    allow, and the account is closed."""
    found = plant('step 1 ms\nmethod rk4\nevents 2 rest rk4\n' + BAR, real=real).outputs(3000)
    sticks = found.grip == 0
    assert 100 < sticks.sum() < 2900 and np.all(found.v[sticks] == 0) and np.all(np.diff(found.x)[sticks[1:] & sticks[:-1]] == 0)
    assert np.abs(found.b[sticks]).max() < most and found.off.max() < most
    assert np.abs(found.effort[sticks]).max() < 5.01 and np.abs(found.balance).max() < 10 * most


def test_two_holds_in_a_loop(plant):
    """The crank and the rocker of a four-bar share its one freedom: an effort on the crank is borne by both."""
    text = linkage.scene('start 60 deg; speed 0 rad/s').replace('(0, -9.81, 0)', '(0, 0, 0)') + '''
effect ramp { joint along; state effort N*m = 0 N*m; rate effort = 1 N*m/s; effort on along = effort; output effort }
effect r ramp { along a }
hold grip_a on a up to 2 N*m
hold grip_c on c up to 3 N*m
output v = speed of a
output effort = r.effort
output first = grip_a
output second = grip_c
'''
    found = plant('step 1 ms\nmethod rk4\nevents 2\n' + text).outputs(5000)
    moves = int(np.argmax(found.v > 1e-6))
    assert abs(found.effort[moves] - (2 + 3 * abs(linkage.rates(math.radians(60))[1]))) < 3e-3
    assert found.first[-1] == 1 and found.second[-1] == np.sign(linkage.rates(math.radians(60))[1])


@pytest.mark.parametrize('method, least', [('euler', 0.8), ('semi_implicit', 0.8), ('heun', 1.8)])
@pytest.mark.parametrize('options', ['', 'compensated yes\n', 'substeps 2\n'])
def test_the_other_methods(plant, method, least, options):
    """The belt, to the order of the method; what sticks has no speed with each of them."""
    truth, counts, errors = truth_of('belt', 6.4, 8), [640, 1280, 2560], []
    for count in counts:
        rows = plant(f'step {6.4 / count * 1e9:.0f} ns\nmethod {method}\n{options}{BELT}output grip = grip\n').outputs(count)
        assert np.all(rows.v[rows.grip == 0] == 0) and np.any(rows.grip == 0) and np.any(rows.grip == 1)
        ours = np.stack([rows.x, rows.v], axis=1)[count // 8::count // 8]
        errors.append(np.sqrt(np.mean((ours - truth) ** 2)))
    order = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    print(method, options.strip(), ' '.join(f'{e:.1e}' for e in errors), f'{order:.2f}')
    assert order > least


def test_a_brake_that_is_switched(plant):
    """A rotor is braked from 1 ms on, where an event says so within a step, and let go again: it stops at the time of the
    closed form, stays, and starts again by the motor's effort."""
    scene = '''step 10 ms
method rk4
events 2 rest rk4
body rotor { mass 1 kg; inertia (0.1, 0.1, 0.1) kg*m^2 }
joint spin revolute { parent ground; child rotor; axis z; speed 10 rad/s }
effect brake {
    joint along
    state now s = 0 s
    rate now = 1
    mode pressed = 0
    when now > 0.1234 s { set pressed = 1 }
    when now > 0.5678 s { set pressed = 0 }
    hold shoes on along up to if(pressed == 1, 5 N*m, 0 N*m)
    effort on along = 1 N*m
    output pressed; output shoes
}
effect b brake { along spin }
output v = speed of spin
output shoes = b.shoes
'''
    found = plant(scene).outputs(100)
    at = lambda time: found.v[round(time / 0.01)]
    assert abs(at(0.12) - 11.2) < 1e-12 and abs(at(0.2) - (10 + 1.234 - 40 * (0.2 - 0.1234))) < 1e-12
    assert np.all(found.v[41:57] == 0) and np.all(found.shoes[41:57] == 0) and found.v[40] > 0
    assert abs(at(0.9) - 10 * (0.9 - 0.5678)) < 1e-12


@pytest.mark.parametrize('real', ['float', 'double'])
def test_dry_friction_and_a_joint_that_seizes(plant, real):
    """Of the library: a block rests on a slope; another seizes at 0.5 s, stops where 2 m/s end by 20 N less 4.905 N, and
    stays."""
    scene = '''gravity (4.905, 0, -8.4957) m/s^2
step 1 ms
method rk4
body block { mass 1 kg }
body other { mass 1 kg }
joint slope prismatic { parent ground; child block; axis x }
joint second prismatic { parent ground; child other; axis x; speed -0.4525 m/s }
effect rub dry_friction { along slope; sliding 4 N; static 5 N }
effect jam seized { along second; static 20 N }
at 0.5 s set jam.active = 1
output v = speed of slope
output u = speed of second
output x = position of second
output grip = rub.grip
output effort = rub.effort
output balance = balance
'''
    found, most = plant(scene, real=real).outputs(3000), {'float': 1e-4, 'double': 1e-9}[real]
    assert np.all(found.v == 0) and np.all(found.grip == 0) and np.allclose(found.effort, -4.905, atol=1e-5)
    stops = 0.5 + 2 / 15.095
    assert abs(found.u[500] - 2) < most and found.u[int(stops * 1000)] > 0 and np.all(found.u[int(stops * 1000) + 2:] == 0)
    assert abs(found.x[-1] - found.x[500] - 2 * 2 / (2 * 15.095)) < most and np.abs(found.balance).max() < 1e-4


@pytest.mark.parametrize('scene, mode', ((BELT, 'grip'), (CLUTCH, 'plates')), ids=('belt', 'clutch'))
def test_what_slips_closes_the_account_of_energy(plant, scene, mode):
    """To rounding of the largest power; between two joints a hold takes the power of the difference of their speeds."""
    rows = plant(f'step 1 ms\nmethod rk4\n{scene}output mode = {mode}\noutput power = power\noutput balance = balance\n').outputs(4000)
    largest = np.abs(rows.power).max()
    assert np.count_nonzero(rows.mode) > 100 and largest > 1e-3
    assert np.abs(rows.balance).max() <= 64 * np.finfo(float).eps * largest
