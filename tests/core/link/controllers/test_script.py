"""A controller that sets tunables and faults at random ticks of a run: what acts in a step to the bit as `at T set` in the
scene, from C and from Python, on the host and on the Cortex-M4F. The example of models/hil: ten faults from one snapshot, with pytest."""
import random
import re
import shlex
import zipfile

import pytest
from link import controller_of, is_refused

from harness.programs import LINKED, client_of, controlled, linked_on_board, path_of, plant_at, run
from harness.project import ROOT

TICKS = 1500
SCENE = (ROOT / 'models/hil/faults.scene').read_text().replace('"../parts/', f'"{ROOT}/models/parts/')
# Those that no output and no memory reads.
PARTS = 'sag supply drive'.split()
EXAMPLE = ROOT / 'models/hil/test_faults.py'


def with_tunable():
    """The scene with a tunable that has limits."""
    text = re.sub('^effect sag weak {', r'\g<0>\n    part reach', SCENE, flags=re.M)
    text = re.sub('^constant pole_start .*', r'\g<0>\ntunable reach = 0.5 in 0 to 1', text, flags=re.M)
    assert text.count('reach') == 2
    return text


def schedule_of(seed):
    """Twelve changes, (tick, name, value) in their order: of faults, of a part that opens, and of the tunable."""
    chance, changes = random.Random(seed), []
    for i in range(12):
        part = chance.choice(PARTS)
        tick, value = chance.randrange(1, TICKS), 0.37 if chance.random() < 0.3 else chance.randrange(2)
        changes.append((tick, 'reach', round(chance.random(), 4)) if i % 4 == 3 else
                       (tick, f'{part}_{"open" if part == "drive" else "active"}', value))
    return sorted(changes, key=lambda change: change[0])


def at(tick, name, value):
    """The same in the scene."""
    return f'at {tick} ms set ' + (f'reach = {value}' if name == 'reach' else f'{name.replace("_", ".")} = {value:g}')


def text_of(schedule):
    return ''.join(f'{tick} {name} {value:g}\n' for tick, name, value in schedule)


@pytest.fixture(scope='module')
def made(isoc, program, tmp_path_factory):
    """made(*statements): the plant of the scene with these behind it; one is compiled once."""
    kept = {}

    def of(*statements):
        if statements not in kept:
            folder = tmp_path_factory.mktemp('script')
            kept[statements] = it = isoc(path_of('\n'.join([with_tunable(), *statements, '']), folder, 'script.scene'), '--link')
            assert it.status == 0, it.errors
            it.program, it.controller = program(it, *LINKED), controller_of(program, 'script', it)
        return kept[statements]

    return of


def from_c(made, schedule, folder):
    with plant_at(made.program) as wire:
        done = controlled(wire.socket, [made.controller, path_of(text_of(schedule), folder, 'schedule'), TICKS])
    assert done.status == 0, done.errors
    return done.printed.strip()


def balanced(link, schedule):
    """The hash of a run that the controller balances, with these changes."""
    y = link.start('lockstep')
    while link.tick < TICKS:
        for _, name, value in (change for change in schedule if change[0] == link.tick):
            assert link.set(name, value) == link.tick
        y = link.exchange(command=min(max(30 * y.measured_pole + 2 * y.measured_cart, -12), 12))
    return f'{link.state().hash:016x}'


def from_python(command, client, schedule, **environment):
    with plant_at(*command, **environment) as wire, client.Link(wire.address) as link:
        return balanced(link, schedule)


@pytest.fixture
def schedule(seed):
    return schedule_of(seed)


def test_what_is_set_over_the_link_is_to_the_bit_as_in_the_scene(made, laboratory, tmp_path, schedule):
    """Control: the same one tick later."""
    over_link, in_scene = made(), made(*(at(*change) for change in schedule))
    assert from_c(over_link, schedule, tmp_path) == from_c(in_scene, [], tmp_path)
    client = client_of(over_link.folder)
    digest = from_python([over_link.program], client, schedule)
    assert digest == from_python([in_scene.program], client_of(in_scene.folder), [])
    later = [(tick + 1, name, value) for tick, name, value in schedule]
    assert digest != from_python([over_link.program], client, later)
    command, environment = linked_on_board(path_of(with_tunable(), tmp_path, 'script.scene'))
    assert digest == from_python(command, client, schedule, **environment)


def test_an_output_has_what_is_set_from_the_next_tick_on(made):
    with plant_at(made().program) as wire, client_of(made().folder).Link(wire.address) as link:
        y = link.start('lockstep')
        link.set('shift_active', 1)
        after = link.exchange(command=0)
        assert abs(y.measured_cart - y.cart) < 1e-6 and abs(after.measured_cart - after.cart - 0.1) < 1e-6


def test_from_a_wheel_the_client_is_the_same(made, tmp_path):
    folder = made().folder
    build = 'import sys; import script_link_wheel; print(script_link_wheel.build_wheel(sys.argv[1]))'
    wheel = tmp_path / run('python3', '-B', '-c', build, tmp_path, cwd=folder).printed.strip()
    assert zipfile.ZipFile(wheel).testzip() is None
    zipfile.ZipFile(wheel).extract('script_link.py', tmp_path)
    assert (tmp_path / 'script_link.py').read_text() == (folder / 'script_link.py').read_text()
    done = run('python3', '-B', '-c', 'import script_link; print(script_link.IDENTITY)', PYTHONPATH=str(wheel))
    assert int(done.printed) == client_of(folder).IDENTITY


def test_tunables_and_counts_can_be_read_and_what_is_wrong_is_refused(made):
    plant = client_of(made().folder)
    with plant_at(made().program) as wire, plant.Link(wire.address) as link:
        assert is_refused(plant, 'no run', link.set, 'reach', 0.1)
        digest, counts = balanced(link, []), link.counts()
        assert counts['ticks'] == counts['link_inputs'] == counts['tick'] == TICKS and f'{counts["hash"]:016x}' == digest
        assert counts['tunables_clamped'] == counts['tunables_held'] == 0
        assert is_refused(plant, 'no tunable is called', link.set, 'reech', 0.1)
        assert is_refused(plant, 'no tunable is called', link.get, 'reech')
        # A tunable as it is set, and as the next step has it within its limits; one that is not finite stays.
        link.set('reach', 7)
        assert link.get('reach') == 7
        link.exchange(command=0)
        assert abs(link.get('reach') - plant.TUNABLES['reach'][2]) < 1e-7 and link.counts()['tunables_clamped'] == 1
        link.set('drive.open', float('nan'))
        before = link.get('drive_open')
        link.exchange(command=0)
        assert before != before and link.get('drive_open') in (0, 1) and link.counts()['tunables_held'] == 1
        link.reset()
        assert abs(link.get('reach') - 0.5) < 1e-7 and link.counts()['ticks'] == 0
        link.run()
        assert link.stop()['ticks'] == 0


@pytest.mark.parametrize('planted', (False, True))
def test_the_worked_example_passes_as_its_head_says(tmp_path, planted):
    """Control: a fault that is not switched on."""
    command = re.search('^    tools/isochron link (.*)$', EXAMPLE.read_text(), re.M)[1]
    test, results = EXAMPLE.parent, tmp_path / 'faults.xml'
    if planted:
        test = path_of(EXAMPLE.read_text().replace('drive.open", 1', 'drive.open", 0'), tmp_path, 'test_planted.py')
    command = command.replace(' models/hil --', f' {test} -p no:cacheprovider --').replace('build/faults.xml', str(results))
    assert str(test) in command and str(results) in command
    done = run(ROOT / 'tools/isochron', 'link', *shlex.split(command), '--out', tmp_path / 'plant', PYTHONDONTWRITEBYTECODE='1',
               TEST_BUILT='yes', PYTEST_ADDOPTS='')
    assert f'failures="{int(planted)}"' in results.read_text(), done.errors
    if not planted:
        assert re.search('^[= ]*10 passed', done.printed, re.M) and done.said['link_inputs'] == '17000'
        assert 'tests="10"' in results.read_text()
