"""Outputs of every n-th tick: in the row of a tick whose number is a multiple of n they are what the same output of each tick is, and
in between what they were; in a snapshot, across 2^32 ticks, where an output is not finite, and over a link; on the board the same
rows, and one number of instructions for all steps. What is of each tick anyhow has the bytes that it had."""
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest
from harness.commands import FOLDER
from harness.plants import STRICT, replaced
from harness.project import ROOT

PLACE = ROOT / 'tests/isoc/plant/outputs/rates.scene'
SCENE = PLACE.read_text()
FAST = replaced(' every .*', '', SCENE)
PAIRS = [('theta', 'theta_4', 4), ('tip_x', 'tip_10_x', 10), ('tip_y', 'tip_10_y', 10), ('tip_y', 'along_4', 4), ('turn', 'turn_3', 3),
         ('mean', 'mean_3', 3), ('late', 'late_10', 10)]


def is_of_rate(y, fast, slow, every):
    """Whether an output is the other one, held for so many rows."""
    rows = np.arange(len(y.theta)) // every * every
    return bool((y[slow] == y[fast][rows]).all() and (y[slow] != y[fast]).any())


def test_a_slow_output_is_held_for_its_rows(plant):
    y = plant(SCENE, real='float').follow(200).y
    for pair in PAIRS:
        assert is_of_rate(y, *pair), pair
    assert not is_of_rate(y, 'theta', 'theta_4', 3) and not is_of_rate(y, 'theta', 'mean_3', 3) and not is_of_rate(y, 'theta', 'theta', 1)


def keeps_rate(p, first, ticks, ahead=0):
    """Whether a slow output changes at the end of the ticks whose number is a multiple of 3, and at no others; the plant is told other
    numbers, which are so far ahead."""
    y = p.named(p.go(ticks, first=first + ahead)[0]).y
    is_due = np.array([(first + k + 1) % 3 == 0 for k in range(ticks)])
    return bool(((y.mean_3[1:] == y.mean[1:]) == is_due).all() and ((y.mean_3[1:] != y.mean_3[:-1]) == is_due).all())


def test_rates_count_ticks_from_a_snapshot_and_across_two_to_the_32(plant):
    p = plant(SCENE, real='float')
    p.start()
    assert p.named(p.now).y.mean == p.named(p.now).y.mean_3, 'at the start all are computed'
    assert keeps_rate(p, 0, 50) and not keeps_rate(p, 50, 10, 1)
    kept = p.now.copy()
    straight = p.go(30, first=62)[0]['y']
    p.start()
    p.now[:] = kept
    assert np.array_equal(p.go(30, first=62)[0]['y'], straight), 'a plant from a snapshot has the same outputs'
    p.go(1, first=2**32 - 6)
    assert keeps_rate(p, 2**32 - 5, 25)


def test_an_output_that_is_not_finite_is_held_and_counted_when_it_is_computed(plant):
    """Then the last good ones of all stand."""
    p = plant(SCENE, real='float')
    y = p.follow(20, sets={0: {'divisor': 0}}).y
    assert p.facts.outputs_held == 4 and (y.lone_5 == y.lone_5[0]).all()
    assert ((y.theta[1:] == y.theta[:-1]) == [k % 5 == 0 for k in range(1, 21)]).all()


def test_the_board_has_the_same_rows_and_its_steps_take_no_more(isochron, tmp_path):
    (tmp_path / 'fast.scene').write_text(FAST)
    host, board, fast = (isochron('run', scene, '--seconds', '0.2', '--target', target).said for scene, target in (
        (PLACE, 'host'), (PLACE, 'cortex-m4f'), (tmp_path / 'fast.scene', 'cortex-m4f')))
    assert (FOLDER / host['trace']).read_bytes() == (FOLDER / board['trace']).read_bytes()
    assert host['hash'] == board['hash'] == fast['hash']
    assert int(board['instructions_per_step']) <= int(fast['instructions_per_step'])
    least, most = map(int, re.search(r'^finish (\d+) to (\d+) instructions$', isochron('ticks', PLACE).printed, re.M).groups())
    assert least < most, 'the least and the most of ten ticks are told'
    assert not re.search('^finish', isochron('ticks', tmp_path / 'fast.scene').printed, re.M)


def test_isoc_tells_the_operations_of_each_rate_and_one_of_each_tick_adds_nothing(isoc):
    assert re.search('^outputs_every_10 add 3 mul 6 ', isoc(SCENE).printed, re.M)
    one = isoc(replaced(' every .*', ' every 1 ticks', SCENE))
    assert {name: text.replace(' every 1 ticks', '') for name, text in one.files().items()} == isoc(FAST).files()


CONTROLLER = '''import sys
sys.path.insert(0, sys.argv[1])
import wired_link as plant
with plant.Link() as link:
    rows = wrong = held = 0
    y = link.start('lockstep', 60)
    while y:
        held = y.theta if rows % 4 == 0 else held
        wrong += y.theta_4 != held
        rows += 1
        y = link.exchange(push=0.1 * y.theta_4)
    print(f'rows {rows} wrong {wrong}')
'''


def test_a_controller_at_the_other_end_of_a_wire_sees_the_same(isochron, isoc, tmp_path):
    wired = tmp_path / 'wired.scene'
    wired.write_text(SCENE.replace('tunable divisor = 1\n', 'tunable divisor = 1\ninput push N*m\n').replace('start 20 deg', 'start 20 deg; drive push'))
    (tmp_path / 'controller.py').write_text(CONTROLLER)
    made = isoc(wired, '--link')
    said = isochron('link', wired, '--seconds', '0.06', '--controller', f'{sys.executable} {tmp_path}/controller.py {made.folder}')
    assert said.said['rows'] == '60 wrong 0', said.printed + said.errors


LADDER = '''effect brake { joint j; effort on j = -1 * speed of j * 1 N*m*s }
effect slows brake { j elbow }
overrun degrade { drop slows; hold; after 10 ticks }
'''


@pytest.mark.parametrize('scene, options', [
    (pathlib.Path('models/pendulum.scene').read_text() + 'output slow = speed of pivot every 4 ticks\n', []), (SCENE + LADDER, []),
    (SCENE + LADDER, ['--link', '--xcp', 'open'])], ids=['nothing else of a row', 'a ladder', 'measured'])
def test_a_plant_with_rates_compiles_without_a_warning(isoc, tmp_path, scene, options):
    made = isoc(scene, *options)
    subprocess.run(['gcc', '-std=c11', *STRICT, '-O0', '-I', ROOT, '-I', made.folder, '-c', made.folder / 'plant.c', '-o', tmp_path / 'o'], check=True)
