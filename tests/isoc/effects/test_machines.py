"""The effects between joints and of bodies in space, tick by tick against closed forms: angles counted, impacts, a linear
gear, a body that is caught, flight against the air, a propeller that speeds up."""
import math
import pathlib

import numpy as np
import pytest
from harness.plants import other_effect
from closed_forms import damping, speed_after
from laws.law import noise

SCENE = pathlib.Path('tests/isoc/effects/machines.scene').read_text()
TICKS, JAM_AT, PUSH_AT, H = 3000, 1000, 2000, 1e-3
T = H * np.arange(1, TICKS + 1)


class Run:
    """All rows but the first, in double, and what was given."""

    def __init__(self, p):
        tick = np.arange(TICKS)
        self.torque = (0.1 * np.sin(0.02 * tick)).astype(p.number)
        self.push = np.where(tick < JAM_AT, 2 * np.sin(0.01 * tick), np.where(tick < PUSH_AT, 0, 1000)).astype(p.number)
        made = p.follow(TICKS, {'torque': self.torque, 'push': self.push}, {JAM_AT: {'jam_active': 1}})
        self.rows, self.ulp, self.chosen = made, p.ulp, p.made.chosen
        self.torque, self.push = self.torque.astype(float), self.push.astype(float)

    def y(self, name):
        return self.rows.y[name][1:].astype(float)

    def x(self, name):
        return self.rows.x[name][1:].astype(float)


def encoders_count_both_ways(r):
    """The angle is 50 deg + 60 t - 30 t^2: forth by 4.8 turns, and back by more. By the formula it is that of a speed of at
    most 120 rad/s, which is rounded in each tick; within the turn, and without the wrap, it is the angle of the state."""
    per_radian, angle, count, wound = 400 / (2 * math.pi), math.radians(50) + 60 * T - 30 * T * T, r.y('count'), r.y('wound')
    assert (np.abs(count + 0.5 - angle * per_radian) - 0.5 <= TICKS * r.ulp / 2 * 120 * T * per_radian).all()
    whole = count + 0.5 - r.x('wheel') * per_radian
    assert (np.abs(whole - 400 * np.round(whole / 400)) - 0.5 <= 16 * r.ulp * 200).all()
    assert (np.abs(wound + 0.5 - r.y('turned') * per_radian) - 0.5 <= 4 * r.ulp * (np.abs(wound) + 1)).all()
    assert ((r.y('index') == 1) == (count % 400 == 0)).all()
    assert (np.abs(r.y('angle') - count / per_radian) <= 4 * r.ulp * 100).all()


def gear_play_leaves_what_the_law_of_impacts_says(r):
    """Free within the gap, with the other sign of the speed, an impact is over. It falls short by what rk4 does at most
    (models/README.md), over a rest of 0.8. The momentum stays."""
    last, impacts, off = 10.0, 0, 0.0
    for apart, rate in zip(r.y('apart'), r.y('apart_rate')):
        if abs(apart) < 0.05 and rate * last < 0:
            expected = speed_after(abs(last), damping(0.8) / 10)
            last, impacts, off = rate, impacts + 1, max(off, abs(abs(rate) - expected) / expected)
    assert impacts > 4 and off <= 0.0065
    assert (np.abs(r.y('momentum') - 20) <= TICKS * r.ulp * 20).all()


def a_cable_pulls_by_its_stretch_and_throws_back(r):
    """Places are known to 2 ulp; the tension is 2000 N/m times as much. Where it gets taut within a step, the force is off for
    a step by k v h."""
    z = r.y('height')
    rate = r.y('speed') * np.where(z < 0, -1, 1)
    stretch = np.maximum(np.abs(z) - 1, 0)
    assert (np.abs(r.y('tension') - 2000 * stretch * (1 + 0.3 * rate)) <= 2600 * 4 * r.ulp).all()
    assert abs(r.y('speed')[-1] - speed_after(speed_after(1, 0.3), 0.3)) <= 2000 * H * H / 0.5


def a_gear_that_gives_is_linear(r):
    """A step of rk4 is the series of the exponential up to the fourth power. A rounding of the common turning stays; the
    twist ends within 26 ticks."""
    slip = np.array([0.1, 0, -1])
    effort = np.array([0, 20, 0]) + 0.05 * slip
    a = H * np.array([-effort / 10 / 1e-5, slip, effort / 2e-3])
    series = np.eye(3) + a @ (np.eye(3) + a @ (np.eye(3) + a / 4) / 3) / 2  # of which a times it is the step
    y, rows = np.zeros(3), []
    for torque in r.torque:
        y = y + series @ (a @ y + H * np.array([torque / 1e-5, 0, 0]))
        rows.append(y)
    far = np.abs(np.stack([r.x('gear_speed'), r.x('gear_twist'), r.x('output_speed')], 1) - rows)
    assert (far <= np.array([TICKS * 1000, 26, TICKS * 100]) * r.ulp).all()


def a_unit_senses_forces_with_bias_and_noise(r):
    k = slice(1, JAM_AT)
    e = np.array([noise(i + 1, 1) for i in range(JAM_AT)])
    walked = 0.2 * math.sqrt(H) * (np.cumsum(e) - e)
    rounding = 16 * r.ulp
    assert (np.abs(r.y('force_x') - r.push / 2 - 0.1)[k] <= rounding).all()
    assert (np.abs(r.y('force_y')[k] - 0.1 - 0.5 * e[k]) <= rounding).all()
    assert (np.abs(r.y('force_z')[k] - 0.1 - walked[k]) <= rounding + 0.5 * np.arange(1, JAM_AT) * r.ulp).all()
    assert (np.abs(r.y('spin_y')[k] - 0.2) <= rounding).all()


def a_jam_catches_with_critical_damping(r):
    """x = v t exp(-rate t); rk4 leaves out (rate h)^5 / 120 of it in a step. Against a force it gives way as a spring."""
    rate, slide = r.chosen['jam.rate'], r.y('slide')
    at, speed, t = slide[JAM_AT - 1], r.x('rail_speed')[JAM_AT - 1], T[:PUSH_AT - JAM_AT]
    off = np.abs(slide[JAM_AT:PUSH_AT] - at - speed * t * np.exp(-rate * t)) / (speed / rate)
    assert (off <= (rate * H)**5 / 120 * 8 + 16 * r.ulp / 1e-3).all()
    stiff = 1000 / r.chosen['jam.stiffness']
    assert abs(slide[-1] - at - stiff) <= 1e-6 * stiff + 4 * r.ulp


def drag_in_the_wind_slows_as_its_square(r):
    """m v' = -c v^2 in the air, which moves with 1 m/s: v = v0 / (1 + c v0 t / m), with v0 = 5 m/s along (3, 4)."""
    c = 1.2 / 2 * 200e-4
    v, rounding = 5 / (1 + c * 5 * T / 0.5), TICKS * r.ulp * 5
    assert (np.abs(r.y('flown') - np.stack([1 + 0.6 * v, 0.8 * v, 0 * v], 1)) <= rounding).all()
    assert (np.abs(r.y('loss') - c * v**3) <= c * 75 * 4 * rounding).all()


def a_propeller_lifts_and_turns_its_craft(r):
    """Its speed is s (1 - e), e = exp(-t / lag); the integral of the square is that of the thrust."""
    lag = 50e-3
    e = np.exp(-T / lag)
    square = 400**2 * (T - 2 * lag * (1 - e) + lag / 2 * (1 - e * e))
    rounded = TICKS * r.ulp + (H / lag)**5 / 120 * TICKS
    assert (np.abs(r.y('lift') - 1e-5 * square / 0.4) <= rounded * 12).all()
    assert (np.abs(r.y('yaw') - 16e-3 * 1e-5 * square / 2e-3) <= rounded * 40).all()


CHECKS = [encoders_count_both_ways, gear_play_leaves_what_the_law_of_impacts_says, a_cable_pulls_by_its_stretch_and_throws_back,
          a_gear_that_gives_is_linear, a_unit_senses_forces_with_bias_and_noise, a_jam_catches_with_critical_damping,
          drag_in_the_wind_slows_as_its_square, a_propeller_lifts_and_turns_its_craft]


@pytest.fixture(scope='module', params=['float', 'double'])
def run(request, plant):
    return Run(plant(SCENE, real=request.param))


@pytest.mark.parametrize('check', CHECKS, ids=lambda check: check.__name__)
def test_that(run, check):
    check(run)


@pytest.mark.parametrize('kind, text, by, check', [
    ('cable', r'1 \+ slow', '1 + 1.1 * slow', a_cable_pulls_by_its_stretch_and_throws_back),
    ('backlash', r'ratio \* effort', 'effort', gear_play_leaves_what_the_law_of_impacts_says),
    ('encoder', r'\(way < -turn', '(way < -2 * turn', encoders_count_both_ways),
    ('drag', '^    force on on = ', '    force on on = 1.001 * ', drag_in_the_wind_slows_as_its_square),
    ('jammed', 'rate\\^2', '1.001 * rate^2', a_jam_catches_with_critical_damping),
    ('propeller', 'lever \\*', '1.001 * lever *', a_propeller_lifts_and_turns_its_craft)])
def test_a_changed_definition_is_found(plant, kind, text, by, check):
    changed = Run(plant(other_effect(kind, text, by) + SCENE))
    with pytest.raises(AssertionError):
        check(changed)
