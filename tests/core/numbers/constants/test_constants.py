"""The functions of core/numbers: the measurements (tests/core/numbers/exhaustive) notice a wrong digit in a constant; no
branch and no address depends on an argument, with either compiler; without an FPU the bits are the same."""
import pytest

from harness.plants import STRICT
from harness.programs import compiles, on_board, run
from harness.project import ROOT
from lab import build

EXHAUSTIVE = 'tests/core/numbers/exhaustive/'
DIGITS = [line.split() for line in '''
exp float 4.166810215e-2 4.166910215e-2
exp float 2.12194440e-4 2.12195440e-4
exp double 4.16666666666666366e-02 4.16666666666676366e-02
log float 3.997757435e-1 3.987757435e-1
log double 1.81835732292057822e-01 1.81835742292057822e-01
tanh float 8.332042024e-3 8.333042024e-3
tanh double 2.75573192113544247e-06 2.75573202113544247e-06
angle float 1.997761428e-1 1.998761428e-1
angle float 0.414213562373095049 0.614213562373095049
angle double 7.69208048088145246e-02 7.69209048088145246e-02
sincos float 1.666665673e-1 1.666675673e-1
sincos float 8.333008736e-3 8.334008736e-3
sincos float 4.166665673e-2 4.166765673e-2
sincos float 8.90891020676e-6 8.93891020676e-6
sincos float <<_ISO_SIGN_SHIFT <<_(ISO_SIGN_SHIFT_-_1)
sincos double 3.1415926534682512 3.1415926534683512
sincos double 1.215420101301238e-10 1.215420201301238e-10
sincos double 8.333333333333196e-03 8.333333333433196e-03
sincos double 2.087659248648486e-09 2.088659248648486e-09
sincos double 1.6666666666666666e-01 1.6666666666666669e-01
'''.strip().splitlines()]
# A coefficient that is off by half of its last bit biases sin^2 + cos^2; that of the cosine, in double, by the bound's
# double.


@pytest.fixture
def measured(program):
    """measured(name, real, planted): a part of the domain of a function."""
    def of(name, real, planted=None, flags=()):
        made = program(f'{EXHAUSTIVE}{name}.c', by='gcc', level='-O2', real=real, planted=planted, flags=flags)
        return run(made, 200 if name == 'sincos' else 4 if flags else 97)

    return of


@pytest.mark.parametrize('name, real, old, new', DIGITS)
def test_found_another_digit(measured, name, real, old, new):
    planted = {f'core/numbers/{name}.h': (old.replace('_', ' ', 1), new.replace('<<_', '<< ').replace('_-_', ' - '))}
    assert measured(name, real, planted).finds()


@pytest.mark.parametrize('real', ('float', 'double'))
def test_the_measurement_of_sines_finds_nothing_in_what_is_good(measured, proves, real):
    proves(measured('sincos', real))


def test_found_halves_that_are_rounded_away_from_zero(measured):
    done = measured('round', 'float', flags=['-DPLANTED'])
    assert done.finds('round: worst error') and '\nok 2 - floor' in done.printed


def test_found_in_noise_ticks_in_pairs(measured):
    assert measured('noise', 'float', flags=['-DPLANTED']).finds('correlation with a later tick')


@pytest.mark.parametrize('by, flags', (('gcc', []), ('clang', []), ('gcc', ['-DPLANTED'])))
def test_no_branch_and_no_address_depends_on_an_argument(program, by, flags):
    """Under memcheck with the arguments undefined. Control: a branch."""
    made = program('tests/core/numbers/constants/functions.c', by=by, level='-O2', flags=flags)
    done = run('valgrind', '--quiet', '--error-exitcode=9', made)
    assert done.status == 0 if not flags else done.status != 0 and 'uninitialised' in done.errors


def test_without_an_fpu_the_bits_are_the_same(proves, laboratory, tmp_path):
    """The unit test, where numbers are computed by functions: only the start of the program knows the FPU."""
    compiler, made = ['arm-none-eabi-gcc', '-std=c11', *STRICT, '-I.', '-mcpu=cortex-m4', '-mthumb'], tmp_path / 'soft'
    sources = [path for path in sorted((ROOT / 'port/mps2').glob('*.c')) if path.name != 'start.c']
    compiles(*compiler, '-mfloat-abi=softfp', '-mfpu=fpv4-sp-d16', '-c', 'port/mps2/start.c', '-o', tmp_path / 'start.o')
    compiles(*compiler, '-mfloat-abi=soft', *build.port('cortex-m4f').facts['PORT_LINK'].split(), 'tests/core/numbers/functions.c',
             'tests/tap.c', *sources, tmp_path / 'start.o', '-lm', '-o', made)
    assert '__aeabi_fadd' in run('arm-none-eabi-nm', made).printed
    proves(*on_board(made))
