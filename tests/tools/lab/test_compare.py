"""isochron compare: what it prints of two runs is what numpy computes from their tables, and runs that cannot be
compared are refused with a reason."""
import shutil

import numpy as np
import pytest

from harness.project import ROOT

PENDULUM = ROOT / 'models/pendulum.scene'


@pytest.fixture
def runs(laboratory, isochron):
    """The folder of two runs, b with twice the step of a."""
    folder = laboratory / 'build/runs'
    for name, *words in ('a', '--seconds', '0.5'), ('b-2.5_ms', '--seconds', '1', '--step', '2ms', '--method', 'heun'):
        run = isochron('run', PENDULUM, *words, '--keep', name)
        assert run.status == 0 and (folder / name / 'summary.txt').read_text() in run.printed
    return folder


def read(run):
    names = (run / 'trace.csv').read_text().split('\n', 1)[0].split(',')
    return names, np.loadtxt(run / 'trace.csv', delimiter=',', skiprows=1)


def changed(runs, name, file, change):
    """A copy of run a with another text."""
    shutil.copytree(runs / 'a', runs / name, dirs_exist_ok=True)
    text = (runs / name / file).read_text()
    assert change(text) != text
    (runs / name / file).write_text(change(text))


def table(printed):
    """{output: rms, largest, time} of what is printed."""
    lines = [line.split() for line in printed.splitlines()[2:] if not line.startswith('build')]
    return {line[0]: list(map(float, line[-3:])) for line in lines}


def test_differences(laboratory, isochron, runs):
    printed = isochron('compare', 'a', 'b-2.5_ms').printed
    assert printed.startswith('a - b-2.5_ms at 251 times, from 0 to 0.5 s\n')
    (names, a), (_, b) = read(runs / 'a'), read(runs / 'b-2.5_ms')
    apart = a[::2] - b[:251]
    found = table(printed)
    assert list(found) == names[1:]
    for column, name in enumerate(names[1:], 1):
        most = np.abs(apart[:, column]).argmax()
        wanted = np.sqrt(np.mean(apart[:, column] ** 2)), apart[most, column], a[2 * most, 0] if apart[most,
                                                                                                       column] else 0
        # A number of six digits is wrong by 5e-6 of it at most.
        assert np.allclose(found[name], wanted, rtol=5e-6, atol=0), name
    folder = laboratory / 'build/compare'
    assert (folder / 'a-b-2.5_ms.gnuplot').read_text().count('\nplot ') == len(names) - 1
    assert all((folder / f'a-b-2.5_ms.{ending}').stat().st_size for ending in ('svg', 'png'))


def test_one_number_that_differs(isochron, runs):
    def change(text):
        lines = text.splitlines()
        time, theta, rest = lines[101].split(',', 2)
        lines[101] = f'{time},{float(theta) + 0.25!r},{rest}'
        return '\n'.join(lines) + '\n'
    changed(runs, 'changed', 'trace.csv', change)
    found = table(isochron('compare', 'changed', 'a').printed)
    assert found.pop('theta')[1:] == [0.25, 0.1]
    assert all(row[:2] == [0, 0] for row in found.values())


def renamed(text):
    head, *rows = text.splitlines()
    return 't,one,two\n' + ''.join(f"{row.split(',')[0]},1,2\n" for row in rows)


def stretched(text):
    head, *rows = text.splitlines()
    return '\n'.join([head, *(f"{0.9973 * float(row.split(',', 1)[0])!r},{row.split(',', 1)[1]}"
                              for row in rows)]) + '\n'


@pytest.mark.parametrize('name, file, change, told', [
    ('other', 'trace.csv', renamed, 'a and other have no output in common'),
    ('degrees', 'units.csv', lambda text: text.replace('rad,', 'deg,', 1),
     "theta is in 'rad' in a, and in 'deg' in degrees"),
    ('odd', 'trace.csv', stretched, 'they have no time in common but the start')])
def test_runs_that_cannot_be_compared(isochron, runs, name, file, change, told):
    changed(runs, name, file, change)
    done = isochron('compare', 'a', name)
    assert done.status == 1 and told in done.errors


@pytest.mark.parametrize('words, told', [
    (('compare', 'a'), 'compare needs RUN RUN'), (('compare', 'a', 'absent'), 'there is no run absent'),
    (('run', PENDULUM, '--keep', '../a'), '--keep ../a is no NAME'),
                                         (('plot', PENDULUM, '--keep', 'a'), '--keep has no effect on plot')])
def test_refused(isochron, runs, words, told):
    done = isochron(*words)
    assert done.status == 1 and told in done.errors
