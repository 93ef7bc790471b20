"""Shares of a step: what a scene with share(A < B) and pwm(DUTY, PERIOD) computes, against an interpreter that finds the
parts of a step by the crossings of straight lines; errors and orders against exact times; and what is refused."""
import math
import random
import re
import sys

import numpy as np
import pytest

from harness.plants import replaced
from harness.project import ROOT

sys.path.insert(0, str(ROOT / 'tests/isoc/events'))
from exact import Event, Run  # noqa: E402

LOAD = 'body load { mass 1 kg }\njoint rail prismatic { parent ground; child load; axis x }\n'


# --- an interpreter of the meaning that tools/isoc/README.md gives ---

def part_of_step(crossings, holds):
    """The part of 0 to 1 in which `holds`, which changes at these places alone."""
    places = [0.0, *sorted(at for at in crossings if 0 < at < 1), 1.0]
    return sum(b - a for a, b in zip(places, places[1:]) if holds(0.5 * (a + b)))


class Line:
    """A number that changes linearly in states, by their product, with time and with a memory."""

    def __init__(self, draw, states):
        self.by = [draw.uniform(-1, 1) for _ in range(states)]
        self.product, self.pair = draw.choice([0, 0.5]), (draw.randrange(states), draw.randrange(states))
        self.time, self.memory, self.rest = draw.choice([0, draw.uniform(-30, 30)]), draw.choice([0, 0.3]), draw.uniform(-0.5, 0.5)

    def text(self):
        i, j = self.pair
        return ' + '.join([f'({by!r}) * y{i}' for i, by in enumerate(self.by)] +
                          [f'({self.product}) * y{i} * y{j}', f'({self.time!r} 1/s) * time', f'({self.memory}) * m', f'({self.rest!r})'])

    def at(self, y, t, m):
        i, j = self.pair
        return sum(b * s for b, s in zip(self.by, y)) + self.product * y[i] * y[j] + self.time * t + self.memory * m + self.rest

    def rate(self, y, rates):
        i, j = self.pair
        return sum(b * r for b, r in zip(self.by, rates)) + self.product * (rates[i] * y[j] + y[i] * rates[j]) + self.time


class Share:
    is_wave = False

    def __init__(self, draw, states):
        self.lines = [Line(draw, states) for _ in range(draw.choice([1, 1, 2]))]

    def text(self):
        return 'share(' + ' and '.join(f'{line.text()} < 0' for line in self.lines) + ')'

    def at_begin(self, y, t, m):
        return float(all(line.at(y, t, m) < 0 for line in self.lines))

    def over_step(self, y, t, m, rates, h):
        lines = [(line.at(y, t, m), h * line.rate(y, rates)) for line in self.lines]
        return part_of_step([-g / d for g, d in lines if d != 0], lambda s: all(g + s * d < 0 for g, d in lines))


class Wave:
    is_wave = True

    def __init__(self, draw, states, h):
        self.duty, self.period, self.phase = Line(draw, states), h * draw.uniform(1, 12), draw.uniform(0, 6)
        self.duty.time = 0

    def text(self):
        return f'pwm({self.duty.text()}, {self.period!r} s, {self.phase!r} rad)'

    def at_begin(self, y, t, m):
        return float(self.over(t) < min(max(self.duty.at(y, t, m), 0), 1))

    def over(self, t):
        turns = t / self.period + self.phase / (2 * math.pi)
        return turns - math.floor(turns)

    def over_step(self, y, t, m, rates, h):
        over, speed = self.over(t), h / self.period
        duty, change = self.duty.at(y, t, m), h * self.duty.rate(y, rates)
        end = min(max(duty + change, 0), 1)
        duty = min(max(duty, 0), 1)
        change = end - duty
        ends = [(duty + n - over) / (speed - change) for n in (0, 1) if speed != change]
        return part_of_step(ends + [(n - over) / speed for n in (1, 2)],
                            lambda s: (over + s * speed) % 1 < duty + s * change if over + s * speed < 1 else
                            over + s * speed - 1 < duty + s * change)


class Scene:
    """States that go to levels which shares set, whose conditions they are in turn."""

    def __init__(self, seed):
        draw = random.Random(seed)
        self.h, self.count = draw.choice([1e-3, 2e-3]), draw.randint(1, 3)
        self.shares = [draw.choice([lambda: Share(draw, self.count), lambda: Wave(draw, self.count, self.h)])()
                       for _ in range(draw.randint(1, 4))]
        self.lags = [draw.uniform(2e-3, 5e-2) for _ in range(self.count)]
        self.levels = [[draw.uniform(-2, 2) for _ in self.shares] for _ in range(self.count)]
        self.start = [draw.uniform(-1, 1) for _ in range(self.count)]

    def text(self):
        states = ''.join(f'    state y{i} = {self.start[i]!r}\n    rate y{i} = (' +
                         ' + '.join(f'({level!r}) * s{k}' for k, level in enumerate(self.levels[i])) +
                         f' - y{i}) / ({self.lags[i]!r} s)\n' for i in range(self.count))
        shares = ''.join(f'    let s{k} = {share.text()}\n' for k, share in enumerate(self.shares))
        shown = ''.join(f'output y{i} = all.y{i}\n' for i in range(self.count)) + \
            ''.join(f'output s{k} = all.s{k}\n' for k in range(len(self.shares)))
        names = '; '.join([f'output y{i}' for i in range(self.count)] + [f'output s{k}' for k in range(len(self.shares))])
        return f'''step {self.h * 1e3} ms
method rk4
{LOAD}effect many {{
    memory m = 0
    next m = 0.5 - 0.9 * m
{shares}{states}    {names}
}}
effect all many {{ }}
{shown}'''

    def rates(self, y, shares):
        return [(sum(level * s for level, s in zip(self.levels[i], shares)) - y[i]) / self.lags[i] for i in range(self.count)]

    def shares_at(self, y, t, m):
        held = [share.at_begin(y, t, m) for share in self.shares]
        for of_waves in (True, False):
            rates = self.rates(y, held)
            found = [share.over_step(y, t, m, rates, self.h) if share.is_wave == of_waves else was
                     for share, was in zip(self.shares, held)]
            held = found
        return held

    def run(self, rows):
        y, m, h = list(self.start), 0.0, self.h
        shares = self.shares_at(y, 0.0, m)
        result = [y + shares]
        for k in range(rows):
            shares = self.shares_at(y, k * h, m)
            a = self.rates(y, shares)
            b = self.rates([s + h / 2 * r for s, r in zip(y, a)], shares)
            c = self.rates([s + h / 2 * r for s, r in zip(y, b)], shares)
            d = self.rates([s + h * r for s, r in zip(y, c)], shares)
            y = [s + h / 6 * (p + 2 * q + 2 * r + v) for s, p, q, r, v in zip(y, a, b, c, d)]
            m = 0.5 - 0.9 * m
            result.append(y + shares)
        return np.array(result)


@pytest.mark.seeds(20)
def test_shares_of_random_scenes(plant, seed):
    scene = Scene(seed)
    assert np.abs(plant(scene.text()).outputs(200).rows - scene.run(200)).max() < 1e-8


@pytest.mark.parametrize('pattern, by', [
    (r'\+ iso_positive\(-\w+\)', ''),   # without the end of the step
    (r'    find_shares\(memory\);\n', '    (void)find_shares;\n')])                     # those of row 0 for ever
def test_planted_defects_are_found(plant, pattern, by):
    scene = next(scene for scene in map(Scene, range(99)) if len(scene.shares) == 2 and not any(s.is_wave for s in scene.shares))
    found = plant(scene.text(), change=lambda text: replaced(pattern, by, text)).outputs(200)
    assert np.abs(found.rows - scene.run(200)).max() > 1e-3


# --- errors and orders ---

ROWS = [5, 10, 20, 40, 80]
R, L, V, P, D = 10.0, 25e-3, 60.0, 1e-3, 0.3712345


def chopper(step, on, real='double', method='rk4'):
    """The current of a winding at a chopper of 1 kHz, from its periodic state on, and its exact course."""
    a, b = math.exp(-D * P * R / L), math.exp(-(1 - D) * P * R / L)
    low = V / R * (1 - a) * b / (1 - a * b)
    high = V / R + (low - V / R) * a
    rows = round(20e-3 / (step * 1e-6))
    over = np.arange(rows + 1) * step * 1e-6 % P
    truth = np.where(over < D * P, V / R + (low - V / R) * np.exp(-over * R / L), high * np.exp(-(over - D * P) * R / L))
    return rows, truth, f'''step {step} us
method {method}
{LOAD}effect chopper {{
    signal duty
    state i A = {low!r} A
    let over = time / 1 ms - floor(time / 1 ms)
    rate i = ({on} * {V} V - {R} Ohm * i) / {L} H
    output i
}}
effect c chopper {{ duty {D} }}
output i = c.i
'''


@pytest.mark.parametrize('real', ['double', 'float'])
@pytest.mark.parametrize('step', [20, 19.4])
def test_pwm_of_1_khz_at_20_us(plant, step, real):
    """Within 1e-4 of its mean, at steps that divide the period and others; by a comparison 1 % is off and more."""
    errors = []
    for on in ('pwm(duty, 1 ms)', '(over < duty)'):
        rows, truth, text = chopper(step, on)
        errors.append(np.abs(plant(text, real=real).outputs(rows).i - truth).max() / truth.mean())
    assert errors[0] < 1e-4 and errors[1] > 1e-2


class Carrier:
    """A triangle between -1 and 1 against a sine, as a chopper by comparison has it."""
    text = '''    state c = -1; mode up = 1; rate c = if(up == 1, 400 1/s, -400 1/s)
    when c > 1 and up == 1 { set up = 0 }
    when c < -1 and up == 0 { set up = 1 }
    state sine = 0.2; state other = 0.6; rate sine = 150 1/s * other; rate other = -150 1/s * sine
    let on = ON(c < sine)
    state i = 0; rate i = (2 * on - 1 - i) / 10 ms
    output i'''
    start, shown = [-1, 1, 0.2, 0.6, 0, 1], 4

    @staticmethod
    def rates(x):
        return [400 if x[1] == 1 else -400, 0, 150 * x[3], -150 * x[2], (2 * x[5] - 1 - x[4]) / 10e-3, 0]

    @staticmethod
    def events():
        return [Event(lambda x: max(1 - x[0], 0.5 - x[1]), lambda x: [x[0], 0, *x[2:]], True),
                Event(lambda x: max(x[0] + 1, x[1] - 0.5), lambda x: [x[0], 1, *x[2:]], True),
                Event(lambda x: x[2] - x[0], lambda x: [*x[:5], 0]), Event(lambda x: x[0] - x[2], lambda x: [*x[:5], 1])]


class Natural:
    """A wave whose duty moves within its period."""
    text = '''    state sine = 0.2; state other = 0.6; rate sine = 150 1/s * other; rate other = -150 1/s * sine
    let on = WAVE
    state i = 0; rate i = (2 * on - 1 - i) / 10 ms
    output i'''
    start, shown = [0, 0.2, 0.6, 0, 1], 3

    @staticmethod
    def rates(x):
        return [200, 150 * x[2], -150 * x[1], (2 * x[4] - 1 - x[3]) / 10e-3, 0]

    @staticmethod
    def events():
        return [Event(lambda x: max(0.5 + 0.5 * x[1] - x[0], 0.5 - x[4]), lambda x: [*x[:4], 0], True),
                Event(lambda x: 1 - x[0], lambda x: [x[0] - 1, *x[1:4], 1], True)]


class Place:
    """A magnet that pulls a mass on one side of a place."""
    text = '''    state x = 1; state v = 0
    rate x = 200 1/s * v; rate v = -200 1/s * (x + 0.8 * ON(x > 0.3))
    let i = x
    output i'''
    start, shown = [1, 0, 1], 0

    @staticmethod
    def rates(x):
        return [200 * x[1], -200 * (x[0] + 0.8 * x[2]), 0]

    @staticmethod
    def events():
        return [Event(lambda x: x[0] - 0.3, lambda x: [x[0], x[1], 0]), Event(lambda x: 0.3 - x[0], lambda x: [x[0], x[1], 1])]


class Own:
    """What switches is of the state that it acts on."""
    text = '''    state i = 0; rate i = (9 - 5 * ON(i > 1) - i) / 30 ms
    output i'''
    start, shown = [0, 0], 0

    @staticmethod
    def rates(x):
        return [(9 - 5 * x[1] - x[0]) / 30e-3, 0]

    @staticmethod
    def events():
        return [Event(lambda x: 1 - x[0], lambda x: [x[0], 1])]


def errors_of(plant, case, by):
    """Root mean squares over 48 ms, at these numbers of steps in 2 ms."""
    run = Run(case.rates, case.events(), case.start, 2e-5)
    truth = [run.until(2e-3 * (k + 1))[case.shown] for k in range(24)]
    found = []
    wave = {'share': 'pwm(0.5 + 0.5 * sine, 5 ms)', '': '(time / 5 ms - floor(time / 5 ms) < 0.5 + 0.5 * sine)'}[by]
    for rows in ROWS:
        text = case.text.replace('ON(', by + '(').replace('WAVE', wave)
        scene = f'''step {2000 // rows} us
method rk4
events 2 rest rk4
{LOAD}effect e {{
{text}
}}
effect one e {{ }}
output i = one.i
'''
        ours = plant(scene).outputs(24 * rows).i[rows::rows]
        found.append(math.sqrt(np.mean((ours - truth) ** 2)))
    return found


@pytest.mark.parametrize('case', [Carrier, Natural, Place, Own])
def test_orders(plant, case):
    """A share is of order two where a comparison is of order one or less."""
    shares, compared = errors_of(plant, case, 'share'), errors_of(plant, case, '')
    order = [-np.polyfit(np.log2(ROWS), np.log2(errors), 1)[0] for errors in (shares, compared)]
    print(case.__name__, shares, compared, order)
    assert order[0] > 1.7 and shares[-1] < 0.1 * compared[-1]


# --- with other features, and what is refused ---

ANY = f'''step 1 ms
method rk4
{LOAD.replace('axis x', 'axis x; speed 1 m/s')}effect any {{
    signal duty = 0.3
    state v = 0
    rate v = (pwm(duty, 2.5 ms) + share(position of along > 0 m) - v) / 10 ms
    joint along
    effort on along = (1 - 2 * share(position of along > 0 m)) * 20 N
    output v
}}
effect one any {{ along rail }}
output v = one.v
output x = position of rail
'''


@pytest.mark.parametrize('change, most', [
    (('effect one any { along rail }', 'effect one any { along rail; substeps 4 }'), 1e-4), (('method rk4', 'method rosenbrock'), 1e-4),
    (('method rk4', 'method rk4\nsubsteps 4'), 1e-4), (('method rk4', 'method heun'), 2e-3), (('method rk4', 'method semi_implicit'), 0.4)])
def test_shares_go_with(plant, change, most):
    """Sub-steps and other methods, one of order one among them: the same motion within their errors."""
    found, other = plant(ANY).outputs(200), plant(ANY.replace(*change)).outputs(200)
    assert np.ptp(found.x) > 0.04 and np.ptp(found.v) > 0.5
    assert np.abs(found.rows - other.rows).max() < most


def test_a_ladder_has_shares_on_each_rung(isoc):
    made = isoc(ANY + 'overrun degrade { method heun; drop one; after 10 ticks }\n')
    assert made.status == 0, made.errors
    source = made.file('plant.c')
    assert source.count('    find_shares(memory);\n') >= 2 and 'find_shares_without_one' in source


def test_what_shares_cost_is_told(isoc):
    """Each part that is below zero has one division: one for the share, three for the wave, of which one is constant."""
    made = isoc(ANY)
    plain = isoc(ANY.replace('share(position of along > 0 m)', '1').replace('pwm(duty, 2.5 ms)', '1'))
    step = [int(of.summary['step'].split(' div ')[1].split()[0]) for of in (made, plain)]
    assert step[0] - step[1] == 4


REFUSED = [
    ('share(floor(time / 1 ms) < 3)', 'jump within a step'),
    ('share(if(v > 0, v, 2) < 1)', 'jump within a step'),
    ('share(v < 1 or v > 2)', 'joined by .and.'),
    ('share(not v < 1)', 'joined by .and.'),
    ('share(v)', 'joined by .and.'),
    ('share(v == 1)', 'joined by .and.'),
    ('share(speed of along < 1 m)', 'must have the same unit'),
    ('share(share(v < 1) < 0.5)', 'not from another share'),
    ('pwm(share(v < 1), 5 ms)', 'not from another share'),
    ('share(acceleration of along < 1 m/s^2)', "'acceleration' is known after"),
    ('share(soft < 0.5)', 'let it be held'),
    ('pwm(v, 0.5 ms)', 'a step of 0.001 s or longer'),
    ('pwm(v, v * 1 s)', 'constant'),
    ('pwm(v * 1 V, 5 ms)', 'the duty of a pwm'),
    ('pwm(v)', 'is written like this'),
    ('share(v < 1, 2)', 'is written like this'),
]


@pytest.mark.parametrize('share, words', REFUSED)
def test_refused_by_name(isoc, share, words):
    smooth = 'input soft smooth\n' if 'soft' in share else ''
    scene = f'''step 1 ms
method rk4
{smooth}{LOAD}effect any {{ joint along; signal soft = 0; state v = 0; rate v = ({share} - v) / 10 ms; output v }}
effect one any {{ along rail{'; soft soft' if smooth else ''} }}
output v = one.v
'''
    made = isoc(scene)
    assert made.refused and re.search(words, made.errors) and re.search(r':\d+:\d+: error', made.errors), made.errors


@pytest.mark.parametrize('line, words', [('method ab4', 'ab4 has a history: take rk4'), ('method bdf4', 'take rosenbrock'),
                                         ('method adams', 'adams has a history'), ('method rk4\nchecked yes', 'leave out the shares')])
def test_methods_that_know_no_jumps_are_refused(isoc, line, words):
    made = isoc(ANY.replace('method rk4', line))
    assert made.refused and words in made.errors, made.errors


def test_no_model_exchange(isoc):
    made = isoc(ANY, '--fmu', '--fmi', '3', '--exchange')
    assert made.status == 1 and 'this share is that of a step' in made.errors


def test_a_linear_model_holds_it(isoc):
    """As every memory; it says which."""
    made = isoc(ANY, '--linear')
    assert made.status == 0 and 'kept_share' in made.printed + made.errors, made.printed + made.errors
