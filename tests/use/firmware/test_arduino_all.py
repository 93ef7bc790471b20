"""Every model and every effect of the library as a library of Arduino: it compiles with the flags of the core's own
platform.txt, to which a user adds none, and takes no root from the C library. On cores of Arm, as packages for them
compile: a root is one instruction where there is one, without a branch for errno, and else that of port/soft."""
import pathlib
import subprocess

import pytest

from arduino import CORE, EFFECTS, MODELS, ROOTS, compiled, needs_the_core, package, wanted, with_effect
from harness.plants import replaced


@needs_the_core
@pytest.mark.parametrize('scene', [*MODELS, *EFFECTS], ids=lambda scene: getattr(scene, 'stem', scene))
def test_a_plant_is_a_library_of_arduino(isoc, scene):
    folder = package(isoc, scene if isinstance(scene, pathlib.Path) else with_effect(scene))
    said = compiled(folder, 'c', 'plant_of_it.c', '-fsyntax-only')
    assert said.returncode == 0, said.stderr


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
def test_the_library_of_effects_is_whole():
    assert set(EFFECTS) == {path.stem for path in pathlib.Path('models/effects').glob('*.scene')} and len(MODELS) >= 25
