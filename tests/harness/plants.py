"""isoc itself, and plants in this process, whose rows are arrays of numpy.

A plant is compiled once for all that it is made of: build/tests/bench keeps it under the hash of its text, of core and
of the compiler's arguments. Workers share it: a file gets its name when it is whole.
"""
import ctypes
import functools
import hashlib
import os
import pathlib
import re
import subprocess
import types

import numpy as np
import pytest

from harness.project import ROOT

KEPT = ROOT / 'build/tests/bench'
# The flags of the host tests: warnings are errors (tests/host/test.sh).
STRICT = ('-Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes -Wmissing-prototypes '
          '-Wvla -Werror -O2 -ffp-contract=off -fno-math-errno -fno-tree-vectorize -fno-tree-slp-vectorize').split()
COMPILERS = {
    'tcc': ['tcc', '-include', str(ROOT / 'tests/host/tcc.h')],
    'gcc': ['gcc', *STRICT, '-fPIC'],
    'clang': ['clang', *STRICT, '-fPIC'],
}
NUMBERS = {'float': np.float32, 'double': np.float64}


@pytest.fixture(autouse=True, scope='session')
def at_the_root():
    os.chdir(ROOT)


class Made(types.SimpleNamespace):
    """What isoc made of a scene: its status, what it printed and what it said, and its files."""

    @functools.cached_property
    def summary(self):
        return dict(line.split(' ', 1) for line in self.printed.splitlines() if ' ' in line)

    @property
    def refused(self):
        return self.status == 1 and not (self.folder / 'plant.c').exists()

    def file(self, name):
        return (self.folder / name).read_text()

    def files(self):
        return {path.name: path.read_text() for path in self.folder.iterdir() if path.is_file()}


@pytest.fixture(scope='session')
def isoc(tmp_path_factory):
    """isoc(scene, *options): what isoc makes of the text of a scene, or of a Path. One process has all calls
    (tests/host/requests.c)."""
    process = subprocess.Popen([ROOT / 'build/tests/requests'], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def call(scene, *options, writes=True):
        place = tmp_path_factory.mktemp('isoc')
        if not isinstance(scene, pathlib.Path):
            scene, text = place / 'plant.scene', scene
            scene.write_text(text)
        words = [place / 'printed', place / 'said', scene, *options] + (['-o', place / 'made'] if writes else [])
        process.stdin.write(b''.join(os.fsencode(str(word)) + b'\0' for word in words) + b'\n')
        process.stdin.flush()
        status = int(process.stdout.readline())
        return Made(status=status, printed=(place / 'printed').read_text(), errors=(place / 'said').read_text(),
                    folder=place / 'made')

    yield call
    process.stdin.close()
    process.wait()


@functools.cache
def core():
    """A hash of all that a plant is compiled with."""
    files = sorted((ROOT / 'core').rglob('*.[ch]')) + [ROOT / 'tests/bench.c']
    return hashlib.sha256(b''.join(file.read_bytes() for file in files)).hexdigest()


def compiled(compiler, files, source, *arguments, kind):
    """The file that the compiler makes of `source`, one of these files of isoc or one of the project, kept by content."""
    command = COMPILERS[compiler] + ['-std=c11', '-I', str(ROOT), *arguments]
    key = hashlib.sha256(repr((core(), command, sorted(files.items()), str(source))).encode()).hexdigest()[:24]
    kept = KEPT / key / ('made' + kind)
    if not kept.exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            (kept.parent / name).write_text(text)
        whole = kept.with_suffix(f'.{os.getpid()}')
        subprocess.run(command + ['-I', kept.parent, kept.parent / source, '-o', whole], check=True)
        whole.rename(kept)
    return kept


class Bench(ctypes.Structure):
    """The struct `bench` of tests/bench.c."""
    _fields_ = [(name, ctypes.c_uint32) for name in
                'states inputs outputs parameters memories bytes x u p y'.split()] + [
                    ('step', ctypes.c_double), ('output_names', ctypes.c_char_p)]


class Plant:
    """A plant in this process. A row is all that it keeps: rows['x'], ['u'], ['p'] and ['y'] are arrays of all rows;
    behind the inputs u has the memories."""

    def __init__(self, library, made, number):
        self.made, self.library, self.number = made, ctypes.CDLL(str(library)), number
        self.library.bench_run.restype = ctypes.c_uint64
        self.library.bench_open()
        self.facts = facts = Bench.in_dll(self.library, 'bench')
        self.step_size, self.states = facts.step, facts.states
        self.names = facts.output_names.decode().split(',')
        # The first field covers all bytes of a row: numpy copies what stands in a field.
        fields = [('memory', f'V{facts.bytes}', 0)] + [
            (name, (number, (size,)), place) for name, size, place in (
                ('x', facts.states, facts.x), ('u', facts.inputs + facts.memories, facts.u),
                ('p', facts.parameters, facts.p), ('y', facts.outputs, facts.y))]
        names, formats, offsets = map(list, zip(*fields))
        self.row = np.dtype({'names': names, 'formats': formats, 'offsets': offsets, 'itemsize': facts.bytes})

    def _array(self, values):
        return None if values is None else np.ascontiguousarray(values, self.number).ctypes

    def run(self, ticks, every=1, tunables=None, given=None, whole=True, first=0):
        """The rows of a run from the start, that behind the last tick too. `given`: the inputs of each tick; `first`: the
        number of the first. A guard that ends the run is a failure, but with whole=False: then the rows up to there."""
        rows = np.zeros(ticks // every + 1, self.row)
        ended = self.library.bench_run(*map(ctypes.c_uint64, (first, ticks, every)), self._array(tunables),
                                       self._array(given), rows.ctypes)
        assert ended == ticks or not whole, f'the guard ended it at tick {ended}'
        return rows[:ended // every + 1]

    def outputs(self, ticks, every=1, **of_run):
        """The outputs of a run by name, and all of them as `rows`."""
        rows = self.run(ticks, every, **of_run)['y']
        return types.SimpleNamespace(rows=rows, **{name.replace('.', '_'): rows[:, i]
                                                   for i, name in enumerate(self.names)})

    def outputs_at(self, rows, x, slopes=None):
        """The outputs of these rows with other states."""
        rows = rows.copy()
        rows['x'] = x
        self.library.bench_look(rows.ctypes, ctypes.c_size_t(len(rows)), None if slopes is None else slopes.ctypes)
        return rows['y']

    def slopes_at(self, rows, x):
        """The derivatives of these rows with other states, and the outputs."""
        slopes = np.zeros((len(rows), self.states), self.number)
        return slopes, self.outputs_at(rows, x, slopes)

    def stepped(self, rows):
        """These rows a step later."""
        rows = rows.copy()
        self.library.bench_step(rows.ctypes, ctypes.c_size_t(len(rows)))
        return rows


@pytest.fixture(scope='session')
def plant(isoc):
    """plant(scene, *options, real=, by=, change=): the plant of a scene, by a compiler of COMPILERS; `change` plants a
    defect in the text of plant.c."""

    def load(scene, *options, real='double', by='tcc', change=None):
        made = isoc(scene, *options, '--real', real)
        assert made.status == 0, made.errors
        files = made.files()
        if change:
            sound, files['plant.c'] = files['plant.c'], change(files['plant.c'])
            assert files['plant.c'] != sound, 'nothing was planted'
        double = ['-DISO_REAL_DOUBLE'] if real == 'double' else []
        library = compiled(by, files, ROOT / 'tests/bench.c', '-shared', '-DPLANT="plant.c"', *double, kind='.so')
        return Plant(library, made, NUMBERS[real])

    return load


def replaced(pattern, by, text):
    """re.sub that must change something."""
    changed = re.sub(pattern, by, text, flags=re.M)
    assert changed != text, pattern
    return changed
