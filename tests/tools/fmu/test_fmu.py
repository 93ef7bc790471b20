"""FMUs of both versions against the plants that they are of, by an importer of the project's own: rows of trace.csv to the
last bit and hashes, in steps of one tick and of many, several instances, resets, FMU states as bytes; messages; calls that
are wrong; a tunable that is set is as if the scene set it. One of the plants has faults, memories and functions of time;
another begins with sub-steps that vary; a third has an input with limits. Every call in every state of the standard: those
that are wrong change nothing. What outputs depend on is what moves them."""
import os
import re
import types

import pytest
from conftest import packed

from harness.programs import LOOP, compiles, path_of, run, traced
from harness.project import ROOT

HERE = 'tests/tools/fmu/'
DRIVE = (ROOT / 'models/cart_pole_drive.scene').read_text().replace('"parts/', f'"{ROOT}/models/parts/')
LOOP_SCENE = (ROOT / 'models/four_bar.scene').read_text().replace('input motor\n', 'input motor in -1 N*m to 1 N*m\n')
PLANTS = {'drive': (DRIVE, (2, 3), 9, []), 'loop': (LOOP_SCENE, (2, 3), 1, ['--method', 'ab4', '--real', 'double']),
          'adams': ((ROOT / 'models/double_pendulum.scene').read_text(), (3,), 1, ['--method', 'adams', '--tolerance', '1e-6'])}
TAP = ['python3', '-B']


@pytest.fixture(scope='module')
def plants(isoc, program, archive, tmp_path_factory):
    """Of each a run of it outside, its `trace` and what it `told`, and its FMU of each `version`; compiled with all
    warnings."""
    def of(name):
        text, versions, seconds, options = PLANTS[name]
        folder = tmp_path_factory.mktemp(name)
        scene = path_of(text, folder, f'{"cart_pole_drive" if name == "drive" else name}.scene')
        alone = program(isoc(scene, *options), *LOOP, 'core/application/main.c', real='double' if 'double' in options else 'float')
        told = path_of(traced(folder, alone, seconds * 10**9).printed, folder, 'told')
        return types.SimpleNamespace(trace=folder / 'trace.csv', told=told,
                                     version={v: archive(scene, v, *options, by='strict') for v in versions})

    return {name: of(name) for name in PLANTS}


def test_rows_and_hashes_are_those_of_the_plants(plants, proves):
    proves(*TAP, HERE + 'check.py', *(word for plant in plants.values() for fmu in plant.version.values()
                                      for word in (fmu, plant.trace, plant.told)))


def test_every_call_in_every_state_of_the_standard(plants, proves):
    proves(*TAP, HERE + 'states.py', *(word for name in ('drive', 'loop') for fmu in plants[name].version.values()
                                       for word in (fmu, plants[name].told)))


def test_what_outputs_depend_on_is_what_moves_them(plants, proves):
    proves(*TAP, HERE + 'dependencies.py', *plants['drive'].version.values(), plants['adams'].version[3], plants['loop'].version[3])


def test_what_the_scene_sets_at_its_times_an_importer_sets_at_these(plants, archive, proves, tmp_path):
    scene = path_of(re.sub('^at .*\n', '', DRIVE, flags=re.M), tmp_path, 'cart_pole_drive.scene')
    proves(*TAP, HERE + 'tunables.py', archive(scene, 2), plants['drive'].trace, plants['drive'].told,
           '6:reading_active:1', '6.5:reading_active:0', '8:drive_open:1')


def test_found_another_row(plants, tmp_path):
    rows = plants['drive'].trace.read_text().splitlines()
    cells = rows[4999].split(',')
    rows[4999] = ','.join([*cells[:2], str(float(cells[2]) + 0.001), *cells[3:]])
    wrong = path_of('\n'.join(rows) + '\n', tmp_path, 'wrong.csv')
    assert run(*TAP, HERE + 'check.py', plants['drive'].version[2], wrong, plants['drive'].told).finds('rows and hash')


def test_found_a_step_after_the_end_and_a_refused_call_that_sets_the_end_of_the_run(plants, archive, tmp_path):
    steps = 'fmu_may(instance, "fmi2DoStep", FMU_STEPPING'
    planted = archive(path_of(DRIVE, tmp_path, 'cart_pole_drive.scene'), 2, change={
        'fmi2.c': lambda text: text.replace(steps, steps + ' | FMU_TERMINATED'),
        'fmu_instance.h': lambda text: text.replace('    if (!(start == 0.0)) {\n', '    f->now.stop = DBL_MAX;\n    if (!(start == 0.0)) {\n')})
    found = run(*TAP, HERE + 'states.py', '--find', planted, plants['drive'].told).printed.splitlines()
    assert 'DoStep in E: not refused' in found and 'wrong arguments of SetupExperiment in N: changes something' in found


def test_sources_of_2_0_have_no_name_that_is_not_of_the_model(plants, tmp_path):
    """In sources that a program links every name begins with that of the model, in 2.0 by itself."""
    compiles('gcc', '-std=c11', '-c', plants['drive'].version[2].parent / 'sources/fmi2.c', '-o', tmp_path / 'linked.o')
    names = [line.split()[-1] for line in run('nm', '--defined-only', '--extern-only', tmp_path / 'linked.o').printed.splitlines()]
    assert 'cart_pole_drive_fmi2DoStep' in names and all(name.startswith('cart_pole_drive_fmi2') for name in names)


def test_the_same_files_at_another_time_give_the_same_archive(plants):
    archive = plants['drive'].version[3]
    for source in (archive.parent / 'sources').glob('*.c'):
        os.utime(source)
    before = archive.read_bytes()
    archive.unlink()
    assert packed(archive.parent).read_bytes() == before


def test_a_scene_that_is_refused_leaves_the_fmu_of_before(isochron, tmp_path):
    kept = [path_of('kept', tmp_path, name) for name in ('sources/kept', 'kept.fmu')]
    of = isochron('fmu', ROOT / 'models/four_bar.scene', '--exchange', '--out', tmp_path)
    assert of.status != 0 and 'error: no model exchange' in of.errors and not (tmp_path / 'new').exists()
    assert all(path.read_text() == 'kept' for path in kept)
