"""The headers of two plants in one file: both of float, or both of double; else the second is an error, in either order,
in C and in C++."""
import subprocess

import pytest

PROGRAM = '''#include "{0}.h"
#include "{1}.h"
#include "core/runtime/tick.h"
static {0}_memory first;
static {1}_memory second;
int main(void)
{{
    const iso_plant a = {0}_plant(&first), b = {1}_plant(&second);
    if (!iso_plant_start(&a) || !iso_plant_start(&b)) {{
        return 1;
    }}
    return iso_plant_tick(&a, 0) != {0}_model.states || iso_plant_tick(&b, 0) != {1}_model.states;
}}
'''
SCENES = {'cart': 'cart_pole', 'swing': 'pendulum'}


@pytest.fixture(scope='module')
def folders(tmp_path_factory):
    """The plants cart_float, cart_double, swing_float and swing_double, each in a folder that compiles alone."""
    place = tmp_path_factory.mktemp('plants')
    for scene in SCENES:
        for real in ('float', 'double'):
            subprocess.run(['build/isoc', f'models/{SCENES[scene]}.scene', '-o', place / f'{scene}_{real}', '--name',
                            f'{scene}_{real}', '--real', real, '--standalone'], check=True, capture_output=True)
    return place


def compiled(folders, compiler, first, second):
    source = folders / ('main.cpp' if '++' in compiler else 'main.c')
    source.write_text(PROGRAM.format(first, second))
    standard = '-std=c++17' if '++' in compiler else '-std=c11'
    return subprocess.run([compiler, standard, '-Wall', '-Wextra', '-Werror', f'-I{folders / first}', f'-I{folders / second}',
                           '-c', source, '-o', folders / 'main.o'], capture_output=True, text=True)


@pytest.mark.parametrize('compiler', ['gcc', 'g++', 'clang', 'clang++'])
@pytest.mark.parametrize('first, second', [('cart', 'swing'), ('swing', 'cart')])
def test_plants_of_two_reals_in_a_file_are_an_error(folders, compiler, first, second):
    for one, other in (('float', 'double'), ('double', 'float')):
        said = compiled(folders, compiler, f'{first}_{one}', f'{second}_{other}')
        assert said.returncode != 0 and f'"{second}_{other} was made with --real {other}' in said.stderr
        assert f'include no plant of {one} in the same file' in said.stderr


@pytest.mark.parametrize('compiler', ['gcc', 'g++'])
@pytest.mark.parametrize('real', ['float', 'double'])
def test_plants_of_one_real_work_side_by_side(folders, compiler, real):
    said = compiled(folders, compiler, f'cart_{real}', f'swing_{real}')
    assert said.returncode == 0, said.stderr
    plants = [folders / f'{name}_{real}' / f'{name}_{real}.c' for name in SCENES]
    subprocess.run(['gcc', '-fno-math-errno', folders / 'main.o', *plants, '-o', folders / 'main'], check=True)
    assert subprocess.run([folders / 'main']).returncode == 0


def test_found_a_header_that_does_not_ask(folders):
    """It compiles; so the error is that of the check."""
    header = folders / 'swing_double' / 'swing_double.h'
    sound = header.read_text()
    header.write_text(sound.replace('#if ISO_REAL_BITS != 64', '#ifndef ISO_REAL_DOUBLE'))
    assert compiled(folders, 'gcc', 'cart_float', 'swing_double').returncode == 0
    header.write_text(sound)
