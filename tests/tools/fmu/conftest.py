"""FMUs of scenes, as archives, and loaded in this process."""
import re
import sys

import pytest
from harness.plants import NUMERICS, STRICT
from harness.programs import compiles, run

sys.path.insert(0, 'tests/tools/fmu')
from importer import Fmu  # noqa: E402

FLAGS = ['-fPIC', '-shared', '-fvisibility=hidden']
BY = {'gcc': ['gcc', '-std=c11', '-O1', *NUMERICS], 'strict': ['gcc', '-std=c11', *STRICT, '-O0'],
      'tcc': ['tcc', '-std=c11', '-include', 'tools/lab/tcc.h']}


@pytest.fixture(scope='session')
def archive(isoc):
    """archive(scene, version, *options, by=, change=): the path of the FMU of a scene, with its sources in `sources` beside;
    `change` plants a defect in the texts of files of it: {name: change}."""

    def make(scene, version, *options, by='gcc', change=None):
        made = isoc(scene, '--fmu', '--fmi', str(version), *options)
        assert made.status == 0, made.errors
        folder = made.folder.parent / 'fmu'
        folder.mkdir()
        sources = made.folder.rename(folder / 'sources')
        for name, other in (change or {}).items():
            text = (sources / name).read_text()
            assert other(text) != text, name
            (sources / name).write_text(other(text))
        library = folder / 'binaries' / Fmu.platform_of(version)
        library.mkdir(parents=True)
        kind = '' if '--exchange' in options else 'CoSimulation '
        name = re.search(kind + r'modelIdentifier="(\w+)"', (sources / 'modelDescription.xml').read_text())[1]
        files = sorted(sources.rglob('*.c')) if '--exchange' not in options else sorted(sources.glob('*.c'))
        compiles(*BY[by], *FLAGS, f'-DFMI{version}_OVERRIDE_FUNCTION_PREFIX', f'-I{sources}', *files, '-o', library / f'{name}.so')
        return packed(folder)

    return make


def packed(folder, name='plant.fmu'):
    done = run(sys.executable, '-B', 'tools/fmu/pack.py', folder, folder / name)
    assert done.status == 0, done.errors
    return folder / name


@pytest.fixture(scope='session')
def fmu(archive):
    """fmu(scene, version, *options): the FMU of a scene; `change` plants a defect in the text of fmu_instance.h."""

    def load(scene, version, *options, change=None):
        return Fmu(archive(scene, version, *options, change={'fmu_instance.h': change} if change else None))

    return load
