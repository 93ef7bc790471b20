"""Bad scenes and bad command lines: what isoc says of each, to the letter, and that it leaves its output alone; a third of them, by turns,
under memcheck.

bad.txt: `== NAME`, then either the scene itself or lines `edit: OLD -> NEW` on the scene good.scene, or on the one that a line `of: SCENE`
names (each OLD stands in it once; \\0, \\n, \\t, \\\\ and \\xHH are read as in C), then lines `> LINE:COLUMN: MESSAGE`, the errors in their
order; a scene without one is to be accepted."""
import math
import os
import pathlib
import re
import subprocess

import pytest
from harness import project
from harness.plants import Requests

HERE = pathlib.Path('tests/isoc/scene')
CASES = [case.split('\n') for case in re.split('^== ', (HERE / 'bad.txt').read_text(), flags=re.M)[1:]]
BASE = {path.stem: path.read_text() for path in HERE.glob('*.scene')}
GOOD = HERE / 'good.scene'


def unescaped(text):
    return re.sub(r'\\(x[0-9A-F]{2}|.)', lambda m: chr(int(m[1][1:], 16)) if len(m[1]) > 1 else {'n': '\n', 't': '\t', '0': '\0'}.get(m[1], m[1]), text)


def scene_of(lines):
    edits = [re.match('edit: (.*?) -> (.*)', line).groups() for line in lines if line.startswith('edit: ')]
    base = next((line[4:] for line in lines if line.startswith('of: ')), 'good')
    scene = BASE[base] if edits else ''.join(f'{line}\n' for line in lines if not line.startswith('> ')).rstrip('\n') + '\n'
    for old, new in (map(unescaped, edit) for edit in edits):
        assert scene.count(old) == 1, f"'{old}' stands {scene.count(old)} times in {base}.scene"
        scene = scene.replace(old, new)
    return scene.encode('latin1')


def told(made):
    """The errors, `LINE:COLUMN: MESSAGE`."""
    return [f'{place or "-"}: {said}' for place, said in re.findall(rf'^{re.escape(str(made.scene))}:(?:(\d+:\d+):)? error: (.*)', made.errors, re.M)]


@pytest.fixture(scope='module')
def place(tmp_path_factory):
    """A folder with the plant of before."""
    folder = tmp_path_factory.mktemp('before')
    for name in ('plant.c', 'plant.h'):
        (folder / name).write_text('as before')
    return folder


def is_as_before(place):
    return (place / 'plant.c').read_text() == (place / 'plant.h').read_text() == 'as before'


def refuse(isoc, place, scene, errors):
    made = isoc(scene, folder=place)
    assert told(made) == errors
    assert made.status == 1 and made.printed == '' and is_as_before(place)


def accept(isoc, scene, *options):
    """Without a word."""
    made = isoc(scene, *options)
    assert made.status == 0 and made.errors == '' and (made.folder / 'plant.c').exists(), made.errors[:500]
    return made


def try_case(isoc, place, case):
    errors = [line[2:] for line in case if line.startswith('> ')]
    if errors:
        refuse(isoc, place, scene_of(case[1:]), errors)
    else:
        accept(isoc, scene_of(case[1:]))


@pytest.mark.parametrize('case', CASES, ids=lambda case: case[0])
def test_a_bad_scene_gets_its_errors_and_touches_nothing(isoc, place, case):
    try_case(isoc, place, case)


NOTHING = [f'1:1: {said}' for said in (
    'nothing moves: the scene has neither a joint that is not fixed nor an effect with a state',
    'the scene has no output: output angle = position of a joint', 'the scene has no step: step 1 ms')]


def try_sizes(isoc, place, many, is_quick):
    """Scenes that are no text of a sensible size; what is long and not deep is compiled."""
    refuse(isoc, place, '', NOTHING)
    if is_quick:
        refuse(isoc, place, 'step 1 ms ' + '@' * 10_000_000,
               ["1:11: unexpected character '@'"] + [said.replace('1:1:', '1:10000011:') for said in NOTHING[:2]])
    assert 'a name of 1000000 characters: at most 64 are allowed' in isoc('body ' + 'b' * 1_000_000).errors
    for sign in ('(', '-', 'f(', '-('):
        made = isoc('step ' + sign * 100_000)
        assert made.status == 1 and re.match(r'\S+:1:\d+: error: parentheses and signs nested more than 100 deep', made.errors)
    accept(isoc, BASE['good'].replace('mass 1 kg', 'mass 1 kg + ' + ' + '.join(f'{i} ug' for i in range(1, many + 1))))
    chain = ''.join(f'constant k{i} = k{i + 1} + 1 ug\n' for i in range(1, many)) + f'constant k{many} = 1 ug\n'
    accept(isoc, chain + BASE['good'].replace('mass 1 kg', 'mass 1 kg + k1'))
    refuse(isoc, place, chain.replace('= 1 ug', '= k2000') + BASE['good'], [f"{many}:{14 + len(str(many))}: 'k2000' depends on itself"])
    accept(isoc, BASE['good'] + ''.join(f'output push{i} = force of pivot along x\n' for i in range(200)))
    made = isoc(bytes((i * 7919 + (i >> 3) * 104729) % 256 for i in range(1, 100_001)))
    assert made.status == 1 and len(made.errors.splitlines()) < 200, '100 kB of noise gets a page of errors at most'


def test_scenes_of_no_sensible_size_are_refused_and_long_ones_compiled(isoc, place):
    try_sizes(isoc, place, 30_000, True)


def test_what_is_no_file_is_told(isoc, place, tmp_path):
    refuse(isoc, place, tmp_path, ['-: a directory, not a scene: name a .scene file in it'])
    refuse(isoc, place, pathlib.Path('/dev/zero'), ['-: not a regular file: a scene is a text file'])
    os.mkfifo(tmp_path / 'fifo.scene')
    refuse(isoc, place, tmp_path / 'fifo.scene', ['-: not a regular file: a scene is a text file'])
    refuse(isoc, place, tmp_path / 'absent.scene', ['-: No such file or directory'])
    lines = isoc(BASE['good'].replace('kg', 'kgg', 1)).errors.splitlines()
    assert lines[1:3] == ['        mass 1 kgg', '               ^'], 'the line and a caret under the word'


@pytest.mark.parametrize('what, before, at, line', [
    ('tunable parameters', 3, '65539:9', 'tunable k{} = 1'), ('inputs and memories', 5, '65540:7', 'input u{} = 1 N*m'),
    ('outputs', 21, '65557:8', 'output y{} = position of pivot'),
    ('states', 12, '32780:7', 'joint j{} revolute {{ parent ground; child bob; axis z }}')])
def test_more_than_a_plant_counts_in_16_bits_is_refused_where_it_begins(isoc, what, before, at, line):
    scene = BASE['good'].splitlines(keepends=True)
    made = isoc(''.join(scene[:before] + [line.format(i) + '\n' for i in range(1, 65_536)] + scene[before:]))
    assert made.status == 1
    assert re.findall(r':(\d+:\d+): error: too many (.*): a plant has at most 65535$', made.errors, re.M) == [(at, what)]


# --- good ones ---


@pytest.mark.parametrize('name', ['loop', 'closed', 'good'])
def test_the_scenes_that_all_cases_are_made_from_are_good(isoc, name):
    accept(isoc, HERE / f'{name}.scene')


def assembled(made):
    return {name: float(value) for name, value in re.findall(r'^assembled (\w+) (\S+) rad(?:/s)?$', made.printed, re.M)}


def test_where_closures_put_what_has_no_start_is_told_and_closes_the_loop(isoc):
    """The pin's two sides meet, and move alike."""
    at = assembled(isoc(HERE / 'loop.scene'))
    coupler = math.pi / 2 + at['elbow']
    gaps = [0.26 * math.cos(coupler) - 0.39 - 0.25 * math.cos(at['foot']), 0.1 + 0.26 * math.sin(coupler) - 0.25 * math.sin(at['foot']),
            -0.1 - 0.26 * math.sin(coupler) * (1 + at['elbow_speed']) + 0.25 * math.sin(at['foot']) * at['foot_speed'],
            0.26 * math.cos(coupler) * (1 + at['elbow_speed']) - 0.25 * math.cos(at['foot']) * at['foot_speed']]
    assert len(at) == 4 and max(map(abs, gaps)) < 1e-8
    assert 'assembled' not in isoc(GOOD).printed


def test_a_start_that_is_found_gives_the_constants_that_it_gives_if_it_is_given(isoc):
    found = BASE['loop'] + 'stabilisation lagrangian\n'
    at = assembled(isoc(HERE / 'loop.scene'))
    given = re.sub(r'(elbow|foot)( revolute \{)', lambda m: f'{m[1]}{m[2]} start {at[m[1]]} rad; speed {at[m[1] + "_speed"]} rad/s;', found)
    constants = [list(map(float, re.findall(r'\bR\(([^)]*)\)', isoc(scene, '--real', 'double').file('plant.c')))) for scene in (found, given)]
    assert len(constants[0]) > 20 and constants[1] == pytest.approx(constants[0], rel=1e-7, abs=0)


def test_a_rough_start_says_in_which_of_two_ways_a_loop_closes(isoc):
    """They are mirrored at the line from the knee to the foot."""
    knee, diagonal = math.atan2(0.1, -0.39), math.hypot(0.39, 0.1)
    half = math.acos((diagonal**2 + 0.25**2 - 0.26**2) / (2 * diagonal * 0.25))
    for start, wanted in ((60, knee - half), (200, knee + half)):
        made = isoc(BASE['loop'].replace('foot revolute {', f'foot revolute {{ start about {start} deg;'))
        assert abs(assembled(made)['foot'] - wanted) < 1e-8


def test_a_double_holds_what_a_float_cannot(isoc):
    ratio = BASE['loop'].replace('rocker { mass 1 kg', 'rocker { mass 4294967296 kg') + 'close drive motion { first shaft; speed 1 rad/s }'
    assert isoc(ratio, '--real', 'double').status == 0
    accept(isoc, BASE['good'].replace('10 deg', '1e-46 rad; speed 1e39 rad/s'), '--real', 'double')


def test_the_same_scene_gives_the_same_bytes_in_another_folder_too(isoc, tmp_path):
    assert isoc(GOOD).files() == isoc(GOOD, folder=tmp_path / 'deeper/folder').files()


def test_names_that_are_long_together_compile(isoc, tmp_path):
    """More than 4095 characters, which a compiler need not take in one string."""
    made = accept(isoc, BASE['good'] + ''.join(f'output {"a" * 50}_{i} = position of bob\n' for i in range(1, 81)))
    subprocess.run(['cc', '-std=c11', '-Wall', '-Wextra', '-Wpedantic', '-Werror', '-Woverlength-strings', '-I', project.ROOT, '-c',
                    made.folder / 'plant.c', '-o', tmp_path / 'o'], check=True)


# --- the command line ---

METHODS = 'euler, heun, rk4, ab4, semi_implicit, abm4, abm4_pec, abm4_pecece, bdf4, rosenbrock or adams'
LINES = [
    ('--method rk5', f"--method:1:1: error: no method is called 'rk5' (did you mean 'rk4'?); take {METHODS}"),
    (['--step', '1 kg'], '--step:1:1: error: the step is in s; this is in kg'),
    (['--step', '-1 ms'], '--step:1:1: error: the step must be between 1 us and 1 s'),
    (['--step', '1 ms method rk4'], "--step:1:6: error: unknown unit 'method'"),
    ('--real half', 'isoc: error: --real must be float or double, not half'), ('--fast', 'isoc: error: unknown option --fast'),
    ('--fmu --fmi 1', 'isoc: error: --fmi must be 2 or 3, not 1'),
    ('--fmi 2', 'isoc: error: --fmi is the version of the standard of an FMU: add --fmu to --fmi 2'),
    ('--step', 'isoc: error: a value is missing after --step'), ('-o FOLDER', 'isoc: error: given twice: -o'),
    ('--dot', 'isoc: error: --dot makes no plant: leave out -o FOLDER'), ('other.scene', 'isoc: error: more than one scene: other.scene')]


@pytest.mark.parametrize('words, message', LINES)
def test_a_bad_command_line_is_told(isoc, place, words, message):
    words = [str(place) if word == 'FOLDER' else word for word in (words.split() if isinstance(words, str) else words)]
    said = place / 'said'
    status = isoc.ask('/dev/null', said, GOOD, '-o', place, *words)
    assert status == 1 and said.read_text().splitlines()[0] == message.replace('FOLDER', str(place)) and is_as_before(place)


def test_an_output_that_cannot_be_is_told(isoc, place):
    assert 'no folder for the plant' in isoc(GOOD, writes=False).errors
    assert 'Not a directory' in isoc(GOOD, folder=place / 'plant.c/below').errors
    for words in (['--help'], ['--methods'], [GOOD, '-o', place / 'made'], [GOOD, '--dot']):
        assert isoc.ask('/dev/full', place / 'said', *words) == 1
        assert (place / 'said').read_text() == 'isoc: error: standard output: No space left on device\n'


def test_the_command_line_overrides_the_scene(isoc):
    assert re.search(r'^method ab4\nstep 0\.0005 s\nreal double\nstates 2\n', isoc(GOOD, '--step', '500us', '--method', 'ab4', '--real', 'double').printed, re.M)


# --- memcheck ---


@pytest.fixture(scope='module')
def watched(tmp_path_factory):
    """isoc under memcheck, which ends with 99 where there is an error or a leak."""
    process = Requests(tmp_path_factory.mktemp, 'valgrind --quiet --leak-check=full --show-leak-kinds=all --errors-for-leak-kinds=all'.split())
    yield process
    process.end()


def test_memcheck_finds_what_is_planted_and_nothing_where_nothing_is(watched, place):
    assert [watched.ask(place / 'out', place / 'said', 'planted', what) for what in ('leak', 'branch', 'nothing')] == [99, 99, 0]


def test_memcheck_finds_nothing_in_a_third_of_the_bad_scenes(watched, place):
    turn = project.turn(3)
    for n, case in enumerate(CASES):
        if turn is None or n % 3 == turn:
            try_case(watched, place, case)
    try_sizes(watched, place, 3_000, turn in (None, 0))
    for name in ('loop', 'closed', 'good', 'effect', 'events'):
        accept(watched, HERE / f'{name}.scene')
