"""isochron sweep side by side: its table, its failures and its summary are, byte for byte, those of runs one by one."""
import functools
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import tempfile

import pytest

CART = pathlib.Path('models/cart_pole.scene').read_text()
LIMITED = re.sub('^tunable rail_damping.*', r'\g<0> in 0 N*s/m to 0.2 N*s/m', CART, flags=re.M)
PENDULUM = pathlib.Path('models/double_pendulum.scene').read_text()
TILTED = 'constant tilt = 90 deg\ntunable weight = 1 kg\n' + PENDULUM.replace('start 90 deg', 'start tilt').replace('mass 1 kg', 'mass weight', 1)
NEAR = ('tunable push = 0 N*m\ninput along N*m = push\n' + pathlib.Path('tests/isoc/closure/singular/near_dead.scene').read_text().replace(
    'joint A revolute {', 'joint A revolute { drive along;') + 'stabilisation projection { near stop }\n')
# A step is made again where the cart meets the wall; a fault at a time of its own; a memory that a row sets.
WALL = '''step 1 ms
checked yes
tunable stiff = 10 kN/m
tunable place = 0.1 m
body cart { mass 1 kg }
joint rail prismatic { parent ground; child cart; axis x; speed 1 m/s }
effect wall { joint along; value edge m; value hard N/m; effort on along = -hard * max(position of along - edge, 0) }
effect hit wall { along rail; edge place; hard stiff }
signal where = position of rail
output now = position of rail
output before = delay(where, 20 ms)
'''
# A spring that pushes where it should pull; a number that begins without a value, and has one later; a condition.
PUSHED = '''step 1 ms
tunable pull = 1 N/m
tunable least = 1
tunable most = 2
input kick N = 1 N
effect held { joint on; value k N/m; value low 1; value high 1; require low <= high; effort on on = -k * position of on * 1000 }
body block { mass 1 kg }
joint rail prismatic { parent ground; child block; axis x; start 0.5 m; drive kick; }
effect by held { on rail; k pull; low least; high most }
output place = position of rail
output inverse = 1 / (position of rail - 0.5 m)
'''
DRIVE = pathlib.Path('models/cart_pole_drive.scene').read_text().replace(
    '"parts/', f'"{pathlib.Path("models/parts").resolve()}/')
SHOWS = 'hash; ticks; restarts'
# name: scene, options, what must stand in the table.
SWEEPS = {
    'random': (CART, dict(set='rod_mass = uniform(100, 300) g; half_length = normal(250, 20) mm', runs='37', seconds='0.5',
                          of=f'max pole; min pole; peak pole_speed; mean energy; rms pole; final cart_position; {SHOWS}'), 'ok'),
    'double': (CART, dict(set='rod_mass = uniform(100, 300) g', runs='23', seconds='0.5', real='double',
                          of='rms energy; mean pole; peak pole'), 'ok'),
    'refused values': (LIMITED, dict(set='rail_damping = normal(0.1, 0.1) N*s/m', runs='50', seconds='0.2',
                                     of=f'mean energy; {SHOWS}'), 'refused: a value'),
    'all refused': (LIMITED, dict(set='rail_damping = 1 .. 2 N*s/m by 20', seconds='0.2', of=f'max pole; {SHOWS}'),
                    'refused: a value'),
    'several plants': (CART, dict(set='rod_mass = 0.1 .. 0.3 kg by 11; method = rk4, bdf4', seconds='0.2',
                                  of=f'max pole; {SHOWS}', lanes='4'), 'bdf4'),
    'starts': (TILTED, dict(set='tilt = 1 .. 90 deg by 11; weight = 1, 2 kg; method = heun, rk4', seconds='0.3', of=f'max elbow_angle; {SHOWS}',
                            lanes='8'), 'ok'),
    'restarts': (WALL, dict(set='stiff = 1, 5 .. 50 kN/m by 9; place = 0.05 .. 0.15 m by 3', method='ab4', seconds='0.4', real='double',
                            of=f'max now; min before; {SHOWS}'), r'\t[1-9]\d*\tok'),
    'guard': (PUSHED, dict(set='pull = -3 .. 3 N/m by 45; least = 1, 2, 3', seconds='3', of=f'max place; mean inverse; {SHOWS}'),
              'not finite|out of range'),
    'singular': (NEAR, dict(set='push = -4 .. 8 N*m by 30', seconds='2', of=f'max violation; {SHOWS}'), 'near a singular position'),
    'drive': (DRIVE, dict(set='pole_start = 170, 175, 178 deg; drive.open = 0, 1; reading.active = 0, 1', seconds='1', method='abm4',
                          of=f'max current; {SHOWS}', lanes='32'), 'ok'),
}


@pytest.fixture(scope='module')
def sweep():
    """sweep(scene, options): what it said, the summary and the files, and the folder; each is made once."""
    place = pathlib.Path(tempfile.mkdtemp(prefix='sweep', dir='build/tests'))  # other workers have theirs
    folders = []

    @functools.cache
    def call(scene, **variables):
        path = place / f'scene{len(folders)}.scene'
        path.write_text(scene)
        folders.append(pathlib.Path('build/sweep') / str(path.with_suffix('')).replace('/', '+'))
        said = subprocess.run(['tools/isochron', 'sweep', path, *(word for name, value in variables.items()
                                                                  for word in (f'--{name}', value))],
                              capture_output=True, text=True)
        names = ('sweep.tsv', 'failures.txt') if said.returncode == 0 else ()
        files = [(folders[-1] / name).read_text().replace(str(path), 'SCENE') for name in names]
        counts = [line for line in said.stdout.splitlines() if line.split()[0] in ('runs', 'plants', 'failed')]
        return said, counts + files, folders[-1]

    yield call
    for folder in [place, *folders]:
        shutil.rmtree(folder, ignore_errors=True)


def lanes_of(folder):
    """How many runs the program makes at once, by what it is made of."""
    return 16 if 'side.c' in next(folder.glob('*/steps.c')).read_text() else 1


@pytest.mark.seeds(len(SWEEPS), 4)
def test_the_same_table(sweep, seed):
    scene, variables, seen = list(SWEEPS.values())[seed - 1]
    said, side, folder = sweep(scene, **variables)
    assert said.returncode == 0, said.stderr
    assert lanes_of(folder) > 1, said.stderr
    assert re.search(seen, side[-2]), side[-2]
    assert side == sweep(scene, **dict(variables, lanes='1'))[1]


OF_CART = dict(set='rod_mass = uniform(100, 300) g', runs='40', seconds='0.1', of='max pole; hash')


def test_it_goes_on_after_parts_that_are_there(sweep):
    whole, folder = sweep(CART, **OF_CART)[1:]
    parts = sorted(folder.glob('*/parts/*.tsv'))
    assert [len(part.read_text().splitlines()) for part in parts] == [16, 16, 8]
    parts[1].unlink()
    said = subprocess.run([*made_again(folder), 'absent'], capture_output=True, text=True, check=True)
    assert said.stdout.split() == ['1']
    subprocess.run([*made_again(folder), 'make', '2'], check=True)
    assert ''.join(part.read_text() for part in parts) in whole[-2]


def made_again(folder):
    program = next(folder.glob('*/program'))
    return [program, program.parent]


@pytest.fixture(scope='module')
def guarded(sweep):
    """The folder of a sweep in lanes, and the lines that its runs have one by one."""
    scene, variables, _ = SWEEPS['guard']
    return sweep(scene, **variables)[2], sweep(scene, **dict(variables, lanes='1'))[1][-2].split('\n', 1)[1]


def planted(folder, *flags):
    """The program of a sweep, whose side.c is compiled with these flags."""
    folder = next(folder.glob('*/program')).parent
    objects = [path for path in folder.glob('*.o') if path.name != 'steps.o']
    shared = [f'build/obj/host/float/{name}.o' for name in (
        'tools/sweep/main', 'tools/sweep/parts', 'tools/sweep/plan', 'tools/sweep/run', 'tools/sweep/table', 'tools/table/table',
        'tools/file/file', 'tools/trace/decimal')]
    subprocess.run(['gcc', '-std=c11', '-O1', '-ffp-contract=off', '-march=native', '-Wno-psabi', '-DISO_LANES=16', '-I.', *flags,
                    'tools/sweep/side.c', *objects, *shared, '-lm',
                    '-o', folder / 'planted'], check=True)
    return folder / 'planted'


@pytest.mark.seeds(5, 2)
def test_found_a_defect_side_by_side(guarded, seed):
    """tools/sweep/side.c with a defect of off.h; defect 0 is none."""
    defect = seed - 1
    folder, sound = guarded
    parts = sorted(folder.glob('*/parts/*.tsv'), key=lambda part: int(part.stem))
    program = planted(folder, f'-DOFF={defect}', '-include', 'tests/tools/sweep/off.h')
    for part in parts:
        part.unlink()
    subprocess.run([program, program.parent, 'make', '1'], check=True)
    assert (''.join(part.read_text() for part in parts) == sound) == (defect == 0)


def test_found_lanes_with_other_bits(guarded):
    """All constants of side.c are others: what it checks before any run."""
    program = planted(guarded[0], '-include', 'tests/isoc/emit/lanes/off.h')
    said = subprocess.run([program, program.parent, 'make', '1'], capture_output=True, text=True)
    assert said.returncode == 1 and 'a flag of the compiler changes the bits of results' in said.stderr


def test_one_by_one_where_isoc_has_no_lanes(sweep):
    said, _, folder = sweep(CART, set='method = rk4, adams; rod_mass = 0.1 .. 0.3 kg by 8', seconds='0.1', of='hash')
    assert said.returncode == 0 and lanes_of(folder) == 1
    assert 'the runs are made one by one: --lanes: the steps of each plant with adams are its own' in said.stderr


@pytest.mark.parametrize('runs, lanes', [(3, 1), (4, 16)])
def test_lanes_where_they_pay(sweep, runs, lanes):
    said, _, folder = sweep(CART, **dict(OF_CART, runs=str(runs)))
    assert said.returncode == 0 and lanes_of(folder) == lanes


def test_another_number_of_lanes_is_refused(sweep):
    said = sweep(CART, **OF_CART, lanes='5')[0]
    assert said.returncode != 0 and '--lanes 5 is unknown; it can be 1, 2, 4, 8, 16 or 32' in said.stderr


def test_another_processor_is_told(sweep):
    """The program gets the signal of an instruction that its processor has not."""
    folder = sweep(CART, **dict(OF_CART, seconds='1000'))[2]
    next(folder.glob('*/parts/0.tsv')).unlink()
    with subprocess.Popen([*made_again(folder), 'part', '0'], stderr=subprocess.PIPE, text=True) as process:
        while not next(folder.glob('*/parts/0.tsv.*'), None):
            assert process.poll() is None
        process.send_signal(signal.SIGILL)
        assert 'this processor lacks instructions' in process.stderr.read()
    assert process.returncode == 1


def seconds_of(folder):
    """Of the processor, for all parts of a sweep; the least of three times."""
    def once():
        for part in folder.glob('*/parts/*.tsv'):
            part.unlink()
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([*made_again(folder), 'make', '1'], check=True, capture_output=True)
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

    return min(once() for _ in range(3))


def test_five_times_as_fast(sweep):
    """Random values of the cart with its pole, a million steps."""
    if 'avx2' not in pathlib.Path('/proc/cpuinfo').read_text():
        pytest.skip('the vectors of this processor are short')
    variables = dict(OF_CART, runs='320', seconds='5', of='max pole')
    def of_lanes(lanes):
        said, _, folder = sweep(CART, **variables, lanes=lanes)
        assert said.returncode == 0, said.stderr
        return seconds_of(folder)

    alone, side = of_lanes('1'), of_lanes('16')
    assert alone / side >= 5, f'{alone} s one by one, {side} s side by side'
