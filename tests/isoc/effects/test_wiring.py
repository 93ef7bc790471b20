"""Faults of a wire, by name from the scene and from outside: open, short to ground, short to the supply; each tick is counted."""
import numpy as np
import pytest

SCENE = """
gravity (0, 0, 0) m/s^2
step 1 ms
method rk4
body bob { mass 1 kg }
joint rail prismatic { parent ground; child bob; axis x }
input volts V
effect line wiring { input volts; supply 12 V; ground 0.5 V; rest 2 V }
output read = line.value
output faulty = line.faulty
"""
READS = {'open': 2.0, 'to_ground': 0.5, 'to_supply': 12.0}
TICKS, FROM, TO = 40, 10, 25


@pytest.mark.parametrize('fault', READS)
def test_a_fault_of_the_scene_is_that_of_a_script(plant, fault):
    """`at T set` of the scene holds in the row of T; a script sets before the step from the row before. Control: no fault."""
    given = {'volts': 3.25}
    by_scene = plant(f'{SCENE}at {FROM} ms set line.{fault} = 1\nat {TO} ms set line.{fault} = 0\n').follow(TICKS, given)
    sound = plant(SCENE)
    by_script = sound.follow(TICKS, given, sets={FROM - 1: {f'line_{fault}': 1}, TO - 1: {f'line_{fault}': 0}})
    expected = np.full(TICKS + 1, 3.25)
    expected[FROM:TO] = READS[fault]
    for rows in (by_scene, by_script):
        assert np.array_equal(rows.y.read[1:], expected[1:]) and rows.y.faulty[-1] == TO - FROM
    alone = sound.follow(TICKS, given)
    assert (alone.y.read[1:] == 3.25).all() and alone.y.faulty[-1] == 0


def test_the_later_of_two_faults_holds_and_a_tick_counts_once(plant):
    rows = plant(SCENE).follow(TICKS, {'volts': 3.25}, sets={5: {'line_open': 1, 'line_to_ground': 1}, 9: {'line_to_supply': 1}})
    assert rows.y.read[7] == 0.5 and rows.y.read[-1] == 12.0 and rows.y.faulty[-1] == TICKS - 5


def test_a_supply_must_be_given(isoc):
    assert isoc(SCENE.replace('supply 12 V; ', '')).refused
