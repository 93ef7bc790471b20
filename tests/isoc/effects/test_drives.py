"""A shaft that swings in its cogging, a chopper that feeds a winding, and wind, against closed forms; the chopper also against
its switchings, at any step; the wind against its recurrences and the spectra of Dryden; batteries against their equation."""
import math
import pathlib
import random

import numpy as np
import pytest
from harness.plants import other_effect
from laws.law import noise

SCENE = pathlib.Path('tests/isoc/effects/drives.scene').read_text()
TICKS, RISES_AT, FALLS_AT, H = 2000, 100, 200, 1e-3


class Run:
    def __init__(self, p):
        self.rows, self.ulp = p.follow(TICKS), p.ulp

    def y(self, name):
        return self.rows.y[name].astype(float)


def cogging_swings_as_a_pendulum(r):
    """Of a pendulum with the amplitude a the period is 2 pi / w / M(1, cos(a / 2)), M the mean of Gauss. The phase errs by
    (w h)^4 / 120, a crossing between two ticks by less than (w h)^2 / 8 of a tick; in float the rounding of an angle adds up."""
    w = math.sqrt(0.2 * 12 / 1e-3)
    a, b = 1.0, math.cos(0.5 * 12 * math.radians(2))
    for _ in range(8):
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    angle = r.y('angle') - math.pi / 180
    rises = np.flatnonzero((angle[:-1] < 0) & (angle[1:] >= 0))
    times = H * (rises + angle[rises] / (angle[rises] - angle[rises + 1]))
    period = (times[-1] - times[0]) / (len(times) - 1)
    assert len(times) > 11 and abs(period * w * a / (2 * math.pi) - 1) <= (w * H)**4 / 60 + TICKS * r.ulp


# --- the chopper of the scene ---

SUPPLY, BACK, INDUCTANCE, DROP, PERIOD, PERIODS = 24.0, 12.0, 5e-3, 0.7, 100e-6, 10


def switched_tick(current, on):
    """The current after a tick of switchings; its mean, and that of the transistor."""
    up, down, mean, fed = (SUPPLY - BACK) / INDUCTANCE, (BACK + DROP) / INDUCTANCE, 0.0, 0.0
    for _ in range(PERIODS):
        top = current + up * on * PERIOD
        falls = min((1 - on) * PERIOD, top / down)
        end = max(top - down * falls, 0)
        part = 0.5 * (current + top) * on
        fed, mean, current = fed + part / PERIODS, mean + (part + 0.5 * (top + end) * falls / PERIOD) / PERIODS, end
    return current, mean, fed


def a_chopper_has_the_means_of_its_switchings(r):
    """In a tick the current rises or falls by 2.5 A, and its mean is that of the half; beyond that the switchings have their
    ripple. Where it comes to zero the last 2 A take the time that the step allows: some ticks, which are left out."""
    current, shown = 0.0, r.y('current')
    for tick in range(400):
        current, mean, fed = switched_tick(current, 0.3 if tick < RISES_AT else 0.9 if tick < FALLS_AT else 0)
        if tick == RISES_AT - 2:  # its row is the last with the duty from before
            assert abs(shown[tick + 1] - mean) <= 1e-4 * mean and abs(r.y('drawn')[tick + 1] - fed) <= 1e-4 * fed
            assert abs(r.y('voltage')[tick + 1] - BACK) <= 1e-4 * BACK
        if tick > RISES_AT and (current > 2.5 or tick > FALLS_AT + 90):
            assert abs(0.5 * (shown[tick] + shown[tick + 1]) - mean) <= (SUPPLY - BACK) * 0.9 * PERIOD / INDUCTANCE
    most = shown[:401].max()
    assert most > 100 and shown[:401].min() >= -most * r.ulp


# --- wind ---


def seed_of(effect, number):
    """Of the noise of an effect: FNV-1a (Fowler, Noll, Vo) of its name, and beyond."""
    made = 2166136261
    for byte in effect.encode():
        made = (made ^ byte) * 16777619 % 2**32
    return made + number


def blown(x, seed, count):
    """A lag of x = h V / L of the noise of ticks 1 to count, and two in series, as spectra of Dryden have them across."""
    left = math.exp(-x)
    fresh, now, second, along, across = math.sqrt(1 - left * left), 0.0, 0.0, [], []
    for tick in range(count):
        e = noise(tick + 1, seed)
        second = left * (second + x * now) + (0.5 - left * left * (0.5 + x)) / fresh * e
        now = left * now + fresh * e
        along.append(now)
        across.append(math.sqrt(1.5) * now + (math.sqrt(0.5) - math.sqrt(1.5)) * second)
    return np.array(along), np.array(across)


HEIGHT, SIGMA_UP = 12.0, 0.8
LOW = 0.177 + 0.000823 * HEIGHT / 0.3048
LENGTH, SIGMA = HEIGHT / LOW**1.2, SIGMA_UP / LOW**0.4


def wind_is_that_of_its_recurrences(r):
    """What rounding has added in a tick is forgotten after L / V, at most 800 ticks."""
    forth = 8 + SIGMA * blown(H * 100 / LENGTH, seed_of('field', 1), TICKS)[0]
    side = SIGMA * blown(H * 100 / LENGTH, seed_of('field', 2), TICKS)[1]
    c, s = math.sqrt(0.75), 0.5
    wind = np.stack([c * forth - s * side, s * forth + c * side, SIGMA_UP * blown(H * 100 / HEIGHT, seed_of('field', 3), TICKS)[1]], 1)
    assert (np.abs(r.y('wind')[1:] - wind) <= 800 * r.ulp * 12).all()
    assert (np.abs(r.y('other')[1:] - blown(25 * H, seed_of('other', 1), TICKS)[0]) <= 800 * r.ulp * 12).all()


@pytest.fixture(scope='module', params=['float', 'double'])
def run(request, plant):
    return Run(plant(SCENE, real=request.param))


CHECKS = [cogging_swings_as_a_pendulum, a_chopper_has_the_means_of_its_switchings, wind_is_that_of_its_recurrences]


@pytest.mark.parametrize('check', CHECKS, ids=lambda check: check.__name__)
def test_that(run, check):
    check(run)


@pytest.mark.parametrize('kind, text, by, check', [
    ('cogging', r'sin\(angle\)$', 'sin(1.001 * angle)', CHECKS[0]),
    ('chopper', r'\(supply \+ drop\) \* edge', 'supply * edge', CHECKS[1]),
    ('gusts', r'0\.5 - left\^2', '0.51 - left^2', CHECKS[2]),
    ('gust', r'sqrt\(1 - left\^2\)', '(1 - left)', CHECKS[2])])
def test_a_changed_definition_is_found(plant, kind, text, by, check):
    changed = Run(plant(other_effect(kind, text, by) + SCENE))
    with pytest.raises(AssertionError):
        check(changed)


WIND = '''step 1 ms
effect field gusts { wind 8 m/s; heading 0 deg; height 12 m; speed 100 m/s }
body b { mass 1 kg }
joint j prismatic { parent ground; child b; axis x }
output wind_x = field.wind_x; output wind_y = field.wind_y; output wind_z = field.wind_z
'''


def test_wind_has_the_correlations_of_dryden(plant):
    """exp(-|t|) of the first axis, of the others (1 - |t| / 2) of it; t in L / V. The mean of the products of a Gaussian process
    with itself over N samples deviates by sqrt(sum over all lags of r^2 + r r / N), at most sqrt(2 sum r^2 / N): four of these
    are allowed, and what the steps leave out."""
    p, count, parts = plant(WIND), 400_000, 8
    p.start()
    wind = np.concatenate([p.go(count // parts, first=k * count // parts)[0]['y'][1:] for k in range(parts)])
    for i, (mean, length, sigma) in enumerate([(8, LENGTH, SIGMA), (0, LENGTH, SIGMA), (0, HEIGHT, SIGMA_UP)]):
        x, now = H * 100 / length, (wind[:, i] - mean) / sigma
        lag = round(1 / x)

        def correlation(n):
            t = np.abs(x * n)
            return np.exp(-t) * (1 if i == 0 else 1 - 0.5 * t)

        square = (correlation(np.arange(-20 * lag, 20 * lag + 1))**2).sum()
        allowed = 4 * math.sqrt(2 * square / count) + x * x
        for n in range(3):
            found = (now[n * lag:] * now[:count - n * lag]).mean()
            assert abs(found - correlation(n * lag)) <= allowed, (i, n)


# --- choppers in discontinuous conduction, and batteries ---


def cell(s):
    """A cell at rest: Chen, Rincon-Mora (2006), eq. 2."""
    return -1.031 * np.exp(-35 * s) + 3.685 + 0.2156 * s - 0.1178 * s * s + 0.3201 * s**3


def mean_of(on, supply, back, drop, resistance, inductance, period):
    """The mean current of the switchings, and the part of the period in which there is any: it rises as an exponential of
    L / R, falls as one to zero, and stays there. Its integral follows from the voltages, whose mean at the inductance is zero."""
    lag = inductance / resistance
    top = (supply - back) / resistance * -math.expm1(-on * period / lag)
    falls = lag * math.log1p(top * resistance / (back + drop))
    return ((supply - back) * on * period - (back + drop) * falls) / (resistance * period), on + falls / period


BATTERIES = [(1, 0), (0.5, 1), (0.02, 0.01), (0.005, 0), (0.3, 20), (0.01, 5), (0.9, -20), (1, -3)]  # charge, current


def supplies(plant, seed, step_us, real='double', definitions=''):
    """What is wrong of twelve choppers and eight batteries within a second. A chopper's current is in the end that of its
    switchings, to the part of L / R that a period is; a battery has the voltage of its equation, gives no more than its charge,
    and takes no more than its capacity."""
    r, step, choppers, batteries = random.Random(seed), step_us * 1e-6, [], []
    scene = [f'step {step_us} us', 'body b { mass 1 kg; inertia (1e15, 1e15, 1e15) kg*m^2 }',
             'joint j revolute { parent ground; child b; axis z; continuous; speed 100 rad/s }']
    while len(choppers) < 12:
        resistance, inductance = 10**r.uniform(-1, 1.5), 10**r.uniform(-3.5, -1)
        lag = inductance / resistance
        period, supply, drop, on = lag * 10**r.uniform(-3, -2), r.uniform(5, 50), r.choice([0, 0.7]), r.uniform(0.02, 0.9)
        back = supply * r.uniform(0.1, 0.98)
        mean, part = mean_of(on, supply, back, drop, resistance, inductance, period)
        if part <= 0.9 and 0.004 < lag < 0.02:
            i = len(choppers)
            scene.append(f'effect c{i} chopper {{ duty {on}; supply {supply} V; current m{i}.current; back m{i}.back; drop {drop} V; '
                         f'resistance {resistance} Ohm; inductance {inductance} H; period {period} s }}\n'
                         f'effect m{i} dc_motor {{ shaft j; supply c{i}.voltage; resistance {resistance} Ohm; '
                         f'inductance {inductance} H; constant {back / 100} N*m/A }}\noutput current{i} = m{i}.current')
            choppers.append((mean, period / lag, supply * step / inductance))
    for i, (start, current) in enumerate(BATTERIES):
        cells, resistance = r.randint(1, 8), r.uniform(0, 0.2)
        scene.append(f'effect b{i} battery {{ current {current} A; capacity 10 A*s; resistance {resistance} Ohm; cells {cells}; '
                     f'start {start} }}\noutput charge{i} = b{i}.charge; output voltage{i} = b{i}.voltage; output heat{i} = b{i}.heat')
        batteries.append((start, current, cells, resistance))
    p = plant('\n'.join(scene) + '\n' + definitions, real=real)
    y, ulp, wrong = p.follow(round(1 / step)).y, p.ulp, set()
    for i, (mean, period, rise) in enumerate(choppers):
        # The voltage is rounded; so is the current that it leads to in a step.
        if not abs(y[f'current{i}'][-1] - mean) <= period * mean + 8 * ulp * rise:
            wrong.add('chopper')
    s = (np.arange(10000) + 0.5) / 10000
    for i, (start, current, cells, resistance) in enumerate(batteries):
        charge, voltage, heat = (y[f'{name}{i}'][1:].astype(float) for name in ('charge', 'voltage', 'heat'))
        expected = cells * cell(charge) * np.minimum(charge / 0.005, 1) - resistance * current
        given = (step * (voltage + resistance * current) * current).sum()
        lost = (step * (heat - resistance * current**2)).sum()
        # In an empty one what it still gives is that of the charge below 0.005, at most the voltage there.
        held = (np.where(s < start, cells * 10 * cell(s) * np.minimum(s / 0.005, 1), 0)).mean()
        edge = cells * 10 * 8 * abs(current) * step / 10 * 4.2 + cells * 10 * 1e-3
        if not ((np.abs(voltage - expected) <= 64 * ulp * (cells * 4.2 + resistance * abs(current))).all()
                and charge.min() >= 0 and charge.max() <= 1 and given <= held + edge and lost >= -len(charge) * ulp * current**2):
            wrong.add('battery')
    return wrong


@pytest.mark.parametrize('step_us, real', [(50, 'double'), (500, 'double'), (2000, 'double'), (5000, 'double'), (2000, 'float')])
def test_choppers_and_batteries_at_any_step(plant, seed, step_us, real):
    assert supplies(plant, seed, step_us, real) == set()


@pytest.mark.parametrize('kind, text, by', [
    ('chopper', r'(back|held) \+ resistance \* (current|edge)', r'\1'),
    ('chopper', r'\(2 \* inductance\)', 'inductance'), ('battery', r'0\.3201', '0.3301'),
    ('battery', r', -most \* \(1 - charge\), most \* charge', ', -most, most'),
    ('battery', r'clamp\(before / empty, 0, 1\)', '1')])
def test_a_changed_supply_is_found(plant, kind, text, by):
    assert supplies(plant, 1, 2000, definitions=other_effect(kind, text, by)) == {kind}
