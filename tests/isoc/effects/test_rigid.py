"""Effects with a law of constant restitution (rigid_bumper, rigid_stop): what is left of a speed at any phase and step, rest, and what leaves
it, against closed forms."""
import math

import numpy as np
import pytest

from harness.plants import replaced

METHODS = ['rk4', 'heun', 'semi_implicit']
PLACES = {'rigid_bumper': 'place 0 m; side -1', 'rigid_stop': 'lower 0 m; upper 50 m'}


def ball(kind='rigid_bumper', start='1 m', rest=0.8, step='1 ms', method='rk4', more=''):
    """On a ground at 0 m."""
    return f'''gravity (0, 0, -9.81) m/s^2
step {step}
method {method}
body ball {{ mass 2 kg }}
joint fall prismatic {{ parent ground; child ball; axis z; start {start} }}
effect floor {kind} {{ along fall; {PLACES[kind]}; rest {rest} }}
{more}output z = position of fall
output v = speed of fall
output holds = floor.holds
output push = floor.push
output energy = energy
'''


@pytest.mark.parametrize('kind', PLACES)
@pytest.mark.parametrize('method, real, most', [('rk4', 'double', 1e-9), ('rk4', 'float', 1e-5), ('heun', 'float', 1e-5)])
def test_restitution_at_100_phases(plant, kind, method, real, most):
    """A hundred places of the impact in its step, at steps from 0.5 to 5 ms: the energy that it leaves. `bumper` is off
    by up to 0.005 with its default stiffness."""
    wrong = []
    for i in range(100):
        step = [0.5, 1, 2, 5][i % 4]
        height, rest = 1 + 2e-3 * i, 0.3 + 7e-3 * i
        found = plant(ball(kind, f'{height!r} m', rest, f'{step} ms', method), real=real).outputs(int(640 / step))
        left = 9.81 * found.z + 0.5 * found.v ** 2
        assert found.z[-1] > 0
        wrong.append(abs(math.sqrt(left[-1] / left[0]) - rest))
    assert max(wrong) < most, max(wrong)


@pytest.mark.parametrize('kind', PLACES)
@pytest.mark.parametrize('real', ['double', 'float'])
@pytest.mark.parametrize('method', METHODS)
def test_a_ball_comes_to_rest(plant, kind, method, real):
    """After infinitely many bounces at the exact time, but for two steps and the next flight; there it lies, 0.81 g h^2 deep with rk4
    and 1.56 g h^2 with the others, at most a tenth more on the way, and bears its weight."""
    found = plant(ball(kind, method=method), real=real).outputs(8000)
    first = int(np.argmax(found.holds > 0))
    truth = math.sqrt(2 / 9.81) * (1 + 2 * 0.8 / (1 - 0.8))
    late = 0.2 if method == 'semi_implicit' else 0.01       # a method of order one
    assert np.count_nonzero(np.diff(found.holds)) == 1 and truth - late < first * 1e-3 < truth
    deep = {'rk4': 0.806, 'heun': 1.5626, 'semi_implicit': 1.5626}[method] * 9.81e-6
    rounding = 1e-6 if real == 'float' else 1e-9
    assert abs(found.z[-1] + deep) < 1e-3 * deep and found.z.min() > -1.1 * deep
    assert abs(found.v[-1]) < rounding and abs(abs(found.push[-1]) - 2 * 9.81) < 20 * rounding
    assert method != 'rk4' or found.z.min() > -9.81e-6


PULL = '''effect pull { joint along; state now s = 0 s; rate now = 1; effort on along = 40 N * max(now - 2 s, 0 s)^2 / 1 s^2 }
effect p pull { along fall }
'''


@pytest.mark.parametrize('kind', PLACES)
@pytest.mark.parametrize('method, most', [('rk4', 2.0), ('heun', 3.5), ('semi_implicit', 4.5)])
def test_what_rests_leaves(plant, kind, method, most):
    """A force grows until it lifts the ball: from there on its way is exact to some g h^2, at three steps."""
    for step in (2, 1, 0.5):
        found = plant(ball(kind, '0.1 m', 0.3, f'{step} ms', method, PULL)).outputs(round(3500 / step))
        held = math.sqrt(2 * 9.81 / 40)
        u = np.maximum(1e-3 * step * np.arange(len(found.z)) - 2 - held, 0)
        truth = 20 * (held * u ** 3 / 3 + u ** 4 / 12)
        late = np.arange(len(found.z)) * step > 1500
        assert np.abs(found.z - truth)[late].max() < most * 9.81e-6 * step ** 2
        assert truth[-1] > 1 and np.count_nonzero(np.diff(found.holds)) == 2


def test_stops_at_both_ends(plant):
    """A cart between two walls loses the same part at each, at 100 phases."""
    for i in range(100):
        found = plant(f'''step 1 ms
method rk4
body cart {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child cart; axis x; speed 1 m/s; start {1.7e-5 * i!r} m }}
effect ends rigid_stop {{ along rail; lower -0.1 m; upper 0.1 m; rest 0.8 }}
output v = speed of rail
''').outputs(1000).v
        speeds = sorted(set(np.round(np.abs(found), 12)), reverse=True)
        assert len(speeds) == 4 and np.abs(np.array(speeds) - 0.8 ** np.arange(4)).max() < 1e-12


CHAIN = '''gravity (0, -9.81, 0) m/s^2
step {step} ms
method rk4
events 2 rest rk4
body upper {{ rod 1 m of 1 kg at (0, -0.5, 0) m rotate 90 deg about x }}
body lower {{ rod 1 m of 0.5 kg at (0, -0.5, 0) m rotate 90 deg about x }}
joint shoulder revolute {{ parent ground; child upper; axis z; start 60 deg }}
joint elbow revolute {{ parent upper at (0, -1, 0) m; child lower; axis z; start 20 deg; speed 1 rad/s }}
effect a rigid_stop {{ along shoulder; lower -40 deg; upper 80 deg; rest 0.5 }}
effect b rigid_stop {{ along elbow; lower -30 deg; upper 30 deg; rest 0.2 }}
output a = position of shoulder
output b = position of elbow
output energy = energy
output lost = event_loss
'''


def test_impacts_in_a_chain(plant):
    """Both joints hit their stops: order four, and what is lost stands in the account."""
    runs = [plant(CHAIN.format(step=step)).outputs(round(1000 / step), every=round(20 / step)) for step in (2, 1, 0.0625)]
    errors = [np.abs(run.rows[:, :2] - runs[2].rows[:, :2]).max() for run in runs[:2]]
    print(errors, runs[2].lost[-1])
    assert errors[1] < 1e-9 and errors[0] / errors[1] > 10 and runs[2].lost[-1] > 0.1
    account = runs[1].energy + runs[1].lost
    assert np.ptp(account) < 1e-8


def test_a_stop_in_a_closed_loop_is_hit(plant):
    """A four-bar: the crank is thrown back with its part of the speed, and the loop stays closed."""
    scene = '''gravity (0, -9.81, 0) m/s^2
step 1 ms
method rk4
body crank { rod 0.3 m of 1 kg at (0.15, 0, 0) m rotate 90 deg about y }
body coupler { rod 0.9 m of 2 kg at (0.45, 0, 0) m rotate 90 deg about y }
body rocker { rod 0.7 m of 1 kg at (0.35, 0, 0) m rotate 90 deg about y }
joint a revolute { parent ground; child crank; axis z; start 60 deg; speed 5 rad/s }
joint b revolute { parent crank at (0.3, 0, 0) m; child coupler; axis z; start about -40 deg }
joint c revolute { parent ground at (1, 0, 0) m; child rocker; axis z; start about 110 deg }
close d revolute { parent coupler at (0.9, 0, 0) m; child rocker at (0.7, 0, 0) m; axis z }
effect e rigid_stop { along a; lower 30 deg; upper 80 deg; rest 0.5 }
output a = position of a
output va = speed of a
output off = violation
output energy = energy
output lost = event_loss
'''
    found = plant(scene).outputs(3000)
    assert found.a.max() < math.radians(80.001) and found.a.min() > math.radians(29.9)
    assert found.off.max() < 1e-6 and found.lost[-1] > 1 and found.energy[-1] + found.lost[-1] < found.energy[0] + 1e-3


@pytest.mark.parametrize('pattern, by', [(r'R\(-0\.8\)', 'R(-0.79)'), (r'both\[1\] = .*;', 'both[1] = R(0.0);')])
def test_a_planted_defect_is_found(plant, pattern, by):
    """Another restitution; an impact that is placed by the secant alone."""
    text = ball('rigid_bumper', '1 m', 0.8, '5 ms')
    found = plant(text, change=lambda source: replaced(pattern, by, source)).outputs(128)
    left = 9.81 * found.z + 0.5 * found.v ** 2
    assert abs(math.sqrt(left[-1] / left[0]) - 0.8) > 1e-7


@pytest.mark.parametrize('line, words', [('method ab4', 'events are for'), ('method rk4\nchecked yes', 'leave out the events')])
def test_methods_without_events_are_refused(isoc, line, words):
    made = isoc(ball().replace('method rk4', line))
    assert made.refused and words in made.errors


def test_what_is_too_light_for_the_step_is_told(isoc):
    """isoc tries the modes that a stop can have: one that holds is too stiff for an inertia that the effect does not know."""
    tie = 'effect tie { joint along; effort on along = -1.5e7 N/m * (position of along - 1 m) }; effect strap tie { along fall }\n'
    assert isoc(ball('rigid_stop')).errors == ''
    assert isoc(ball('rigid_stop', more=tie), '--without', 'floor').errors == ''
    assert 'too fast' in isoc(ball('rigid_stop', more=tie)).errors


# --- a ball on a plane ---

THROWN = '''gravity (0, 0, -9.81) m/s^2
step 1 ms
method rk4
body ball {{ sphere 10 cm of 1 kg }}
joint air free {{ parent ground; child ball; start at (0, 0, {start}) m; speed (1, 0, 0) m/s; spin (0, 3, 0) rad/s }}
effect floor rigid_contact {{ ball ball; radius 10 cm; rest {rest}; {more} }}
output x = position of ball along x
output z = position of ball along z
output vx = velocity of ball along x
output vz = velocity of ball along z
output w = spin of ball in ground along y
output holds = floor.holds
output normal = floor.normal
output energy = energy
output lost = event_loss
output balance = balance
'''


@pytest.mark.parametrize('tilt', [0, 30, -70])
@pytest.mark.parametrize('real, most', [('double', 1e-9), ('float', 2e-5)])
def test_a_ball_on_an_inclined_plane(plant, tilt, real, most):
    """What it has along the plane it keeps, and towards it the part `rest`, at 20 phases."""
    up = np.array([math.sin(math.radians(tilt)), math.cos(math.radians(tilt))])
    for i in range(20):
        found = plant(THROWN.format(start=1 + 1e-3 * i, rest=0.6, more=f'normal (sin({tilt} deg), 0, cos({tilt} deg))'),
                      real=real).outputs(700)
        v = np.stack([found.vx, found.vz], axis=1) @ up
        k = int(np.argmax(np.diff(v) > 0.1))
        # Between the rows before and behind the impact gravity goes on; where it is, follows from the depth.
        far = np.stack([found.x, found.z], axis=1) @ up - 0.1
        fall = -9.81 * up[1]
        at = (-v[k] - math.sqrt(v[k] ** 2 - 2 * fall * far[k])) / fall if fall else -far[k] / v[k]
        hit = v[k] + fall * at
        behind = -0.6 * hit + fall * (1e-3 - at)
        assert abs(v[k + 1] - behind) < most * 10 and abs(found.w[k + 1] - 3) < most
        along = np.array([up[1], -up[0]])
        tangent = np.stack([found.vx, found.vz], axis=1) @ along
        assert abs(tangent[k + 1] - tangent[k] - 9.81 * up[0] * 1e-3) < most
        assert found.balance.max() < 1e-3 and found.lost[-1] > 0


@pytest.mark.parametrize('real', ['double', 'float'])
def test_a_ball_comes_to_roll(plant, real):
    """It bounces out, lies and slips, until friction makes it roll: at 2/7 of what slip there was less than its speed. Its depth is
    that of `rigid_bumper`."""
    found = plant(THROWN.format(start=0.3, rest=0.5, more='friction 0.2'), real=real).outputs(4000)
    rounding = 1e-9 if real == 'double' else 3e-5
    assert found.holds[-1] == 1 and np.count_nonzero(np.diff(found.holds)) == 1
    slip = 1 - 0.1 * 3
    assert abs(found.vx[-1] - (1 - slip * 2 / 7)) < 1e-4 and abs(found.vx[-1] - 0.1 * found.w[-1]) < 1e-4
    assert found.z.min() > 0.1 - 9.81e-6 - rounding and abs(found.normal[-1] - 9.81) < 1e4 * rounding


def test_an_arm_that_hits_the_ground(plant):
    """The tip of two rods: the speeds behind the impact are those of an impulse along the normal at the tip, by the mass matrix that is
    known, and the tip has its part of the speed."""
    scene = '''gravity (0, -9.81, 0) m/s^2
step 1 us
method rk4
body upper { rod 1 m of 1 kg at (0, -0.5, 0) m rotate 90 deg about x }
body lower { rod 1 m of 0.5 kg at (0, -0.5, 0) m rotate 90 deg about x }
joint shoulder revolute { parent ground; child upper; axis z; start 60 deg }
joint elbow revolute { parent upper at (0, -1, 0) m; child lower; axis z; start 20 deg; speed 1 rad/s }
effect floor rigid_contact { ball lower at (0, -1, 0) m; normal (0, 1, 0); height -1.2 m; rest 0.4; load 0.2 kg }
output a = position of shoulder
output b = position of elbow
output da = speed of shoulder
output db = speed of elbow
output energy = energy
output lost = event_loss
'''
    found = plant(scene).outputs(450000, every=1)
    k = int(np.argmax(np.abs(np.diff(found.da)) > 0.05))
    assert k > 1000
    (a, b, *before), after = found.rows[k, :4], found.rows[k + 1, 2:4]
    c, d = 0.5 * 1 * 0.5, 0.5 / 3
    mass = np.array([[1 / 3 + 0.5 + d + 2 * c * math.cos(b), d + c * math.cos(b)], [d + c * math.cos(b), d]])
    row = np.array([math.sin(a) + math.sin(a + b), math.sin(a + b)])        # of the height of the tip
    impulse = -1.4 * (row @ before) / (row @ np.linalg.solve(mass, row))
    assert np.abs(np.array(before) + np.linalg.solve(mass, row) * impulse - after).max() < 1e-4
    assert abs(row @ after + 0.4 * (row @ before)) < 1e-4
    assert abs(found.energy[k + 1] + found.lost[k + 1] - found.energy[0]) < 1e-6


def test_a_velocity_in_an_event(isoc, plant):
    """Of the scene: two components of one body at once; and what is none."""
    scene = '''step 1 ms
method rk4
body puck { mass 2 kg }
joint plane planar { parent ground; child puck; axis z; speed (1, 2, 0) m/s }
when position of puck along x > 0.0105 m { set velocity of puck along (1, 0, 0) = -0.5 m/s; set velocity of puck along (0, 3, 0) = 9 m/s }
output vx = velocity of puck along x
output vy = velocity of puck along y
'''
    scene = scene.replace('body puck { mass 2 kg }', 'body puck { sphere 1 cm of 2 kg }')
    found = plant(scene).outputs(20)
    assert abs(found.vx[-1] + 0.5) < 1e-12 and abs(found.vy[-1] - 3) < 1e-12 and found.vx[5] == 1
    for change, words in (('velocity of puck along (1, 0, 0)', 'along and a vector'), ('velocity of puk along (1, 0, 0)', 'no body is called'),
                          ('velocity of puck along 1', 'a direction')):
        text = scene.replace('velocity of puck along (1, 0, 0)', change if 'vector' not in words else 'velocity of puck')
        made = isoc(text)
        assert made.refused and words in made.errors, made.errors
