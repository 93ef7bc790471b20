"""inertia of BODY and of JOINT in the formulas of effects: what a push meets; and what contact derives from it."""
import math
import pathlib

import numpy as np
import pytest

SCENE = pathlib.Path('tests/isoc/effects/inertia.scene').read_text()


def off(plant, scene, real='double'):
    """From rest and without weight, in a step of euler a push alone gives the speed step * push / inertia: of seven pushes how far
    the inertia is off, in ulp."""
    p = plant(scene, real=real)
    rows = [p.follow(1, {f'push{i}': 2.0 * (i == push) for i in range(1, 8)}).y for push in range(1, 8)]
    return [abs(1e-3 * 2 / float(y[f'v{i}'][1]) / float(y[f'met{i}'][1]) - 1) / p.ulp for i, y in enumerate(rows, 1)]


@pytest.mark.parametrize('real', ['float', 'double'])
def test_a_push_meets_the_inertia_that_a_formula_reads(plant, real):
    """Some hundred roundings of numbers whose differences are a tenth of them."""
    assert max(off(plant, SCENE, real)) <= 1000


def test_the_inertia_at_another_point_is_found(plant):
    assert (np.array(off(plant, SCENE.replace('inertia of on at beside', 'inertia of on'))) > 1000).tolist() == [True] * 3 + [False] * 4


HEAD = 'gravity (0, 0, -9.81) m/s^2; step 1 ms; method rk4; output energy = energy\n'
BALL = '''body ball { sphere 5 cm of 0.3 kg }; joint air free { parent ground; child ball; start at (0, 0, 0.3) m }
effect floor contact { ball ball; radius 5 cm; impact 1 m/s; rest 1; friction 0.4 }
'''
WHEEL = '''body cart { mass 10 kg }; body wheel { cylinder (50, 20) mm of 80 g rotate 90 deg about x }
joint slide prismatic { parent ground; child cart; axis z; start 6 cm }
joint axle revolute { parent cart; child wheel; axis y; continuous; speed 1 rad/s }
effect floor contact { ball wheel; radius 5 cm; impact 1 m/s; friction 0.4'''


def test_contact_of_a_ball_has_its_mass(isoc):
    chosen = isoc(HEAD + BALL).chosen
    assert chosen['floor.load'] == pytest.approx(0.3, rel=1e-8)
    assert chosen['floor.stiffness'] == pytest.approx(0.3 * (math.pi / 16 * 1000)**2, rel=1e-8)
    assert chosen['floor.grip'] == pytest.approx(0.3 / 4 * 2.7853 * 500, rel=1e-8)


def test_contact_of_a_light_wheel_under_a_heavy_body_grips_by_the_wheel(isoc):
    """Its slip moves the wheel alone, inertia / radius^2 = 0.04 kg; a quarter of all is too much for the step."""
    made = isoc(HEAD + WHEEL + ' }\n')
    assert made.errors == '' and made.chosen['floor.load'] == pytest.approx(10.08, rel=1e-8)
    assert made.chosen['floor.grip'] == pytest.approx(0.04 * 2.7853 * 500, rel=1e-8)
    assert "warning: the effect 'floor' is too fast" in isoc(HEAD + WHEEL + '; grip 10.08 kg / 4 * 2.7853 * 500 /s }\n').errors
