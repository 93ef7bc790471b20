"""The same scene gives the same bytes of C, whichever compiler built isoc."""
import re
import subprocess

import pytest

from harness.plants import NUMERICS
from harness.project import ROOT, make

MADE = ROOT / 'build/obj/tools/isoc'
SCENES = sorted(path for pattern in ('models/*.scene', 'tests/isoc/scene/*.scene', 'tests/isoc/mechanism/*.scene')
                for path in ROOT.glob(pattern))


def sources():
    """The files that make compiles isoc of: one for each of its folders, and what it has in it."""
    rooms = [path.name for path in (ROOT / 'tools/isoc').iterdir() if path.is_dir() and any(path.glob('*.c'))]
    return [*ROOT.glob('tools/isoc/*.c'), *(MADE / f'{name}.c' for name in [*rooms, *(
        f'{kind}_files' for kind in ('core', 'effect', 'client', 'help'))])]


def built(files, folder):
    """An isoc by clang, without optimisation: it compiles for longer than it saves here. The kernels stay rolled, as make
    has them."""
    words = ['clang', '-std=c11', '-O0', *NUMERICS, '-D_POSIX_C_SOURCE=200809L', '-DISO_REAL_DOUBLE', '-DISO_UNROLL=', '-I', ROOT]
    objects = []
    for file in files:
        objects.append(folder / f'{file.parent.name}-{file.stem}.o')
        subprocess.run([*words, '-c', file, '-o', objects[-1]], check=True)
    subprocess.run(['clang', *objects, '-o', folder / 'isoc', '-lm'], check=True)
    return folder / 'isoc'


@pytest.fixture(scope='module')
def by_clang(tmp_path_factory):
    make('tools')
    return built(sources(), tmp_path_factory.mktemp('clang'))


def is_same(isoc, program, scene, folder, *options):
    made = isoc(scene, *options)
    subprocess.run([program, scene, '-o', folder / 'plant', *options], capture_output=True)
    return made.status == 0 and made.files() == {path.name: path.read_text() for path in (folder / 'plant').iterdir()}


def method_of(text):
    """By rosenbrock, since its plants have the Jacobian too; by one that the scene fits where it does not."""
    return 'bdf4' if 'residual' in text else 'rk4' if re.search('^ *when ', text, re.M) else 'rosenbrock'


@pytest.mark.parametrize('scene', SCENES, ids=[path.stem for path in SCENES])
def test_an_isoc_that_clang_built_writes_the_same_bytes(isoc, by_clang, tmp_path, scene):
    assert is_same(isoc, by_clang, scene, tmp_path, '--method', method_of(scene.read_text()))


@pytest.mark.parametrize('kind', ['projection', 'lagrangian'])
def test_closures_that_are_held(isoc, by_clang, tmp_path, kind):
    scene = tmp_path / 'closures.scene'
    scene.write_text((ROOT / 'tests/isoc/scene/closures.scene').read_text() + f'stabilisation {kind}\n')
    assert is_same(isoc, by_clang, scene, tmp_path, '--method', 'rk4')


def test_found_products_that_are_made_in_another_order(isoc, tmp_path):
    make('tools')
    text = (ROOT / 'tools/isoc/graph/graph.c').read_text()
    one, other = 'const node ab = mul(g, a, b), cd = mul(g, c, d);', 'const node cd = mul(g, c, d), ab = mul(g, a, b);'
    assert one in text
    (tmp_path / 'other.c').write_text(text.replace(one, other))
    (tmp_path / 'graph.c').write_text((MADE / 'graph.c').read_text().replace('tools/isoc/graph/graph.c', str(tmp_path / 'other.c')))
    planted = built([tmp_path / 'graph.c' if file == MADE / 'graph.c' else file for file in sources()], tmp_path)
    assert not is_same(isoc, planted, ROOT / 'models/double_pendulum.scene', tmp_path, '--method', 'rosenbrock')
