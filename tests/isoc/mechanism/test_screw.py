"""A screw, by each way to solve for its acceleration, moves as a cylindrical joint whose slide a gear couples to its turn, and the joint below
it bears the same. A screw in a closed loop moves as its equation says."""
import math
import pathlib

import numpy as np
import pytest
from harness.plants import replaced

SCREW = pathlib.Path('tests/isoc/mechanism/screw.scene').read_text()
TICKS = 2000


def with_gear():
    """The pair in the place of the screw."""
    text = SCREW
    for pattern, by in [('^joint thread screw', 'joint thread cylindrical'), (r'^    damping 0\.02', '    spin_damping 0.02'), ('^    start 40 deg.*\n', ''),
                        ('^    pitch 300 mm', '    start at 33.333333333333336 mm rotate 40 deg'),
                        ('^    speed 2 rad/s', '    speed 95.49296585513721 mm/s; spin 2 rad/s'),
                        ('(position|speed) of thread$', r'\1 of thread_turn')]:
        text = replaced(pattern, by, text)
    return text + 'close pair gear { first thread_slide; second thread_turn; ratio 47.74648292756861 mm/rad }\n'


def apart(a, b, names):
    return max(np.abs(a[name] - b[name]).max() for name in names)


@pytest.mark.parametrize('pitch, is_same', [('300 mm', True), ('301 mm', False)])
def test_a_screw_is_a_cylindrical_joint_with_a_gear(plant, pitch, is_same):
    a, b = (plant(SCREW.replace('300 mm', pitch if kind == 'composite' else '300 mm'), '--formulation', kind).follow(TICKS).y
            for kind in ('composite', 'articulated'))
    c = plant(with_gear()).follow(TICKS).y
    assert (np.abs(a.array - b.array).max() < 1e-9) == is_same
    assert (apart(a, c, ('tip', 'angle', 'rate')) < 1e-6) == is_same
    if is_same:
        assert apart(a, c, ['held']) < 1e-5
        assert np.abs(a.angle - a.angle[0]).max() > 1 and a.energy[-1] < a.energy[0]


@pytest.mark.parametrize('method', ['rk4', 'rosenbrock'])
def test_a_nut_on_a_guide_moves_as_its_equation_says(plant, method):
    y = plant(pathlib.Path('tests/isoc/mechanism/lead_screw.scene'), '--method', method).follow(TICKS).y
    lead = 0.1 / (2 * math.pi)
    angle = 0.5 * 0.5 / (0.002 + 4 * lead**2) * (0.001 * TICKS)**2
    assert y.angle[-1] == pytest.approx(angle, rel=1e-10) and y.place_z[-1] == pytest.approx(-lead * angle, rel=1e-10)
