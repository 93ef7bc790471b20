"""Armatures of joints of several coordinates: of a free body they are a body without weight, of a universal joint those of
its two hinges; the energy has them, and all ways to the accelerations agree."""
import pathlib
import random
import re

import numpy as np
import pytest

HEAD = 'step 1 ms\nmethod rk4\n'
OUTPUTS = 'output energy = energy\noutput balance = balance\n'
BODIES = '''
body disc {{ {}lump (1, 2, 2.5; 0.1, 0.2, 0) g*m^2 of 2 kg at (0.02, 0, 0.01) m }}
body arm {{ mass 0.3 kg; com (0.1, 0, 0) m; inertia (1, 1, 1) g*m^2 }}
joint hinge revolute {{ parent disc at (0.1, 0, 0) m; child arm; axis y; speed 2 rad/s }}
joint air free {{ parent ground; child disc; start at (0, 0, 1) m rotate 30 deg about x; speed (1, 2, 3) m/s; spin (1, 2, 3) rad/s; {} }}
'''


def relative(a, b):
    return np.abs(a - b).max() / np.abs(b).max()


@pytest.mark.parametrize('spin, finds', [('0.02', False), ('0.0200001', True)])
def test_of_a_free_body_it_is_a_body_without_weight(plant, spin, finds):
    """Without gravity: a point of 0.5 kg at its origin, which has an inertia of 0.02 kg*m^2 about all axes."""
    lump = plant(HEAD + BODIES.format('lump (0.02, 0.02, 0.02) kg*m^2 of 0.5 kg; ', 'damping 0 N*s/m') + OUTPUTS)
    own = plant(HEAD + BODIES.format('', f'armature 0.5 kg; spin_armature {spin} kg*m^2') + OUTPUTS)
    rows, others = own.run(200), lump.run(200)
    assert (relative(rows['x'], others['x']) > 1e-12) == finds
    assert (relative(rows['y'][:, 0], others['y'][:, 0]) > 1e-12) == finds


def test_of_a_universal_joint_it_is_that_of_two_hinges(plant):
    arm = 'body arm { mass 0.3 kg; com (0.1, 0.05, 0) m; inertia (1, 2, 3) g*m^2 }\n'
    gravity = 'gravity (0, 0, -9.81) m/s^2\n'
    universal = plant(HEAD + gravity + arm + 'joint pair universal { parent ground; child arm; axis x; second y; spin (1, 2) rad/s;'
                      'spin_armature 0.01 kg*m^2 }\n' + OUTPUTS)
    hinges = plant(HEAD + gravity + arm + 'body cross { mass 0 }\n'
                   'joint one revolute { parent ground; child cross; axis x; speed 1 rad/s; armature 0.01 kg*m^2 }\n'
                   'joint two revolute { parent cross; child arm; axis y; speed 2 rad/s; armature 0.01 kg*m^2 }\n' + OUTPUTS)
    assert relative(universal.run(500)['x'], hinges.run(500)['x']) < 1e-12


def mechanism(seed):
    """A chain of joints of several coordinates, all with armatures."""
    r = random.Random(seed)

    def number(low, high):
        return f'{r.uniform(low, high):.4g}'

    def vector(size):
        return f'({", ".join(number(-size, size) for _ in range(3))})'

    lines = [HEAD, f'gravity {vector(10)} m/s^2']
    kinds = ['free', *r.choices(['spherical', 'universal', 'cylindrical', 'planar'], k=2), 'spherical']
    for k, kind in enumerate(kinds):
        spins, slides = {'spherical': (3, 0), 'free': (3, 3), 'universal': (2, 0), 'cylindrical': (1, 1), 'planar': (1, 2)}[kind]
        spin = f'({", ".join(number(-2, 2) for _ in range(spins))})' if spins > 1 else number(-2, 2)
        parts = [f'spin {spin} rad/s', f'spin_armature {number(0.001, 0.1)} kg*m^2']
        parts += [f'armature {number(0.01, 1)} kg'] * (slides > 0)
        parts += {'universal': ['axis x', 'second y'], 'cylindrical': ['axis z'], 'planar': ['axis y']}.get(kind, [])
        parent = f'b{k - 1} at {vector(0.3)} m rotate {number(-90, 90)} deg about {vector(1)}' if k else 'ground'
        lines += [f'body b{k} {{ mass {number(0.2, 2)} kg; com {vector(0.1)} m; inertia (1, 1.5, 2; 0.1, 0.2, 0.1) g*m^2 }}',
                  f'joint j{k} {kind} {{ parent {parent}; child b{k}; {"; ".join(parts)} }}']
    return '\n'.join(lines) + '\n' + OUTPUTS


def slopes_of(plant, rows):
    """Of the states of another plant's rows: its own have another memory."""
    return plant.slopes_at(plant.run(len(rows) - 1), rows['x'])[0]


@pytest.mark.seeds(4)
def test_all_ways_to_the_accelerations_agree(plant, seed):
    """Both formulations, and the balance of energy and power, to rounding; the implicit method with both factors."""
    scene = mechanism(seed)
    composite, articulated = (plant(scene, '--formulation', f) for f in ('composite', 'articulated'))
    rows = composite.run(100)
    slopes, shown = composite.slopes_at(rows, rows['x'])
    assert relative(slopes_of(articulated, rows), slopes) < 1e-10
    power = np.abs(slopes).max() * np.abs(rows['x']).max()  # of a kilogram
    assert np.abs(shown[:, 1]).max() < 1000 * np.finfo(float).eps * power
    full, sparse = (plant(scene, '--method', 'rosenbrock', '--factors', f).run(50)['x'] for f in ('full', 'sparse'))
    assert relative(full, sparse) < 1e-10
    other = plant(scene.replace('spin_armature 0.', 'spin_armature 0.1', 1), '--formulation', 'articulated')
    assert relative(slopes_of(other, rows), slopes) > 1e-6, 'another armature is not found'


# --- against a flywheel on the ground with a gear ---

ARMATURE = pathlib.Path('tests/isoc/mechanism/armature.scene').read_text()


def with_wheels():
    """That of the slide turns by 1 rad where it slides by 1 m."""
    wheels = [('shoulder', '(0.1, 0.1, 0.2) kg*m^2', '1'), ('elbow', '(rotor / 2, rotor / 2, rotor)', '1'),
              ('rail', '(0.15, 0.15, 0.3) kg*m^2', '1 rad/m')]
    return re.sub('; armature [^;}]*', '', ARMATURE) + ''.join(
        f'''body {joint}_wheel {{ mass 0.1 kg; inertia {inertia} }}
joint {joint}_turn revolute {{ parent ground; child {joint}_wheel; axis z; start 0 deg }}
close {joint}_gear gear {{ first {joint}_turn; second {joint}; ratio {ratio} }}
''' for joint, inertia, ratio in wheels)


@pytest.mark.parametrize('armature, is_same', [('0.2 kg', True), ('0.2001 kg', False)])
def test_an_armature_is_a_flywheel_that_the_joint_turns(plant, armature, is_same):
    """The accelerations and the energy at the start, by both formulations; the rate of the energy is the power; and both ways to the
    factors of an implicit method."""
    scene = ARMATURE.replace('armature 0.2 kg', f'armature {armature}')
    names = ('shoulder', 'elbow', 'rail')

    def start(p):
        y = p.follow(1).y
        return np.array([y[name][0] for name in names])

    composite, wheels = plant(scene, '--formulation', 'composite'), plant(with_wheels())
    articulated = plant(ARMATURE, '--formulation', 'articulated')
    assert (np.abs(start(composite) - start(wheels)).max() < 1e-12) == is_same
    assert (np.abs(start(composite) - start(articulated)).max() < 1e-12) == is_same
    if is_same:
        assert abs(composite.follow(1).y.energy[0] - wheels.follow(1).y.energy[0]) < 1e-12
        assert max(np.abs(p.follow(1000).y.balance).max() for p in (composite, articulated)) < 1e-11
        full, sparse = (plant(scene, '--method', 'rosenbrock', '--factors', f).follow(1000).rows['x'][-1] for f in ('full', 'sparse'))
        assert np.abs(full - sparse).max() < 1e-9
