"""A plant in Python: one file of pytest has equal results on the plant in the process, on the host over the link in virtual
and in real time, and on the Cortex-M4F over it. Plants beside one another, float and double, with policies and with steps
that are made again, have the hash of one alone, which is that of a run. The wheel; refusals of isoc; and many plants side by
side, each lane as the plant alone."""
import re
import sys
import types
import xml.etree.ElementTree
import zipfile

import pytest

from harness.programs import LINKED, LOOP, controlled, linked_on_board, path_of, plant_at, run, traced
from harness.project import ROOT
from lab import build, python

HERE = ROOT / 'tests/tools/python'
WORDS, CART = HERE / 'words.scene', ROOT / 'tests/core/xcp/masters/cart.scene'
PYTEST = ['pytest-3', '-p', 'no:cacheprovider', '-q', '-rsf']


@pytest.fixture
def package(laboratory):
    """package(scene, ...): the folder of the package of its plant; options are of the command."""
    return lambda scene, **options: python.package(scene, quiet=True, flags='-O0', **options).absolute()


@pytest.fixture(scope='module')
def linked(isoc):
    return isoc(WORDS, '--link')


def kept(folder):
    """What the tests of all words keep, by test and name; all of them must have been run."""
    suite = xml.etree.ElementTree.parse(folder / 'kept.xml').getroot().find('testsuite')
    assert (suite.get('tests'), suite.get('failures'), suite.get('errors'), suite.get('skipped')) == ('16', '0', '0', '0')
    return [(case.get('name'), of.get('name'), of.get('value')) for case in suite for of in case.iter('property')
            if of.get('name') != 'takes']


def words(folder, path, file=HERE / 'try_words.py'):
    """The command of the tests of all words, and its environment."""
    return [*PYTEST, file, '-o', 'junit_family=xunit1', f'--junitxml={folder}/kept.xml'], {
        'PYTHONPATH': str(path), 'PYTHONDONTWRITEBYTECODE': '1'}


@pytest.fixture(scope='module')
def in_process(isochron, tmp_path_factory):
    """What the words keep on the plant in the process."""
    folder = tmp_path_factory.mktemp('process')
    of = isochron('python', WORDS, '--out', folder / 'words')
    assert of.status == 0, of.errors
    command, environment = words(folder, of.said['package'])
    done = run(*command, **environment)
    assert done.status == 0, done.printed
    return types.SimpleNamespace(kept=kept(folder), package=of.said['package'])


def over_link(folder, linked, command, file=HERE / 'try_words.py', **environment):
    tests, of_tests = words(folder, linked.folder, file)
    with plant_at(*command, **environment) as wire:
        done = controlled(wire.socket, tests, **of_tests)
    assert done.status == 0, done.printed
    return kept(folder)


@pytest.mark.parametrize('port', ('host', 'posix', 'cortex-m4f'))
def test_the_words_have_equal_results_over_the_link(in_process, linked, program, laboratory, tmp_path, port):
    """On the host in virtual and in real time, and on the board."""
    environment = {}
    if port == 'cortex-m4f':
        command, environment = linked_on_board(WORDS)
    else:
        command = [program(linked, *(f'port/{port}/*.c' if source == 'port/host/*.c' else source for source in LINKED),
                           by='tcc' if port == 'host' else 'clang')]
    now = over_link(tmp_path, linked, command, **environment)
    assert now == in_process.kept and sum(name == 'hash' for _, name, _ in now) > 3


def test_found_an_input_that_is_another(in_process, tmp_path):
    text = (HERE / 'try_words.py').read_text()
    assert 'wind=0.25)' in text
    other = path_of(text.replace('wind=0.25)', 'wind=0.2500001)'), tmp_path, 'test_planted.py')
    command, environment = words(tmp_path, in_process.package, other)
    assert run(*command, **environment).status == 0 and kept(tmp_path) != in_process.kept


def test_numpy_takes_the_arrays_without_a_copy(in_process):
    done = run(*PYTEST, HERE / 'try_numpy.py', PYTHONPATH=in_process.package)
    assert done.status == 0 and ' passed' in done.printed, done.printed


def test_the_wheel_of_this_platform_has_the_plant_with_its_library(in_process, tmp_path):
    build_it = 'import sys; import words_plant_wheel; print(words_plant_wheel.build_wheel(sys.argv[1]))'
    wheel = run('python3', '-c', build_it, tmp_path, cwd=in_process.package).printed.strip()
    zipfile.ZipFile(tmp_path / wheel).extractall(tmp_path / 'installed')
    done = run('python3', '-c', 'import words_plant; assert words_plant.Plant().start().cart == 0', PYTHONPATH=str(tmp_path / 'installed'))
    assert done.status == 0, done.errors


def instances(package, digest):
    """Plants beside one another have this hash of 1500 ticks, or that of one alone."""
    module, = package.glob('*_plant')
    done = run('python3', '-B', HERE / 'instances.py', module.name, digest, 1500, PYTHONPATH=str(package))
    assert done.status == 0, done.errors


def test_plants_beside_one_another_with_policies_and_a_fault_at_a_time(package, tmp_path):
    text = (ROOT / 'models/cart_pole_drive.scene').read_text().replace('"parts/', f'"{ROOT}/models/parts/')
    text += 'overrun degrade { drop rub; method heun; hold; after 9 ticks }; histogram; publish next_tick; at 0.3 s set drive.open = 1\n'
    instances(package(path_of(text, tmp_path, 'policies.scene')), 'alone')


def test_likewise_in_double_with_steps_that_are_made_again_that_of_a_run(package, isoc, program, tmp_path):
    text = (ROOT / 'models/hopper.scene').read_text() + '\nchecked yes\n'
    alone = program(isoc(text, '--real', 'double', '--method', 'abm4'), *LOOP, 'core/application/main.c', real='double')
    digest = traced(tmp_path / 'run', alone, 1500000000).said['hash']
    instances(package(path_of(text, tmp_path, 'checked.scene'), real='double', method='abm4'), digest)


@pytest.mark.parametrize('option', ('--link', '--standalone', '--shape', '--name cart'))
def test_isoc_refuses_what_a_package_cannot_be_beside(isoc, option):
    of = isoc(WORDS, '--python', *option.split())
    assert of.status == 1 and not of.folder.exists()
    assert '--python makes a whole program: leave out --name' in of.errors or option != '--name cart'


@pytest.fixture
def lanes(isochron, package, tmp_path):
    """lanes(count, real): what pytest says of so many plants side by side, with another library too."""
    def of(count, real, library=None):
        folder = tmp_path / real
        if not library:
            made = isochron('python', CART, '--out', folder, '--lanes', count, '--real', real)
            assert made.status == 0, made.errors
        path = f'{ROOT}/tools/python:{package(CART, real=real)}'
        return run(*PYTEST, HERE / 'try_lanes.py', PYTHONPATH=path, PYTHONDONTWRITEBYTECODE='1',
                   LANES_LIBRARY=str(library or folder / 'lanes/lanes.so'))

    return of


@pytest.mark.parametrize('real, count', (('float', 8), ('double', 4)))
def test_each_lane_has_the_outputs_and_the_hash_of_the_plant_alone(lanes, tmp_path, real, count):
    """Control: a restart of one row."""
    done = lanes(count, real)
    assert done.status == 0, done.printed
    if real == 'double':
        text = (ROOT / 'tools/python/lanes.c').read_text()
        assert 'side->lanes.plant.lane_bytes, mask' in text
        planted = path_of(text.replace('side->lanes.plant.lane_bytes, mask', 'sizeof(real), mask'), tmp_path, 'lanes.c')
        build.host_program(tmp_path / 'planted.so', [planted, ROOT / 'core/numbers/self_check.c'],
                           ['-O1', '-Wno-psabi', '-fPIC', '-shared', '-DISO_REAL_DOUBLE', '-DISO_LANES=4', '-Wno-error',
                            '-iquote', tmp_path / 'double/lanes'])
        assert re.search('FAILED.*test_steps_and_restarts', lanes(count, real, tmp_path / 'planted.so').printed)


def test_lanes_without_inputs_and_tunables_and_with_inputs_that_are_functions_of_time(isochron, tmp_path):
    text = (ROOT / 'models/pendulum.scene').read_text()
    free = path_of(re.sub('^input .*|.*drive .*', '', text, flags=re.M), tmp_path, 'free.scene')
    for scene, count, name in ((free, 16, 'free'), (WORDS, 2, 'words')):
        assert isochron('python', scene, '--out', tmp_path / name, '--lanes', count).status == 0
    done = run(sys.executable, '-c', '''import sys, lanes
free, words = (lanes.Lanes(path) for path in sys.argv[1:])
assert free.count == 16 and not free.inputs and not free.tunables and free.record(9)["theta"].shape == (10, 16)
assert list(words.inputs) == ["force"] and words.step(force=1.5)''', *(tmp_path / name / 'lanes/lanes.so' for name in ('free', 'words')),
               PYTHONPATH=f'{ROOT}/tools/python')
    assert done.status == 0, done.errors
