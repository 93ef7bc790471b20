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
# What a test follows from, beside its folder and SHARED, if it does not say; those of tests/check from all sources.
SOURCES = 'core port models tools Makefile'.split()
SHARED = ('tests/host tests/harness tests/conftest.py .pytest.ini '
          'tools/lab/rig.c tools/lab/rig.py tools/lab/tcc.h tests/tap.c tests/tap.h').split()
# isoc is what its sources are compiled to: their comments are of no test. What it holds of core for what it exports, a
# test follows from anyhow.
ISOC, OBJECTS = 'tools/isoc/', 'build/obj/tools/isoc'
# The header of a method is followed from where a file beside the test names the method, or rk4, which scenes have, or
# other rooms of core include it; all are where one beside the test has such a word.
METHODS = 'core/methods/'
ALL_METHODS = {'methods', 'METHODS', 'oscillator', 'handwritten'}


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
def method_headers():
    """Of each method the headers that a plant with it includes, of those that other plants do not; all.h of none."""
    def included(*paths):
        return {name for path in paths if path.exists()
                for name in re.findall(r'^#include "core/methods/(\w+\.h)"', path.read_text(), flags=re.M)}

    methods = ROOT / METHODS
    others = [path for path in (ROOT / 'core').rglob('*.[ch]') if path.parent != methods and path.name != 'handwritten.h']
    of = {name: [name] for name in included(methods / 'all.h')}
    of['everywhere.h'] = ['rk4.h', *(included(*others) & of.keys())]
    for headers in of.values():
        for header in headers:
            headers += [other for other in included(methods / header) if other in of and other not in headers]
    return {'': {METHODS + 'all.h'}} | {name.removesuffix('.h'): {METHODS + header for header in headers}
                                        for name, headers in of.items()}


@functools.cache
def words_beside(folder, test):
    """The words of a test, and of all beside it that is no other test; constants of methods as their names."""
    files = [file for file in folder.iterdir() if file.is_file() and file.suffix in ('.c', '.h', '.py', '.scene', '.sh', '.txt')]
    words = set()
    for file in [test] + [file for file in files if not file.name.startswith('test_')]:
        words.update(re.findall(r'\w+', file.read_text(errors='replace')))
    return words | {word.lower().removeprefix('iso_') for word in words if word.startswith('ISO_')}


@functools.cache
def not_followed(test):
    """Of SOURCES the headers of methods that nothing beside the test names."""
    words, headers = words_beside(test.parent, test), method_headers()
    if words & ALL_METHODS:
        return frozenset()
    return frozenset().union(*headers.values()).difference(*(of for name, of in headers.items() if name in words | {'everywhere'}))


@functools.cache
def sources(less):
    """A hash of SOURCES without these files, and with the objects of isoc for its text."""
    objects = [(name, file) for name, file in files_in(OBJECTS) if name.endswith('.o') and not name.endswith('/core_files.o')]
    return state_of([objects] + [(name, file) for place in SOURCES for name, file in files_in(place)
                                 if name not in less and not (objects and name.startswith(ISOC) and name.endswith(('.c', '.h')))])


@functools.cache
def state_of_test(test):
    """A hash of what a script or a test in Python follows from: its folder, what all tests share, the files of Markdown that
    it names, and SOURCES, or what a line `# Depends on: ` at its head says."""
    text = test.read_text()
    said = re.search(r'^# Depends on: (.*)$', text[:3000], flags=re.M)
    places = [str(test.parent.relative_to(ROOT)), *SHARED]
    places += sorted(name for name in set(re.findall(r'[\w/]+\.md\b', text)) if (ROOT / name).is_file())
    if said or test.parent == ROOT / 'tests/check':
        return state_of([files_in(place) for place in places + (said[1].split() if said else SOURCES + ['tests'])])
    return state_of([files_in(place) for place in places] + [sources(not_followed(test))])


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
