"""The same mechanism as a tree with one closure and in absolute coordinates, every body free and every joint a closure:
one motion, to 1e-8 over 5 s (double, rk4, 0.1 ms, projection). The slider-crank turns at a tenth of its 150 rad/s, where
the truncation of a step alone is more than that, and another one in other coordinates."""
import re

import numpy as np
import pytest

from harness.project import ROOT

SLOWER = [('^stabilisation.*', 'stabilisation projection'), ('-225 rad', '-22.5 rad'), (r'([ ,])150(\)* rad)', r'\g<1>15\2'),
          (r'22\.95', '2.295'), (r'-75\) rad', '-7.5) rad')]
SCENES = [('models/four_bar.scene', ['coupler_point_x', 'coupler_point_y'], 'tests/isoc/mechanism/absolute_four_bar.scene',
           ['coupler_point_x', 'coupler_point_y']),
          ('models/slider_crank.scene', ['slider_position'], 'tests/isoc/mechanism/absolute_slider_crank.scene', ['slider_x'])]


@pytest.fixture
def moved(plant):
    """moved(scene, outputs, ...): what the outputs do, in rows of 10 ms."""
    def call(scene, outputs, *change):
        text = (ROOT / scene).read_text()
        for pattern, by in [*SLOWER, *change]:
            text = re.sub(pattern, by, text, flags=re.M)
        of = plant(text, '--step', '100us')
        return of.run(50000, every=100)['y'][:, [of.names.index(name) for name in outputs]]
    return call


@pytest.mark.parametrize('tree, of_tree, absolute, of_absolute', SCENES, ids=['four_bar', 'slider_crank'])
def test_one_motion_in_both(moved, tree, of_tree, absolute, of_absolute):
    rows = moved(tree, of_tree)
    assert np.ptp(rows, axis=0).min() > 0.01 and np.abs(rows - moved(absolute, of_absolute)).max() <= 1e-8


def test_found_a_crank_of_other_mass(moved):
    """By a part in 10,000."""
    scene, outputs = SCENES[1][:2]
    assert np.abs(moved(scene, outputs) - moved(scene, outputs, ('mass 38 g', 'mass 38.0038 g'))).max() > 1e-8
