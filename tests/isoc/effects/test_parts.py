"""Effects in effects: a part is an effect of its own, with the names, the price and the absence of one."""
import re

import numpy as np
import pytest
from nested import Kinds

CART = '''step 1 ms
body b { mass 1 kg }
joint rail prismatic { parent ground; child b; axis x; start 0.1 m; speed 1 m/s }
'''
# A part in a part in a part, and the same effects by themselves.
NESTED = CART + '''
effect rub { joint along; value c N*s/m; fault gone; effort on along = -c * (1 - gone) * speed of along; output effort = -c * speed of along
  loss = c * (1 - gone) * speed of along^2 }
effect seat { joint on; value c N*s/m; part dry rub { along on; c c / 2 }; state wear m = 0 m; rate wear = speed of on; output wear
  output effort = dry.effort }
effect axle { joint of; value c N*s/m; part left seat { on of; c 3 * c }; part right seat { on of; c c }
  output effort = left.effort + right.effort }
effect cart axle { of rail; c 2 N*s/m }
output place = position of rail
output effort = cart.effort
output wear = cart.left.wear
output loss = loss of cart
'''
FLAT = CART + '''
effect rub { joint along; value c N*s/m; fault gone; effort on along = -c * (1 - gone) * speed of along; output effort = -c * speed of along
  loss = c * (1 - gone) * speed of along^2 }
effect seat { joint on; signal effort_of_dry N; state wear m = 0 m; rate wear = speed of on; output wear; output effort = effort_of_dry }
effect cart_left seat { on rail; effort_of_dry cart_left_dry.effort }
effect cart_left_dry rub { along rail; c 3 N*s/m }
effect cart_right seat { on rail; effort_of_dry cart_right_dry.effort }
effect cart_right_dry rub { along rail; c 1 N*s/m }
output place = position of rail
output effort = cart_left.effort + cart_right.effort
output wear = cart_left.wear
output loss = loss of cart_left_dry + loss of cart_right_dry
'''


def test_parts_have_the_rows_of_effects_by_themselves(plant):
    nested, flat = (plant(scene).outputs(50).rows for scene in (NESTED, FLAT))
    np.testing.assert_array_equal(nested, flat)
    assert (nested[1:] != plant(NESTED.replace('c 3 * c', 'c 2 * c')).outputs(50).rows[1:]).all(axis=1).any()


def test_a_fault_three_deep_is_switched_by_its_name(plant, isoc):
    switched = plant(NESTED + 'at 10 ms set cart.left.dry.gone = 1\n')
    flat = plant(FLAT + 'at 10 ms set cart_left_dry.gone = 1\n').outputs(50).rows
    np.testing.assert_array_equal(switched.outputs(50).rows, flat)
    assert (flat[20:] != plant(FLAT).outputs(50).rows[20:]).any()
    from_start = plant(NESTED, '--set', 'cart.left.dry.gone = 1').outputs(50).rows
    np.testing.assert_array_equal(from_start, plant(FLAT, '--set', 'cart_left_dry.gone = 1').outputs(50).rows)
    assert 'PLANT_P_CART_LEFT_DRY_GONE' in switched.made.file('plant.h')
    assert "did you mean 'cart.left.dry.gone'" in isoc(NESTED + 'at 10 ms set cart.left.dry.gon = 1').errors


@pytest.mark.seeds(8)
def test_random_definitions_with_parts_have_the_rows_of_the_scene_without_any(plant, isoc, seed):
    """To rounding: sums stand in another order. Without one of the uses the plant has the bytes of the scene that never
    had it."""
    kinds = Kinds(seed)
    scene, flat = kinds.scene(), kinds.flat()
    print(scene)
    found, expected = (plant(text).outputs(40).rows for text in (scene, flat))
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())
    assert np.abs(found[-1] - found[0]).min() > 1e-6
    one = scene.replace('one.y + two.y', 'one.y')
    assert isoc(one, '--without', 'two').files() == isoc(re.sub(r'^effect two .*\n', '', one, flags=re.M)).files()
    listed = isoc(scene, '--effects', writes=False).printed.splitlines()
    assert [line.split()[0].replace('.', '_') for line in listed] == [use for use, *_ in kinds.uses()]


def test_a_part_that_is_left_out_lets_its_readers_read_zero(plant):
    rows = plant(NESTED, '--without', 'cart.left.dry').outputs(50)
    np.testing.assert_array_equal(rows.loss, plant(NESTED.replace('left.effort + right.effort', 'right.effort'), '--set',
                                                   'cart.left.dry.gone = 1').outputs(50).loss)
    assert (rows.wear != 0).any()


def test_names_of_parts_lead_to_their_effects(isoc):
    """In a warning, in the header, in the list of effects."""
    made = isoc(NESTED, '--effects', writes=False)
    assert made.printed.split('\n') == ['cart axle', 'cart.left seat', 'cart.left.dry rub', 'cart.right seat',
                                        'cart.right.dry rub', '']
    made = isoc(NESTED.replace('c c / 2', 'c c * 1000'))
    assert re.search(r"plant.scene:\d+:8: warning: the effect 'cart.left.dry' is too fast", made.errors)


@pytest.mark.parametrize('planted, message', [
    ('effect a { part b c { } }; effect c { part d e { } }; effect e { part f a { } }; effect x a { }',
     r"plant.scene:\d+:\d+: error: an effect cannot be a part of itself: a has c, c has e, e has a"),
    ('effect a { part b a { } }; effect x a { }', 'an effect cannot be a part of itself: a has a'),
    ('effect a { part b rub { c 1 N*s/m } }; effect x a { }', "'x.b' has no along: the effect rub needs it; in the effect 'x'"),
    ('effect a { joint j; part b rub { along k; c 1 N*s/m } }; effect x a { j rail }',
     "'k' is no joint of this effect: write 'joint k' in it; in the effect 'x'"),
    ('effect a { joint j; part b rub { along j; c 1 N } }; effect x a { j rail }', "'c' is in N.s/m; this is in N; in the effect 'x'"),
    ('effect a { joint j; part b rub { along j; c 1 N*s/m }; part b rub { along j; c 1 N*s/m } }; effect x a { j rail }',
     "a second part 'b'; the first is in line"),
    ('effect a { let y = b.effort }; effect x a { }', "this effect has no part 'b'; in the effect 'x'"),
    ('effect a { joint j; part b rub { along j; c 1 N*s/m }; let y = b.forte }; effect x a { j rail }',
     "the effect 'x.b' has no output 'forte'"),
    ('effect a { joint j; part b rub { along j; c 1 N*s/m }; bogus j }; effect x a { j rail }', "found 'bogus'"),
    ('effect a { joint j; part b rub { along j; c 1 N*s/m } }; effect x a { }', "'x' has no j: the effect a needs it"),
    ('effect a { part b none { } }; effect x a { }', "no effect of the kind 'none' is defined; in the effect 'x'"),
    ('effect a { joint j; part b rub { along j; c 1 N*s/m; more 2 } }; effect x a { j rail }', "the effect rub has no operand 'more'"),
])
def test_what_is_wrong_in_a_part_is_told_with_its_use(isoc, planted, message):
    made = isoc(NESTED + planted + '\n')
    assert made.refused and re.search(message, made.errors), made.errors


SIX = CART + '''
effect controller { signal wanted m; signal place m; value gain N/m
  every 5 ms at 2 ms { output force = gain * (wanted - place) } }
effect drive { joint axis; signal wanted m; value gain N/m
  part control controller { wanted wanted; place position of axis; gain gain }
  part bearing rub { along axis; c 1 N*s/m }
  effort on axis = control.force }
effect rub { joint along; value c N*s/m; effort on along = -c * speed of along }
repeat i from 1 to 6 { effect drive[i] drive { axis rail; wanted 1 mm * i; gain 10 N/m } }
output x = position of rail
'''


def test_six_drives_have_a_row_each_and_rows_below_for_their_parts(isochron, tmp_path):
    (tmp_path / 'six.scene').write_text(SIX)
    done = isochron('cost', tmp_path / 'six.scene', '--seconds', '0.05')
    assert done.status == 0, done.errors
    costs = {row[0].replace('&nbsp;', ''): row[1:] for row in done.rows if len(row) == 14}
    for i in range(1, 7):
        assert {f'drive{i}, drive', f'drive{i}.control, controller', f'drive{i}.bearing, rub'} <= set(costs)
    add = [int(costs[f'drive{i}, drive'][0]) for i in range(1, 7)]
    assert int(costs['sum of the effects'][0]) == sum(add)
    assert int(costs['base, without any'][0]) + sum(add) <= int(costs['whole'][0]) + 6 * 8  # shared leaves


def test_three_hundred_effects_compile_in_a_second_and_a_half(isoc, tmp_path):
    """Of processor time."""
    import resource
    import subprocess
    many = SIX.replace('to 6', 'to 100')
    path = tmp_path / 'many.scene'
    path.write_text(many)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(['build/isoc', path, '-o', tmp_path / 'made'], check=True, capture_output=True)
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before < 1.5
    listed = subprocess.run(['build/isoc', path, '--effects'], capture_output=True, text=True, check=True).stdout
    assert len(listed.splitlines()) == 300
