"""The folder of `isoc --standalone` has what the plant includes, and nothing else."""
import pathlib
import shutil
import subprocess

import pytest

from harness.project import ROOT

PENDULUM = ROOT / 'models/double_pendulum.scene'


def compiles(folder):
    """tcc removes what it writes to first: so it is no device."""
    return subprocess.run(['tcc', '-std=c11', '-D__NO_MATH_ERRNO__', '-I', folder, '-c', folder / 'plant.c', '-o', folder / 'plant.o'],
                          capture_output=True).returncode == 0


def core_of(made):
    return sorted(path for folder in ('core', 'port') for path in (made.folder / folder).rglob('*') if path.is_file())


def test_with_rk4_it_is_small(isoc):
    """At most 20 files and 2300 lines of core: rk4, what it is made of, and what a program calls."""
    files = core_of(isoc(PENDULUM, '--standalone'))
    lines = sum(len(path.read_text().splitlines()) for path in files)
    assert len(files) <= 20 and lines <= 2300, (len(files), lines)


@pytest.mark.parametrize('method', 'euler heun rk4 ab4 semi_implicit abm4 abm4_pec abm4_pecece bdf4 rosenbrock adams'.split())
def test_each_file_is_needed(isoc, tmp_path, method):
    """The folder of each method compiles, and not without any one of its files; tick.h is what a program includes."""
    made = isoc(PENDULUM, '--standalone', '--method', method)
    assert made.status == 0 and compiles(made.folder)
    for path in core_of(made):
        away = tmp_path / 'away'
        shutil.move(path, away)
        assert not compiles(made.folder), f'{path.relative_to(made.folder)} is not needed'
        shutil.move(away, path)


def test_a_file_more_is_noticed(isoc):
    """Control: a header that nothing includes is one that is not needed."""
    made = isoc(PENDULUM, '--standalone')
    shutil.copy(ROOT / 'core/methods/adams.h', made.folder / 'core/methods/adams.h')
    assert compiles(made.folder)
    (made.folder / 'core/methods/adams.h').unlink()
    assert compiles(made.folder)
