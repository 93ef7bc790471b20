"""FMUs of scenes, loaded in this process."""
import re
import subprocess
import sys

import pytest
from harness.plants import NUMERICS

sys.path.insert(0, 'tests/tools/fmu')
from importer import Fmu  # noqa: E402

FLAGS = ['-std=c11', '-O1', *NUMERICS, '-fPIC', '-shared', '-fvisibility=hidden']


@pytest.fixture(scope='session')
def fmu(isoc):
    """fmu(scene, version, *options): the FMU of a scene; `change` plants a defect in the text of fmu_instance.h."""

    def load(scene, version, *options, change=None):
        made = isoc(scene, '--fmu', '--fmi', str(version), *options)
        assert made.status == 0, made.errors
        folder = made.folder.parent / 'fmu'
        folder.mkdir()
        sources = made.folder.rename(folder / 'sources')
        if change:
            text = (sources / 'fmu_instance.h').read_text()
            (sources / 'fmu_instance.h').write_text(change(text))
        library = folder / 'binaries' / Fmu.platform_of(version)
        library.mkdir(parents=True)
        name = re.search(r'CoSimulation modelIdentifier="(\w+)"', (sources / 'modelDescription.xml').read_text())[1]
        subprocess.run(['gcc', *FLAGS, f'-DFMI{version}_OVERRIDE_FUNCTION_PREFIX', f'-I{sources}', *sources.rglob('*.c'),
                        '-o', library / f'{name}.so'], check=True)
        subprocess.run([sys.executable, '-B', 'tools/fmu/pack.py', folder, folder / 'plant.fmu'], check=True)
        return Fmu(folder / 'plant.fmu')

    return load
