"""What isoc says of events: of those that follow others within a step, at the time at which they do, and nothing of what
has its time; and of those that do not happen."""
import pathlib
import re
import sys

import pytest

sys.path.append(str(pathlib.Path(__file__).parents[1] / 'events'))
import test_random  # noqa: E402
from test_random import ROWS, STEP  # noqa: E402

MEETS = r'this event follows .* within a step of \S+ ms, at (\S+) s, and waits'
DECAYS = 'this event does not happen'


README = ' '.join(pathlib.Path('tools/isoc/README.md').read_text().split())


def warning(made):
    """The first line that isoc said, from the number of the line of the scene on."""
    return made.errors.splitlines()[0].split('.scene', 1)[1]


def meeting(errors, within):
    """The step in which events meet first, within so many rows; None where in none."""
    told = [round(float(at) / STEP) for at in re.findall(MEETS, errors)]
    return min((step for step in told if step <= within), default=None)


@pytest.mark.seeds(12, 4)
@pytest.mark.parametrize('slots', [1, 2])
def test_events_that_meet(isoc, seed, slots):
    """Against the times of all events, found to rounding: the first step with more events than slots. What isoc follows
    has times to 1/1000 of a step: an event that is nearer to an end of one may be on its other side."""
    scene = test_random.Scene(seed)
    run = scene.run()
    run.until(STEP * ROWS)
    steps = [int(at / STEP) for at, _ in run.fired]
    near = min(abs(at / STEP - round(at / STEP)) for at, _ in run.fired)
    crowded = [step + 1 for step in steps if steps.count(step) > slots]
    made = isoc(scene.text().replace('events 3', f'events {slots}'), '--real', 'double')
    found = meeting(made.errors, ROWS)
    assert DECAYS not in made.errors
    assert found == min(crowded, default=None) or near < 1e-3, (found, crowded)


def test_the_family_has_both():
    """Scenes whose events meet, and scenes whose events do not."""
    met = []
    for seed in range(1, 13):
        run = test_random.Scene(seed).run()
        run.until(STEP * ROWS)
        steps = [int(at / STEP) for at, _ in run.fired]
        met.append(len(set(steps)) < len(steps))
    assert 2 < met.count(True) < 10


BALL = '''gravity (0, 0, -9.81) m/s^2
step 1 ms
body ball { mass 1 kg }
joint fall prismatic { parent ground; child ball; axis z; start START m }
when position of fall < 0 m { set speed of fall = -REST * speed of fall PLACE }
output z = position of fall
'''


@pytest.mark.parametrize('start, rest', [(1, 0.8), (0.5, 0.6), (2, 0.3)])
def test_a_ball_that_comes_to_rest(isoc, start, rest):
    """At the first step with two bounces, whose times are a geometric row; not where the event sets the place too, nor where
    the ball bounces for ever."""
    scene = BALL.replace('START', str(start)).replace('REST', str(rest))
    made = isoc(scene.replace('PLACE', ''))
    told = re.findall(MEETS, made.errors)
    assert (warning(made) in README) == (start == 1)
    at, flight, last = (2 * start / 9.81) ** 0.5, 2 * (2 * start / 9.81) ** 0.5, -1
    while int(at / 1e-3) > last:
        last = int(at / 1e-3)
        flight *= rest
        at += flight
    assert [round(float(time), 3) for time in told] == [round(1e-3 * (last + 1), 3)]
    assert 'this event' not in isoc(scene.replace('PLACE', '; set position of fall = 0 m')).errors
    assert 'this event' not in isoc(scene.replace('PLACE', '').replace(str(rest), '1')).errors


@pytest.mark.parametrize('balls, slots', [(1, 1), (2, 1), (2, 2), (3, 2), (3, 3)])
def test_balls_that_lie_on_the_ground(isoc, plant, balls, slots):
    """A ball at rest takes an event in each step: with more balls than slots the last one falls through the ground, and
    that is told."""
    scene = f'gravity (0, 0, -9.81) m/s^2\nstep 1 ms\nevents {slots}\n' + ''.join(f'''body b{i} {{ mass 1 kg }}
joint f{i} prismatic {{ parent ground; child b{i}; axis z; start {0.1 + 0.02 * i} m }}
when position of f{i} < 0 m {{ set speed of f{i} = -0.3 * speed of f{i}; set position of f{i} = 0 m }}
output z{i} = position of f{i}
''' for i in range(balls))
    lowest = plant(scene).outputs(5000, every=1000).rows[-1].min()
    says = isoc(scene).errors
    assert (lowest < -1) == ('this event follows that of line' in says) == (balls > slots)
    assert f'take `events {balls}`' in says or balls <= slots


DECAY = '''step 1 ms
body load { mass 1 kg }
joint rail prismatic { parent ground; child load; axis x }
effect decay { state x = START; rate x = -RATE 1/s * x; output x }
effect d decay { }
mode done = 0
when d.x CONDITION { set done = done + 1 }
output done = done
'''


@pytest.mark.seeds(8, 3)
def test_what_decays_to_a_value(isoc, plant, seed):
    """A state that decays to 0 from either side does not reach it, and fires at a thousandth of its start."""
    draw = test_random.random.Random(seed)
    start, below = draw.choice([-1, 1]) * 10 ** draw.uniform(-6, 6), draw.choice(['<', '<='])
    scene = DECAY.replace('START', repr(start)).replace('RATE', repr(draw.uniform(10, 500)))
    passes = below if start > 0 else below.replace('<', '>')
    at_zero, before = (scene.replace('CONDITION', f'{passes} {limit!r}') for limit in (0, start / 1000))
    assert DECAYS in isoc(at_zero).errors and plant(at_zero).outputs(3000, every=3000).done[-1] == 0
    assert 'this event' not in isoc(before).errors and plant(before).outputs(3000, every=3000).done[-1] == 1
    # A port may drive it on, and no event has happened yet where there is time left.
    driven = at_zero.replace('effect decay {', 'input u 1/s\neffect decay { signal u 1/s; ').replace('* x;', '* x + u;')
    assert 'this event' not in isoc(driven.replace('decay { }', 'decay { u u }')).errors
    slow = at_zero.replace('-RATE', '-').replace(re.search(r'rate x = -(\S+)', at_zero)[1], '0.5')
    assert 'this event' not in isoc(slow).errors


def test_a_thyristor_that_never_blocks(isoc):
    """Its current decays to 0 from above: blocked at `i < 0 A` it would carry a third too much, and be told."""
    scene = '''step 50 us
effect thyristor {
    value resistance Ohm
    value inductance H
    state i A = 0 A
    state phase rad = 0 rad
    mode on = 0
    let back = -inductance * stable_rate * i
    rate i = if(on == 1, max(325 V * sin(phase) - resistance * i, back), back) / inductance
    rate phase = 314.159 rad/s
    when phase > 2 * pi { set phase = phase - 2 * pi }
    when phase > 60 deg { set on = 1 }
    when i < LIMIT { set on = 0 }
    output i
}
body dummy { mass 1 kg }
joint rail prismatic { parent ground; child dummy; axis x }
effect t thyristor { resistance 10 Ohm; inductance 20 mH }
output i = t.i
'''
    made = isoc(scene.replace('LIMIT', '0 A'))
    assert made.errors.count(DECAYS) == 1 and warning(made) in README
    assert 'this event' not in isoc(scene.replace('LIMIT', '1 mA')).errors
