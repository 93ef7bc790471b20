"""The effects of signals and circuits, tick by tick against the same equations: rk4 for what has a state, recurrences for
what has a memory, formulas for the rest. What differs is rounding alone. And what an integration by the same method could
not tell: a steady state, the moments of gusts."""
import math
import pathlib

import numpy as np
import pytest
from harness.plants import other_effect
from laws.law import noise, rk4

SCENE = pathlib.Path('tests/isoc/effects/signals.scene').read_text()
TICKS, FAULT_AT, H = 2000, 1000, 1e-3
FAULTS = ['one', 'two', 'three', 'four', 'five', 'six', 'seven', 'eight']
DIGITS = 1e-8  # of what isoc chose and printed


def cell(s):
    """The voltage of a cell at rest, Chen and Rincon-Mora (2006), eq. 2."""
    return -1.031 * np.exp(-35 * s) + 3.685 + 0.2156 * s - 0.1178 * s * s + 0.3201 * s**3


def clamp(x, least, most):
    return min(max(x, least), most)


def states_of(volts, amps, lag, gain):
    """Filter, slow, charge, current and warmth of each row."""
    def slope(y, u, a):
        current, over = y[3], y[4]
        drop = 2 * (1 + 0.00393 * (20 + over)) * current
        supply = 24 - gain * (current - clamp(current, -3, 3))
        return [(u - y[0]) / 20e-3, clamp((u - y[1]) / lag, -20, 50), -a, (supply - drop) / 20e-3, (drop * current - over / 5) / 0.1]

    y, rows = [0.0, 0.0, 1.0, 0.0, 0.0], []
    for u, a in zip(volts.tolist(), amps.tolist()):
        y = rk4(lambda x, u=u, a=a: slope(x, u, a), y, H)
        rows.append(y)
    return np.array(rows).T


def is_code(found, of, levels, ulp):
    """The nearest code, to the rounding of what it is of."""
    return np.where(found == np.floor(found), np.abs(found - np.clip(of, 0, levels - 1)), np.inf), 0.5 + 8 * ulp * levels


def wrong_outputs(plant, scene, real):
    """The outputs that are not as expected."""
    p = plant(scene, real=real)
    tick = np.arange(TICKS)
    volts = (2 * np.sin(0.011 * tick) + np.where(tick // 333 % 2 == 0, 1, -1)).astype(p.number)
    amps = (0.35 + 2.6 * np.sin(0.04 * tick)).astype(p.number)
    y = p.follow(TICKS, {'volts': volts, 'amps': amps}, {FAULT_AT: {f'{name}_active': 1 for name in FAULTS}}).y
    y = {name: y[name][1:].astype(float) for name in y.places}
    volts, amps, ulp = volts.astype(float), amps.astype(float), p.ulp
    lag, gain = p.made.chosen['slow.lag'], p.made.chosen['fuse.gain']
    filtered, slow, charge, current, over = states_of(volts, amps, lag, gain)
    noise_1, noise_2 = (np.array([noise(int(k) + 1, seed) for k in tick]) for seed in (1, 2))
    walked = 0.5 * math.sqrt(H) * (np.cumsum(noise_2) - noise_2)
    left, gust = math.exp(-25 * H), [0.0]
    for e in noise_1:
        gust.append(left * gust[-1] + 2 * math.sqrt(1 - left * left) * e)
    duty, on = np.clip(volts / 2, -1, 1), tick >= FAULT_AT
    one = 8 * ulp * 3
    # A rounding of each step lasts as long as the time constant, of the charge for ever.
    expected = {
        'filter': (filtered, 4 * 20 * ulp * 3), 'slow': (slow, TICKS * ulp * 3 + DIGITS), 'charge': (charge, TICKS * ulp),
        'limited_current': (current, 4 * 10 * ulp * 24 + DIGITS), 'temperature': (313.15 + over, 500 * ulp * (313.15 + over)),
        'heat': (2 * (1 + 0.00393 * (y['temperature'] - 293.15)) * y['limited_current']**2, 16 * ulp * 30),
        # Of the charge of a tick before.
        'rest': (3 * cell(y['charge']) - 0.1 * amps, 3 * 0.02),
        'limited': (np.clip(volts, -1, 2), one), 'band': (volts - np.clip(volts, -0.5, 0.5), one),
        'converted': (-2 + 4.5 / 1024 * y['code'], one), 'sensed': ((0.5 / 256 * y['sensed_code'] - 0.25) / 0.1, one),
        'bridge': (duty * 24 - 1.4 * amps / np.sqrt(amps**2 + 1e-4) - 0.2 * amps, 8 * one), 'drawn': (duty * amps, one),
        'probe': (1.02 * volts + 0.1 + walked + 0.2 * noise_1, (TICKS + 8) * ulp * 4), 'wind': (3 + np.array(gust[1:]), 2 * 40 * ulp * 10)}
    faults = {'stuck': volts[FAULT_AT - 1], 'dropped': 7, 'shifted': volts + 0.3, 'scaled': volts * 1.5, 'noisy': volts + 0.1 * noise_2,
              'delayed': np.roll(volts, 4), 'weak': volts / 4, 'dead': 0}
    expected.update((name, (np.where(on, of, volts), 8 * ulp * 7)) for name, of in faults.items())
    off = {name: (np.abs(y[name] - of), allowed) for name, (of, allowed) in expected.items()}
    off['code'] = is_code(y['code'], (volts + 3e-3 + 2) / (4.5 / 1024), 1024, ulp)
    off['sensed_code'] = is_code(y['sensed_code'], (0.11 * amps + 2e-3 + 0.25) / (0.5 / 256), 256, ulp)
    assert set(off) == set(y)
    hot = 2 * (1 + 0.00393 * (y['temperature'][-1] - 293.15))
    assert y['limited_current'][-1] == pytest.approx((24 + gain * 3) / (hot + gain), rel=1e-4), 'where the limit holds it'
    return {name for name, (far, allowed) in off.items() if not (far <= allowed).all()}


@pytest.mark.parametrize('real', ['float', 'double'])
def test_each_output_is_what_its_equation_says(plant, real):
    assert wrong_outputs(plant, SCENE, real) == set()


@pytest.mark.parametrize('kind, output, text, by', [('lag', 'filter', r'rate y = \(input', 'rate y = (0.999 * input'),
                                                    ('gust', 'wind', r'sqrt\(1 - left\^2\)', '(1 - left)'),
                                                    ('sensor', 'probe', r'gain \* input', '1.001 * gain * input')])
def test_a_changed_definition_is_found(plant, kind, output, text, by):
    assert wrong_outputs(plant, other_effect(kind, text, by) + SCENE, 'double') == {output}


@pytest.mark.parametrize('real', ['float', 'double'])
def test_gusts_have_the_mean_the_variance_and_the_correlation_of_their_law(plant, real):
    """Of a Gaussian process with the correlation a^n the means of N samples deviate by sigma sqrt((1 + a) / (1 - a) / N),
    its second moments by sigma^2 sqrt(2 (1 + a^2) / (1 - a^2) / N). Four of these are allowed; L / V is 40 ticks."""
    count, a, sigma = 40000, math.exp(-1 / 40), 2.0
    gust = plant(SCENE, real=real).follow(count).y.wind[1:].astype(float) - 3
    few, more = 4 * sigma * math.sqrt((1 + a) / (1 - a) / count), 4 * sigma**2 * math.sqrt(2 * (1 + a * a) / (1 - a * a) / count)
    assert abs(gust.mean()) <= few
    assert abs((gust * gust).mean() - sigma**2) <= more
    assert abs((gust[40:] * gust[:-40]).mean() - sigma**2 / math.e) <= more
