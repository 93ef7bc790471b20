"""The clock of an importer and the ticks of the plant: each way to add time is taken as long as it is within a quarter of
a tick of the plant's own, and refused from there on, as exact arithmetic says."""
import decimal
import functools
import random

import numpy as np
import pytest
from importer import OK, Instance

SCENE = '''step {} ns
method euler
body b {{ mass 1 kg }}
joint j prismatic {{ parent ground; child b; axis x; start 0.5 m }}
force pull {{ body b; axis x; drive push }}
input push
output x = position of j
'''
PERIODS = {'1 ms': 1_000_000, '100 ms': 100_000_000, '1/60 s': 16_666_667}
AHEAD = 4_000_000  # ticks of the first step: behind them rounding adds up to a millionth of a tick in some thousand steps
STEPS = 20_000


def sums(start, h, number):
    """t += h."""
    t = number(start)
    while True:
        yield float(t), float(h)
        t = number(t + number(h))


def doubles(start, period, draw):
    return sums(start, period / 1e9, float)


def floats(start, period, draw):
    return sums(start, period / 1e9, np.float32)


def products(start, period, draw):
    i, h = round(start * 1e9 / period), period / 1e9
    while True:
        yield i * h, h
        i += 1


def kahan(start, period, draw):
    t, lost, h = start, 0.0, period / 1e9
    while True:
        yield t, h
        more = h - lost
        after = t + more
        t, lost = after, (after - t) - more


def sixtieths(start, period, draw):
    """A step that the tick has but for a rounding to ns, where there is one."""
    return sums(start, 1 / round(1e9 / period), float)


def sevens(start, period, draw):
    return sums(start, 7 * (period / 1e9), float)


def nanoseconds(start, period, draw):
    i = round(start * 1e9 / period)
    while True:
        yield i * period / 1e9, (i + 1) * period / 1e9 - i * period / 1e9
        i += 1


def texts(start, period, draw):
    """Times as they stand in a file of 6 decimals."""
    i = round(start * 1e9 / period)
    while True:
        t, after = (float(f'{decimal.Decimal(j * period) / 10**9:.6f}') for j in (i, i + 1))
        yield t, after - t
        i += 1


def multiples(start, period, draw):
    t = start
    while True:
        h = draw.randint(1, 9) * (period / 1e9)
        yield t, h
        t += h


WAYS = [doubles, floats, products, kahan, sixtieths, sevens, nanoseconds, texts, multiples]


@pytest.fixture(scope='module', params=[2, 3])
def fmus(request, fmu):
    return {name: fmu(SCENE.format(period), request.param) for name, period in PERIODS.items()}


def expected(tick, t, h, period):
    """The tick at which a step ends, or None where it is refused; and how near that is, in ticks. The arithmetic is right
    to 1e-9 of a tick."""
    start, end = t * 1e9 / period, (t + h) * 1e9 / period
    last = round(end)
    off = max(abs(start - tick), abs(end - last))
    return (last if off <= 0.25 and last > tick else None), abs(off - 0.25)


def drive(model, way, period, draw, steps=STEPS):
    """So many steps of a clock, from AHEAD on: the tick that was reached, how many steps were taken, what was said, and
    whether each was taken or refused as it should be. The hash is that of one step to there."""
    run = Instance(model)
    assert run.begin() == OK and run.step(1e-9 * period) == OK and run.restore(model.ahead) == OK
    tick, taken, is_right = AHEAD, 0, True
    for t, h in way(AHEAD * period / 1e9, period, draw):
        last, near = expected(tick, t, h, period)
        if taken == steps or near < 1e-6:  # where rounding decides
            break
        is_taken = run.step(h, t) == OK
        is_right = is_taken == (last is not None)
        if not is_taken or not is_right:
            break
        tick, taken = last, taken + 1
    made, said = run.hash(), [message for _, message in run.messages]
    assert run.restore(model.ahead) == OK
    assert tick == AHEAD or run.step((tick - AHEAD) * 1e-9 * period, AHEAD * 1e-9 * period) == OK
    assert run.hash() == made
    run.free()
    return tick, taken, said, is_right


@pytest.fixture(scope='module')
def clocked(fmu):
    """The FMU of a version and a tick, and its state behind AHEAD ticks."""

    def load(version, name, **options):
        model = fmu(SCENE.format(PERIODS[name]), version, **options)
        run = Instance(model)
        assert run.begin() == OK and run.step(AHEAD * 1e-9 * PERIODS[name]) == OK
        model.ahead = run.take()
        run.free()
        return model

    return functools.cache(load)


@pytest.mark.parametrize('version, way', [(3, way) for way in WAYS] + [(2, doubles), (2, sixtieths), (2, multiples)])
@pytest.mark.parametrize('name', PERIODS)
def test_ways(clocked, version, name, way, seed):
    tick, taken, said, is_right = drive(clocked(version, name), way, PERIODS[name], random.Random(seed))
    assert is_right, (tick, taken, said)
    assert taken == STEPS or way is floats  # 24 bits are not enough for parts of a tick


@pytest.mark.parametrize('version', [2, 3])
def test_wrong(clocked, version):
    """A clock that is truly wrong is refused by name: half a tick off, a step between two ticks, one that is 3 % long."""
    name, period = '1 ms', PERIODS['1 ms']
    start = AHEAD * 1e-9 * period
    for way, steps, words in (
            (lambda *_: iter([(start + 0.0005, 0.001)]), 0, 'the plant is at'),
            (lambda *_: iter([(start, 0.0015)]), 0, 'no whole multiple of the tick'),
            (lambda *_: iter([(start, 0.0002)]), 0, 'no whole multiple of the tick'),
            (lambda *_: sums(start, 0.00103, float), 8, 'no whole multiple of the tick')):
        tick, taken, said, is_right = drive(clocked(version, name), way, period, None)
        assert is_right and abs(taken - steps) <= 1 and words in said[-1], (taken, said)


@pytest.mark.parametrize('version', [2, 3])
def test_stop(clocked, version):
    """The end of a run may be a rounding before its last tick; a tick more is refused."""
    run = Instance(clocked(version, '100 ms'))
    end = sum(10 * [0.1])
    assert end < 1.0 and run.begin(stop=end) == OK
    for i in range(10):
        assert run.step(0.1, i * 0.1) == OK
    assert run.step(0.1, 1.0) != OK and 'the end of the run was said to be' in run.messages[-1][1]
    run.free()


@pytest.mark.parametrize('version', [2, 3])
@pytest.mark.parametrize('name', ['1 ms', '1/60 s'])
def test_control(clocked, version, name):
    """Found: a millionth of a tick is all that a clock may be off."""
    model = clocked(version, name, change=lambda text: text.replace('FMU_PERIOD_NS / 4e9', 'FMU_PERIOD_NS / 1e15'))
    assert not drive(model, doubles if name == '1 ms' else sixtieths, PERIODS[name], None)[3]
