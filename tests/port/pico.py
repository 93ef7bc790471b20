"""The emulator of the RP2040 for tests: as it is, and a copy that lacks something."""
import shutil
import subprocess

import pytest

from harness.project import ROOT, make

PORT = ROOT / 'port/rp2040'


@pytest.fixture(scope='session', autouse=True)
def package():
    """A test file that imports this has the emulator's package; without it, it fails."""
    make('build/rp2040js')


def emulated(program, nanoseconds=20_000_000, script=(), emulator=PORT / 'emulator.mjs', seconds=60):
    """What a program writes on its console in the emulator."""
    return subprocess.run(['node', emulator, program, str(nanoseconds), *script], capture_output=True, timeout=seconds,
                          check=False)


def copied(folder, without=None, package=True):
    """A copy of the emulator, with or without its package, that lacks this line of chip.mjs."""
    made = folder / 'port/rp2040'
    made.mkdir(parents=True)
    (folder / 'build').mkdir()
    if package:
        (folder / 'build/rp2040js').symlink_to(ROOT / 'build/rp2040js')
    for path in PORT.glob('*.mjs'):
        shutil.copy(path, made)
    text = (made / 'chip.mjs').read_text()
    assert without is None or text.count(f'    {without}\n') == 1
    (made / 'chip.mjs').write_text(text.replace(f'    {without}\n', ''))
    return made / 'emulator.mjs'
