"""A build that would change bits is refused: by the preprocessor where it sees the flag, else by iso_self_check at
start."""
import pathlib
import platform
import re
import subprocess

import pytest

from harness.project import ROOT
from lab import build

MAIN = '''#include <stdio.h>
#include "core/numbers/self_check.c"
#ifdef MODE
#include <xmmintrin.h>
#endif
int main(void)
{
#ifdef MODE
    _mm_setcsr(_mm_getcsr() | MODE);
#endif
    puts(iso_self_check() ? "kept" : "changed");
    return 0;
}
'''
STRICT = '-std=c11 -O2 -ffp-contract=off'
X86 = pytest.mark.skipif(platform.machine() != 'x86_64', reason='this processor has no such modes')
FUSES = 'fma' in pathlib.Path('/proc/cpuinfo').read_text().split()
HAS_FMA = pytest.mark.skipif(not FUSES, reason='this processor has no fused multiply-add')
REALS = pytest.mark.parametrize('real', ['', '-DISO_REAL_DOUBLE'], ids=['float', 'double'])


@pytest.fixture(scope='module')
def bare(tmp_path_factory):
    """The numbers of core without what puts a stranger's flags right, for who looks there first."""
    folder = tmp_path_factory.mktemp('bare')
    (folder / 'core/numbers').mkdir(parents=True)
    for path in (ROOT / 'core/numbers').glob('*.h'):
        text = path.read_text()
        (folder / 'core/numbers' / path.name).write_text(re.sub('^#pragma.*\n', '', text, flags=re.M) if path.name == 'real.h' else text)
    return folder


# A name, a command and what the self-check says of it; BARE is for `bare`.
ANYWHERE = [
    *((level, f'gcc -std=c11 {level} -ffp-contract=off', 'kept') for level in ('-O0', '-O2', '-Os')),
    ('half precision computed as such, as on a Cortex-M55',
     'gcc -std=gnu17 -O2 -ffp-contract=off -U__FLT_EVAL_METHOD__ -D__FLT_EVAL_METHOD__=16', 'kept'),
]
ON_X86 = [
    ('flush to zero', f'gcc {STRICT} -DMODE=0x8000', 'changed'),
    ('denormal operands taken for zero', f'gcc {STRICT} -DMODE=0x0040', 'changed'),
    *((f'rounding {way}', f'gcc {STRICT} -DMODE={mode}', 'changed') for way, mode in (
        ('down', '0x2000'), ('up', '0x4000'), ('to zero', '0x6000'))),
    ('x87', 'gcc -std=c11 -O2 -mfpmath=387 -U__FLT_EVAL_METHOD__ -D__FLT_EVAL_METHOD__=0', 'changed'),
    ('division by a reciprocal', f'gcc {STRICT} -freciprocal-math -U__RECIPROCAL_MATH__', 'changed'),
    ('zeros without a sign', 'gcc -std=c11 -O2 -fno-signed-zeros -U__NO_SIGNED_ZEROS__', 'changed'),
]
WITH_FMA = [
    ('what gcc would fuse', 'gcc -std=gnu11 -O2 -mfma -ffp-contract=fast', 'kept'),
    ('fused multiply-add', 'gcc -IBARE -std=gnu11 -O2 -mfma', 'changed'),
    ('fused multiply-add by clang', 'clang -O2 -mfma -ffp-contract=fast', 'changed'),
]


@REALS
@pytest.mark.parametrize('name, command, said', ANYWHERE + [pytest.param(*case, marks=X86) for case in ON_X86] +
                         [pytest.param(*case, marks=HAS_FMA) for case in WITH_FMA])
def test_the_self_check_says(bare, tmp_path, real, name, command, said):
    (tmp_path / 'main.c').write_text(MAIN)
    words = command.replace('BARE', str(bare)).split() + ([real] if real else [])
    subprocess.run([*words, '-I.', tmp_path / 'main.c', '-o', tmp_path / 'checked'], check=True, capture_output=True)
    assert subprocess.run([tmp_path / 'checked'], capture_output=True, text=True).stdout == said + '\n'


@REALS
@pytest.mark.parametrize('flags, said', [
    ('-ffast-math', 'without them and without -Ofast'), ('-ffinite-math-only', 'without them and without -Ofast'),
    # Float computed in double, as on s390x, and in a type that is not known.
    ('-U__FLT_EVAL_METHOD__ -D__FLT_EVAL_METHOD__=1', '-fexcess-precision=fast'),
    ('-U__FLT_EVAL_METHOD__ -D__FLT_EVAL_METHOD__=-1', 'is not known'),
    pytest.param('-mfpmath=387', '-msse2 -mfpmath=sse', marks=X86)])
def test_the_preprocessor_stops_and_says_the_right_flag(tmp_path, real, flags, said):
    done = subprocess.run(['gcc', *flags.split(), *([real] if real else []), '-std=c11', '-I.', '-c', 'core/numbers/self_check.c', '-o',
                           tmp_path / 'refused.o'], capture_output=True, text=True)
    assert done.returncode != 0 and re.search(f'error.*{said}', done.stderr)


@pytest.fixture
def built(isoc, tmp_path):
    """built(port, word, ...): the program of a plant, by its compiler alone."""
    plant = isoc(ROOT / 'tests/core/methods/order/top.scene').folder / 'plant.c'

    def call(port, *words):
        sources = [path for pattern in ('core/numbers/*.c', 'core/runtime/*.c', 'core/application/*.c', f'port/{port}/*.c')
                   for path in sorted(ROOT.glob(pattern))] + ([] if port == 'mps2' else [ROOT / 'port/unix/console.c'])
        subprocess.run([*words, '-I.', plant, *sources, '-o', tmp_path / 'built'], check=True, capture_output=True)
        return tmp_path / 'built'
    return call


ON_HOST = f'gcc {STRICT} -fno-tree-vectorize -fno-tree-slp-vectorize'.split()
# The flags of the board's compiler, and what a linker needs.
ON_BOARD = ('-std=gnu11 -O2 -fno-math-errno -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -ffunction-sections -nostartfiles '
            '--specs=nano.specs -T port/mps2/mps2.ld -Wl,--gc-sections').split()


def run(program, port='host'):
    """100 ms."""
    qemu = ('qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -serial none '
            '-semihosting-config enable=on,target=native,arg=plant,arg=100000000 -kernel').split()
    return [*qemu, program] if port == 'mps2' else [program, '100000000']


def bails_out(command):
    """What it writes says that it does not run."""
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True)
    return done.returncode != 0 and re.search(rb'^Bail out! .*-ffp-contract=off', done.stdout, re.M)


def hash_of(command, folder):
    done = subprocess.run([ROOT / 'build/trace', '-o', folder, '--', *command], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    return re.search('^hash (.*)', done.stdout, re.M)[1]


def test_all_that_this_processor_can_changes_no_bit(built):
    plain = subprocess.run(run(built('host', *ON_HOST)), capture_output=True).stdout
    assert len(plain) > 1000 and plain == subprocess.run(run(built('host', *ON_HOST, '-march=native')), capture_output=True).stdout


@HAS_FMA
def test_a_program_that_fuses_says_so_and_does_not_run(built, bare):
    assert bails_out(run(built('host', 'gcc', f'-I{bare}', *'-std=gnu11 -O2 -mfma'.split())))


def test_nor_does_that_of_the_board_with_the_flags_of_its_compiler(built, bare, tmp_path):
    """With the pragmas of core it moves as on the host."""
    build.need(['arm-none-eabi-gcc', 'qemu-system-arm'], 'apt-get install gcc-arm-none-eabi qemu-system-arm')
    assert bails_out(run(built('mps2', 'arm-none-eabi-gcc', f'-I{bare}', *ON_BOARD), 'mps2'))
    there = hash_of(run(built('mps2', 'arm-none-eabi-gcc', *ON_BOARD), 'mps2'), tmp_path)
    assert there == hash_of(run(built('host', *ON_HOST)), tmp_path)
