"""isoc itself, and plants in this process, whose rows are arrays of numpy.

A plant is compiled once for all that it is made of: build/tests/bench keeps it under the hash of its text, of core and
of the compiler's arguments. Workers share it: a file gets its name when it is whole.
"""
import functools
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import types

import numpy as np
import pytest

from harness import project
from harness.project import ROOT, TOOLS, make

sys.path.insert(0, str(ROOT / 'tools'))
from lab import rig  # noqa: E402

KEPT = ROOT / 'build/tests/bench'
NUMERICS = (ROOT / 'tools/build/numerics').read_text().split()
# The flags of the host tests: warnings are errors (tests/host/test.sh).
STRICT = ('-Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes -Wmissing-prototypes '
          '-Wvla -Werror -O2').split() + NUMERICS
COMPILERS = {
    'tcc': ['tcc', '-include', str(ROOT / 'tools/lab/tcc.h')],
    'gcc': ['gcc', *STRICT, '-fPIC'],
    'clang': ['clang', *STRICT, '-fPIC'],
}


@pytest.fixture(autouse=True, scope='session')
def at_the_root():
    os.chdir(ROOT)


class Made(types.SimpleNamespace):
    """What isoc made of a scene: its status, what it printed and what it said, and its files."""

    @functools.cached_property
    def summary(self):
        return dict(line.split(' ', 1) for line in self.printed.splitlines() if ' ' in line)

    @functools.cached_property
    def chosen(self):
        """What isoc chose and printed, `stable slow.lag 0.000718 s`, by name."""
        return {name: float(value) for name, value in re.findall(r'^stable (\S+) (\S+)', self.printed, re.M)}

    @property
    def refused(self):
        return self.status == 1 and not (self.folder / 'plant.c').exists()

    def file(self, name):
        return (self.folder / name).read_text()

    def files(self):
        return {path.name: path.read_text() for path in self.folder.iterdir() if path.is_file()}


class Requests:
    """One process that has all calls of isoc (tests/host/requests.c); `starter` is what runs it, such as valgrind."""

    def __init__(self, make_folder, starter=()):
        self.place, self.calls = make_folder('isoc'), 0
        self.process = subprocess.Popen([*starter, ROOT / 'build/tests/requests'], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def ask(self, *words):
        """The status of isoc with these words: where its output goes, where its messages, and its arguments."""
        self.process.stdin.write(b''.join(os.fsencode(str(word)) + b'\0' for word in words) + b'\n')
        self.process.stdin.flush()
        return int(self.process.stdout.readline())

    def __call__(self, scene, *options, writes=True, folder=None):
        self.calls += 1
        place = self.place / f'{self.calls}'
        place.mkdir()
        folder = folder or place / 'made'
        if not isinstance(scene, pathlib.Path):
            scene, text = place / 'plant.scene', scene
            scene.write_bytes(text if isinstance(text, bytes) else text.encode())
        status = self.ask(place / 'printed', place / 'said', scene, *options, *(['-o', folder] if writes else []))
        return Made(status=status, printed=(place / 'printed').read_text(), errors=(place / 'said').read_text(errors='replace'),
                    folder=folder, scene=scene)

    def end(self):
        self.process.stdin.close()
        self.process.wait()


@pytest.fixture(scope='session')
def isoc(tmp_path_factory):
    """isoc(scene, *options): what isoc makes of the text of a scene, or of a Path, in a new folder or in `folder`."""
    make(*TOOLS)
    project.make(*project.TOOLS)
    process = Requests(tmp_path_factory.mktemp)
    yield process
    process.end()


@functools.cache
def core():
    """A hash of all that a plant is compiled with."""
    files = sorted((ROOT / 'core').rglob('*.[ch]')) + [ROOT / 'tools/lab/rig.c']
    return hashlib.sha256(b''.join(file.read_bytes() for file in files)).hexdigest()


def compiled(compiler, files, source, *arguments, kind):
    """The file that the compiler makes of `source`, one of these files of isoc or one of the project, kept by content."""
    command = COMPILERS[compiler] + ['-std=c11', *arguments]
    key = hashlib.sha256(repr((core(), command, sorted(files.items()), str(source))).encode()).hexdigest()[:24]
    kept = KEPT / key / ('made' + kind)
    if not kept.exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            (kept.parent / name).parent.mkdir(parents=True, exist_ok=True)
            (kept.parent / name).write_text(text)
        whole = kept.with_suffix(f'.{os.getpid()}')
        subprocess.run(command + ['-I', kept.parent, '-I', ROOT, kept.parent / source, '-o', whole], check=True)
        whole.rename(kept)
    return kept


class Named:
    """Columns of an array by name: `shaft_speed`; and three as one, `place` of place_x, place_y and place_z."""

    def __init__(self, array, places):
        self.array, self.places = array, places

    def __getitem__(self, name):
        place = self.places.get(name)
        return self.array[..., [self.places[f'{name}_{axis}'] for axis in 'xyz'] if place is None else place]

    def __getattr__(self, name):
        return self[name]


class Plant(rig.Plant):
    """A plant in this process, and what isoc made of its scene. `ulp` is the epsilon of its numbers; places['x'] has the
    places of the states by name, and so for inputs and memories u, tunables p and outputs y."""

    def __init__(self, library, made):
        super().__init__(library)
        self.made = made
        self.ulp = float(np.finfo(self.number).eps)
        self.places = {kind: {} for kind in 'xupy'}
        for kind, name, place in re.findall(r'^    PLANT_([XUPY])_(\w+)(?: = (\d+))?,', made.file('plant.h'), re.M):
            of = self.places[kind.lower()]
            of[name.lower()] = int(place) if place else len(of)

    def named(self, rows):
        """Rows by name: .x.shaft_speed is of all rows."""
        return types.SimpleNamespace(rows=rows, **{kind: Named(rows[kind], self.places[kind]) for kind in 'xupy'})

    def _inputs(self, ticks, given):
        """{name: values of each tick, or one} as an array, and which inputs these are."""
        array, which = np.zeros((ticks, self.facts.inputs), self.number), np.zeros(self.facts.inputs, bool)
        for name, values in given.items():
            place = self.places['u'][name]
            array[:, place], which[place] = values, True
        return array, which

    def follow(self, ticks, given=None, sets=None, tunables=None, whole=True):
        """The rows of a run from the start, by name. `given`: inputs by name, one value or one for each tick, the others
        are those of the scene; `sets`: tunables and faults that are set in rows, {tick: {name: value}}."""
        array, which = self._inputs(ticks, given or {})
        sets, rows = sets or {}, []
        self.start(tunables)
        stops = sorted({0, ticks, *sets})
        for begin, end in zip(stops, stops[1:]):
            for name, value in sets.get(begin, {}).items():
                self.now['p'][0, self.places['p'][name]] = value
            part, ended = self.go(end - begin, 1, array[begin:end], begin, which)
            assert ended == end - begin or not whole, f'the guard ended it at tick {begin + ended}'
            rows.append(part if end == ticks else part[:-1])
        # As bytes: numpy packs the fields of structures that it joins.
        return self.named(np.concatenate([part.view(f'V{self.facts.bytes}') for part in rows]).view(self.row))

    def outputs(self, ticks, every=1, **of_run):
        """The outputs of a run by name, and all of them as `rows`."""
        rows = self.run(ticks, every, **of_run)['y']
        return types.SimpleNamespace(rows=rows, **{name.replace('.', '_'): rows[:, i]
                                                   for i, name in enumerate(self.names)})


@pytest.fixture(scope='session')
def plant(isoc):
    """plant(scene, *options, real=, by=, change=, core=): the plant of a scene, by a compiler of COMPILERS; `change` plants a
    defect in the text of plant.c, `core` in those of files of core: {path: change}."""

    def load(scene, *options, real='double', by='tcc', change=None, core=None):
        made = isoc(scene, *options, '--real', real)
        assert made.status == 0, made.errors
        files = made.files()
        if change:
            sound, files['plant.c'] = files['plant.c'], change(files['plant.c'])
            assert files['plant.c'] != sound, 'nothing was planted'
        for path, other in (core or {}).items():
            files[path] = other((ROOT / path).read_text())
        double = ['-DISO_REAL_DOUBLE'] if real == 'double' else []
        library = compiled(by, files, ROOT / 'tools/lab/rig.c', '-shared', *double, kind='.so')
        return Plant(library, made)

    return load


def replaced(pattern, by, text):
    """re.sub that must change something."""
    changed = re.sub(pattern, by, text, flags=re.M)
    assert changed != text, pattern
    return changed


def other_effect(kind, pattern, by):
    """The definition of an effect of the library, in which a text is another one."""
    return replaced(pattern, by, (ROOT / f'models/effects/{kind}.scene').read_text())
