"""A ball rolls on each of the six planes across a coordinate axis. A thin disc rolls in general position: steady motions, and motions that
tumble, on planes and with axles of several directions, by an explicit and by an implicit method, against its equations of motion written
by hand. And discs that cannot stand are refused."""
import math
import re

import numpy as np
import pytest


@pytest.mark.parametrize('axis, place, spin, part, speed', [
    ('x', '(0.1,0,0)', '(0,2,0)', 'z', '-0.2'), ('-x', '(-0.1,0,0)', '(0,2,0)', 'z', '0.2'), ('y', '(0,0.1,0)', '(0,0,2)', 'x', '-0.2'),
    ('-y', '(0,-0.1,0)', '(0,0,2)', 'x', '0.2'), ('z', '(0,0,0.1)', '(2,0,0)', 'y', '-0.2'), ('-z', '(0,0,-0.1)', '(2,0,0)', 'y', '0.2')])
def test_a_ball_rolls_on_the_side_to_which_the_normal_points_and_no_other(isoc, axis, place, spin, part, speed):
    """Its centre, at 0.1 n, moves as its spin w says, with w x 0.1 n; on the other side it is refused, two radii off."""
    def ball(at):
        return isoc(f'''step 1 ms
body ball {{ mass 1 kg; inertia (1, 1, 1) g*m^2 }}
joint air free {{ parent ground; child ball; start at {at} m rotate 0 deg about x; spin {spin} rad/s }}
close plane rolling {{ parent ground; child ball; axis {axis}; radius 0.1 m }}
output place = position of ball
''')

    assert re.search(rf'^assembled air_{part}_speed {speed} m/s$', ball(place).printed, re.M)
    other = '(' + ','.join(str(-float(x)) for x in place.strip('()').split(',')) + ')'
    assert 'a gap of 0.2 m remains' in ball(other).errors


# --- a disc ---

MASS, RADIUS, ACROSS, ABOUT, G = 2.0, 0.3, 0.045, 0.09, 9.81
MRR = MASS * RADIUS**2


def slope(x):
    """In the axes u (level), e (up in the disc) and w (the axle), with w at the angle theta from the plane's normal n, the angular velocity is
    (p, q, r), and these axes turn with (p, q, q cot theta); the lowest point is at -radius e from the centre and rests, so that the
    centre's velocity is radius (-r, 0, p). Newton's and Euler's equations, without the contact force, for the moments of inertia A across
    the axle and C about it (O'Reilly 1996, The dynamics of rolling disks and sliding disks, Nonlinear Dynamics 10):

        (A + m radius^2) p' = A q^2 cot theta - (C + m radius^2) q r - m g radius cos theta
        A q' = C p r - A p q cot theta
        (C + m radius^2) r' = m radius^2 p q
        theta' = p,  psi' = q / sin theta,  centre' = radius (-r u + p w)"""
    theta, psi, p, q, r = x[:5]
    s, c = math.sin(theta), math.cos(theta)
    cot = c / s
    return np.array([p, q / s, (ACROSS * q * q * cot - (ABOUT + MRR) * q * r - MASS * G * RADIUS * c) / (ACROSS + MRR),
                     (ABOUT * p * r - ACROSS * p * q * cot) / ACROSS, MRR * p * q / (ABOUT + MRR),
                     RADIUS * (-r * math.cos(psi) + p * s * math.sin(psi)), RADIUS * (-r * math.sin(psi) - p * s * math.cos(psi))])


def look(x, height):
    """What does not depend on the axes of the scene: energy, height, tilt, how far it has gone, and the contact force m (a + g n)."""
    theta, _, p, q, r, *_ = x
    d, s, c = slope(x), math.sin(theta), math.cos(theta)
    energy = 0.5 * (MRR * (p * p + r * r) + ACROSS * (p * p + q * q) + ABOUT * r * r) + MASS * G * RADIUS * s
    a = RADIUS * np.array([p * q - d[4], -(p * p + q * r * c / s), d[2] + q * r])
    gone = math.sqrt(x[5]**2 + x[6]**2 + (RADIUS * s - height)**2)
    return [energy, RADIUS * s, c, gone, MASS * np.linalg.norm(a + [0, G * s, G * c])]


def by_hand(theta, p, q, r, ticks, h, finer=4):
    """The looks of each tick, by the classical Runge-Kutta method."""
    x = np.array([theta, 0, p, q, r, 0, 0])
    height, d = RADIUS * math.sin(theta), h / finer
    rows = [look(x, height)]
    for _ in range(ticks):
        for _ in range(finer):
            k1 = slope(x)
            k2 = slope(x + d / 2 * k1)
            k3 = slope(x + d / 2 * k2)
            x = x + d / 6 * (k1 + 2 * k2 + 2 * k3 + slope(x + d * k3))
        rows.append(look(x, height))
    return np.array(rows)


# On the ground, below a ceiling that pulls it up, on a slope; with its axle along z, x, or between them: the axis, the normal, the wheel, the
# inertia, how the disc is turned at the start, and its spin.
PLACES = {
    'ground': ('z', (0, 0, 1), '(0, 0, 1)', '(0.045, 0.045, 0.09)', 'rotate theta about x', lambda p, q, r: (p, q, r)),
    'ceiling': ('-y', (0, -1, 0), '(1, 0, 0)', '(0.09, 0.045, 0.045)', 'rotate theta - 90 deg about z', lambda p, q, r: (r, -q, p)),
    'slope': ('(0, 3, 4)', (0, 0.6, 0.8), '(0.6, 0, 0.8)', '(0.0612, 0.045, 0.0738; 0, 0.0216, 0)',
              'rotate asin(-0.6) about x rotate theta about x rotate -asin(0.6) about y', lambda p, q, r: (0.8 * p + 0.6 * r, q, 0.8 * r - 0.6 * p))}


def disc(place, method, theta, pqr, turned=None):
    axis, normal, wheel, inertia, turn, spin = PLACES[place]
    return f'''step 0.5 ms
method {method}
stabilisation projection
gravity -9.81 m/s^2 * {normal}
body disc {{ mass 2 kg; inertia {inertia} kg*m^2 }}
joint air free {{ parent ground; child disc; start at 0.3 m * sin(theta) * {normal} {turned or turn}; spin {spin(*pqr)} rad/s }}
constant theta = {theta} rad
close floor rolling {{ parent ground; child disc; axis {axis}; radius 30 cm; wheel {wheel} }}
output at = position of disc
output axle = position of disc at 1 m * {wheel}
output energy = energy
output contact = force of floor
'''


S, C = math.sin(1.2), math.cos(1.2)
TUMBLES = 1.1, (0.5, 1, -4)
# A precession of 2 rad/s at this angle, with the spin that it needs.
STEADY = 1.2, (0, 2 * S, (ACROSS * 4 * S * C - 2 * G * 0.3 * C) / ((ABOUT + 2 * 0.09) * 2 * S))


@pytest.mark.parametrize('place, method, motion', [('ground', 'rk4', TUMBLES), ('ground', 'bdf4', TUMBLES), ('ceiling', 'rk4', TUMBLES),
                                                   ('slope', 'rk4', TUMBLES), ('ground', 'rk4', STEADY), ('ceiling', 'rk4', STEADY)])
def test_a_disc_rolls_as_its_equations_by_hand(plant, place, method, motion):
    """Within the method's h^4 at 0.5 ms, and what rounding adds in 2 s. A steady one goes round a circle."""
    (theta, pqr), ticks, tolerance, normal = motion, 4000, 1e-8, np.array(PLACES[place][1])
    p = plant(disc(place, method, theta, pqr))
    y = p.follow(ticks).y
    ours = np.stack([y.energy, y.at @ normal, (y.axle - y.at) @ normal, np.linalg.norm(y.at - y.at[0], axis=1), np.linalg.norm(y.contact, axis=1)], 1)
    theirs = by_hand(theta, *pqr, ticks, p.step_size)
    off = np.abs(ours - theirs) / [theirs[0, 0], 1, 1, 1, MASS * G]
    assert off[0].max() <= 1e-12 and off.max() <= tolerance
    assert np.abs(ours[:, 0] / theirs[0, 0] - 1).max() <= tolerance, 'the energy'
    first = slope(np.array([theta, 0, *pqr, 0, 0]))
    if motion is STEADY:
        assert abs(first[2]) < 1e-12
        chord = 2 * abs(RADIUS * pqr[2] / first[1] * math.sin(0.5 * first[1] * p.step_size * ticks))
        assert abs(ours[-1, 3] - chord) <= tolerance and abs(ours[-1, 1] - ours[0, 1]) <= tolerance
    else:
        assert abs(ours[-1, 1] - ours[0, 1]) > 0.01, 'this motion is not steady'


@pytest.mark.parametrize('theta, turned', [(0, 'rotate 0 deg about x'), (-math.pi / 2, 'rotate -90 deg about x')])
def test_a_disc_that_lies_flat_or_below_its_plane_is_refused(isoc, theta, turned):
    made = isoc(disc('ground', 'rk4', theta, (0.5, 1, -4), turned))
    assert made.refused and 'lies flat on its plane at the start, or is below it' in made.errors
