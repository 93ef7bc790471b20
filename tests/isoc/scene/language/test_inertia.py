"""Inertias that no body has: refused, or with `as_given` taken as they are, with a warning that says by how much."""
import random

import numpy as np
import pytest

SCENE = """gravity (0, 0, -9.81) m/s^2
step 1 ms
body a {{ {} }}
joint j spherical {{ parent ground; child a at (0.1, 0, 0) m; spin (1, 2, 3) rad/s }}
output energy = energy
output balance = balance
"""


def body(moments, word='', turn='rotate 30 deg about (1, 2, 3)', lump=False):
    inertia = f'({", ".join(f"{x:.17g}" for x in moments)}) kg*m^2 {word}'
    return SCENE.format(f'lump {inertia} of 1 kg {turn}' if lump else f'mass 1 kg; inertia {inertia} {turn}')


def moments_beyond(seed):
    """Two moments, the third beyond their sum, and the excess."""
    r = random.Random(seed)
    one, other, excess = r.uniform(0.01, 0.1), r.uniform(0.01, 0.1), 10 ** r.uniform(-6, 1)
    return r.sample([one, other, (one + other) * (1 + excess)], 3), excess


@pytest.mark.seeds(10)
@pytest.mark.parametrize('lump', [False, True])
def test_beyond_the_triangle_inequality(isoc, plant, seed, lump):
    moments, excess = moments_beyond(seed)
    refused = isoc(body(moments, lump=lump))
    assert refused.status == 1 and "is impossible: a principal moment is larger than the sum of the other two" in refused.errors
    made = isoc(body(moments, 'as_given', lump=lump))
    assert made.status == 0 and f"warning: no body has the inertia of 'a', which is as given: a principal moment is {100 * excess:.3g} %" in made.errors
    shown = plant(body(moments, 'as_given', lump=lump)).run(1000)['y']
    scale = np.abs(shown[:, 0]).max()
    assert np.ptp(shown[:, 0]) < 1e-6 * scale  # rk4 keeps the energy, as of any rigid body


@pytest.mark.seeds(5)
def test_a_possible_one_is_the_same_with_the_word(isoc, seed):
    moments, _ = moments_beyond(seed)
    moments[moments.index(max(moments))] = 0.9 * (sum(moments) - max(moments))
    plain, given = isoc(body(moments)), isoc(body(moments, 'as_given'))
    assert given.errors == plain.errors == '' and given.file('plant.c') == plain.file('plant.c')


@pytest.mark.parametrize('word', ['', 'as_given'])
@pytest.mark.parametrize('moments', [(-0.01, 0.1, 0.2), (0.1, -1e-6, 0.1)])
def test_a_negative_one_is_refused_with_it_too(isoc, moments, word):
    made = isoc(body(moments, word))
    assert made.status == 1 and "is not positive definite: a principal moment is negative" in made.errors


@pytest.mark.parametrize('excess, is_named', [(0.1, True), (1e-6, True), (-1e-3, False)])
def test_to_mujoco_it_is_cut_and_named(isoc, excess, is_named):
    made = isoc(body((0.01, 0.02, 0.03 * (1 + excess)), 'as_given'), '--mjcf', writes=False)
    assert made.status == 0 and ('; the inertia of of_j, whose largest moment is cut' in made.printed) == is_named


def test_only_a_lump_has_the_word(isoc):
    made = isoc(SCENE.format('sphere 1 m as_given of 1 kg'))
    assert made.status == 1 and "expected 'of' and a mass" in made.errors
