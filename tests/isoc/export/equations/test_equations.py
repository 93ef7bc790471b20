"""What `isoc --equations` writes, as text, gives the accelerations, corrections, memories, outputs and functions of time of the plant, to a
bound of the rounding (compare.py): all models and ten random scenes, in double. As LaTeX it says the same equations, with other names one
to one, and all that it opens it closes."""
import pathlib
import re
import subprocess
import sys

import pytest
import reading
from compare import check_same, check_values, points_of, turned_signs
from harness.programs import run

MODELS = sorted(pathlib.Path('models').glob('*.scene'))
FOUR_BAR = pathlib.Path('models/four_bar.scene')


def calls(text):
    """The calls of what plant.c has for corrections, and for the next values of memories."""
    held = 'tune(h, p->p), ' * bool(re.search(r'^static void tune\(', text, re.M)) + 'hold(h, p->u), ' * bool(re.search(r'^static void hold\(', text, re.M))
    settle, line = '', re.search(r'^static void settle\(.*', text, re.M)
    if line:
        parts = ['p->x'] + ['p->u'] * bool(re.search(r'const u[,)]', line[0])) + ['p->p'] * bool(re.search(r'const p[,)]', line[0]))
        parts += ['kept'] * ('pivots' in line[0]) + [f'kept_at(p, {f"({held}h)" if held else "p->p"})'] * ('sines' in line[0])
        settle = f'settle({", ".join(parts)})'
    nexts = re.search(r'^static void (follow|advance)\(', text, re.M)
    return [f'-DSETTLE={settle}', f'-DNEXTS={nexts[1] + "(p->memory)" if nexts else ""}']


def documents(isoc, scene):
    return [isoc(scene, '--equations', style, '--real', 'double', writes=False).printed for style in ('text', 'latex')]


@pytest.fixture(scope='module')
def points(isoc, program):
    """points(scene): what its plant computes at three points."""
    def call(scene):
        made = isoc(scene, '--real', 'double')
        values = program('tests/isoc/export/equations/values.c', real='double', flags=[f'-DPLANT="{made.folder}/plant.c"', *calls(made.file('plant.c'))])
        return points_of(run(values, 3, 1).printed)

    return call


def judgement(text, latex, points):
    """How many numbers are compared and off, and what is wrong with the LaTeX beside the text."""
    read = reading.text(text)
    tally = check_values(*read, points)
    return tally.compared, tally.off, check_same(*read, latex)


def try_scene(isoc, points, scene):
    compared, off, other = judgement(*documents(isoc, scene), points(scene))
    assert compared > 0 and off == [] and other == '', (off[:3], other)


@pytest.mark.parametrize('path', MODELS, ids=lambda path: path.stem)
def test_the_equations_of_a_model_give_the_numbers_of_its_plant(isoc, points, path):
    try_scene(isoc, points, path)


@pytest.mark.seeds(10)
def test_so_do_those_of_random_scenes(isoc, points, seed):
    try_scene(isoc, points, subprocess.run([sys.executable, 'tests/promises/random/write_scene.py', str(seed)], capture_output=True, text=True, check=True).stdout)


def test_each_sign_that_is_turned_is_found_by_the_numbers_and_beside_the_latex(isoc, points):
    """Each between two terms of the derivatives of a closed loop."""
    (text, latex), known = documents(isoc, FOUR_BAR), points(FOUR_BAR)
    turned = list(turned_signs(text))
    assert turned and all(off and other for _, off, other in (judgement(changed, latex, known) for changed in turned))


@pytest.mark.parametrize('pattern, by, words', [
    (r'\}\$\\par', r'$\\par', 'something is open'), (r'= t_\{1\} ', '= t_{2} ', 'another equation of'),
    (r'^\$.displaystyle.*\n', '', 'more or fewer equations')])
def test_a_changed_latex_is_refused(isoc, points, pattern, by, words):
    text, latex = documents(isoc, FOUR_BAR)
    planted = re.sub(pattern, by, latex, count=1, flags=re.M)
    assert planted != latex
    _, off, other = judgement(text, planted, points(FOUR_BAR))
    assert off == [] and other.startswith(words)


def test_another_form_and_a_folder_in_the_place_of_a_file_are_refused(isoc, tmp_path):
    pendulum = pathlib.Path('models/pendulum.scene')
    assert 'must be text or latex, not html' in isoc(pendulum, '--equations', 'html', writes=False).errors
    assert 'directory' in isoc(pendulum, '--equations', 'text', folder=tmp_path).errors


def test_standard_output_has_what_a_file_has(isoc, tmp_path):
    isoc(FOUR_BAR, '--equations', 'latex', '--real', 'double', folder=tmp_path / 'file')
    assert (tmp_path / 'file').read_text() == documents(isoc, FOUR_BAR)[1]
