"""Every model and every effect of the library as a library of Arduino: it compiles with the flags of the core's own
platform.txt, to which a user adds none, and takes no root from the C library. On cores of Arm, as packages for them
compile: a root is one instruction where there is one, without a branch for errno, and else that of port/soft."""
import pathlib
import re
import subprocess

import pytest

from conftest import replaced

CORE = pathlib.Path('/usr/share/arduino/hardware/arduino/avr')
MODELS = sorted(pathlib.Path('models').glob('*.scene'))
PENDULUM = pathlib.Path('models/pendulum.scene').read_text()
ROWS = [[cell.strip() for cell in line.split('|')] for line in pathlib.Path('tools/measure/library.txt').read_text().splitlines()
        if '|' in line and line[0] != '#']
BASES = {name: (signal, statements) for word, name, signal, statements in ROWS if word == 'base'}
EFFECTS = {kind: row for kind, *row in ROWS if kind != 'base'}
ROOTS = pathlib.Path('tests/functions/all.scene')
SKETCH = '''#include <Arduino.h>
#include <plant_of_it.h>
#include <core/runtime/tick.h>
static plant_of_it_memory memory;
static const iso_plant swing = plant_of_it_plant(&memory);
void setup() { pinMode(13, iso_plant_start(&swing) ? OUTPUT : INPUT); }
void loop() { static uint32_t tick; (void)iso_plant_tick(&swing, tick++); }
'''
needs_the_core = pytest.mark.skipif(not CORE.exists(), reason='arduino-core-avr is not installed')


def with_effect(kind):
    base, signal, statements = EFFECTS[kind]
    own, both = BASES[base]
    return PENDULUM + both.replace('SIGNAL', signal or own) + '\n' + statements + '\n'


def properties(path):
    pairs = (line.split('=', 1) for line in path.read_text().splitlines() if '=' in line and line[0] != '#')
    return {key: value for key, value in pairs}


def recipe(language, board, source, made, includes):
    """The command of the core for a file, as arduino-cli makes it (Arduino, Platform specification)."""
    known = properties(CORE / 'platform.txt')
    of_board = {key.removeprefix(board + '.'): value for key, value in properties(CORE / 'boards.txt').items()
                if key.startswith(board + '.')}
    known |= of_board | {
        'runtime.ide.version': '10819', 'build.arch': 'AVR', 'source_file': str(source), 'object_file': str(made),
        'includes': ' '.join(f'"-I{path}"' for path in (CORE / 'cores/arduino', CORE / 'variants/standard', *includes))}
    command = known[f'recipe.{language}.o.pattern']
    while '{' in command:
        command = re.sub(r'\{([^{}]*)\}', lambda name: known[name[1]], command)
    return command


def package(isoc, scene):
    made = isoc(scene, '--name', 'plant_of_it', '--standalone')
    assert made.status == 0, made.errors
    return made.folder


def compiled(folder, language, source, *more):
    command = recipe(language, 'uno', folder / source, folder / (source + '.o'), [folder])
    return subprocess.run(' '.join((command, *more)), shell=True, capture_output=True, text=True)


def wanted(tool, path):
    """The symbols that an object does not define."""
    return set(subprocess.run([tool, '-u', path], check=True, capture_output=True, text=True).stdout.split()) - {'U'}


@needs_the_core
@pytest.mark.parametrize('scene', [*MODELS, *EFFECTS], ids=lambda scene: getattr(scene, 'stem', scene))
def test_a_plant_is_a_library_of_arduino(isoc, scene):
    folder = package(isoc, scene if isinstance(scene, pathlib.Path) else with_effect(scene))
    said = compiled(folder, 'c', 'plant_of_it.c', '-fsyntax-only')
    assert said.returncode == 0, said.stderr


@needs_the_core
@pytest.mark.parametrize('kind', ['contact', 'friction', 'cable'])
def test_a_library_and_its_sketch_link_without_a_root_of_libm(isoc, kind):
    folder = package(isoc, with_effect(kind))
    (folder / 'sketch.cpp').write_text(SKETCH)
    for language, source in (('c', 'plant_of_it.c'), ('cpp', 'sketch.cpp')):
        said = compiled(folder, language, source, '-fno-lto')
        assert said.returncode == 0, said.stderr
    assert not wanted('avr-nm', folder / 'plant_of_it.c.o') & {'sqrt', 'sqrtf', 'errno'}
    assert 'plant_of_it_model' in wanted('avr-nm', folder / 'sketch.cpp.o')


CORES = {
    'cortex-m0plus': ('-mcpu=cortex-m0plus', 0), 'cortex-m3': ('-mcpu=cortex-m3', 0),
    'cortex-m4f': ('-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16', 1),
    'cortex-m33': ('-mcpu=cortex-m33 -mfloat-abi=hard -mfpu=fpv5-sp-d16', 1),
}


@pytest.mark.parametrize('optimise', ['-O0', '-Os', '-O2'])
@pytest.mark.parametrize('core', CORES)
def test_a_root_is_an_instruction_or_that_of_the_package(isoc, core, optimise):
    folder = package(isoc, ROOTS)
    flags, has_root = CORES[core]
    subprocess.run(['arm-none-eabi-gcc', '-std=gnu11', '-mthumb', *flags.split(), optimise, '-Wall', '-Wextra', '-Werror',
                    '-c', folder / 'plant_of_it.c', '-o', folder / 'it.o'], check=True)
    listing = subprocess.run(['arm-none-eabi-objdump', '-d', folder / 'it.o'], capture_output=True, text=True).stdout
    assert not wanted('arm-none-eabi-nm', folder / 'it.o') & {'sqrt', 'sqrtf', '__errno'}
    assert ('vsqrt' in listing) == bool(has_root)


@pytest.mark.parametrize('compiler', ['gcc', 'clang'])
def test_the_flag_adds_and_takes_no_instruction(isoc, compiler):
    folder = package(isoc, ROOTS)
    codes = []
    for flags in ([], ['-fno-math-errno']):
        subprocess.run([compiler, '-std=c11', '-O2', '-ffp-contract=off', *flags, '-c', folder / 'plant_of_it.c', '-o',
                        folder / 'it.o'], check=True)
        codes.append(subprocess.run(['objdump', '-d', '--no-addresses', folder / 'it.o'], capture_output=True, text=True).stdout)
    assert codes[0] == codes[1] and 'sqrtss' in codes[0] and 'sqrtf' not in codes[0]


# Controls.

def test_found_a_root_with_errno(isoc):
    """By the function of the compiler that is not declared as constant."""
    folder = package(isoc, ROOTS)
    root = folder / 'core/numbers/sqrt.h'
    root.write_text(replaced(r'#define ISO_ROOT\(name\) name', '#define ISO_ROOT(name) __builtin_##name', root.read_text()))
    subprocess.run(['gcc', '-std=c11', '-O2', '-c', folder / 'plant_of_it.c', '-o', folder / 'it.o'], check=True)
    assert 'sqrtf' in wanted('nm', folder / 'it.o')


@needs_the_core
def test_found_a_package_without_its_root(isoc):
    folder = package(isoc, ROOTS)
    root = folder / 'core/numbers/sqrt.h'
    root.write_text(replaced(r'#include "../../port/soft/own_root.h"\n', '', root.read_text()))
    compiled(folder, 'c', 'plant_of_it.c', '-fno-lto')
    assert wanted('avr-nm', folder / 'plant_of_it.c.o') & {'sqrt', 'sqrtf'}


@needs_the_core
def test_the_library_of_effects_is_whole():
    assert set(EFFECTS) == {path.stem for path in pathlib.Path('models/effects').glob('*.scene')} and len(MODELS) >= 25
