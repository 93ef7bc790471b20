"""Functions in the formulas of a scene: their values, their bits on the board, and that they are not there where nobody calls them."""
import pathlib
import re
import subprocess

import numpy as np
import pytest
from harness.plants import STRICT, replaced
from harness.project import ROOT

PLACE = ROOT / 'tests/isoc/formula/functions/all.scene'
SCENE = PLACE.read_text()
TABLE = (PLACE.parent / 'table.scene').read_text()
SUMS = 21  # the outputs from here on are sums of 1 and the result


def grid(q, v, width):
    """Bilinear in the cell of q and v."""
    columns, rows, cells = np.array([-0.5, 0.25, 1]), np.array([-1, 0, 2.5]), [[0, 1, 0.5], [width, 2, -1], [1, 0, 3]]
    lines = np.stack([np.interp(q, columns, row) for row in cells])
    j = np.where(v < 0, 0, 1)
    b = np.clip((v - rows[j]) / (rows[j + 1] - rows[j]), 0, 1)
    at = np.arange(len(q))
    return (1 - b) * lines[j, at] + b * lines[j + 1, at]


def expected(q, v):
    """What each output is; q and v are those that the plant had, and the arguments are computed in its real, as it does."""
    real = q.dtype.type
    width, third = real(0.4), real(0.3)
    shifted, half = q * q + width, real(0.5) * q
    root = np.sqrt((real(1) - half) * (real(1) + half))
    d = {name: value.astype(float) for name, value in dict(q=q, v=v, shifted=shifted, half=half, root=root).items()}
    arguments = [10 * q, real(3) * v, np.clip(q, real(-0.2), width), np.minimum(np.minimum(q, v), third), np.maximum(np.maximum(q, v), -third)]
    tens, three, within, least, most = (a.astype(float) for a in arguments)
    left = (q - third * np.floor((q / third).astype(float)).astype(real)).astype(float)
    return np.stack([
        d['q'], d['v'], np.sqrt(d['shifted']), np.exp(d['v']), np.log(d['shifted']), np.tanh(three), np.arctan2(d['q'], d['v']),
        np.arctan2(d['half'], d['root']), np.arctan2(d['root'], -d['half']), np.sign(d['v']), np.floor(tens), np.rint(tens), within, least, most,
        np.abs(d['v']), q < v, q <= v, q > v, q >= v, np.where(q * v > 0, q, real(2) * v).astype(float), np.sin(d['q']) + np.tan(d['q']),
        np.maximum(d['q'], 0) + np.minimum(d['v'], 0), np.interp(d['q'], [-0.5, 0, 0.25, 1], [-1, 0.25, float(width), 2.5]),
        grid(d['q'], d['v'], float(width)), d['shifted']**float(real(0.7)), d['shifted']**-2, np.arctan(d['v']), np.hypot(d['q'], d['v']), left], 1)


def off(p):
    """How far each output is off the host's libm, in ulp."""
    y = p.follow(5000).rows['y']
    want = expected(y[:, 0], y[:, 1])
    assert y[:, 1].min() < 0 < y[:, 1].max() and len(want.T) == y.shape[1]
    scale = np.abs(want) + (np.arange(y.shape[1]) >= SUMS) + 1e-30
    return (np.abs(y.astype(float) - want) / scale).max(0) / p.ulp


@pytest.mark.parametrize('real', ['float', 'double'])
def test_each_function_is_within_its_bound(plant, real):
    """core/numbers: 4 ulp of the result, for those that are sums of 1 and the result."""
    assert (off(plant(SCENE, real=real)) <= 4).all()


@pytest.mark.parametrize('words, other, place', [('max(q, v, -0.3)', 'min(q, v, -0.3)', 14), ('tanh(3 * v)', 'tanh(3.00001 * v)', 5),
                                                 ('floor(10 * q)', 'round(10 * q)', 10)])
def test_a_wrong_function_is_found(plant, words, other, place):
    assert np.flatnonzero(off(plant(SCENE.replace(f'= {words}', f'= {other}'))) > 4).tolist() == [place]


def test_the_board_has_the_same_bits_and_one_number_of_instructions(isochron):
    host, board = (isochron('run', PLACE, '--seconds', '5', '--real', 'float', '--target', target).said for target in ('host', 'cortex-m4f'))
    assert host['hash'] == board['hash'] and board['instructions_per_step'].isdigit()


@pytest.mark.parametrize('compiler', ['gcc', 'clang'])
def test_no_branch_depends_on_what_the_memory_holds(isoc, tmp_path, compiler):
    """The step and the outputs with all of the plant's memory undefined, under memcheck."""
    made = isoc(SCENE)
    (tmp_path / 'cases.c').write_text('#include <stddef.h>\n#include "tests/promises/poison.h"\n'
                                      'const poison_case poison_cases[] = {{"all", &iso_the_plant}, {NULL, NULL}};\n')
    subprocess.run([compiler, '-std=c11', *STRICT, '-I', ROOT, '-I', made.folder, tmp_path / 'cases.c', ROOT / 'tests/promises/poison.c',
                    made.folder / 'plant.c', '-lm', '-o', tmp_path / 'program'], check=True)
    done = subprocess.run(['valgrind', '--quiet', tmp_path / 'program'], capture_output=True, text=True)
    results = re.findall('^(not ok|ok)', done.stdout, re.M)
    assert done.returncode == 0 and results and set(results) == {'ok'}, done.stdout + done.stderr


def test_a_plant_with_every_function_compiles_alone(isoc, tmp_path):
    folder = isoc(SCENE, '--name', 'alone', '--standalone').folder
    subprocess.run(['cc', '-std=c11', '-O2', '-I', folder, '-c', folder / 'alone.c', '-o', tmp_path / 'o'], check=True)


def ends(p):
    """Whether tables have their values at and between their places, behind an end the value there, and of a NaN a NaN, or that at an end."""
    largest = np.finfo(p.number).max
    p.start()
    places = [-1, 0.5, 2, -largest, largest, -np.inf, np.inf, np.nan, -np.nan]
    rows = np.repeat(p.now, len(places))
    x = rows['x'].copy()
    x[:, p.places['x']['j']] = places
    y = p.outputs_at(rows, x)
    first, last = [8, 2], [-3, 9]
    is_nan = np.isnan(y[7:]) | (y[7:] == first) | (y[7:] == last)
    return np.array_equal(y[:7], [first, [4.5, 6], last, first, last, first, last]) and is_nan.all()


@pytest.mark.parametrize('real', ['float', 'double'])
def test_tables_end_at_their_places(plant, real):
    assert ends(plant(TABLE, real=real))
    assert not ends(plant(TABLE, real=real, change=lambda text: replaced(r'iso_min\((.*), R\(1\.0\)\)', r'(\1)', text))), 'found: one without an end'


@pytest.mark.parametrize('word', ['exp', 'log', 'tanh', 'sqrt'])
def test_a_plant_includes_the_files_of_the_functions_that_it_calls(isoc, word):
    pendulum = pathlib.Path('models/pendulum.scene').read_text()
    assert not re.search(r'exp|log|tanh|numbers/angle|iso_angle|iso_atan2|pieces|sqrt', isoc(pendulum).file('plant.c'))
    one = isoc(replaced('^output rate.*', f'output rate = {word}(2 + speed of pivot / (1 rad/s))', pendulum))
    assert re.findall('numbers/(exp|log|tanh|angle|pieces|sqrt)', one.file('plant.c')) == [word]
