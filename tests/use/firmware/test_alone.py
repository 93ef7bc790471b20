"""A plant beside other firmware, by what its scene says of the loop and by what it is called. Each policy is refused with its
place, with and without --name; what is accepted compiles alone in an empty folder, by gcc and by clang, and moves bit for bit
as with isochron run, also where there are two. A name is refused, or hides nothing: names of the headers of three compilers,
keywords, headers of core, and words that the generated code itself begins with."""
import os
import re
import shutil

import pytest

from harness.plants import NUMERICS
from harness.programs import path_of, run
from harness.project import ROOT

MODELS = ROOT / 'models'
STRICT = ['-std=c11', *'-Wall -Wextra -Wpedantic -Werror'.split(), *NUMERICS]
SCENES = {'pendulum': 1, 'dc_motor_bench': 0.1}     # a second, and a tenth: 1000 ticks
TEXTS = {name: (MODELS / f'{name}.scene').read_text() for name in SCENES}
NAMED = [], ['--name', 'swing']
POLICIES = ((1, 'overrun catch_up 3'), (1, 'overrun stop'), (1, 'overrun degrade { method euler; after 9 ticks }'),
            (1, 'overrun degrade { hold; after 9 ticks }'), (7, 'grace 10 ticks'), (1, 'publish next_tick'), (1, 'histogram'))
SANITIZED = ['-fsanitize=undefined', '-fno-sanitize-recover=all']


def moves(made, compiler, named):
    """The hashes of each instance of a folder that compiles alone."""
    shutil.copy(ROOT / 'tests/use/firmware/alone.c', made.folder)
    shutil.copy(ROOT / 'core/runtime/hash.h', made.folder)
    sources = [path.name for path in made.folder.glob('*.c')]
    done = run(compiler, *STRICT, '-O1', *(['-DNAMED'] if named else []), '-I.', *sources, '-o', 'alone', cwd=made.folder)
    assert done.status == 0, done.errors
    return run('./alone', cwd=made.folder).printed.split()


@pytest.mark.parametrize('name', SCENES)
def test_alone_and_twice_with_a_name_it_moves_as_with_isochron_run(isochron, isoc, name):
    """Control: a plant with sub-steps, which moves otherwise."""
    of = isochron('run', MODELS / f'{name}.scene', '--seconds', SCENES[name])
    assert of.said['ticks'] == '1000'
    for compiler in ('gcc', 'clang'):
        for named in NAMED:
            hashes = moves(isoc(TEXTS[name], '--standalone', *named), compiler, named)
            assert hashes == [of.said['hash']] * (2 if named else 1), (compiler, named)
    other = moves(isoc(f'{TEXTS[name]}\nsubsteps 2\n', '--standalone', *NAMED[1]), 'gcc', True)
    assert len(other) == 2 and of.said['hash'] not in other


@pytest.mark.parametrize('named', NAMED)
@pytest.mark.parametrize('name', SCENES)
def test_what_the_defaults_say_adds_no_byte(isoc, name, named):
    def files(text):
        folder = isoc(text, '--standalone', *named).folder
        return {path.relative_to(folder): path.read_bytes() for path in folder.rglob('*') if path.is_file()}

    assert files(f'{TEXTS[name]}\n') == files(f'{TEXTS[name]}\noverrun count; publish at_once\n')


@pytest.mark.parametrize('named', NAMED)
@pytest.mark.parametrize('name', SCENES)
@pytest.mark.parametrize('column, line', POLICIES)
def test_a_policy_is_refused_with_its_place(isoc, name, named, column, line):
    of = isoc(f'{TEXTS[name]}{line}\n', '--standalone', *named)
    place = f'plant.scene:{TEXTS[name].count(chr(10)) + 1}:{column}: error: '
    assert of.status == 1 and not of.folder.exists()
    assert re.search(f'{place}.*--standalone', of.errors)


def test_two_policies_are_two_errors_and_refused_with_name_alone(isoc):
    text = TEXTS['pendulum'] + 'histogram\npublish next_tick\n'
    assert isoc(text, '--standalone').errors.count(': error: ') == 2
    of = isoc(text, '--name', 'swing')
    assert of.status == 1 and not of.folder.exists()


@pytest.fixture(scope='module')
def taken(program):
    """taken(words): those that isoc takes as names, by the function that says so."""
    names = program('tests/use/firmware/names.c', 'tools/isoc/emit/prefix.c', 'tools/isoc/base/arena.c',
                    ROOT / 'build/obj/tools/isoc/core_files.o', by='gcc', real='double')
    return lambda words: run(names, given='\n'.join(words) + '\n').printed.split()


@pytest.fixture
def all_refused(isoc, taken):
    """Whether each of these words is refused as a name; the first of them by isoc itself, and nothing is written."""
    def check(words):
        of = isoc(MODELS / 'pendulum.scene', '--name', words[0])
        return of.status == 1 and '--name' in of.errors.splitlines()[0] and not of.folder.exists() and taken(words) == []

    return check


C_HEADERS = '''assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg stdatomic
    stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype'''.split()


def headers_of(compiler, folder):
    """What the headers of C need, of this compiler, as far as a file beside the program could hide it."""
    text = ''.join(f'#if __has_include(<{name}.h>)\n#include <{name}.h>\n#endif\n' for name in C_HEADERS)
    said = run(compiler, '-xc', '-E', '-v', '-', given='\n').errors
    listed = re.search('^#include <.*\n((?: .*\n)*)', said, re.M)[1]
    roots = {os.path.realpath(place) for place in listed.split()}
    paths = re.findall(r'\S+\.h(?=\s|\\|$)', run(compiler, '-M', '-MG', path_of(text, folder, 'c.c')).printed)
    real = {os.path.realpath(path) for path in paths}
    return {os.path.basename(path)[:-2] for path in real if os.path.dirname(path) in roots}


def test_names_of_headers_are_refused(all_refused, tmp_path):
    """Of those that gcc, clang and the board's compiler read for those of C, among them those that others include; and of
    core."""
    found = set(C_HEADERS).union(*(headers_of(compiler, tmp_path) for compiler in ('gcc', 'clang', 'arm-none-eabi-gcc')))
    words = sorted(word for word in found if re.fullmatch('[a-z][a-z0-9_]*', word))
    assert len(words) > 33 and 'features' in words and all_refused(words)
    core = [path.stem for folder in ('numbers', 'methods') for path in sorted((ROOT / 'core' / folder).glob('*.h'))]
    assert all_refused([*core, 'plant', 'tick'])


def test_keywords_are_refused(all_refused, tmp_path):
    """A word is a keyword where it cannot be the name of a variable, of gcc or clang++."""
    text = (ROOT / 'tools/isoc/emit/prefix.c').read_text()
    words = sorted(set(re.findall(r'(?<![A-Za-z0-9_])[a-z][a-z0-9_]*[a-z0-9](?![A-Za-z0-9_])', text)))
    path = path_of(''.join(f'int {word};\n' for word in words), tmp_path, 'word.c')
    said = run('gcc', '-std=c11', '-fsyntax-only', path).errors + run(
        'clang++', '-std=c++20', '-ferror-limit=0', '-xc++', '-fsyntax-only', path).errors
    keywords = [words[int(line) - 1] for line in sorted(set(re.findall(r'word\.c:(\d+):.*error: ', said)), key=int)]
    assert len(keywords) > 80 and all_refused(keywords)


def test_other_words_are_refused(all_refused):
    assert all_refused(['main', 'cart_', 'a__b', 'iso', 'isolated'])


USER = '#include "core/runtime/tick.h"\n#include <stdio.h>\n#include <stdlib.h>\nint main(void) { return 0; }\n'


def test_words_that_the_generated_code_begins_with_are_good_names(isoc, taken):
    scene = MODELS / 'cart_pole_drive.scene'
    made = isoc(scene, '--name', 'swing')
    found = set(re.findall(r'\b([a-z][a-z0-9]*)_', made.file('swing.c') + made.file('swing.h')))
    words = taken(sorted(word for word in found if not word.startswith(('iso', 'swing'))))
    assert words
    for word in words:
        folder = isoc(scene, '--name', word, '--standalone').folder
        path_of(f'#include "{word}.h"\n{USER}', folder, 'user.c')
        done = run('clang', *STRICT, '-fsyntax-only', '-I.', f'{word}.c', 'user.c', cwd=folder)
        assert done.status == 0, done.errors


TURNS = '''#include "swing.h"
#include "core/runtime/tick.h"
int main(void)
{
    static swing_memory memory;
    const iso_plant swing = swing_plant(&memory);
    iso_plant_start(&swing);
    memory.turns[0] = INT32_MAX - 1;
    for (uint32_t tick = 0; tick < 100; tick++) {
        if (iso_plant_tick(&swing, tick) < SWING_STATES) {
            return 1;
        }
    }
    return !(memory.turns[0] < INT32_MIN + 8 && memory.turns[0] > INT32_MIN && swing.y[SWING_Y_TURNED] < (real)-2e9);
}
'''


@pytest.mark.parametrize('planted', (False, True))
def test_turns_go_on_behind_the_largest_count(isoc, planted):
    """In a plant that a sanitizer watches. Control: a count that overflows."""
    text = re.sub('^    start.*\n', '', TEXTS['pendulum'], flags=re.M)
    text = re.sub('^    axis z.*', r'\g<0>; continuous; speed 3000 rpm', text, flags=re.M) + 'output turned = turns of pivot\n'
    folder = isoc(text, '--name', 'swing', '--standalone').folder
    path_of(TURNS, folder, 'turns.c')
    if planted:
        source = (folder / 'swing.c').read_text()
        assert 'iso_counted_turns(memory->turns[0], ' in source
        path_of(source.replace('iso_counted_turns(memory->turns[0], ', '(memory->turns[0] + '), folder, 'swing.c')
    done = run('gcc', *STRICT, *SANITIZED, '-I.', *(path.name for path in folder.glob('*.c')), '-o', 'turns', cwd=folder)
    assert done.status == 0, done.errors
    done = run('./turns', cwd=folder)
    assert 'signed integer overflow' in done.errors if planted else done.status == 0
