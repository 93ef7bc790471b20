"""FMUs for model exchange, by an importer of the project's own (exchange.py): its steps end where those of the plant end;
directional derivatives are central differences, and those of isoc --linear; calls that are wrong. A scene of functions of
time, one of slides alone, in float, a closed loop, and twenty random ones. What has no such equations is refused, by its
line."""
import pytest

from harness.programs import path_of, run
from harness.project import ROOT

HERE = 'tests/tools/fmu/'
MODELS, SEEDS = ROOT / 'models', range(1, 21)
TAP = ['python3', '-B']
DOUBLE, FLOAT = ['--real', 'double'], ['--real', 'float']
HEAD = '''step 1 ms
body b { mass 1 kg; com (1, 0, 0) m; inertia (1, 1, 1) kg*m^2 }
joint j revolute { parent ground; child b; axis z; continuous }
output q = position of j
'''
GEAR = '''joint k revolute { parent ground at (3, 0, 0) m; child c; axis z }
body c { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
joint l revolute { parent ground at (6, 0, 0) m; child d; axis z; start 10 deg }
body d { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
'''


@pytest.fixture(scope='module')
def archives(isoc, archive, tmp_path_factory):
    """FMUs by name, of those by hand compiled with all warnings; random ones have numbers."""
    folder = tmp_path_factory.mktemp('random')
    assert run(*TAP, 'tests/isoc/linear/linear_scene.py', folder, *SEEDS).status == 0
    loop = path_of('stabilisation baumgarte\n' + (MODELS / 'four_bar.scene').read_text(), folder, 'four_bar.scene')
    made = {name: archive(scene, 3, '--exchange', *options, by='strict') for name, scene, options in (
        ('crane', MODELS / 'crane.scene', DOUBLE), ('euler', MODELS / 'double_pendulum.scene', [*DOUBLE, '--method', 'euler']),
        ('loop', loop, DOUBLE), ('car', MODELS / 'quarter_car.scene', FLOAT))}
    for seed in SEEDS:      # every fourth one is a closed loop
        scene = folder / f'{seed}.scene'
        scene.write_text(scene.read_text() + 'stabilisation baumgarte\n')
        made[seed] = archive(scene, 3, '--exchange', *DOUBLE, by='tcc')
    return made


def test_its_steps_end_where_those_of_the_plant_end(archives, isoc, proves):
    matrices = isoc(MODELS / 'crane.scene', '--linear').folder / 'matrices.tsv'
    proves(*TAP, HERE + 'exchange.py', *(word for name, fmu in archives.items() for word in (fmu, matrices if name == 'crane' else '-')))


def test_every_call_in_every_state(archives, proves):
    proves(*TAP, HERE + 'exchange_states.py', *(archives[name] for name in ('loop', 'crane', 'car')))


@pytest.mark.parametrize('where, what, lines', (
    ('5:12', 'this previous is a value of an earlier tick; take a state', 'output o = previous(speed of j)'),
    ('5:12', 'this delay is a value of an earlier tick; take a state', 'output o = delay(speed of j, 10 ms)'),
    ('5:12', 'this sample is taken at ticks; take a state', 'output o = sample(speed of j, every 10 ms)'),
    ('5:8', "the output 'e' is of a step of the method; leave it out", 'output e = local_error'),
    ('5:8', "the output 'v' is of every 4th tick; leave out 'every'", 'output v = speed of j every 4 ticks'),
    ('5:8', "the output 'g' counts turns at the end of each step; leave it out", 'output g = turns of j'),
    ('10:8', "the memory 'hold_m' changes at ticks; take a state", 'effect holding {\n    memory m = 0\n    next m = m + 1\n'
     '    output o = m\n}\neffect hold holding {}\noutput o = hold.o'),
    ('5:7', "the projection moves the states at the end of each step; take 'stabilisation baumgarte'",
     'close g gear { first k; second l; ratio -2 }\n' + GEAR),
    ('5:15', "the projection moves the states at the end of each step; take 'stabilisation lagrangian { omega ... }'",
     'stabilisation lagrangian\nclose g gear { first k; second l; ratio -2 }\n' + GEAR)))
def test_refused(isoc, where, what, lines):
    """For model exchange; it has co-simulation."""
    of = isoc(f'{HEAD}{lines}\n', '--fmu', '--exchange')
    assert of.status == 1 and not of.folder.exists() and f'plant.scene:{where}: error: no model exchange: {what}' in of.errors
    alone = isoc(f'{HEAD}{lines}\n', '--fmu')
    assert alone.status == 0
    assert f'plant.scene:{where}: warning: no model exchange, co-simulation alone: {what}' in alone.errors.splitlines()[0]


def test_what_has_co_simulation_alone_makes_no_instance_for_model_exchange(archive, proves):
    proves(*TAP, HERE + 'exchange.py', '--alone', archive(HEAD + 'output g = turns of j\n', 3, *DOUBLE, by='strict'))
