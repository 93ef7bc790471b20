"""What acts on a block on a rail: dry friction, stops, bumpers, and impacts of all kinds."""
import math
import pathlib
import random

import numpy as np
import pytest
from harness.plants import other_effect, replaced
from closed_forms import bisected, damping, speed_after

FRICTION = pathlib.Path('tests/isoc/effects/friction.scene').read_text()
SLIP = pathlib.Path('tests/isoc/effects/slip.scene').read_text()
STOP = pathlib.Path('tests/isoc/effects/stop.scene').read_text()
BUMPERS = replaced(r'^effect ends .*$', r'''effect ends bumper { along rail; place 0.15 m; impact 1 m/s; rest 0.8 }
effect start bumper { along rail; side -1; place -0.1 m; impact 1 m/s; rest 0.8 }''', STOP)

# --- friction, as steep as the method allows ---


@pytest.mark.parametrize('method, real', [(method, 'float') for method in (
    'euler', 'heun', 'rk4', 'semi_implicit', 'ab4', 'abm4', 'bdf4', 'rosenbrock')] + [('rk4', 'double'), ('bdf4', 'double')])
def test_friction_stops_holds_creeps_and_lets_go(plant, method, real):
    """A block of 2 kg with 3 N while it slides and 4 N at rest. It slides to rest and never gains energy; held against 2 N it
    creeps at the speed of the closed form and no faster; 5 N tear it off."""
    p = plant(FRICTION, '--method', method, real=real)
    creep, ulp = p.made.chosen['drag.creep'], p.ulp
    push = np.repeat([0, 2, 5, 5], 1000)
    y = p.follow(4000, {'push': push}).y
    speed, energy = y.speed.astype(float), y.energy.astype(float)
    # bdf4 passes zero a little where it comes to rest: by less than a tenth of the energy at the speed of creep.
    passing = 0.05 * 2 * creep**2 if method == 'bdf4' else 0
    assert np.diff(energy[:1001]).max() <= 4 * ulp * energy[0] + passing
    assert abs(speed[1000]) < 1e-3 * creep
    assert abs(y.loss[1000]) <= 4 * ulp * energy[0], 'what it loses is its power'
    # static w (3 - w^2) / 2 = push, w = v / creep. The effort at rest is known to a few roundings of 4 N; the speed to as
    # many of creep, which isoc prints with nine digits.
    expected = creep * bisected(0, 1, lambda w: 4 * w * (3 - w * w) / 2 < 2)
    assert abs(speed[2000] - expected) <= (32 * ulp + 1e-8) * creep
    # Beyond the fall of the curve the force on the block is push - sliding.
    gained, most = speed[4000] - speed[3000], (5 - 3) / 2
    least = most - (4 - 3) / 2 / (1 + (speed[3000] / (10 * creep))**2)
    assert least * (1 - 1e-3) <= gained <= most * (1 + 1e-3)


def holding(plant, seed, real, definitions=''):
    """Of 24 frictions of random values: how far the largest effort over all speeds, that just below creep, is off `static`, in
    ulp, and whether it is against every speed."""
    r, scene, values = random.Random(seed), ['step 1 ms'], []
    for i in range(24):
        static = 10**r.uniform(-3, 4)
        creep, fall = 10**r.uniform(-5, 0), 10**r.uniform(-6, 1)
        sliding, fall = static * r.choice([0, 0.5, 0.99, 1, r.random()]), creep if i % 4 == 0 else fall
        scene.append(f'body b{i} {{ mass 1 kg }}; joint j{i} prismatic {{ parent ground; child b{i}; axis x }}\n'
                     f'effect e{i} friction {{ along j{i}; static {static} N; sliding {sliding} N; creep {creep} m/s; '
                     f'fall {fall} m/s }}; output effort{i} = e{i}.effort')
        values.append((static, creep))
    p = plant('\n'.join(scene) + '\n' + definitions, real=real)
    part = 1e-6 * 10**(12 * np.abs(np.arange(-1000, 1001)) / 1000) * np.where(np.arange(-1000, 1001) < 0, -1, 1)
    part[1000] = 1 - 8 * p.ulp
    p.start()
    rows, static = np.repeat(p.now, len(part)), np.array([v[0] for v in values])
    x = rows['x'].copy()
    for i, (_, creep) in enumerate(values):
        x[:, p.places['x'][f'j{i}_speed']] = part * creep
    effort = p.outputs_at(rows, x).astype(float)
    return (np.abs(np.abs(effort).max(0) / static - 1) / p.ulp).max(), (part[:, None] * effort).max() <= 0


@pytest.mark.parametrize('real', ['float', 'double'])
def test_friction_holds_static_whatever_fall_and_creep_are(plant, seed, real):
    """Each factor of the formula is rounded once: three ulp."""
    off, is_against = holding(plant, seed, real)
    assert off <= 3 and is_against


def test_a_root_for_the_sign_of_the_speed_holds_less(plant):
    off, _ = holding(plant, 1, 'double', other_effect('friction', 'let near = .*', 'let near = v * sqrt(1 / (v^2 + creep^2))'))
    assert off > 1000


# --- stick and slip ---


def slips(times, speed):
    """The mean of the last five periods of the slips, which begin where the speed rises through that of the spring's end."""
    rises = np.flatnonzero((speed[:-1] < 0.05) & (speed[1:] >= 0.05))
    begins = times[rises] + (times[1] - times[0]) * (0.05 - speed[rises]) / (speed[rises + 1] - speed[rises])
    assert len(begins) > 5
    return (begins[-1] - begins[-6]) / 5


def integrated(creep, ticks, h=1e-4, parts=4):
    """The same equations by rk4 in steps of a quarter of the tick."""
    def acceleration(x, v, end):
        beyond = max(v * v - creep * creep, 0)
        near = min(max(v / creep, -1), 1)
        return (200 * (end - x) - (3 + 1 / (1 + beyond / 0.014**2)) * near * (3 - near * near) / 2) / 2

    x, v, d, speed = 0.0, 0.0, h / parts, [0.0]
    for tick in range(ticks):
        end = 0.05 * h * tick
        for _ in range(parts):
            a = acceleration(x, v, end)
            b = acceleration(x + d / 2 * v, v + d / 2 * a, end)
            c = acceleration(x + d / 2 * (v + d / 2 * a), v + d / 2 * b, end)
            e = acceleration(x + d * (v + d / 2 * b), v + d * c, end)
            x, v = x + d * (v + d / 6 * (a + b + c)), v + d / 6 * (a + 2 * b + 2 * c + e)
        speed.append(v)
    return np.array(speed)


def test_a_block_sticks_and_slips_with_its_period(plant):
    """The period is that of the integration, and longer than that of the closed form for a friction that falls at once: while
    it slips it swings about the place where the spring holds the sliding friction, from a stretch beyond that by `far` to one
    short of it by as much. The spring's force has the rounding of its places, up to 0.25 m, of the 1 N that the period is of;
    rk4 follows a creep at half of what it holds to some parts in a million. The control has a hundredth newton more."""
    ticks = 50000
    times = 1e-4 * np.arange(ticks + 1)
    far, w = (4 - 3) / 200, math.sqrt(200 / 2)
    closed = 2 * far / 0.05 + 2 / w * (math.pi - math.atan(far * w / 0.05))
    exact = slips(times, integrated(plant(SLIP).made.chosen['drag.creep'], ticks))
    for real in ('float', 'double'):
        p = plant(SLIP, real=real)
        period = slips(times, p.follow(ticks).y.speed.astype(float))
        assert abs(period / exact - 1) <= 10 * 200 * 0.25 * p.ulp + 1e-5
        assert closed < period < 1.1 * closed
    other = plant(SLIP.replace('static 4 N', 'static 4.01 N'))
    assert abs(slips(times, other.follow(ticks).y.speed) / exact - 1) > 1e-4


# --- stops and bumpers, as stiff as the method allows ---


def bounced(p, impacts=4):
    """How far four impacts are off their law, over what is expected, and whether none gives energy."""
    y = p.follow(4000).y
    last, off, energy = 1.0, [], []
    for v, x, e in zip(y.speed[1:].astype(float), y.place[1:], y.energy[1:]):
        if v * last < 0 and -0.1 < x < 0.15 and len(off) < impacts:
            expected = speed_after(abs(last), damping(0.8))
            off.append(abs(abs(v) - expected) / expected)
            energy.append(e)
            last = v
    assert len(off) == impacts
    return max(off), max(energy) < y.energy[0]


SHORT = {'euler': 0.02, 'heun': 0.0145, 'rk4': 0.0065, 'semi_implicit': 0.0145, 'ab4': 0.0145, 'bdf4': 0.0145}


@pytest.mark.parametrize('method, scene, real', [(method, 'stop', 'float') for method in SHORT]
                         + [('rk4', 'stop', 'double'), ('rk4', 'bumpers', 'double')])
def test_stops_leave_what_the_law_says(plant, method, scene, real):
    """What an impact falls short of at most (models/README.md), over a rest of 0.8."""
    off, loses = bounced(plant(STOP if scene == 'stop' else BUMPERS, '--method', method, real=real))
    assert off <= SHORT[method] and loses


# --- impacts of all kinds, in small steps ---

STEP, ANGLE, TICKS = 1e-5, 1e-2, 6000
RESTS = [1, 0.999, 0.8, 0.6, 0.4, 0.2, 0.05, None]  # None: it leaves faster than the effect follows


def impact(r, i, kind, rest):
    """The text of one; its speed, the sign of its pushes. The speed is the one for which the rest is meant; the stiffness is that
    with which 1 + d times as much, as at the begin of an impact, oscillates by ANGLE in a step."""
    is_fast, part = rest is None, rest or 0.5
    mass, speed, other = 10**r.uniform(-2, 2), 10**r.uniform(-1, 1), 10**r.uniform(-2, 2)
    ratio = r.choice([-1, 1]) * 10**r.uniform(-0.5, 0.5) if kind == 'backlash' else 0
    stiffness = mass / (1 + ratio**2 * mass / other) * (ANGLE / STEP)**2 / (1 + damping(part))
    side = r.choice([-1, 1]) if kind in ('stop', 'bumper') else -1 if kind == 'contact' else 1
    now, start = side * speed, -side * speed * STEP * r.uniform(1, 3)
    gap = (1600000 if is_fast else 16000) * speed * STEP  # to its other side it does not come
    start += gap / 2 * (kind == 'backlash')
    if is_fast:
        start, now = start + side * speed * STEP * 1000, -side * speed * 100
    common = f'impact {speed} m/s; rest {part}; stiffness {stiffness} N/m'
    shown, others = f'speed of j{i}', ''
    if kind == 'stop':
        ends = 'lower -1 km; upper 0 m' if side > 0 else 'lower 0 m; upper 1 km'
        effect = f'along j{i}; {ends}; {common}'
    elif kind == 'bumper':
        effect = f'along j{i}; place 0 m; side {side}; {common}'
    elif kind == 'contact':
        effect = f'ball b{i}; {common}'
    else:
        others = f'body o{i} {{ mass {other} kg }}\njoint k{i} prismatic {{ parent ground; child o{i}; axis x }}\n'
        effect, shown = f'motor j{i}; load k{i}; gap {gap} m; ratio {ratio}; {common}', f'{shown} - {ratio} * speed of k{i}'
    push = 'normal' if kind == 'contact' else 'effort'
    text = (f'body b{i} {{ mass {mass} kg }}\njoint j{i} prismatic {{ parent ground; child b{i}; '
            f'axis {"z" if kind == "contact" else "x"}; start {start} m; speed {now} m/s }}\n{others}'
            f'effect e{i} {kind} {{ {effect} }}\noutput speed{i} = {shown}\noutput push{i} = e{i}.{push}\noutput loss{i} = loss of e{i}\n')
    return text, now, -side if kind in ('stop', 'bumper') else 1


def wrong_impacts(plant, seed, real, definitions=''):
    """The kinds that do not leave their rest, pull, or give power; and whether the account of energy closes.

    What rk4 makes of the corner at the begin of an impact: in a step whose part r is before it the force is off by (1 - r)^2 / 2
    - max(1 / 2 - r, 0) 2 / 3 - (1 - r) / 6 of (1 + d) (w h)^2 times the speed, at most 1 / 24 of it; at its end by as much or
    less. In float a speed is rounded in each step: v0 by half an ulp in each of rk4's sums and by one in its slopes' sum. The
    depth a lead of 0.0091 h later takes a part of at most 1 - exp(-pi ANGLE 0.0091 / 2) besides."""
    r, wrong, power = random.Random(seed), set(), 0
    cases = [(kind, rest) for kind in ('stop', 'bumper', 'backlash', 'contact') for rest in RESTS]
    made = [impact(r, i, *case) for i, case in enumerate(cases)]
    p = plant(f'step {STEP * 1e6} us\n' + ''.join(text for text, *_ in made) + 'output balance = balance\n' + definitions, real=real)
    y = p.follow(TICKS).y
    for i, ((kind, rest), (_, speed, sign)) in enumerate(zip(cases, made)):
        push, loss, v = (y[f'{name}{i}'][1:].astype(float) for name in ('push', 'loss', 'speed'))
        push *= sign
        most = push.max()
        allowed = 2 * ANGLE**2 / 24 + TICKS * p.ulp
        short = (rest or 0) + v[-1] / speed
        if rest and not (-allowed <= short <= allowed + 0.5 * math.pi * 0.0091 * ANGLE * rest and most > 0):
            wrong.add(kind)
        if not (push.min() >= 0 and loss.min() >= -4 * p.ulp * most * abs(speed)):
            wrong.add(kind)
        # The terms of the account: what is pushed and what is lost; what is stored is at most both.
        power = max(power, (np.abs(push * v) + np.abs(loss)).max())
    return wrong, np.abs(y.balance).max() <= len(cases) * 8 * p.ulp * power


@pytest.mark.parametrize('real', ['float', 'double'])
def test_impacts_leave_their_rest_and_never_pull(plant, seed, real):
    assert wrong_impacts(plant, seed, real) == (set(), True)


@pytest.mark.parametrize('kind, text, by', [(kind, r'impact_damping\(rest\)', '1.5 * (1 - rest)') for kind in ('stop', 'bumper', 'backlash', 'contact')]
                         + [('stop', r'push = min\((.*), 0\) - min\((.*), 0\)$', r'push = \1 - (\2)'),
                            ('bumper', r'\(push - depth\)', '(1.01 * push - depth)')])
def test_a_changed_impact_is_found(plant, kind, text, by):
    wrong, closes = wrong_impacts(plant, 1, 'double', other_effect(kind, text, by))
    assert wrong <= {kind} and (wrong or not closes)
