"""What a scene says about overruns, a grace, the publication and a histogram: what the loop counts under random scripts
of the simulated port, against an account by other code (policy_model.py); the trajectory, which is that of the ticks that were
done, by the methods and with the effects of the rungs."""
import re

import numpy as np
import pytest
from policy_model import KEYS, account, script_of

from harness.programs import LOOP, REPORT, hash_of, path_of, run, traced
from harness.project import ROOT

HERE = ROOT / 'tests/core/runtime/overruns'
PENDULUM, DROPPED = ((HERE / f'{name}.scene').read_text() + '\n' for name in ('pendulum', 'dropped'))
RUN = [*LOOP, 'core/application/main.c']
SECOND = 1000000000
FAMILIES = {
    'catch_0': (PENDULUM, 'overrun catch_up 0', ('catch_up', 0, 0)),
    'catch_3': (PENDULUM, 'overrun catch_up 3\ngrace 50 ticks\nhistogram', ('catch_up', 3, 50)),
    'counted': (PENDULUM, 'histogram\npublish next_tick', ('count', 0, 0)),
    'stopped': (PENDULUM, 'overrun stop\ngrace 20 ticks', ('stop', 0, 20)),
    'ladder': (PENDULUM, 'overrun degrade { method heun; method euler; hold; after 20 ticks }\ngrace 5 ticks',
               ('degrade', 20, 5)),
    'drops': (DROPPED, 'overrun degrade { drop hinge; drop wind; hold; after 20 ticks }\ngrace 5 ticks', ('degrade', 20, 5)),
}


@pytest.fixture(scope='module')
def runs(isoc, program, tmp_path_factory):
    """runs(scene, script, *options): a second of a scene on the simulated port, with its `table`, as text."""
    programs = {}

    def of(scene, script='', *options):
        key = scene, options
        if key not in programs:
            made = isoc(scene, *options)
            assert made.status == 0, made.errors
            programs[key] = program(made, *RUN)
        folder = tmp_path_factory.mktemp('run')
        done = traced(folder, programs[key], SECOND, path_of(script, folder, 'script'))
        done.table = (folder / 'trace.csv').read_text().splitlines()
        done.values = {}
        for line in done.printed.splitlines():
            key, _, rest = line.partition(' ')
            done.values.setdefault(key, []).append(rest)
        return done

    return of


def of_family(runs, name, script):
    scene, statements, _ = FAMILIES[name]
    return runs(f'{scene}{statements}\n', script.text)


@pytest.mark.seeds(8)
@pytest.mark.parametrize('name', FAMILIES)
def test_the_account_is_the_models(runs, name, seed):
    """What the policies of a scene do not count is not told."""
    script = script_of(seed)
    values, _ = account(script, *FAMILIES[name][2])
    keys = KEYS + ['histogram'] * ('histogram' in FAMILIES[name][1])
    done = of_family(runs, name, script)
    assert {key: done.values.get(key, []) for key in keys} == {key: values[key] for key in keys}, done.errors


def test_found_another_number_of_ticks_that_are_caught_up(runs):
    script = script_of(3)
    assert of_family(runs, 'catch_0', script).values['skipped'] != account(script, 'catch_up', 2, 0)[0]['skipped']


@pytest.mark.seeds(2)
def test_the_trajectory_is_that_of_the_ticks_that_were_done_whatever_was_skipped(runs, seed):
    script = script_of(seed)
    hashes = {of_family(runs, name, script).said['hash'] for name in ('catch_0', 'catch_3', 'counted')}
    assert len(hashes) == 1 and of_family(runs, 'counted', script).values['latency'] == ['1 ticks']


@pytest.mark.seeds(3)
def test_a_run_that_an_overrun_stops_says_so_and_its_table_ends_with_that_tick(runs, seed):
    script = script_of(seed)
    done, ticks = of_family(runs, 'stopped', script), account(script, *FAMILIES['stopped'][2])[0]['ticks'][0]
    assert done.errors.splitlines()[0] == f'trace: stopped by the overrun of tick {ticks}' and len(done.table) == int(ticks) + 2


def test_on_the_board_the_hash_is_the_same_and_the_histogram_of_instructions(runs, isochron, tmp_path):
    scene, statements, _ = FAMILIES['catch_3']
    of = isochron('run', path_of(f'{scene}{statements}\n', tmp_path, 'plant.scene'), '--target', 'cortex-m4f', '--seconds', 1)
    assert of.said['hash'] == of_family(runs, 'catch_3', script_of(1)).said['hash']
    assert of.said['histogram'].endswith(' instructions: 1000')


@pytest.mark.seeds(2)
def test_the_trajectory_of_a_ladder_is_that_of_its_methods(runs, plant, seed):
    """One plant hands its states to the others. Control: another rung."""
    plants = [plant(PENDULUM, '--method', method, real='float') for method in ('rk4', 'heun', 'euler')]

    def replayed(rungs):
        for one in plants:
            one.start()
        rows = []
        for tick, rung in enumerate(rungs):
            if rung < 3:
                plants[rung].go(1, first=tick)
            for one in plants:
                one.now['x'] = plants[min(rung, 2)].now['x']
            rows.append(plants[0].now['x'][0].copy())
        return hash_of(np.array(rows))

    script = script_of(seed)
    _, rungs = account(script, *FAMILIES['ladder'][2])
    digest = of_family(runs, 'ladder', script).said['hash']
    assert set(rungs) > {0, 1} and replayed(rungs) == digest
    assert replayed([2 if rung == 1 else rung for rung in rungs]) != digest


@pytest.fixture(scope='module')
def drops(isoc, program, tmp_path_factory):
    """drops(rungs, table): the hash of plants of the scene with less and less effects, and in how many lines of the table
    an output has other bits (drops.c)."""
    plants = [isoc(DROPPED, '--name', name, *without) for name, without in (
        ('by_all', []), ('by_less', ['--without', 'hinge']), ('by_least', ['--without', 'hinge; wind']))]
    by_hand = program(*plants, 'tests/core/runtime/overruns/drops.c', 'core/numbers/self_check.c')

    def of(rungs, table):
        folder = tmp_path_factory.mktemp('drops')
        return run(by_hand, path_of('\n'.join(map(str, rungs)) + '\n', folder, 'rungs'),
                   path_of('\n'.join(table) + '\n', folder, 'table')).printed.split()

    return of


@pytest.mark.seeds(2)
def test_a_ladder_that_drops_effects_moves_and_shows_what_the_scene_without_them_does(runs, drops, seed):
    """Controls: other rungs."""
    script = script_of(seed)
    _, rungs = account(script, *FAMILIES['drops'][2])
    done = of_family(runs, 'drops', script)
    right = [done.said['hash'], '0']
    assert drops(rungs, done.table) == right
    for old, new in ((1, 2), (2, 1), (3, 2)):
        other = [new if rung == old else rung for rung in rungs]
        assert other == rungs or drops(other, done.table) not in (right, []), (old, new)
    at = rungs.index(0, 39)
    assert drops([*rungs[:at], 1, *rungs[at + 1:]], done.table) not in (right, [])


@pytest.mark.parametrize('rungs', ('drop hinge; hold; method rk4; drop wind', 'method heun; drop hinge; method rk4; drop wind'))
def test_each_rung_has_a_step_of_its_own_name_and_its_operations_are_told(isoc, program, rungs):
    made = isoc(f'{DROPPED}overrun degrade {{ {rungs}; after 20 ticks }}\n')
    program(made, by='gcc', flags=['-fPIC'], link=['-shared'])
    assert made.summary['step_without_hinge_wind'].split()[0] == 'add'


def test_from_a_snapshot_on_a_lower_rung_the_board_goes_on_with_fewer_instructions(isochron, laboratory, tmp_path):
    scene = path_of(DROPPED + 'overrun degrade { drop hinge; drop wind; after 1000000 ticks }\n', tmp_path, 'plant.scene')
    script = path_of('slow 100 2ms\nslow 130 2ms\n', tmp_path, 'script')
    host = isochron('run', scene, '--script', script, '--snapshot', 150, '--seconds', 0.3)
    top = isochron('run', scene, '--target', 'cortex-m4f', '--seconds', 0.3)
    lower = isochron('run', scene, '--target', 'cortex-m4f', '--restore', laboratory / host.said['snapshot'], '--seconds', 0.3)
    assert lower.said['hash'] == host.said['hash'] and lower.said['degraded'] == '150 to rung 2'
    assert int(lower.said['instructions_per_step']) < int(top.said['instructions_per_step'])


def columns(table, names):
    """These columns of a table."""
    at = [table[0].split(',').index(name) for name in names]
    return [[line.split(',')[i] for i in at] for line in table]


SMOOTH = (ROOT / 'models/quarter_car.scene').read_text().replace('1 s: 0 m, 1.4 s', '0.1 s: 0 m, 0.5 s').replace('1.42 s', '0.52 s')
CHAIN = (ROOT / 'tests/isoc/plant/tunables/chain.scene').read_text() + '\n'


@pytest.mark.parametrize('scene, effect, more, stands', (
    (CHAIN, 'motor', 'at 0.3 s set length = 0.25 m\n', r'tune_without_motor\(memory->h_without_motor'),
    (SMOOTH + '\n', 'buffers', '', r'iso_method_sample\(.*equations_without_buffers')))
def test_a_rung_without_an_effect_is_the_scene_without_it(runs, isoc, scene, effect, more, stands):
    """An effect that does nothing in the first tick, after which it is dropped. What follows from tunables is kept for each
    rung, and computed anew when one changes; smooth inputs are so on each. Control: the run with the effect."""
    text = f'{scene}overrun degrade {{ drop {effect}; after 1000000 ticks }}\n{more}'
    dropped, whole = runs(text, 'slow 1 2ms\n'), runs(text)
    alone = runs(f'{scene}overrun count\n{more}', '', '--without', effect)
    assert dropped.said['degraded'] == '999 to rung 1' and len(alone.table) == 1002
    names = alone.table[0].split(',')
    assert columns(dropped.table, names) == columns(alone.table, names) != columns(whole.table, names)
    assert re.search(stands, isoc(text).file('plant.c'))


def test_the_rung_and_the_good_ticks_on_it_are_in_a_record_and_a_reset_begins_anew(isoc, program, proves, tmp_path):
    """Control: a record with another rung."""
    made = isoc(PENDULUM + 'overrun degrade { method heun; method euler; after 30 ticks }\npublish next_tick; histogram\n')
    script = path_of('slow 40 1500us\nslow 50 1500us\n', tmp_path, 'script')
    sources = [made, *LOOP, REPORT, 'tests/core/runtime/overruns/restored.c']
    proves(program(*sources), 0, script)
    planted = {'core/runtime/snapshot.c': ('head.rung = (uint16_t)ladder->rung;', 'head.rung = 1;')}
    assert run(program(*sources, planted=planted), 0, script).finds('to the same hash')


@pytest.mark.parametrize('statement, adds', (
    ('overrun count', False), ('publish at_once', False), ('overrun stop', True), ('grace 1 ticks', True),
    ('publish next_tick', True), ('histogram', True), ('overrun catch_up 1', True)))
def test_what_the_loop_does_anyhow_adds_nothing_to_the_plant(isoc, statement, adds):
    assert (isoc(f'{PENDULUM}{statement}\n').file('plant.c') != isoc(PENDULUM).file('plant.c')) == adds
