"""All formulations of a tree, and of closed loops, say the same, to rounding; and isoc keeps the one that takes least.

How much the equations magnify rounding differs from scene to scene: a planar chain of 16 rods loses six times as much by its mass matrix
as by articulated bodies. What either says in float is off from what it says in double by that times the roundings in float, as many as
there are in double; so that in double the two may differ by as much times the ratio of the roundings. Roundings of the two reals are not
the same ones: at some states they happen to cancel in float, for which the worst of all states stands, and a factor."""
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest
from rods_and_legs import Platform, rods

MODELS = [path for path in sorted(pathlib.Path('models').glob('*.scene')) if not re.search('^ *(close|effect) ', path.read_text(), re.M)]
FINE, COARSE = np.finfo(np.float64).eps, np.finfo(np.float32).eps
STRETCHED = pathlib.Path('tests/isoc/dynamics/formulation/stretched.scene').read_text()


def chain(n, kind):
    return subprocess.run([sys.executable, 'tools/lab/chain.py', str(n), kind], capture_output=True, text=True, check=True).stdout


def text_of(name):
    """The scene of a name: a path, planar_8, spatial_3, rods_2 or legs_5."""
    kind, _, number = name.partition('_')
    of = {'planar': lambda n: chain(n, 'planar'), 'spatial': lambda n: chain(n, 'spatial'), 'rods': rods, 'legs': lambda n: Platform(n).text}
    return of[kind](int(number)) if number.isdigit() else pathlib.Path(name)


class Pair:
    """Two scenes in their formulations, both in both reals, along a run of the first."""

    def __init__(self, plant, first, formulations, second=None, states=50, between=20):
        scenes = [first, second or first]
        self.plants = {(i, real): plant(scenes[i], '--method', 'rk4', '--formulation', formulations[i], real=real)
                       for i in (0, 1) for real in ('float', 'double')}
        p = self.plants[0, 'double']
        p.start()
        rows, found = p.now.copy(), []
        for _ in range(states):
            for _ in range(between):
                rows = p.stepped(rows)
            found.append(rows['x'][0])
        x = np.array(found)
        self.apart = self.off((1, 'double'), x, (0, 'double'))
        single = x.astype(np.float32)  # there a quaternion's length is off one, which formulations feel
        self.in_first, self.in_second = (self.off((i, 'float'), single, (0, 'double')) for i in (0, 1))

    def slopes(self, key, x):
        p = self.plants[key]
        p.start()
        return p.slopes_at(np.repeat(p.now, len(x)), x)[0].astype(float)

    def off(self, key, x, exact):
        """The worst relative difference of the derivatives from others, 2-norms."""
        right = self.slopes(exact, x)
        size = np.linalg.norm(right, axis=1)  # 0 of what hovers
        return (np.linalg.norm(self.slopes(key, x) - right, axis=1) / np.where(size > 0, size, 1)).max()

    def agrees(self):
        return self.apart <= 8 * FINE / COARSE * (self.in_first + self.in_second)


TREES = [str(path) for path in MODELS] + [f'planar_{n}' for n in (3, 8, 16)] + [f'spatial_{n}' for n in (3, 8, 16)] + \
    [f'rods_{seed}' for seed in range(1, 10)]
LOOPS = [(name, formulation) for name in ('models/four_bar.scene', 'models/squeezer.scene', 'tests/isoc/mechanism/slot.scene',
                                          'tests/isoc/scene/closures.scene') for formulation in ('parent_axes', 'child_axes')]
LEGS = [('models/stewart.scene', 'legs_in_child_axes')] + [
    (f'legs_{seed}', ('legs', 'legs_in_child_axes', 'legs_in_parent_axes')[seed % 3]) for seed in range(1, 9)]


def kept(isoc, scene, *options):
    """The formulation that isoc keeps."""
    return re.search('^formulation (\\w+) kept', isoc(scene, *options).printed, re.M)[1]


@pytest.mark.parametrize('name, formulation', [(name, 'articulated') for name in TREES] + LOOPS)
def test_a_formulation_says_what_composite_bodies_say(plant, name, formulation):
    assert Pair(plant, text_of(name), ['composite', formulation]).agrees()


@pytest.mark.parametrize('name, formulation', LEGS)
def test_legs_say_so_too_and_isoc_keeps_none_in_float_that_rounds_more(isoc, plant, name, formulation):
    pair = Pair(plant, text_of(name), ['composite', formulation])
    assert pair.agrees()
    assert kept(isoc, text_of(name), '--real', 'float') != formulation or pair.in_second <= 4 * pair.in_first


def test_gravity_off_by_a_hundred_millionth_is_found(plant):
    arm = pathlib.Path('models/arm6.scene').read_text()
    assert not Pair(plant, arm, ['composite', 'articulated'], arm.replace('9.81)', '9.8100001)')).agrees()


@pytest.mark.parametrize('formulation, mass, holds', [('legs', '2', True), ('legs_in_parent_axes', '2', True), ('legs_in_child_axes', '2', True),
                                                      ('legs', '2.0001', False)])
def test_a_leg_that_is_stretched_is_not_eliminated_alone_there(plant, formulation, mass, holds):
    """The elimination leg by leg would divide by nearly nothing. Along a run that begins where a leg is stretched, and comes there again, it
    rounds no more than 4 times what composite bodies do. The control is a plate heavier by 5e-5 of itself."""
    straight = STRETCHED.replace('bend = 0.8 rad', 'bend = 0 rad')
    pair = Pair(plant, straight, ['composite', formulation], STRETCHED.replace('mass 2 kg', f'mass {mass} kg'), states=5000, between=1)
    limit = 4 * pair.in_first
    assert (pair.in_second <= limit) == (pair.apart <= limit * FINE / COARSE) == holds


@pytest.mark.parametrize('name, formulation', [
    ('models/arm6.scene', 'composite'), ('planar_16', 'articulated'), ('spatial_16', 'articulated'), ('models/four_bar.scene', 'child_axes'),
    ('models/stewart.scene', 'legs_in_child_axes'), ('straight', 'parent_axes')])
def test_isoc_keeps_the_formulation_that_takes_least(isoc, name, formulation):
    """A division for 14 others. A leg that is stretched at the start is not eliminated alone."""
    printed = isoc(STRETCHED.replace('bend = 0.8 rad', 'bend = 0 rad') if name == 'straight' else text_of(name)).printed
    costs = {(kind, of): int(add) + int(mul) + 14 * int(div) for kind, of, add, mul, div in re.findall(
        r'^formulation (\w+) (kept|left) add (\d+) mul (\d+) div (\d+)', printed, re.M)}
    add, mul, div = map(int, re.search(r'^derivative add (\d+) mul (\d+) div (\d+)', printed, re.M).groups())
    assert costs[formulation, 'kept'] == add + mul + 14 * div
    assert all(costs[formulation, 'kept'] <= cost for (_, of), cost in costs.items() if of == 'left')


def test_of_some_legs_with_knees_isoc_keeps_the_elimination_leg_by_leg(isoc):
    assert any(kept(isoc, Platform(seed).text).startswith('legs') for seed in range(1, 12, 2))


def test_a_step_of_the_governor_closes_its_loops_to_rounding(plant):
    """The projection divides by factors of the last stage of a step; its gaps are those of the end, also where a factor is a part of a gap,
    as the sine of an arm is here. So what a step leaves is the square of its local error: less than 8 ulp of a meter."""
    scene = pathlib.Path('tests/core/methods/order/governor.scene').read_text() + 'output gap = violation\n'
    assert plant(scene).follow(500).y.gap.max() < 8 * FINE


@pytest.mark.parametrize('name, formulation', [('models/four_bar.scene', 'articulated'), ('models/four_bar.scene', 'legs'),
                                               ('models/arm6.scene', 'child_axes')])
def test_there_is_no_such_formulation(isoc, name, formulation):
    """A closed loop is not articulated, one closure has no legs, and a tree has no closures."""
    made = isoc(pathlib.Path(name), '--formulation', formulation)
    assert made.refused and 'no such formulation' in made.errors
