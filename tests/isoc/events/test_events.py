"""What events promise besides their order: no bit changes where nothing fires, when they fire and when not, that a speed
is set by an impulse, and times and restitutions to the digits that a fixed step has between events."""
import math

import numpy as np
import pytest

from harness.plants import replaced

LOAD = 'body load { mass 1 kg }\njoint rail prismatic { parent ground; child load; axis x }\n'
METHODS = ['euler', 'heun', 'rk4', 'semi_implicit']
WATCH = '''effect watch {
    joint along
    value rest
    state now s = 0 s
    state at s = 0 s
    mode count = 0
    rate now = 1
    rate at = 0
    when position of along < 0 m { set speed of along = -rest * speed of along; set at = now; set count = count + 1 }
    output at; output count
}
'''
PENDULUM = '''gravity (0, -9.81, 0) m/s^2
step 1 ms
body upper { rod 1 m of 1 kg at (0, -0.5, 0) m rotate 90 deg about x }
body lower { rod 1 m of 0.5 kg at (0, -0.5, 0) m rotate 90 deg about x }
joint shoulder revolute { parent ground; child upper; axis z; start 60 deg }
joint elbow revolute { parent upper at (0, -1, 0) m; child lower; axis z; start 20 deg; speed 1 rad/s }
output a = position of shoulder
output b = position of elbow
output da = speed of shoulder
output db = speed of elbow
'''


def ball(step, height='1 m', rest=0.8):
    return f'''gravity (0, 0, -9.81) m/s^2
step {step}
body ball {{ mass 1 kg }}
joint fall prismatic {{ parent ground; child ball; axis z; start {height} }}
{WATCH}effect floor watch {{ along fall; rest {rest} }}
output z = position of fall
output v = speed of fall
output at = floor.at
output count = floor.count
'''


@pytest.mark.parametrize('method', METHODS)
@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('options', ['', 'compensated yes\n', 'substeps 4\n'])
def test_no_event_changes_no_bit(plant, method, real, options):
    scene = f'{PENDULUM}method {method}\n{options}'
    without = plant(scene, real=real).outputs(500).rows
    with_events = plant(scene + '''when position of elbow > 100 rad { set speed of elbow = 0 rad/s }
when speed of shoulder > 100 rad/s or position of shoulder < -50 rad { set position of shoulder = 0 rad }
''', real=real).outputs(500).rows
    assert without.tobytes() == with_events.tobytes()
    fired = plant(scene + 'when position of shoulder < 50 deg { set speed of elbow = 0 rad/s }\n', real=real).outputs(500)
    assert fired.rows.tobytes() != without.tobytes()


def test_what_is_below_zero_at_the_start_does_not_fire(plant):
    scene = f'''step 1 ms
method rk4
{LOAD}mode hits = 0
effect ramp {{ state x = 1; rate x = -1 1/s; output x }}
effect r ramp {{ }}
when r.x < 2 {{ set hits = hits + 1 }}
output hits = hits
'''
    assert plant(scene).outputs(20).hits[-1] == 0
    unarmed = lambda text: replaced(r'^    iso_events_begin\(.*\n', '    memset(memory->events, 255, sizeof memory->events);\n', text)
    assert plant(scene, change=unarmed).outputs(20).hits[-1] == 1


def test_a_tunable_and_a_memory_fire_at_the_begin_of_a_step(plant):
    scene = f'''step 1 ms
method rk4
{LOAD}tunable limit = 1
mode by_tunable = 0
mode by_memory = 0
at 5 ms set limit = -1
effect counter {{ memory rows = 0; next rows = rows + 1; output rows }}
effect c counter {{ }}
when limit < 0 {{ set by_tunable = by_tunable + 1 }}
when c.rows >= 7 {{ set by_memory = by_memory + 1 }}
output by_tunable = by_tunable
output by_memory = by_memory
'''
    found = plant(scene).outputs(20)
    assert np.argmax(found.by_tunable > 0) == 6 and found.by_tunable[-1] == 1
    # A >= B has the function B - A, which is zero in row 7 and below it in row 8: the step from there has the event.
    assert np.argmax(found.by_memory > 0) == 9 and found.by_memory[-1] == 1


TWO = f'''step 10 ms
method rk4
{LOAD}effect ramp {{ state x = 0; rate x = 1 1/s; output x }}
effect r ramp {{ }}
effect pair {{
    signal x
    state now s = 0 s
    state first s = 0 s
    state second s = 0 s
    mode order = 0
    rate now = 1
    rate first = 0
    rate second = 0
    when x > 0.0222 {{ set first = now; set order = 10 * order + 1 }}
    when x > SECOND {{ set second = now; set order = 10 * order + 2 }}
    output first; output second; output order
}}
effect p pair {{ x r.x }}
output first = p.first
output second = p.second
output order = p.order
'''


def test_two_events_in_a_step(plant):
    """With one slot the second waits for the begin of the next step; with two both have their time."""
    scene = TWO.replace('SECOND', '0.0277')
    one, two = plant(scene).outputs(5), plant(scene + 'events 2\n').outputs(5)
    assert one.order[3] == 1 and one.order[4] == 12 and two.order[3] == 12
    assert abs(one.first[-1] - 0.0222) < 1e-12 and abs(one.second[-1] - 0.03) < 1e-12
    assert abs(two.first[-1] - 0.0222) < 1e-12 and abs(two.second[-1] - 0.0277) < 1e-12


def test_of_two_at_one_time_the_first_in_the_text_fires_first(plant):
    found = plant(TWO.replace('SECOND', '0.0222') + 'events 2\n').outputs(5)
    assert found.order[-1] == 12 and abs(found.first[-1] - found.second[-1]) < 1e-15
    swapped = lambda text: replaced(r'functions\[2\] = \{event_1, event_2\}', 'functions[2] = {event_2, event_1}', text)
    other = plant(TWO.replace('SECOND', '0.0277') + 'events 2\n', change=swapped).outputs(5)
    assert other.order[-1] == 21


@pytest.mark.parametrize('rest', [0.0, 0.5, 1.0])
def test_a_speed_is_set_by_an_impulse(plant, rest):
    """Where the shoulder of a double pendulum is stopped, the momentum of the elbow stays."""
    scene = f'{PENDULUM}method rk4\nwhen position of shoulder < 30 deg {{ set speed of shoulder = -{rest} * speed of shoulder }}\n'
    free = plant(PENDULUM + 'method rk4\n').outputs(1000)
    hit = int(np.argmax(free.a < math.radians(30)))
    found = plant(scene.replace('step 1 ms', 'step 1 us')).outputs(1000 * hit, every=1)
    k = int(np.argmax(np.abs(np.diff(found.da)) > 0.5))
    before, after = found.rows[k], found.rows[k + 1]
    # M = [[a + 2 c cos b, d + c cos b], [d + c cos b, d]], of two rods; the momentum of the elbow is its second row.
    c, d = 0.5 * 1 * 0.5, 0.5 / 3

    def momentum(row):
        return (d + c * math.cos(row[1])) * row[2] + d * row[3]
    assert abs(after[2] + rest * before[2]) < 1e-4 and abs(before[3] - after[3]) > 0.5
    assert abs(momentum(after) - momentum(before)) < 2e-5


def test_an_impulse_keeps_the_closures(plant):
    """A four-bar has one freedom: an impulse changes all speeds by one factor."""
    scene = '''gravity (0, -9.81, 0) m/s^2
step 1 ms
method rk4
events 1 rest rk4
body crank { rod 0.3 m of 1 kg at (0.15, 0, 0) m rotate 90 deg about y }
body coupler { rod 0.9 m of 2 kg at (0.45, 0, 0) m rotate 90 deg about y }
body rocker { rod 0.7 m of 1 kg at (0.35, 0, 0) m rotate 90 deg about y }
joint a revolute { parent ground; child crank; axis z; start 60 deg; speed 5 rad/s }
joint b revolute { parent crank at (0.3, 0, 0) m; child coupler; axis z; start about -40 deg }
joint c revolute { parent ground at (1, 0, 0) m; child rocker; axis z; start about 110 deg }
close d revolute { parent coupler at (0.9, 0, 0) m; child rocker at (0.7, 0, 0) m; axis z }
output a = speed of a
output b = speed of b
output c = speed of c
output off = violation_rate
'''
    hit = 'when position of a > 80 deg { set speed of a = -0.5 * speed of a }\n'
    free, found = plant(scene).outputs(200), plant(scene + hit).outputs(200)
    k = int(np.argmax(np.abs(np.diff(found.a)) > 2))
    assert 10 < k < 150
    # Between the rows before and behind the event the four-bar moves on by less than a step.
    factors = found.rows[k + 1, :3] / free.rows[k + 1, :3]
    assert np.allclose(factors, -0.5, atol=0.02) and np.ptp(factors) < 2e-2
    assert found.off[k + 1:].max() < 1e-9


def test_the_second_bounce(plant):
    """At 1 ms its time is off by less than 1e-7 s."""
    found = plant(ball('1 ms') + 'method rk4\n').outputs(2000)
    first = math.sqrt(2 / 9.81)
    second = first + 2 * 0.8 * first
    assert abs(found.at[np.argmax(found.count == 1)] - first) < 1e-7
    assert abs(found.at[np.argmax(found.count == 2)] - second) < 1e-7
    assert found.count[-1] == 3


@pytest.mark.parametrize('real, most', [('double', 1e-9), ('float', 1e-4)])
def test_restitution_at_any_phase(plant, real, most):
    """A hundred places of the impact in its step: the speed that it leaves."""
    wrong = []
    for i in range(100):
        text = ball('1 ms', f'{1 + 1e-4 * i} m') + 'method rk4\n'
        found = plant(text, real=real).outputs(600)
        energy = 9.81 * found.z + 0.5 * found.v ** 2
        wrong.append(abs(math.sqrt(energy[-1] / energy[0]) - 0.8))
    assert max(wrong) < most


def test_relay_switches(plant):
    """A relay holds a body between 19 K and 21 K by 40 K at 1 s: 18 switches, each within 1e-5 s at 10 ms."""
    scene = f'''step 10 ms
method rk4
{LOAD}effect relay {{
    state warm K = 0 K
    state now s = 0 s
    state at s = 0 s
    mode on = 1
    mode count = 0
    rate warm = (on * 40 K - warm) / 1 s
    rate now = 1
    rate at = 0
    when warm > 21 K and on == 1 {{ set on = 0; set at = now; set count = count + 1 }}
    when warm < 19 K and on == 0 {{ set on = 1; set at = now; set count = count + 1 }}
    output at; output count; output on
}}
effect r relay {{ }}
output at = r.at
output count = r.count
output on = r.on
'''
    found = plant(scene).outputs(300)
    times = [math.log(40 / 19)]
    while len(times) < 18:
        times.append(times[-1] + (math.log(21 / 19)))
    ours = [found.at[np.argmax(found.count == n + 1)] for n in range(18)]
    assert found.count[-1] >= 18 and np.abs(np.array(ours) - times).max() < 1e-5
    assert set(found.on) == {0.0, 1.0}


def test_modes_are_exact(plant):
    """Whole numbers stay what they are through 1000 events, and between them in every row."""
    scene = f'''step 1 ms
method rk4
{LOAD}events 3
mode big = 16777000
effect saw {{ state x = 0; rate x = 937 1/s; when x > 1 {{ set x = x - 1 }} output x }}
effect s saw {{ }}
when s.x < 0.5 {{ set big = big + 1 }}
output big = big
output x = s.x
'''
    found = plant(scene, real='float').outputs(230)
    assert np.array_equal(found.big, np.round(found.big)) and found.big[-1] == 16777000 + int(230 * 0.937)
    assert np.all(np.diff(found.big) >= 0)


def test_a_mode_by_names_starts_by_a_formula(plant):
    scene = f'''step 1 ms
method heun
{LOAD}tunable warm = 2
mode state in (cold, mild, hot) = if(warm > 1, hot, cold)
effect e {{ signal is; output is }}
effect f e {{ is if(state == hot, 5, if(state == mild, 3, 1)) }}
output state = state
output is = f.is
'''
    found = plant(scene).outputs(3)
    assert found.state[-1] == 2 and getattr(found, 'is')[-1] == 5


@pytest.mark.parametrize('hit', ['set speed of shoulder = -0.3 * speed of shoulder', 'set position of elbow = 0 rad',
                                 'set speed of elbow = 0 rad/s; set position of elbow = 5 deg'])
def test_the_loss_of_events_closes_the_account(plant, hit):
    """The energy with what events have taken stays, to the error of the method; without one event it does not."""
    scene = PENDULUM + f'''method rk4
events 1 rest rk4
when position of shoulder < 20 deg {{ {hit} }}
output energy = energy
output loss = event_loss
output both = energy + event_loss
'''
    found = plant(scene).outputs(3000)
    assert np.ptp(found.energy) > 0.1 and np.ptp(found.both) < 1e-7
    assert np.allclose(found.both, found.energy + found.loss, rtol=0, atol=1e-14)


def test_three_impacts_in_a_step(plant):
    """Three masses meet their walls within a step of 10 ms: with three slots each keeps its time; with one the others
    are late, and off by what they move until the next step."""
    masses = ''.join(f'''body m{i} {{ mass 1 kg }}
joint r{i} prismatic {{ parent ground; child m{i}; axis x; start {0.1 + 0.002 * i} m; speed -1 m/s }}
when position of r{i} < 0 m {{ set speed of r{i} = -0.5 * speed of r{i} }}
output x{i} = position of r{i}
''' for i in range(3))
    one = plant(f'step 10 ms\nmethod rk4\n{masses}').outputs(20)
    three = plant(f'step 10 ms\nmethod rk4\nevents 3\n{masses}').outputs(20)
    truth = [0.5 * (0.2 - (0.1 + 0.002 * i)) for i in range(3)]
    assert max(abs(getattr(three, f'x{i}')[-1] - truth[i]) for i in range(3)) < 1e-12
    assert abs(one.x0[-1] - truth[0]) < 1e-12 and abs(one.x2[-1] - truth[2]) > 1e-3


def test_an_event_on_the_time_is_warned_of(isoc):
    """By the time it would be up to a step late without a word; by a state that is the time it is not."""
    scene = f'''step 1 ms
method rk4
{LOAD}mode on = 0
effect clock {{ state now s = 0 s; rate now = 1; output now }}
effect c clock {{ }}
when CONDITION {{ set on = 1 }}
output on = on
'''
    for condition, is_told in (('time > 2.5 ms', True), ('c.now > 2.5 ms', False), ('square(20 Hz) < 0', True)):
        made = isoc(scene.replace('CONDITION', condition))
        assert made.status == 0 and ('up to a step late' in made.errors) == is_told


def test_a_function_that_rises_at_first(plant):
    """A ball that leaves the ground and comes back within a step meets it then, and not where it leaves."""
    found = plant(ball('10 ms', '0 m; speed 0.04 m/s') + 'method rk4\n').outputs(1)
    assert found.count[-1] == 1 and abs(found.at[-1] - 2 * 0.04 / 9.81) < 1e-12


def test_an_event_forgets_the_compensation_of_sums(plant):
    """What is set stays to the bit, also where the rounding errors of sums are kept beside the states."""
    scene = f'''step 1 ms
method rk4
compensated yes
{LOAD}effect ramp {{
    state x = 0
    mode on = 1
    rate x = if(on == 1, 0.3 1/s, 0 1/s)
    when x > 0.01 {{ set x = 0; set on = 0 }}
    output x
}}
effect r ramp {{ }}
output x = r.x
'''
    found = plant(scene, real='float').outputs(100)
    assert found.x[30] > 0.008 and np.all(found.x[40:] == 0)
