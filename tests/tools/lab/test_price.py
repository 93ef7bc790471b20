"""isochron cost SCENE: what each effect of a scene costs and changes. Each row is the difference to the scene in which
the statement of the effect is not written."""
import math
import re

import pytest

from harness.project import ROOT
from harness.commands import FOLDER
from lab import price, table

MODELS = str(ROOT / 'models')
SLEDS = '''\
# Two sleds that do not know of each other.
step 1 ms
method rk4
body first { mass 1 kg }
body second { mass 2 kg }
joint left prismatic { parent ground; child first; axis x; speed 1 m/s; spring 40 N/m }
joint right prismatic { parent ground; child second; axis x; speed 2 m/s; spring 30 N/m }
effect rub friction { along left; sliding 0.3 N }
effect count counter { what speed of right }
effect counter {
    signal what
    memory sum = 0
    next sum = sum + what / 1 m * 1 s
    output sum
}
output left = position of left
output right = position of right
output sum = count.sum
'''


@pytest.fixture(scope='module')
def sleds(isochron):
    """The command's result, its table as {row: {column: cell}}, and the folder of what it wrote."""
    (FOLDER / 'sleds.scene').write_text(SLEDS)
    of = isochron('cost', 'sleds.scene', '--seconds', '0.2')
    assert of.status == 0, of.errors
    folder = FOLDER / 'build/cost/sleds'
    head, *rows = table.read(folder / 'effects.tsv')
    of.table = {row[0] or row[1]: dict(zip(head, row)) for row in rows}
    of.folder = folder
    return of


def adds(of):
    """Whether base and sum are the whole, in all that is counted without a compiler."""
    return all(int(of['base'][key]) + int(of['sum'][key]) == int(of['whole'][key]) for key in price.KEYS
               if key not in ('step', 'tick', 'text', 'memory'))


def test_a_row_for_each_effect(sleds):
    assert {row[0] for row in sleds.rows} >= {'rub, friction', 'count, counter', 'whole'}
    rub, count = ({key: int(sleds.table[name][key]) for key in price.KEYS} for name in ('rub', 'count'))
    assert rub['add'] > 0 and rub['step'] > 0 and count['memories'] == 1 and count['step'] == 0 < count['tick']
    assert adds(sleds.table)
    planted = {row: dict(cells) for row, cells in sleds.table.items()}
    planted['sum']['add'] = str(int(planted['sum']['add']) + 1)
    assert not adds(planted)


def test_the_picture_shows_the_numbers_of_the_table(sleds):
    wanted = [sleds.table[name][key] for key in ('step', 'tick', 'text', 'memory') for name in ('rub', 'count')]
    wanted += [f'{100 * float(sleds.table[name]["part"]):.3g}' for name in ('rub', 'count')]
    shown = re.findall(r'> ([^<]+)<', (sleds.folder / 'effects.svg').read_text())
    assert [text.strip() for text in shown] == wanted
    assert (sleds.folder / 'effects.png').stat().st_size > 0


def test_a_row_is_the_difference_to_the_scene_without_the_statement(sleds, isochron):
    (FOLDER / 'smooth.scene').write_text(re.sub('^effect rub.*', '', SLEDS, flags=re.M))
    run = isochron('run', 'smooth.scene', '--seconds', '0.2', '--target', 'cortex-m4f')
    step = int(sleds.table['whole']['step'])
    assert int(sleds.table['rub']['step']) == step - int(run.said['instructions_per_step']) > 0
    traces = sleds.folder / 'cortex-m4f-float/whole/trace.csv', FOLDER / run.said['trace']
    whole, smooth = (table.read(path, ',') for path in traces)
    off = [float(a[whole[0].index('left')]) - float(b[smooth[0].index('left')]) for a, b in zip(whole[1:], smooth[1:])]
    for key, change in (('rms', math.sqrt(sum(d * d for d in off) / len(off))), ('largest', max(map(abs, off)))):
        assert 0 < change == pytest.approx(float(sleds.table['rub'][f'left_{key}']), rel=1e-8)


def test_an_output_that_does_not_know_of_an_effect_does_not_change_and_its_own_is_gone(sleds):
    assert float(sleds.table['rub']['right_largest']) == float(sleds.table['count']['left_largest']) == 0
    assert sleds.table['count']['sum_rms'] == ''


RUNAWAY = '''\
step 1 ms
method rk4
body cart { mass 1 kg }
joint rail prismatic { parent ground; child cart; axis x; speed 1 m/s }
effect spring { joint along; value stiffness N/m; effort on along = -stiffness * position of along }
effect push spring { along rail; stiffness -200 N/m }
effect hold spring { along rail; stiffness 201 N/m }
output x = position of rail
'''


def test_a_scene_that_runs_away_without_an_effect_has_a_row_for_it(isochron):
    (FOLDER / 'runaway.scene').write_text(RUNAWAY)
    of = isochron('cost', 'runaway.scene', '--seconds', '20')
    assert of.status == 0, of.errors
    assert {row[0] for row in of.rows} >= {'push, spring', 'hold, spring', 'whole'}
    assert re.search(r'^Without hold the guard stops the run at [0-9.]+ s; the changes are until then\.$', of.printed, re.M)


def test_a_run_that_the_guard_stops_has_an_end():
    whole = [['t', 'x'], ['0', '1'], ['1', '2'], ['2', '3']]
    of = price.Changes(whole, [['t', 'x'], ['0', '1'], ['1', '4']])
    assert of.end == 1 and of.largest == {'x': 2} and of.of == 'x' and price.Changes(whole, whole).end is None


@pytest.mark.parametrize('words, problem', (
    ([MODELS + '/pendulum.scene'], 'models/pendulum.scene has no effect'),
    ([MODELS + '/quarter_car.scene', '--parts', 'models'], '--parts and --methods have no effect on a scene'),
    ([MODELS + '/oscillator.c'], 'cost is for scenes'),
    (['--parts', 'modles'], '--parts modles is unknown; it can be: models methods'),
    (['--target', 'host'], 'is of the cortex-m4f in float')))
def test_told(isochron, words, problem):
    of = isochron('cost', *words)
    assert of.status == 1 and problem in of.errors and len(of.errors.splitlines()) == 1
