"""Balls on the ground: impacts leave the speed of their law, a ball that slides ends by rolling with 5/7 of its speed, and what
stands on the ground falls freely when the ground goes."""
import pathlib

import numpy as np
import pytest
from harness.plants import other_effect
from closed_forms import damping, speed_after

SCENE = pathlib.Path('tests/isoc/effects/ground.scene').read_text()
TICKS, DROP_AT, H, G = 2300, 2000, 1e-3, 9.81
T = H * np.arange(1, TICKS + 1)


class Run:
    """All rows but the first."""

    def __init__(self, p):
        level = np.where(np.arange(TICKS) < DROP_AT, 0.05, -1)
        self.rows, self.ulp = p.follow(TICKS, {'level': level}), p.ulp
        # The weight rests on the ground to the rounding of 5 cm at 20 kN/m: a part of it, of the speed as well.
        self.rounding = 4 * p.ulp * 0.05 * 20e3 / (0.3 * G) + TICKS * p.ulp + 1e-6

    def y(self, name):
        return self.rows.y[name][1:].astype(float)


def three_impacts_leave_what_the_law_says(r):
    """The speeds at the ground, by height and speed in flight. An impact falls short by what rk4 does at most, over a rest of
    0.8; and gravity takes up to 7 g h of the 1.3 m/s and more that are left."""
    last, off = 0.0, []
    for z, v in zip(r.y('fallen_z') - 0.05, r.y('falling')):
        at_ground = max(v * v + 2 * G * z, 0)**0.5
        if z > 0:
            if v > 0 > last and len(off) < 3:
                expected = speed_after(-last, damping(0.8) / 2)
                off.append(abs(at_ground - expected) / expected)
            last = -at_ground if v < 0 else at_ground
    assert len(off) == 3 and max(off) <= 0.0065 + 7 * G * H / 1.3


def a_ball_slides_until_it_rolls(r):
    """Friction is 0.3 m g against its way; the slip, of 1 m/s, falls by 7/2 as much."""
    slides = 1 - 3.5 * 0.3 * G * T > 0.05
    v = (1 - 0.3 * G * T)[slides, None] * [0.8, 0.6]
    assert (np.abs(r.y('rolling')[slides, :2] - v) <= r.rounding).all()
    left = 5 / 7 * 0.8
    assert abs(r.y('rolling_x')[-1] - left) <= r.rounding and abs(0.05 * r.y('spinning_y')[-1] - left) <= r.rounding


def a_point_stands_and_falls_freely_when_the_ground_goes(r):
    at, speed = r.y('stood')[DROP_AT - 1], float(r.rows.x.lift_z_speed[DROP_AT])
    assert abs(at - (0.05 - 0.1 * G / 10e3)) <= 1e-6 + 4 * r.ulp
    t = T[:TICKS - DROP_AT]
    assert (np.abs(r.y('stood')[DROP_AT:] - at - speed * t + 0.5 * G * t * t) <= 4 * 300 * r.ulp).all()


def no_impact_gives_energy(r):
    """In an impact the account of a tick is as good as rk4: it leaves out of the point's oscillation with 316 rad/s, and at
    most the 0.1 J of its fall. Where the ground goes, what it has stored is lost."""
    rows = np.flatnonzero(r.y('fallen_z') > 0.05)
    rise = np.diff(np.concatenate([r.y('energy')[:1], r.y('energy')[rows]]))[rows != DROP_AT]
    assert rise.max() <= 16 * r.ulp * r.y('energy')[0] + ((10e3 / 0.1)**0.5 * H)**5 / 120 * 0.1


@pytest.fixture(scope='module', params=['float', 'double'])
def run(request, plant):
    return Run(plant(SCENE, real=request.param))


@pytest.mark.parametrize('check', [three_impacts_leave_what_the_law_says, a_ball_slides_until_it_rolls,
                                   a_point_stands_and_falls_freely_when_the_ground_goes, no_impact_gives_energy],
                         ids=lambda check: check.__name__)
def test_that(run, check):
    check(run)


@pytest.mark.parametrize('text, by, check', [
    (r'impact_damping\(rest\)', '2 * impact_damping(rest)', three_impacts_leave_what_the_law_says),
    (r'arm = -radius', 'arm = -0.99 * radius', a_ball_slides_until_it_rolls),
    (r'rub = min\(friction', 'rub = min(1.001 * friction', a_ball_slides_until_it_rolls)])
def test_a_changed_contact_is_found(plant, text, by, check):
    changed = Run(plant(other_effect('contact', text, by) + SCENE))
    with pytest.raises(AssertionError):
        check(changed)
