"""Random effects, ten in a scene, against an interpreter of their text: states, memories, their starts, the past of formulas, noise,
functions of time, tables, comparisons, a tunable that changes, by euler, heun and rk4, in float and in double."""
import re

import pytest

import generator
from interpreter import Number, Plant

ROWS = 24


def compared(plant, seed, real, planted=None):
    """How many numbers of the outputs are decided by the interpreter's bounds, as a part of all, and what is off; the plant."""
    text, scene = generator.scene_of(seed)
    p = plant(text, real=real)
    Number.epsilon = 2.0**-24 if real == 'float' else 2.0**-53
    decided, off = 0, []
    rows = p.follow(ROWS).rows['y'].astype(float)
    for k, (got, want) in enumerate(zip(rows, Plant(scene, planted).run(ROWS))):
        for name, g, w in zip(scene['outputs'], got.tolist(), want):
            decided += w.bound < 0.1
            if not abs(g - w.value) <= w.bound:
                off.append(f'{name} in row {k} is {g:.9g}, wanted {w.value:.9g} +- {w.bound:.2g}')
    return decided / rows.size, off, p


@pytest.mark.seeds(10)
@pytest.mark.parametrize('real', ['float', 'double'])
def test_effects_are_what_their_text_says_and_each_derivative_is_set_once(plant, seed, real):
    decided, off, p = compared(plant, seed - 1, real)
    assert decided >= 2 / 3 and not off, off[:8]
    places = re.findall(r'dx\[[A-Z0-9_]*\] = ', p.made.file('plant.c'))
    assert len(places) == len(set(places)) == p.states


@pytest.mark.parametrize('planted', ['previous', 'delay', 'sample', 'next', 'noise'])
def test_another_meaning_is_found(plant, planted):
    assert compared(plant, 10, 'double', planted)[1]
