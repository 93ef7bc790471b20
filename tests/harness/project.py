"""The project, and what stands in build/ of it."""
import functools
import hashlib
import os
import pathlib
import re
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / 'build/tests'
MACHINE = ('cc gcc g++ clang arm-none-eabi-gcc riscv64-unknown-elf-gcc avr-gcc tcc ld qemu-system-arm qemu-system-riscv32 '
         'simavr node valgrind clang-format cppcheck gnuplot dot make sh awk sed python3').split()
# What `make` builds before a test of plants or of commands is run.
TOOLS = ('tools', 'build/tests/requests', 'build/simavr_trace', 'build/regions.tsv')
# What a test follows from, beside its folder and SHARED, if it does not say; those of tests/check from all tests too.
SOURCES = 'core port models tools Makefile'.split()
SHARED = ('tests/host tests/harness tests/conftest.py .pytest.ini '
          'tools/lab/rig.c tools/lab/rig.py tools/lab/tcc.h tests/tap.c tests/tap.h').split()


@functools.cache
def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


@functools.cache
def files_in(place):
    """The files of a folder, by name and content; a file itself; all that fit a pattern such as *.md."""
    path = ROOT / place
    if '*' in place:
        found = ROOT.rglob(place)
    else:
        found = path.rglob('*') if path.is_dir() else [path]
    return sorted((str(file.relative_to(ROOT)), digest(file)) for file in found
                  if file.is_file() and '__pycache__' not in file.parts
                  and not ('*' in place and file.is_relative_to(ROOT / 'build'))
                  and (file.suffix != '.md' or '*' in place or file == path))


@functools.cache
def state_of_test(test):
    """A hash of what a script or a test in Python follows from: its folder, what all tests share, the files of Markdown that
    it names, and SOURCES, or what a line `# Depends on: ` at its head says."""
    text = test.read_text()
    said = re.search(r'^# Depends on: (.*)$', text[:3000], flags=re.M)
    places = [str(test.parent.relative_to(ROOT)), *SHARED]
    places += sorted(name for name in set(re.findall(r'[\w/]+\.md\b', text)) if (ROOT / name).is_file())
    places += said[1].split() if said else SOURCES + (['tests'] if test.parent == ROOT / 'tests/check' else [])
    return state_of([files_in(place) for place in places])


@functools.cache
def machine():
    """What a result follows from besides: the tools of the machine, the compilers behind ccache among them, and the variables
    that the tests know."""
    path = ':'.join(place for place in os.environ['PATH'].split(':') if not place.endswith('/ccache'))
    tools = [(tool, os.stat(found).st_size, os.stat(found).st_mtime) for tool in MACHINE if (found := shutil.which(tool, path=path))]
    return repr((tools, [os.environ.get(name) for name in ('CC', 'CFLAGS', 'TEST_WHOLE', 'TEST_TURN')]))


def state_of(held):
    """A hash of these files."""
    return hashlib.sha256(repr((machine(), held)).encode()).hexdigest()


def turn(parts, test=None):
    """Which of so many parts of a long test is tried this time, from 0: it follows from what the test, by default that which
    runs, follows from, so that over commits each part has its turn. TEST_TURN names it; None is all, with TEST_WHOLE."""
    if os.environ.get('TEST_WHOLE'):
        return None
    return int(os.environ.get('TEST_TURN') or turn_of(test or running())) % parts


def running():
    """The test that runs."""
    return ROOT / os.environ['PYTEST_CURRENT_TEST'].split('::')[0]


def turn_of(test):
    return int(state_of_test(test)[:8], 16)


@functools.cache
def make(*goals):
    """What has changed is built before a test that is run by itself; `make test` has built all, and says so in TEST_BUILT."""
    if not os.environ.get('TEST_BUILT'):
        subprocess.run(['flock', 'build/lock', 'make', '-s', *goals], cwd=ROOT, check=True,
                       env={name: value for name, value in os.environ.items() if not name.startswith('MAKE')})
