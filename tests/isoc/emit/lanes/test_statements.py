"""Plants side by side: what a scene says about how it is computed, and each option of isoc, compiles with -DISO_LANES by
gcc and clang, or is refused by its name."""
import pathlib
import re
import subprocess

import pytest

from harness.plants import STRICT, replaced

PENDULUM = pathlib.Path('models/pendulum.scene').read_text()
FOUR_BAR = pathlib.Path('models/four_bar.scene').read_text()
METHODS = 'euler heun rk4 ab4 semi_implicit abm4 abm4_pec abm4_pecece bdf4 rosenbrock'.split()
REFUSED = {
    'histogram': 'histogram', 'grace 10 ticks': 'grace', 'publish next_tick': 'publish next_tick',
    'overrun stop': 'overrun', 'overrun catch_up 3': 'overrun', 'overrun degrade { hold; after 9 ticks }': 'overrun',
    'overrun degrade { method euler; after 9 ticks }': 'overrun',
}
STATEMENTS = ['publish at_once', 'overrun count', 'substeps 2',
              'signal angle = position of pivot; output again = previous(angle)',
              'signal angle = position of pivot; output late = delay(angle, 20 ms)',
              'signal angle = position of pivot; output seldom = sample(angle, every 4 ms)']
EFFECTS = [line.split('|') for line in pathlib.Path('tools/measure/effects.txt').read_text().splitlines()
           if '|' in line and line[0] != '#']


def with_method(method, scene=PENDULUM):
    return re.sub('^method.*', f'method {method}', scene, flags=re.M)


def compiles(made, compiler='gcc', real='float'):
    double = ['-DISO_REAL_DOUBLE'] if real == 'double' else []
    return subprocess.run([compiler, '-std=c11', *STRICT, *double, '-Wno-psabi', '-I.', '-DISO_LANES=8', '-fsyntax-only',
                           made.folder / 'plant.c'], capture_output=True).returncode == 0


def accepted(isoc, scene, *options):
    """Whether what isoc makes of it compiles in lanes, in float by gcc and in double by clang."""
    for real, compiler in (('float', 'gcc'), ('double', 'clang')):
        made = isoc(scene, '--lanes', '--real', real, *options)
        assert made.status == 0, made.errors
        assert compiles(made, compiler, real)


@pytest.mark.parametrize('statement', REFUSED)
def test_a_policy_is_refused_with_its_place_and_the_cure(isoc, statement):
    made = isoc(PENDULUM + statement + '\n', '--lanes')
    line = len(PENDULUM.splitlines()) + 1
    assert made.refused and f'plant.scene:{line}:' in made.errors
    assert f'error: {REFUSED[statement]} is for the loop' in made.errors and 'leave it out' in made.errors
    assert isoc(PENDULUM + statement + '\n').status == 0


@pytest.mark.parametrize('option, text', [
    ('--fmu', '--fmu is for one plant'), ('--link', '--link is for one plant'), ('--python', '--python is for one plant'),
    ('--equations', '--equations makes no plant'), ('--linear', '--linear makes no plant'), ('--mjcf', '--mjcf makes no plant')])
def test_what_makes_no_plants_side_by_side_is_refused(isoc, option, text):
    made = isoc(PENDULUM, '--lanes', option, *(['text'] if option == '--equations' else []), writes=option not in ('--mjcf',))
    assert made.status == 1 and text in made.errors and 'leave out --lanes' in made.errors


@pytest.mark.parametrize('statement', STATEMENTS)
def test_other_statements_compile(isoc, statement):
    accepted(isoc, PENDULUM + statement + '\n')


@pytest.mark.parametrize('effect', EFFECTS, ids=[name.strip() for name, _, _ in EFFECTS])
def test_parts_of_a_scene_compile(isoc, effect):
    _, inside, statements = effect
    accepted(isoc, replaced('^ *axis.*', rf'\g<0>\n{inside}', PENDULUM) + statements + '\n')


@pytest.mark.parametrize('method', METHODS)
def test_methods_compile_with_what_they_can_have(isoc, method):
    options = [('checked yes',), ('compensated yes',), ('substeps 2', 'compensated yes')]
    if method == 'bdf4':
        options.append(('iterations 3', 'checked yes'))
    for lines in options:
        scene = '\n'.join((with_method(method), *lines)) + '\n'
        made = isoc(scene)
        if made.status == 0:
            accepted(isoc, scene)
        else:
            assert 'error:' in made.errors and method in made.errors


@pytest.mark.parametrize('near', ['count', 'stop', 'hold'])
@pytest.mark.parametrize('kind', ['projection', 'lagrangian'])
def test_closures_near_a_singular_position(isoc, kind, near):
    accepted(isoc, FOUR_BAR + f'stabilisation {kind} {{ near {near}; limit 1 um }}\n')


@pytest.mark.parametrize('factors', ['full', 'sparse', 'looped'])
@pytest.mark.parametrize('method', ['bdf4', 'rosenbrock'])
def test_factors_of_implicit_methods(isoc, method, factors):
    accepted(isoc, with_method(method), '--factors', factors)


def test_found_a_policy_that_is_not_refused(isoc):
    """The text of a policy in a plant with lanes does not compile."""
    plain = isoc(PENDULUM + 'histogram\n').file('plant.c')
    made = isoc(PENDULUM, '--lanes')
    begin = plain.index('static iso_policy_histogram')
    policy = plain[begin:plain.index('};', plain.index('static const iso_policy policy')) + 2]
    (made.folder / 'plant.c').write_text(made.file('plant.c') + policy)
    assert not compiles(made)
