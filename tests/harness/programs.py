"""Programs of C on this machine, and a wire between a plant and its controller.

What is compiled here runs for less time than a compiler optimises, so it is compiled by tcc: that changes no bit
(promises/same_bits.t), and what gcc and clang warn of other tests see (check/warnings.t).
"""
import contextlib
import importlib.util
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile

import pytest

from harness import project
from harness.plants import COMPILERS, Made
from harness.project import ROOT
from harness.tap import PATIENCE, STARTERS, Results
from lab import build

# What a plant's program has beside it: without a link, and with one.
LOOP = 'core/numbers/*.c core/runtime/*.c core/application/stream.c port/host/*.c port/unix/console.c'.split()
LINKED = [*LOOP, 'core/link/*.c', 'port/unix/channel.c', 'port/unix/datagrams.c']
REPORT = 'tests/host/report.c'


class Done:
    """What a program printed, its errors and its status. `said` has the rest of a line by its first word."""

    def __init__(self, status, printed, errors):
        self.status, self.printed, self.errors = status, printed, errors
        self.said = dict(line.split(' ', 1) for line in printed.splitlines() if ' ' in line)

    def finds(self, words=''):
        """Whether, of a program that prints TAP, a result with these words failed, by the program's own judgement."""
        results = Results(self.printed, self.status)
        return results.whole and any(line.startswith('not ok') and words in line for line in results.lines)


def run(*command, cwd=ROOT, given=None, **environment):
    """A command, with these variables in its environment, and with `given` as its input."""
    done = subprocess.run(list(map(str, command)), cwd=cwd, env={**os.environ, **environment}, input=given, text=True,
                          errors='replace', capture_output=True, timeout=PATIENCE, **({} if given else {'stdin': subprocess.DEVNULL}))
    return Done(done.returncode, done.stdout, done.stderr)


def traced(folder, *command, **environment):
    """The summary of a run by tools/trace, which writes its table into a folder."""
    folder.mkdir(exist_ok=True)
    return run(ROOT / 'build/trace', '-o', folder, '--', *command, **environment)


@pytest.fixture
def proves(record_property):
    """proves(command or Done): each result of a program that prints TAP is one of this test, and all are right."""
    passed = 0

    def check(*command):
        nonlocal passed
        done = command[0] if isinstance(command[0], Done) else run(*command)
        results = Results(done.printed, done.status)
        passed += results.passed
        record_property('tap', (passed, 0, 0))
        assert not results.failed, results.reason() + done.errors[-1000:]
        return done

    return check


def compiles(*command):
    """A compiler, which must find nothing wrong."""
    done = run(*command)
    assert done.status == 0, done.errors


@pytest.fixture(scope='session')
def program(tmp_path_factory):
    """program(source, ..., real=, by=, level=, target=, flags=, planted=): the path of the program. A source is a pattern of paths
    from the root, a path, or what isoc made, whose headers are found too. `planted` has a defect for each file of the
    project that is changed, a source or what sources include: a text of it and the one in its place, or a dict of such."""
    project.make(*project.TOOLS)
    objects = {}

    def changed(path, edits, tree):
        text = (ROOT / path).read_text()
        for old, new in (edits.items() if isinstance(edits, dict) else [edits]):
            assert old in text, f'{path} has no {old}'
            text = text.replace(old, new)
        (tree / path).parent.mkdir(parents=True, exist_ok=True)
        (tree / path).write_text(text)
        return tree / path

    def make(*sources, real='float', by='tcc', level='-O0', target=None, flags=(), link=(), planted=None, name='program'):
        folder = tmp_path_factory.mktemp(name)
        copies = {ROOT / path: changed(path, edits, folder / 'tree') for path, edits in (planted or {}).items()}
        made = [source.folder for source in sources if isinstance(source, Made)]
        files = [file for source in sources for file in
                 (source.folder.glob('*.c') if isinstance(source, Made) else
                  sorted(ROOT.glob(source)) if isinstance(source, str) else [source])]
        assert len(files) >= len(sources), sources
        first = [] if set(copies) <= set(files) else ['-I', folder / 'tree']
        then = ['-I', ROOT, *(word for place in made for word in ('-I', place)), *(['-Wno-error'] if copies else []), *flags]
        files = [copies.get(file, file) for file in files]
        if target:
            port = build.port(target, real)
            words, linker, libraries = [*port.compile[:1], *first, *port.compile[1:], *then], port.link, port.libraries.split()
        else:
            words = [level if word == '-O2' else word for word in COMPILERS[by]] + [
                '-std=c11', *first, *then, *(['-DISO_REAL_DOUBLE'] if real == 'double' else [])]
            linker, libraries = [by], ['-lm']
        if by != 'tcc' or target:
            files = [file if file.suffix == '.o' else compiled(tuple(map(str, words)), file) for file in files]
            words = linker
        compiles(*words, *link, *files, '-o', folder / name, *libraries)
        return folder / name

    def compiled(words, file):
        """The object, which other programs may share."""
        if (words, file) not in objects:
            objects[words, file] = tmp_path_factory.getbasetemp() / f'{len(objects)}.o'
            compiles(*words, '-c', file, '-o', objects[words, file])
        return objects[words, file]

    return make


def on_board(program):
    """The command of a firmware on a Cortex-M4F in QEMU that writes to its console."""
    return [*STARTERS['m4f'], program]


def client_of(folder):
    """The module of the controller's end that isoc wrote into this folder."""
    path, = folder.glob('*_link.py')
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    is_written, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    spec.loader.exec_module(module)
    sys.dont_write_bytecode = is_written
    return module


class Started:
    """A process whose output is in files, so that it never waits for a reader."""

    def __init__(self, command, environment, wire):
        self.files = [tempfile.TemporaryFile() for _ in range(2)]
        self.process = subprocess.Popen([str(word) for word in command], env={**os.environ, **environment}, stdin=subprocess.DEVNULL,
                                        stdout=self.files[0], stderr=self.files[1], cwd=ROOT, pass_fds=[wire.fileno()])

    def done(self):
        status = self.process.wait(PATIENCE)
        texts = []
        for file in self.files:
            file.seek(0)
            texts.append(file.read().decode(errors='replace'))
            file.close()
        return Done(status, *texts)


class Wire:
    """The controller's end of a wire; `plant` is a Done when the plant has ended."""

    def __init__(self, end):
        self.socket, self.plant = end, None

    @property
    def address(self):
        """Of a descriptor that its user closes."""
        return f'fd:{os.dup(self.socket.fileno())}'


@contextlib.contextmanager
def plant_at(*command, is_endless=True, **environment):
    """A plant that runs at the other end of the Wire that this gives. One that is endless is ended behind this, any other
    one ends by itself. QEMU is told of the descriptor in its command, where ports say 3 (port/mps2/board.mk)."""
    ours, its = socket.socketpair()
    words = [re.sub(r'\bfd=3\b', f'fd={its.fileno()}', str(word)) for word in command]
    started = Started(words, {'ISOCHRON_CONTROLLER': f'fd:{its.fileno()}', **environment}, its)
    wire = Wire(ours)
    try:
        if not is_endless:      # such a plant ends when its controller has gone
            its.close()
        yield wire
    except BaseException:
        started.process.kill()
        raise
    finally:
        if is_endless:
            started.process.terminate()
        ours.close()
        its.close()
        wire.plant = started.done()
        if is_endless and wire.plant.status == -signal.SIGTERM:
            wire.plant.status = 0


def controlled(wire, command, **environment):
    """A controller, a command, at this end of a wire: a Done."""
    return Started(command, {'ISOCHRON_LINK': f'fd:{wire.fileno()}', **environment}, wire).done()


def linked_on_board(scene):
    """The command of the program of a scene with its link on a Cortex-M4F in QEMU, without an end, and its environment."""
    bench = build.plant(scene, kind='linked', target='cortex-m4f', isoc=['--link'])
    command = bench.port.exec.replace(',arg="$NANOSECONDS"', '')
    return ['sh', '-c', f'exec {command}'], {'FROM': f'{ROOT}/', 'PROGRAM': str(bench.program.absolute())}


def path_of(text, folder, name):
    """A file with this text."""
    path = pathlib.Path(folder) / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


HASH_START, HASH_PRIME = 0xCBF29CE484222325, 0x100000001B3


def hash_of(rows, digest=HASH_START):
    """The hash of a trajectory, rows of states: Fowler, Noll and Vo's FNV-1a in 64 bits over their bytes
    (core/runtime/hash.h)."""
    for byte in rows.tobytes():
        digest = (digest ^ byte) * HASH_PRIME & 0xFFFFFFFFFFFFFFFF
    return f'{digest:016x}'
