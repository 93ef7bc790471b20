"""What runs on the target calls nothing but itself: no heap, stdio, libm, and in the float build no double arithmetic.
By rk4 the models that are tried in depth, and the others by turns, as promises/same_bits.t, which has the same objects;
and one of all kinds of joints by every method."""
import collections
import pathlib
import re
import subprocess

import pytest

from harness import project
from harness.project import ROOT
from lab import build
from lab.methods import known_methods

IN_DEPTH = 'pendulum double_pendulum cart_pole arm6 tree rigid_body four_bar'.split()
CORE = 'core/numbers/*.c core/runtime/*.c'
PORT = 'port/mps2/*.c'
# What may be called beside the project's own: copying and comparing memory, and whole numbers of 64 bits (EABI's run-time
# helpers); names of the linker; and what these helpers are made of.
ALLOWED = r'mem(cpy|move|set|cmp)|__aeabi_mem(cpy|set|clr)[48]?|__aeabi_(uldivmod|ldivmod|lmul|llsl|llsr|lasr|lcmp|ulcmp|ldiv0|idiv0)'
LINKER = re.findall(r'^ *(\w+) = ', (ROOT / 'port/mps2/sections.ld').read_text(), flags=re.M)
HELPERS = r'__(u)?divmoddi4|__udivmoddi4|__(u)?divdi3|__gnu_u?ldivmod_helper'
# Of the firmware: arithmetic in software, and the heap.
HELD = r'__aeabi_.*|_sbrk.*|_malloc.*|__.*[sd]f.*'
PLANTED = {
    'malloc': '#include <stdlib.h>\nchar *f(void); char *f(void) { return malloc(4); }',
    'printf': '#include <stdio.h>\nvoid f(int); void f(int x) { printf("%d", x); }',
    'sinf': '#include <math.h>\nfloat f(float); float f(float x) { return sinf(x); }',
    'sqrt': '#include <math.h>\ndouble f(double); double f(double x) { return sqrt(x); }',
    '__aeabi_dmul': 'double f(double); double f(double x) { return x * x; }',
    '__aeabi_f2d': 'double f(float); double f(float x) { return x; }',
    '__aeabi_dcmplt': 'int f(double); int f(double x) { return x < 1; }',
    '__aeabi_i2d': 'double f(int); double f(int x) { return x; }',
}


@pytest.fixture(scope='module')
def compiled(tmp_path_factory):
    """compiled(file or pattern, ..., flags=): the objects of these files for the target, each compiled once."""
    made = {}

    def call(*patterns, flags=()):
        files = [file for pattern in patterns
                 for file in (sorted(ROOT.glob(pattern)) if isinstance(pattern, str) else [pattern])]
        for file in files:
            if file not in made:
                place = tmp_path_factory.mktemp('object') / f'{file.stem}.o'
                subprocess.run([*build.port('cortex-m4f', 'float').compile, *flags, '-c', file, '-o', place], check=True)
                made[file] = place
        return [made[file] for file in files]
    return call


def nm(*words):
    """(type, symbol) of these objects."""
    lines = subprocess.run(['arm-none-eabi-nm', *words], capture_output=True, text=True, check=True).stdout.splitlines()
    return [tuple(line.split()[-2:]) for line in lines if len(line.split()) > 1]


def needs(objects):
    """The symbols that the objects need and none of them has, but for those allowed."""
    of = collections.defaultdict(set)
    for kind, symbol in nm('-g', *objects):
        of[kind == 'U'].add(symbol)
    return {symbol for symbol in of[True] - of[False] if symbol not in LINKER and not re.fullmatch(ALLOWED, symbol)}


def holds(objects, folder):
    """The helpers and the heap in the firmware of these objects, but for those allowed."""
    firmware = folder / 'firmware'
    subprocess.run([*build.port('cortex-m4f', 'float').link, *objects, '-o', firmware], check=True)
    return {symbol for _, symbol in nm(firmware) if re.match(HELD, symbol) and not re.fullmatch(f'{ALLOWED}|{HELPERS}', symbol)}


def is_alone(objects, folder):
    assert needs(objects) == set()
    assert holds(objects, folder) == set()


def models():
    """Those of the turn."""
    turn, of_stewart = project.turn(2, pathlib.Path(__file__)), project.turn(20, pathlib.Path(__file__))
    names = sorted(path.stem for path in ROOT.glob('models/*.scene'))
    return [name for i, name in enumerate(names) if turn is None or name in IN_DEPTH or
            (of_stewart == 0 if name == 'stewart' else i % 2 == turn)]


@pytest.fixture
def plant_of(isoc):
    def call(model, *options):
        made = isoc(ROOT / f'models/{model}.scene', *options, '--real', 'float')
        assert made.status == 0, made.errors
        return made.folder
    return call


def test_a_plant_by_hand(compiled, tmp_path):
    is_alone(compiled(CORE.split()[0], CORE.split()[1], 'core/application/*.c', PORT, 'models/oscillator.c'), tmp_path)


@pytest.mark.parametrize('model', models())
def test_a_model(plant_of, compiled, tmp_path, model):
    folder = plant_of(model, '--method', 'rk4')
    is_alone(compiled(*CORE.split(), 'core/application/*.c', PORT, folder / 'plant.c'), tmp_path)


@pytest.mark.parametrize('method', known_methods())
def test_a_method(plant_of, compiled, tmp_path, method):
    folder = plant_of('tree', '--method', method)
    is_alone(compiled(*CORE.split(), 'core/application/*.c', PORT, folder / 'plant.c'), tmp_path)


def test_a_plant_with_a_link_and_with_calibration(plant_of, compiled, tmp_path):
    folder = plant_of('tree', '--link', '--xcp', 'open')
    is_alone(compiled(*CORE.split(), 'core/application/stream.c', 'core/link/*.c', 'core/xcp/*.c', PORT, folder / 'plant.c',
                      folder / 'interface.c'), tmp_path)


@pytest.mark.parametrize('symbol', PLANTED)
def test_found_what_calls_something_else(compiled, tmp_path, symbol):
    file = tmp_path / 'planted.c'
    file.write_text(PLANTED[symbol] + '\n')
    assert symbol in needs(compiled(file, flags=['-Wno-double-promotion', '-Wno-conversion']))


def test_found_double_arithmetic_in_a_firmware(compiled, tmp_path):
    plant = tmp_path / 'plant.c'
    plant.write_text((ROOT / 'models/oscillator.c').read_text().replace(
        '#include', 'double planted(double x);\n__attribute__((used)) double planted(double x)\n{\n    return x * x;\n}\n#include', 1))
    objects = compiled(*CORE.split(), 'core/application/*.c', PORT, plant)
    keeps = [*objects, '-Wl,--undefined=planted']
    assert '__aeabi_dmul' in needs(objects) and '__aeabi_dmul' in holds(keeps, tmp_path)
