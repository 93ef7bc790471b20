"""A plant as a part of other firmware: two plants, one of them twice, in one program; a folder that compiles alone, as C by
three compilers and from C++; names, units and limits in the header; files that are replaced together or not at all."""
import re
import resource
import shutil
import subprocess

import pytest

from harness.programs import compiles, path_of, run
from harness.project import ROOT

HERE = ROOT / 'tests/use/firmware'
MODELS = ROOT / 'models'
ISOC = ROOT / 'build/isoc'
STRICT = '-Wall -Wextra -Werror -Wconversion -std=c11'.split()
FAST = '-Wpedantic -O2 -ffp-contract=off'.split()
M4F = '-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16'.split()
PENDULUM = (MODELS / 'pendulum.scene').read_text()
CART = re.sub('^tunable rail_damping.*', 'tunable rail_damping = 2 N*s/m in 0.5 N*s/m to 4 N*s/m',
              (MODELS / 'cart_pole.scene').read_text(), flags=re.M)


def folder_of(place, *options, swing=PENDULUM):
    """Both plants, each with what it needs, by the compiler by itself, far from the project: it finds nothing of it."""
    shutil.copy(ISOC, path_of('', place, 'isoc'))
    for name, text in (('cart', CART), ('swing', swing)):
        done = run('./isoc', path_of(text, place, f'{name}.scene'), '-o', place / 'made', '--name', name, '--standalone', *options, cwd=place)
        assert done.status == 0, done.errors
    for source in ('own.c', 'bare.c'):
        shutil.copy(HERE / source, place / 'made')
    return place / 'made'


def objects(folder, *compiler):
    """All its sources, without a path to anything else."""
    sources = [path.name for path in folder.glob('*.c') if path.name not in ('own.c', 'bare.c')]
    done = run(*compiler, *STRICT, *FAST, '-c', *sources, cwd=folder)
    return done, sorted(path.name for path in folder.glob('*.o'))


def linked(folder, *words):
    done = run(*words, cwd=folder)
    assert done.status == 0, done.errors


@pytest.mark.parametrize('real', ('float', 'double'))
@pytest.mark.parametrize('method', ('rk4', 'abm4', 'bdf4', 'adams'))
def test_the_folder_compiles_alone(proves, tmp_path, real, method):
    folder = folder_of(tmp_path, '--real', real, '--method', method)
    done, made = objects(folder, 'gcc')
    assert done.status == 0, done.errors
    linked(folder, 'gcc', *STRICT, '-Wpedantic', 'own.c', *made, '-o', 'own')
    proves(folder / 'own')
    if (real, method) == ('float', 'rk4'):
        cpp = [word for word in STRICT if word != '-std=c11']
        linked(folder, 'g++', '-std=c++17', *cpp, '-x', 'c++', 'own.c', '-x', 'none', *made, '-o', 'from_cpp')
        linked(folder, 'g++', '-std=c++20', *cpp, '-fsyntax-only', '-x', 'c++', 'own.c')
        proves(folder / 'from_cpp')
    if (real, method) == ('double', 'rk4'):
        other = folder_of(tmp_path / 'other')
        done = run('gcc', '-std=c11', '-c', HERE / 'bare.c', f'-I{other}', '-DISO_REAL_DOUBLE', '-o', 'bare.o', cwd=folder)
        assert done.status != 0 and 'was made with --real float' in done.errors


def test_by_clang_and_for_the_cortex_m4f(tmp_path):
    """Control: a folder that lacks a file."""
    folder = folder_of(tmp_path)
    done, made = objects(folder, 'clang')
    assert done.status == 0, done.errors
    linked(folder, 'clang', *STRICT, 'own.c', *made, '-o', 'own')
    assert run(folder / 'own').status == 0
    done, made = objects(folder, 'arm-none-eabi-gcc', *M4F)
    assert done.status == 0, done.errors
    linked(folder, 'arm-none-eabi-gcc', *STRICT, *M4F, '--specs=rdimon.specs', 'own.c', *made, '-o', 'own.elf')
    (folder / 'core/methods/progress.h').unlink()
    done, _ = objects(folder, 'clang')
    assert done.status != 0 and 'progress.h' in done.errors


def test_a_plant_whose_steps_are_made_again_takes_room_for_one_before(tmp_path):
    folder = folder_of(tmp_path, '--method', 'abm4', swing=PENDULUM + 'checked yes\n')
    assert objects(folder, 'gcc')[0].status == 0
    assert 'swing_plant(swing_memory *const memory)' not in (folder / 'swing.h').read_text()


def test_found_a_header_that_is_c_alone(tmp_path):
    folder = folder_of(tmp_path)
    with open(folder / 'cart.h', 'a') as header:
        header.write('static inline int *bad(void) { void *p = 0; return p; }\n')
    assert objects(folder, 'gcc')[0].status == 0
    done = run('g++', '-std=c++17', '-x', 'c++', '-c', 'own.c', '-o', 'own.o', cwd=folder)
    assert done.status != 0 and 'invalid conversion' in done.errors


def names_of(path):
    return [line.split()[-1] for line in run('nm', '-g', '--defined-only', path).printed.splitlines()]


def test_all_names_of_the_plant_for_others_begin_with_its_own(isoc, tmp_path):
    """So do the constants of its header. Control: the plant of the program, without --name."""
    folder = folder_of(tmp_path, '--method', 'bdf4')
    assert objects(folder, 'gcc')[0].status == 0
    assert names_of(folder / 'cart.o') and all(name.startswith('cart_') for name in names_of(folder / 'cart.o'))
    constants = re.findall(r'^#define (\w+)|^    ([A-Z_]+),', (folder / 'cart.h').read_text(), re.M)
    assert constants and all((one or other).startswith('CART_') for one, other in constants)
    compiles('gcc', f'-I{ROOT}', '-c', isoc(PENDULUM).folder / 'plant.c', '-o', tmp_path / 'plant.o')
    assert any(name.startswith('iso_the_plant') for name in names_of(tmp_path / 'plant.o'))


@pytest.mark.parametrize('name', ('Cart', '9cart', 'iso_cart', 'a b', ''))
def test_refused_as_a_name(isoc, name):
    of = isoc(PENDULUM, '--name', name)
    assert of.status == 1 and '--name' in of.errors and not of.folder.exists()


def test_tables_take_no_bytes_where_nobody_looks_into_them(tmp_path):
    """Found where somebody does."""
    folder = folder_of(tmp_path)
    for flags in ([], ['-DLOOKS']):
        linked(folder, 'gcc', '-O2', *flags, '-c', 'bare.c', '-o', 'bare.o')
        found = re.findall('cart_(states|inputs|parameters|outputs)', run('nm', folder / 'bare.o').printed)
        assert ('states' in found) if flags else not found


def test_what_a_reader_sees(isoc, tmp_path):
    """Places by name, units, the scene's own lines; that of a closure above its first quantity."""
    folder = folder_of(tmp_path)
    source, header = ((folder / f'cart.{kind}').read_text() for kind in 'ch')
    assert not re.search(r'\b(x|dx|u|p|y)\[\d', source) and 'x[CART_X_HINGE_SPEED]' in source
    assert 'CART_X_HINGE_SPEED, /* rad/s */' in header and 'CART_U_FORCE, /* N */' in header
    for line in ('joint rail prismatic', 'output energy = energy', 'input force'):
        assert f'/* {line}' in source and f'\n{line}' in CART
    lines = isoc(MODELS / 'four_bar.scene').file('plant.c').splitlines()
    first = next(i for i, line in enumerate(lines) if re.search('real [a-zA-Z_]*Phi_rocker_pin', line))
    assert '/* close rocker_pin' in lines[first - 1]


@pytest.mark.parametrize('line, column, said', (
    ('tunable k = 3 N/m in 0.5 N/m to 2 N/m', 13, "the default of 'k' is not within its limits"),
    ('tunable k = 1 N/m in 2 N/m to 0.5 N/m', 22, "the limits of 'k' are in the wrong order"),
    ('tunable k = 1 N/m in 0.5 N to 2 N/m', 22, "a limit of 'k'"),
    ('tunable k = 1 N/m in 0.5 N/m', 1, 'expected to and the largest value'),
    ('constant k = 1 N/m in 0.5 N/m to 2 N/m', 20, ''), ('tunable k = 1 N/m in 1 N/m to 1 N/m', None, '')))
def test_limits_of_a_tunable(isoc, line, column, said):
    """Those that the default stands on are accepted."""
    of = isoc(f'{PENDULUM}{line}\n')
    if column is None:
        assert of.status == 0
    else:
        assert of.status == 1 and not of.folder.exists() and re.search(rf'plant.scene:\d+:{column}: error: {said}', of.errors)


def old(place):
    """A folder with files of before."""
    return path_of('OLD\n', place, 'plant.c') and path_of('OLD\n', place, 'plant.h').parent


def limited(place, size):
    """isoc, where a file has at most so many bytes."""
    return subprocess.run([ISOC, MODELS / 'arm6.scene', '-o', place], capture_output=True, text=True, preexec_fn=lambda: (
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))))


def test_a_file_that_cannot_be_written_whole_leaves_both_as_they_were(tmp_path):
    """Nothing is left beside them. So many bytes hold the header, not the source. Found: with room for both, both are new."""
    folder = old(tmp_path / 'full')
    done = limited(folder, 8192)
    assert done.returncode != 0 and done.stderr and {path.name: path.read_text() for path in folder.iterdir()} == {
        'plant.c': 'OLD\n', 'plant.h': 'OLD\n'}
    assert limited(folder, 512000).returncode == 0
    assert (folder / 'plant.h').stat().st_size < 8192 < (folder / 'plant.c').stat().st_size


def test_a_folder_where_a_file_should_be_leaves_the_other_as_it_was(tmp_path):
    folder = old(tmp_path / 'folder')
    (folder / 'plant.c').unlink()
    (folder / 'plant.c').mkdir()
    done = run(ISOC, MODELS / 'pendulum.scene', '-o', folder)
    assert done.status != 0 and 'plant.c: error: Is a directory' in done.errors
    assert (folder / 'plant.h').read_text() == 'OLD\n' and sorted(path.name for path in folder.iterdir()) == ['plant.c', 'plant.h']


def test_a_full_standard_output_is_told(tmp_path):
    with open('/dev/full', 'w') as full:
        done = subprocess.run([ISOC, MODELS / 'pendulum.scene', '-o', tmp_path], stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode != 0 and 'standard output' in done.stderr
