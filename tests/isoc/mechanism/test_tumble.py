"""Free turns: the length of a quaternion in float, energy and momentum of a tumbling body with every method, a heavy top, a gyroscope."""
import math
import pathlib

import numpy as np
import pytest
from harness.plants import replaced

BODY, TOP, GYROSCOPE = (pathlib.Path(f'models/{name}.scene') for name in ('rigid_body', 'top', 'gyroscope'))
INERTIA = np.array([1.0, 2, 3])


def length_off(rows):
    """How far the quaternion's length goes from one, in ulp."""
    q = rows['x'][:, 3:7].astype(float)
    return np.abs(np.sqrt((q * q).sum(1)) - 1).max() / float(np.finfo(rows['x'].dtype).eps)


def invariants(rows):
    """By how much the energy and the momentum in the ground's axes change, as parts of the whole: E = w.Jw / 2 and R J w, with the turn of a
    vector v by q: v + 2 q_v x (q_v x v + q_w v)."""
    q, w = rows['x'][:, 3:7].astype(float), rows['x'][:, 10:13].astype(float)
    body = INERTIA * w
    energy, momentum = (body * w).sum(1) / 2, body + 2 * np.cross(q[:, 1:], np.cross(q[:, 1:], body) + q[:, :1] * body)
    return (np.abs(energy - energy[0]).max() / energy[0],
            np.linalg.norm(momentum - momentum[0], axis=1).max() / np.linalg.norm(momentum[0]))


def longest(plant, ticks, **of_plant):
    """The worst length in so many ticks of 1 ms in float, a million at a time; by gcc, as it is a long run."""
    p = plant(BODY, real='float', by='gcc', **of_plant)
    p.start()
    part = ticks // 10
    return max(length_off(p.go(part, every=7, first=k * part)[0]) for k in range(10))


def test_in_float_the_quaternion_keeps_its_length(plant):
    """Each product of the quaternion with its scale, near 1, rounds by half an ulp of a part below 1, and the scale itself, 1.5 less half the
    square of the length, by half an ulp of 1.5: together less than 4 ulp of 1. In 1e7 steps, of which every seventh is looked at. The
    control is without the last step of Newton's method."""
    assert longest(plant, 10_000_000) < 4

    def loose(text):
        return replaced('^static void settle', 'static inline void settle', replaced(r'^    settle\(memory->x\);$', '', text))

    assert longest(plant, 1_000_000, change=loose) > 4


# A step of a method of order p with error constant C misses C (w h / 2)^(p + 1) of the quaternion, which turns at half of w = 5 rad/s, and
# twice that of the angle. Were all steps off to the same side, energy and momentum would be by 2 T C (w / 2)^(p + 1) h^p after T = 20 s. C is
# that of y' = ly (Hairer, Norsett and Wanner 1993, ch. III.2; Hairer and Wanner 1996, ch. IV.7): of rk4 1/5!, of bdf4 1/5, of rosenbrock
# 1/4! - g/2 + 3 g^2/2 - g^3 with g = 0.43587.
CONSTANTS = [('euler', 1, 0.5), ('heun', 2, 0.166667), ('rk4', 4, 0.00833333), ('ab4', 4, 0.348611), ('semi_implicit', 1, 0.5), ('abm4', 4, 0.0263889),
             ('abm4_pec', 4, 0.0263889), ('abm4_pecece', 4, 0.0263889), ('bdf4', 4, 0.2), ('rosenbrock', 3, 0.0259)]


@pytest.mark.parametrize('method, order, constant', CONSTANTS)
def test_energy_and_momentum_are_kept_to_the_order_of_the_method(plant, method, order, constant):
    """Half the step keeps both better, by 0.7 * 2^order and more; and the bound is less than 100 times as much."""
    coarse, fine = (np.array(invariants(plant(BODY, '--method', method, '--step', f'{ms}ms').follow(20_000 // ms).rows)) for ms in (2, 1))
    bound = 2 * 20 * constant * 2.5**(order + 1) * 0.001**order
    assert (fine <= bound).all() and (fine > bound / 100).any()
    assert (coarse >= 0.7 * 2**order * fine).all()


def test_a_heavy_top_keeps_what_lagrange_says_and_nutates_down_to_his_height(plant):
    """Over 10 s at 0.5 ms. The top turns by 0.1 rad a step, of which rk4 misses (0.1 / 2)^5 / 5! in its quaternion; were all of 20,000 steps off to
    the same side, the integrals would be by no more than their sum. From a cusp at u0 = cos 30 deg the height u obeys
    u'^2 = a (u0 - u) (1 - u^2) - b^2 (u0 - u)^2 with a = 2 m g l / across and b = along spin / across, since the precession begins at zero:
    it turns back where a (1 - u^2) = b^2 (u0 - u) (Goldstein 1980, Classical Mechanics, sec. 5-7)."""
    across, along = 182.5e-6, 45e-6  # about the tip: 22.5e-6 + 0.1 kg (40 mm)^2 across the stem
    y = plant(TOP).follow(20_000).rows['y']
    w, i, j, k = y[:, 3:7].T
    up = np.stack([2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j)], 1)
    spin, energy = y[:, 7:10], y[:, 10]
    vertical = (spin * up * [across, across, along]).sum(1)
    most = 20_000 * 0.05**5 / 120
    assert np.abs(energy / energy[0] - 1).max() <= most and np.abs(vertical / vertical[0] - 1).max() <= most
    assert np.abs(spin[:, 2] / spin[0, 2] - 1).max() <= 1e-12, 'a quotient of constants'
    a, b, u0 = 2 * 0.1 * 9.81 * 0.04 / across, along * 200 / across, math.sqrt(0.75)
    half = b * b / (2 * a)
    assert abs(y[:, 2].min() - (half - math.sqrt(half**2 - 2 * half * u0 + 1))) <= 1e-5


def test_a_gyroscope_precesses_at_weight_times_lever_over_its_momentum(plant):
    """0.1962 rad/s, but for the second order of precession over spin, 0.1962 / 500, and for what nutates."""
    rows = plant(GYROSCOPE).follow(20_000).rows
    angle = rows['y'][-1, 0] + 2 * math.pi * rows['y'][-1, 1]
    assert abs(angle / 20 / 0.1962 - 1) <= 1e-3 and np.abs(rows['x'][:, 1]).max() <= 1e-3
