"""What `isochron run` promises to scripts: the lines it ends with, the table it writes, and its exit status."""
import os
import re
import shutil

import numpy as np
import pytest

from harness.programs import hash_of, path_of
from harness.project import ROOT

MODELS = ROOT / 'models'
PENDULUM = MODELS / 'double_pendulum.scene'
OSCILLATOR = MODELS / 'oscillator.c'
KEYS = 'scene method step real ticks late overruns state hash trace'.split()


@pytest.fixture
def runs(isochron, laboratory):
    """runs(word, ...): a run, of the double pendulum unless a scene is named; with the lines of its `table`."""
    def call(*words, **environment):
        scene = [] if words and str(words[0]).endswith(('.scene', '.c')) else [PENDULUM]
        of = isochron('run', *scene, *words, **environment)
        of.table = (laboratory / of.said['trace']).read_text().splitlines() if of.status == 0 else []
        return of

    return call


@pytest.fixture
def first(runs):
    """With nothing said but the scene."""
    return runs()


def test_it_ends_with_a_summary_that_has_each_key_once(first):
    summary = first.printed[first.printed.rindex('scene '):].splitlines()
    assert all([line.split(' ')[0] for line in summary].count(key) == 1 for key in KEYS)
    said = first.said
    assert (said['scene'], said['ticks'], said['real'], said['late'], said['overruns']) == ('double_pendulum', '10000', 'float', '0', '0')
    assert re.fullmatch('[0-9a-f]{16}', said['hash']) and said['trace'] == 'build/host/float/double_pendulum/trace.csv'


def test_the_table_has_a_row_for_the_start_and_one_for_each_tick_and_reads_back_exactly(first, runs):
    """From its columns, which begin with the four states, comes the hash of the run: that of ticks 1 and after."""
    head, *rows = first.table
    assert head == 't,shoulder_angle,elbow_angle,shoulder_rate,elbow_rate,tip_x,tip_y,tip_z,energy' and len(rows) == 10001
    cells = [row.split(',') for row in rows]
    assert {len(row) for row in cells} == {9}
    assert abs(np.array([float(row[0]) for row in cells]) - 1e-3 * np.arange(10001)).max() < 1e-9
    assert hash_of(np.array([row[1:5] for row in cells[1:]], np.float32)) == first.said['hash']
    assert first.said['state'] == ' '.join(cells[-1][1:5])
    again = runs()
    assert again.said['hash'] == first.said['hash'] and again.table == first.table


def test_method_step_seconds_and_real_are_heard(runs):
    said = runs('--method', 'euler', '--step', '2ms', '--seconds', 1)
    assert (said.said['method'], said.said['ticks'], len(said.table)) == ('euler', '500', 502)
    single, double = runs('--seconds', 1), runs('--seconds', 1, '--real', 'double')
    assert (double.said['real'], double.said['ticks']) == ('double', '1000') and double.said['hash'] != single.said['hash']


def test_a_scene_outside_the_project_and_a_plant_written_by_hand(runs, tmp_path):
    mine = shutil.copy(MODELS / 'pendulum.scene', tmp_path / 'mine.scene')
    for scene, name in ((mine, 'mine'), (OSCILLATOR, 'oscillator')):
        of = runs(scene, '--seconds', 1)
        assert of.said['scene'] == name and len(of.table) == 1002


def test_the_status_is_not_0_when_the_state_leaves_the_finite_numbers(runs, tmp_path):
    wild = path_of(re.sub('^step .*', 'step 500 ms', PENDULUM.read_text(), flags=re.M), tmp_path, 'wild.scene')
    assert runs(wild, '--method', 'euler', '--step', '500ms', '--seconds', 2000).status != 0


def test_ticks_that_are_late_lost_or_slow_are_accounted_and_do_not_change_the_trajectory(first, runs, tmp_path):
    """Late: 5; 20 and 21, done with 22; 41 and 42, after 40 at 42.5 ms. Lost, since told of with a later one: 20, 21; 41.
    Overruns: 20, at 22 ms (21 is done when 22 is due); 40 and 41, at 42.5 ms."""
    script = path_of('late 5 300us\nlose 20\nlose 21\nslow 40 2500us\n', tmp_path, 'script')
    said = runs('--script', script).said
    assert said['hash'] == first.said['hash']
    assert [said[key] for key in ('ticks', 'late', 'lost', 'overruns')] == ['10000', '5', '3', '3']


@pytest.mark.parametrize('text, words', (
    (r'absent\.scene', [MODELS / 'absent.scene']), ('target', ['--target', 'abacus']), ('method', ['--method', 'guess']),
    ('real', ['--real', 'decimal']), ('step', ['--step', 'fast']), ('seconds', ['--seconds', 'soon'])))
def test_refused(runs, text, words):
    of = runs(*words)
    assert of.status != 0 and re.search(text, of.printed + of.errors)


def test_a_plant_in_c_is_checked_and_compensated_where_it_is_asked_for(runs):
    plain, checked, compensated = (runs(OSCILLATOR, '--seconds', 1, *word) for word in ([], ['--checked'], ['--compensated']))
    assert 'local_error' not in plain.said and 'local_error' in checked.said
    assert checked.said['hash'] == plain.said['hash'] != compensated.said['hash']
    # A check with a history finds the step of its force, and begins anew.
    assert runs(OSCILLATOR, '--method', 'ab4', '--seconds', 2, '--checked').said['restarts'] == '1'


def test_a_plant_by_hand_runs_with_adams(runs):
    error = runs(OSCILLATOR, '--method', 'adams', '--tolerance', '1e-9', '--real', 'double', '--seconds', 1).said['local_error']
    assert 0 < float(error) <= 1e-9
    assert int(runs(OSCILLATOR, '--method', 'adams', '--seconds', 1).said['substeps']) >= 1000


def test_a_plant_by_hand_without_a_jacobian_is_not_compiled_for_a_method_that_needs_one(runs, tmp_path):
    text = OSCILLATOR.read_text()
    for pattern, by in (('^#define ISO_HAS_JACOBIAN.*\n', ''), (r'^static void (factor|solve)\((.|\n)*?^}\n', ''),
                        ('^static const iso_equations.*', 'static const iso_equations equations = {.derivative = derivative};')):
        text, count = re.subn(pattern, by, text, flags=re.M)
        assert count > 0, pattern
    simple = path_of(text, tmp_path, 'simple.c')
    of = runs(simple, '--method', 'bdf4')
    assert of.status != 0 and 'needs a Jacobian, and this plant has none' in of.printed + of.errors
    assert runs(simple, '--method', 'heun', '--seconds', 1).status == 0


def test_a_machine_without_the_cross_compiler_or_the_emulator_is_told_what_to_install(runs, tmp_path):
    """All tools but those that the target needs; the compilers themselves, not what keeps their objects."""
    for folder in os.environ['PATH'].split(':'):
        for tool in os.scandir(folder) if os.path.isdir(folder) and not folder.endswith('/ccache') else []:
            if not tool.name.startswith(('arm-none-eabi-', 'qemu-system-')) and not os.path.lexists(tmp_path / tool.name):
                os.symlink(tool.path, tmp_path / tool.name)
    path = str(tmp_path)
    of = runs('--target', 'cortex-m4f', PATH=path)
    assert of.status != 0 and re.search('apt(-get)? install.*gcc-arm-none-eabi', of.printed + of.errors)
    assert runs('--seconds', 1, PATH=path).status == 0
    compiler = next(p for p in (f'{folder}/arm-none-eabi-gcc' for folder in os.environ['PATH'].split(':')
                                if not folder.endswith('/ccache')) if os.path.exists(p))
    os.symlink(compiler, tmp_path / 'arm-none-eabi-gcc')
    of = runs('--target', 'cortex-m4f', PATH=path)
    assert of.status != 0 and 'qemu-system-arm' in of.printed + of.errors
