"""How plants grow with their size: the time and the memory of isoc, the time of gcc, the length of functions; and
functions that are cut compute what those of small plants do."""
import itertools
import math
import os
import pathlib
import re
import subprocess

import numpy as np
import pytest

from harness.plants import STRICT

ISOC = pathlib.Path('build/isoc')
BEGIN = 'gravity (0, -9.81, 0) m/s^2\nstep 1 ms\nmethod rk4\n'
END = 'output energy = energy\n'
ROD = '''body rod{0} {{ mass 1 kg; com (0, -0.5, 0) m; inertia (85, 0.05, 85) g*m^2 }}
joint j{0} revolute {{ parent {1}; child rod{0}; axis z; start {2} deg }}
'''
STOP = 'effect end{0} stop {{ along j{0}; lower -1 rad; upper 1 rad; impact 1 rad/s }}\n'
POINT = 'output p{0} = position of rod{1} at (0, {2}, 0) m\n'
TUNED = '''tunable m{0} = {1} kg
body b{0} {{ mass m{0}; com (0, -1, 0) m; inertia (1, 1, 1) kg*m^2 }}
joint j{0} revolute {{ parent ground; child b{0}; axis z; start 10 deg }}
'''
DRIVEN = '''input u{0} N*m = {1} N*m * sin({1} Hz)
body b{0} {{ mass 1 kg; com (0, -1, 0) m }}
joint j{0} revolute {{ parent ground; child b{0}; axis z; start 10 deg; drive u{0} }}
'''


def of_each(text, count, *more):
    return ''.join(text.format(i, *(f(i) for f in more)) for i in range(1, count + 1))


def rods(count):
    return of_each(ROD, count, lambda i: f'rod{i - 1} at (0, -1, 0) m' if i > 1 else 'ground', lambda i: 90 if i == 1 else 0)


def some(i):
    return 1 + i % 7


SCENES = {
    'chain': lambda n: BEGIN + rods(n) + END,
    'stops': lambda n: BEGIN + rods(n) + of_each(STOP, n) + END,
    'tunables': lambda n: BEGIN + of_each(TUNED, n, some) + END,
    'inputs': lambda n: BEGIN + of_each(DRIVEN, n, some) + END,
    'outputs': lambda n: BEGIN + rods(4) + of_each(POINT, n, lambda i: 1 + i % 4, lambda i: -0.001 * i),
    'windows': lambda n: pathlib.Path('models/n_four_bar.scene').read_text().replace('windows = 2', f'windows = {n}'),
}
LINEAR = [kind for kind in SCENES if kind != 'windows']


def seconds(*command):
    """The processor's time of a run, of which others on the machine take little. It is counted in ticks of some
    milliseconds: so a short one is run again, until all took 0.2 s."""
    total, runs = 0, 0
    while total < 0.2:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = status
        assert status == 0, command
        total += used.ru_utime
        runs += 1
    return total / runs


def exponent(sizes, times):
    return np.polyfit(np.log(sizes), np.log(times), 1)[0]


def make(kind, size, folder):
    scene = folder / f'{kind}_{size}.scene'
    scene.write_text(SCENES[kind](size))
    return ISOC, scene, '-o', folder / f'{kind}_{size}', '--real', 'double'


def exponent_of_isoc(kind, sizes, folder):
    return exponent(sizes, [seconds(*make(kind, size, folder)) for size in sizes])


# A growth that is linear but for logarithms, with what a process takes to start: if the time of
# an end is off by a third, the power is off by 0.1.
LIMIT = 1.2
SIZES = [64, 256, 1024]


@pytest.mark.seeds(5, 2)
def test_time_of_isoc_is_linear(seed, tmp_path):
    """Of three measurements the least: programs beside it take from a large one more of the cache than from a small one."""
    kind, found = LINEAR[seed - 1], LIMIT + 1
    for _ in range(3):
        if found > LIMIT:
            found = min(found, exponent_of_isoc(kind, SIZES, tmp_path))
    assert found <= LIMIT, f'{kind}: the power {found:.2f} of the size'


def test_control_time_of_isoc_for_loops_grows_faster(tmp_path):
    """The closures of a row of windows are solved together."""
    assert exponent_of_isoc('windows', [16, 64], tmp_path) > LIMIT


def exponent_of_gcc(kind, sizes, folder):
    def compiled(size):
        command = make(kind, size, folder)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return ('gcc', '-std=c11', *STRICT, '-DISO_REAL_DOUBLE', '-I.', '-c', command[3] / 'plant.c', '-o', folder / 'o')
    alone = seconds(*compiled(1))  # core's headers, and the method
    return exponent(sizes, [seconds(*compiled(size)) - alone for size in sizes])


@pytest.mark.seeds(2, 1)
def test_time_of_gcc_is_linear(seed, tmp_path):
    """With one function for all outputs, and for the energy, it is the power 1.55 and 1.58."""
    kind, sizes = [('outputs', [128, 1024]), ('chain', [64, 256])][seed % 2]
    found = exponent_of_gcc(kind, sizes, tmp_path)
    assert found <= LIMIT, f'{kind}: the power {found:.2f} of the size'


@pytest.mark.seeds(2, 1)
def test_time_of_gcc_is_linear_over_four_doublings(seed, tmp_path):
    """Between them it grows faster up to the size from which functions are cut, and slower behind."""
    kind, sizes = [('tunables', [64, 1024]), ('stops', [32, 512])][seed % 2]
    found = exponent_of_gcc(kind, sizes, tmp_path)
    assert found <= LIMIT, f'{kind}: the power {found:.2f} of the size'


def functions(text):
    """The lines of each function by its name, but for sines that it is handed."""
    found = re.findall(r'^[^\n/* #].*?(\w+)\((?:[^{};]*)\)\n\{\n(.*?)^\}$', text, flags=re.M | re.S)
    return {name: len([line for line in body.splitlines()
                       if line and '/*' not in line and not line.startswith('    const iso_sine_cosine ')])
            for name, body in found}


# Statements, with some lines that are broken, and the values that they read (tools/isoc/emit/statements.c); more of
# those that stand in an order of their own.
LONGEST, LONGEST_IN_ORDER = 1300, 3300


@pytest.mark.parametrize('kind', SCENES)
def test_functions_of_large_plants_are_cut(isoc, kind):
    made = isoc(SCENES[kind](64 if kind == 'windows' else 1000), '--real', 'double')
    lines = functions(made.file('plant.c'))
    assert {'step', 'finish'} <= lines.keys()
    for name, count in lines.items():
        most = LONGEST_IN_ORDER if re.fullmatch('(held_)?derivative(_by_sines)?', name) else LONGEST
        assert count <= most, f'{name} has {count} lines'
    # Control: what belongs together is longer than that.
    def whole(name):
        return re.sub(r'_\d+$', '', name)
    assert max(sum(lines[name] for name in parts)
               for _, parts in itertools.groupby(sorted(lines, key=whole), whole)) > LONGEST


@pytest.mark.parametrize('kind, kilobytes', [('chain', 150_000), ('stops', 220_000)])
def test_memory_of_isoc_for_1000_links(kind, kilobytes, tmp_path):
    """It takes 105 and 160 MB: a dense mass matrix of nodes would be ten times as much."""
    def within(limit):
        return subprocess.run(['sh', '-c', 'ulimit -v "$0" && exec "$@"', str(limit), *make(kind, 1000, tmp_path)],
                              capture_output=True).returncode == 0
    assert within(kilobytes)
    assert not within(kilobytes // 3), 'control: a third is not enough'


def test_outputs_in_parts_are_those_of_small_plants(plant):
    """One plant with 800 outputs, three numbers each, against eight with 100."""
    lines = SCENES['outputs'](800).splitlines(keepends=True)
    others = [line for line in lines if not line.startswith('output')]
    outputs = [line for line in lines if line.startswith('output')]
    whole = plant(''.join(lines))
    assert 'output_prepared_2(' in whole.made.file('plant.c')
    small = [plant(''.join(others + outputs[i:i + 100])) for i in range(0, 800, 100)]
    rows = whole.outputs(20).rows
    assert np.array_equal(rows, np.hstack([one.outputs(20).rows for one in small]))
    assert len(np.unique(rows[-1])) > 1000


@pytest.mark.parametrize('kind, cut, value', [('tunables', 'tune_2(', 'p'), ('inputs', 'drive_2(', 'u')])
def test_joints_in_parts_move_as_those_of_a_small_plant(plant, kind, cut, value):
    whole, part = plant(SCENES[kind](1260)), plant(SCENES[kind](140))
    assert cut in whole.made.file('plant.c') and cut not in part.made.file('plant.c')
    rows, others = whole.run(20), part.run(20)
    assert np.array_equal(rows['x'], np.hstack([others['x'][:, :140]] * 9 + [others['x'][:, 140:]] * 9))
    assert np.array_equal(rows[value], np.hstack([others[value]] * 9))
    assert len(np.unique(others['x'][-1])) >= 7


def test_control_a_part_that_carries_another_value_is_found(plant):
    scene = SCENES['outputs'](800)
    swapped = re.compile(r'(?<= = v\[)(\d+)(?=\];\n)')
    numbers = itertools.count()
    broken = plant(scene, change=lambda text: swapped.sub(lambda m: '0' if next(numbers) == 5 else m[1], text))
    assert not np.array_equal(plant(scene).outputs(20).rows, broken.outputs(20).rows)


def test_a_plant_too_large_for_the_check_of_stability_says_so(isoc):
    line = 'stability not checked'
    assert line in isoc(SCENES['chain'](40)).printed
    assert line not in isoc(SCENES['chain'](30)).printed
    assert line not in isoc(SCENES['chain'](40), '--method', 'adams', '--tolerance', '1e-6').printed
