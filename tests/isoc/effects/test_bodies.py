"""Effects between two bodies in space: a spring between two points, and a bushing. Momenta stay, energy stays without damping
and falls with it; for small displacements and speeds a bushing's forces and moments are the products of its stiffness."""
import pathlib

import numpy as np
import pytest
from harness.plants import other_effect

H = 1e-3
BUSHING = pathlib.Path('tests/isoc/effects/bushing.scene').read_text()
PAIR = pathlib.Path('tests/isoc/effects/pair.scene').read_text()
MASS, INERTIA = [1.0, 2.0], np.array([[0.010, 0.012, 0.015], [0.030, 0.040, 0.050]])
STIFF, TURNING, TIME_CONSTANT = np.array([500.0, 800, 1000]), np.array([4.0, 6, 9]), 10e-3
BODIES = ['first', 'second']


def turned(q, v):
    """A vector in the axes of a body, in those of the ground: v + 2 q x (q x v + w v)."""
    return v + 2 * np.cross(q[..., 1:], np.cross(q[..., 1:], v) + q[..., :1] * v)


def quaternion(x, body):
    return np.stack([x[f'{body}_turn_{axis}'] for axis in 'wxyz'], -1).astype(float)


def vector(x, name):
    """Three states: first_x_speed and so on."""
    head, end = name.split('*')
    return np.stack([x[f'{head}{axis}{end}'] for axis in 'xyz'], -1).astype(float)


def momenta(x, inertia):
    """Linear momentum, and angular momentum about the origin."""
    made = 0
    for body, mass, of_body in zip(BODIES, MASS, inertia):
        linear = mass * vector(x, f'{body}_*_speed')
        own = turned(quaternion(x, body), of_body * vector(x, f'{body}_turn_*_speed'))
        made = made + np.concatenate([linear, own + np.cross(vector(x, f'{body}_*'), linear)], -1)
    return made


# --- a spring between two points ---


@pytest.mark.parametrize('is_damped', [False, True])
def test_a_spring_between_points_keeps_momentum_and_energy(plant, is_damped):
    """The fastest motion is below sqrt(k r^2 / J + k / m) = 20 rad/s: of it rk4 leaves out (20 h)^5 / 120 in a step. Of the
    momentum as well, as the quaternions within a step have not quite the length one."""
    p, ticks, inertia = plant(PAIR), 2000, np.array([[0.02], [0.03]])
    r = p.follow(ticks, sets={0: {'damping': 2.0 * is_damped}})
    gap = r.y.other - r.y.this
    square = (gap * gap).sum(1)
    energy = 50 * square + sum(0.5 * mass * (vector(r.x, f'{body}_*_speed')**2).sum(1)
                               + 0.5 * j * (vector(r.x, f'{body}_turn_*_speed')**2).sum(1)
                               for body, mass, (j,) in zip(BODIES, MASS, inertia))
    assert (np.abs(r.y.length - np.sqrt(square)) <= 8 * p.ulp * np.sqrt(square)).all()
    assert (np.abs(r.y.across) <= 64 * p.ulp * square).all()
    assert (np.abs(r.y.energy - energy) <= 16 * p.ulp * energy).all()
    left_out, before = 2 * (20 * H)**5 / 120, energy[0]
    linear = momenta(r.x, inertia)[:, :3]
    assert np.abs(linear - linear[0]).max() <= left_out * ticks * np.sqrt(2 * before * sum(MASS))
    if is_damped:
        assert (np.diff(energy) <= left_out * before).all() and energy[-1] < 0.9 * before
    else:
        assert np.abs(energy - before).max() <= left_out * ticks * before


# --- a bushing ---


def small(p, is_moving):
    """How far the derivative of both bodies is from F = -k d at the point and M = -k phi, in the axes of the second, when the
    first is moved by d and turned by phi, or has these speeds; and what is allowed: angles of 4 mrad to the second order, and
    products of spins; and the rounding of 0.3 m at 1 kN/m, over 3 N."""
    d, phi = np.array([1e-3, -2e-3, 1.5e-3]), np.array([2e-3, 1e-3, -3e-3])
    p.start()
    x = p.now['x'][0]
    at = p.places['x']
    x[:] = 0
    x[[at['first_turn_w'], at['second_turn_w']]] = 1
    x[at['first_x']] = 0.3
    place, turn = ('first_{}_speed', 'first_turn_{}_speed') if is_moving else ('first_{}', 'first_turn_{}')
    for i, axis in enumerate('xyz'):
        x[at[place.format(axis)]] += d[i]
        x[at[turn.format(axis)]] = phi[i] if is_moving else phi[i] / 2
    p.now['p'][0] = TIME_CONSTANT * is_moving
    rows = p.now.copy()
    rate = p.named(rows).x
    rate.array = p.slopes_at(rows, rows['x'])[0]
    lever, other = np.array([-0.1, 0, 0]), np.array([0.2, 0, 0])
    factor = TIME_CONSTANT if is_moving else 1
    force, moment = -STIFF * factor * (d + np.cross(phi, lever)), -TURNING * factor * phi
    far = [(vector(rate, 'first_*_speed') - force / MASS[0]) / 3, (vector(rate, 'second_*_speed') + force / MASS[1]) / 1.5,
           (vector(rate, 'first_turn_*_speed') * INERTIA[0] - np.cross(lever, force) - moment) / 0.3,
           (vector(rate, 'second_turn_*_speed') * INERTIA[1] + np.cross(other, force) + moment) / 0.6]
    return np.abs(far).max(), (1e-6 if is_moving else 8e-3) + 100 * p.ulp


@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('is_moving', [False, True])
def test_small_displacements_and_speeds_of_a_bushing_are_linear(plant, real, is_moving):
    far, allowed = small(plant(BUSHING, real=real), is_moving)
    assert far <= allowed


def damped_in_common(p):
    """What damping does, in m/s^2, where both turn as one body, with 3 rad/s about the origin."""
    omega = np.array([1.0, 2, -2])
    p.start()
    x, at = p.now['x'][0], p.places['x']
    for body in BODIES:
        moves = np.cross(omega, [x[at[f'{body}_{axis}']] for axis in 'xyz'])
        for i, axis in enumerate('xyz'):
            x[at[f'{body}_{axis}_speed']], x[at[f'{body}_turn_{axis}_speed']] = moves[i], omega[i]
    rates = []
    for damping in (0, TIME_CONSTANT):
        p.now['p'][0] = damping
        rows = p.now.copy()
        rates.append(p.slopes_at(rows, rows['x'])[0])
    change = p.named(rows).x
    change.array = rates[1] - rates[0]
    return max(factor * np.abs(vector(change, name.format(body))).max()
               for body in BODIES for factor, name in ((1, '{}_*_speed'), (0.03, '{}_turn_*_speed')))


@pytest.mark.parametrize('real', ['float', 'double'])
def test_a_common_turning_of_a_bushing_is_not_damped(plant, real):
    """Speeds of 1 m/s, times 1 kN/m and 10 ms."""
    p = plant(BUSHING, real=real)
    assert damped_in_common(p) <= 16 * p.ulp * 10


def kept(p, is_damped):
    """What the momenta change by in a run, and the energy of each row; the momenta may change by `allowed`. The fastest motion
    is below 100 rad/s: of it rk4 leaves out (100 h)^5 / 120 in a step. Places are rounded as 1 m, against 10 N."""
    ticks = 2000
    r = p.follow(ticks, sets={0: {'damping': TIME_CONSTANT * is_damped}})
    energy, sums = r.y.energy.astype(float), momenta(r.x, INERTIA)
    allowed = 0.1**5 / 120 + 16 * p.ulp + 10 * p.ulp / energy[0]
    return np.abs(sums - sums[0]).max() <= ticks * allowed, energy / energy[0], allowed


@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('is_damped', [False, True])
def test_a_bushing_keeps_momenta_and_energy(plant, real, is_damped):
    is_kept, energy, allowed = kept(plant(BUSHING, real=real), is_damped)
    assert is_kept
    if is_damped:
        assert (np.diff(energy) <= allowed).all() and energy[-1] < 0.9
    else:
        assert np.abs(energy - 1).max() <= len(energy) * allowed


def test_changed_definitions_are_found(plant):
    turning = plant(other_effect('bushing', r'of other - cross\(spin', 'of other + cross(spin') + BUSHING)
    assert damped_in_common(turning) > 0.1
    stiffer = plant(other_effect('bushing', 'turn_z - turn_x', '2 * turn_z - turn_x') + BUSHING)
    far, allowed = small(stiffer, False)
    assert far > allowed
    beside = plant(other_effect('bushing', '^    moment on other = -cross', '    moment on other = -0.5 * cross') + BUSHING)
    assert not kept(beside, False)[0]
