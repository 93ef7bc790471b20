"""A plant and a controller with a wire between them: in lockstep the hash is that without a wire, on the host and on the
board, of a controller in C and of one in Python; another plant is refused; without a link nothing of all this is
there."""
import contextlib
import random
import re
import select
import socket
import threading

import numpy as np
import pytest
from link import CONTROLLERS, alone, balance, cart, controller_of, is_refused, law

from harness.programs import LINKED, client_of, controlled, hash_of, linked_on_board, plant_at, run
from harness.project import ROOT
from lab import build

NUMBERS = {'float': np.float32, 'double': np.float64}
ROTOR = (CONTROLLERS / 'rotor.scene').read_text()


@pytest.fixture(scope='module')
def made(isoc, program, tmp_path_factory):
    """made(real): what isoc makes of the cart, its `program` with a link, its `client` and a `controller` in C."""
    kept = {}

    def of(real):
        if real not in kept:
            kept[real] = cart_made = isoc(cart(tmp_path_factory.mktemp('cart')), '--link', '--real', real)
            cart_made.program = program(cart_made, *LINKED, real=real)
            cart_made.client = client_of(cart_made.folder)
            cart_made.controller = controller_of(program, 'controller', cart_made, real)
        return kept[real]

    return of


@pytest.fixture(scope='module')
def expected(plant, tmp_path_factory):
    """expected(real, ticks): the hash without a wire, and what a controller says at the end."""
    def of(real, ticks):
        rows, pole = alone(plant(cart(tmp_path_factory.mktemp('alone')), '--link', real=real), ticks, NUMBERS[real])
        return hash_of(rows), f'hash {hash_of(rows)} pole {pole:.6g}\n'

    return of


@pytest.mark.parametrize('real', NUMBERS)
def test_the_hash_is_that_without_a_wire_from_c_and_from_python(made, expected, real):
    _, said = expected(real, 3000)
    with plant_at(made(real).program) as wire:
        done = controlled(wire.socket, [made(real).controller, 3000])
    assert done.printed == said, done.errors
    with plant_at(made(real).program) as wire, made(real).client.Link(wire.address) as link:
        y = balance(link, link.start('lockstep', 3000), 2999, NUMBERS[real])
        assert link.exchange(force=float(law(y, NUMBERS[real]))) is None
    assert f'hash {link.end["hash"]:016x} pole {link.outputs.pole:.6g}\n' == said


@pytest.mark.parametrize('real', NUMBERS)
def test_a_program_that_is_told_how_long_to_run_writes_its_trace_and_ends(made, expected, tmp_path, real):
    command = [ROOT / 'build/trace', '-o', tmp_path, '--', made(real).program, 3 * 10**9]
    with plant_at(*command, is_endless=False) as wire:
        done = controlled(wire.socket, [made(real).controller, 0])
    assert done.status == 0 and wire.plant.status == 0 and wire.plant.said['hash'] == expected(real, 3000)[0]
    assert len((tmp_path / 'trace.csv').read_text().splitlines()) == 3002


@contextlib.contextmanager
def bad(wire, seed):
    """A wire of which one byte of 270 has a bit turned, is left out, or has another before it: its controller's end, and
    the damages so far."""
    ours, its = socket.socketpair()
    chance, damages = random.Random(seed), []

    def passed_on(data):
        for byte in data:
            kind = chance.randrange(800)
            if kind < 3:
                damages.append(kind)
            yield from ([byte ^ 1 << chance.randrange(8)], [], [chance.randrange(256), byte])[kind] if kind < 3 else [byte]

    def work():
        other = {ours: wire, wire: ours}
        with contextlib.suppress(OSError):
            while True:
                for end in select.select(list(other), [], [])[0]:
                    data = end.recv(256)
                    if not data:
                        return
                    other[end].sendall(bytes(passed_on(data)))

    worker = threading.Thread(target=work)
    worker.start()
    yield its, damages
    its.close()
    worker.join()
    ours.close()


@pytest.mark.parametrize('by', ('C', 'Python'))
def test_over_a_bad_wire_all_is_sent_again_until_it_has_come(made, expected, by, seed):
    """But for the outputs of the last tick, behind which the end comes."""
    of = made('float')
    with plant_at(of.program) as wire, bad(wire.socket, seed) as (end, damages):
        if by == 'C':
            done = controlled(end, [of.controller, 500, 10])
            digest = done.printed.split()[1] if done.status == 0 else done.errors
        else:
            client = client_of(of.folder)
            client.PATIENCE = 0.01
            with client.Link(f'fd:{end.detach()}') as link:
                y = link.start('lockstep', 500)
                while y:
                    y = link.exchange(force=float(law(y)))
            digest = f'{link.end["hash"]:016x}'
    assert damages and digest == expected('float', 500)[0]


def test_in_c_a_run_that_is_ended_the_same_again_and_a_free_one(made, program):
    with plant_at(made('float').program) as wire:
        done = controlled(wire.socket, [controller_of(program, 'again', made('float'))])
    assert done.status == 0, done.printed + done.errors


def test_in_python_likewise_and_what_is_refused(made):
    client = client_of(made('float').folder)

    def ended(link, exchanges):
        balance(link, link.start('lockstep'), exchanges)
        end = link.stop()
        assert end['ticks'] == exchanges and link.stop() is end
        return end['hash']

    with plant_at(made('float').program) as wire, client.Link(wire.address) as link:
        assert ended(link, 100) == ended(link, 100)
        y, last = link.start('free', 20000), -1
        while y:
            assert link.tick > last
            last = link.tick
            y = link.exchange(force=0.0)
        assert link.end['ticks'] == 20000 and link.end['link_inputs'] > 0 and link.end['margin'] > 0
        assert link.end['link_inputs'] + link.end['link_missing'] >= 20000
        link.start('lockstep', 10)
        with pytest.raises(client.LinkError, match='^no input is called push; there are: force$'):
            link.exchange(push=1.0)
        client.IDENTITY ^= 1
        assert is_refused(client, 'refused: another plant', link.start, 'lockstep', 10)
    assert client.INPUTS == {'force': ('N', -20, 20)} and client.OUTPUTS['pole_speed'][0] == 'rad/s'


def test_a_controller_has_the_words_of_the_end_that_core_has(made, program):
    words = run(program(CONTROLLERS / 'words.c')).printed.split()
    header = made('float').file('cart_pole_link.h')
    listed = re.search(r'#define ISO_CLIENT_WORDS((?:.*\\\n)*.*)', header)[1]
    assert re.findall(r'X\(([a-z_]+)\)', listed) == words and list(made('float').client.END) == words and 'late' in words


@pytest.mark.parametrize('option', ('--standalone', '--name cart'))
def test_a_link_makes_a_whole_program(isoc, tmp_path, option):
    of = isoc(cart(tmp_path), '--link', *option.split())
    assert of.status == 1 and not of.folder.exists() and 'makes a whole program: leave out' in of.errors


def long(outputs):
    return ROTOR + ''.join(f'output long_{i} = speed of shaft\n' for i in range(outputs))


def test_the_longest_frame_is_what_a_channel_takes_at_once(isoc, program):
    """With the two of the rotor 506 floats, or 253 doubles, are what a frame has room for. Control: a channel that takes
    less than its 2046 bytes."""
    interface = isoc(long(504), '--link').folder / 'interface.c'
    program(interface, by='gcc', link=['-shared'], flags=['-fPIC'])
    less = {'port/channel.h': ('ISO_CHANNEL_BYTES = 2048', 'ISO_CHANNEL_BYTES = 2045')}
    with pytest.raises(AssertionError, match='a channel takes a frame at once'):
        program(interface, by='gcc', link=['-shared'], flags=['-fPIC'], planted=less)
    of = isoc(long(505), '--link')
    assert of.refused and not of.folder.exists() and of.errors.endswith(
        'plant.scene: error: a frame of its 507 outputs has 2050 bytes, and a channel takes 2048 at once; leave some of them '
        'out, or read them over XCP\n')
    assert isoc(long(251), '--link', '--real', 'double').status == 0 and isoc(long(252), '--link', '--real', 'double').refused


@pytest.mark.parametrize('other, options', (('another step', '--step 2ms'), ('another method', '--method heun'),
                                            ('another time of a safe value', ''), ('another type of numbers', '--real double'),
                                            ('the same plant', '')))
def test_a_controller_of_another_plant_is_refused(made, isoc, program, tmp_path, other, options):
    statement = 'input force in -20 N to 20 N safe 0 N after 5 ticks'
    scene = cart(tmp_path, statement.replace('5 ticks', '6 ticks') if 'safe' in other else statement)
    real = 'double' if 'numbers' in other else 'float'
    with plant_at(program(isoc(scene, '--link', *options.split()), *LINKED, real=real)) as wire:
        done = controlled(wire.socket, [made('float').controller, 10])
    if other == 'the same plant':
        assert done.status == 0
    else:
        assert done.status == 1 and 'another plant, method, step or type' in done.errors


def test_on_the_board_the_hash_is_that_of_the_host(made, expected, laboratory, tmp_path):
    """UART0 is the wire. 300 ticks, since a byte takes QEMU 0.1 ms."""
    command, environment = linked_on_board(cart(tmp_path))
    with plant_at(*command, **environment) as wire:
        done = controlled(wire.socket, [made('float').controller, 300])
    assert done.printed == expected('float', 300)[1], wire.plant.errors


def test_a_firmware_without_a_link_has_no_byte_of_one(made, program, laboratory, tmp_path):
    """It is the same whether what a link needs stands beside it or not. Control: one with a link."""
    linked = build.port('cortex-m4f', kind='linked').facts['SOURCES'].split()
    plain = build.port('cortex-m4f').facts['SOURCES'].split()
    more = [source for source in linked if source not in plain]
    plant_c, interface = (made('float').folder / name for name in ('plant.c', 'interface.c'))

    def image(*sources):
        elf = program(*sources, target='cortex-m4f')
        assert run('arm-none-eabi-objcopy', '-O', 'binary', elf, elf.with_suffix('.bin')).status == 0
        return elf.with_suffix('.bin').read_bytes()

    assert 'core/link/main.c' in more
    alone = image(plant_c, *plain)
    assert alone == image(plant_c, *plain, interface, *(source for source in more if source != 'core/link/main.c'))
    assert alone != image(plant_c, interface, *linked)


def test_the_plant_with_a_link_is_that_without(made, isoc, tmp_path):
    without = isoc(cart(tmp_path))
    assert without.files() == {name: made('float').file(name) for name in ('plant.c', 'plant.h')}


def test_a_safe_value_changes_no_byte_of_the_plant_but_the_line_of_the_scene(isoc, tmp_path):
    never = isoc(cart(tmp_path, 'input force')).file('plant.c')
    safe = isoc(cart(tmp_path, 'input force safe 0 N after 5 ticks')).file('plant.c')
    assert safe != never and safe.replace(' safe 0 N after 5 ticks', '') == never


@pytest.mark.parametrize('old, new', (
    ('link->age >= wire->after', 'link->age > wire->after'),
    ('answers + 1 < link->answered', 'answers + 1 <= link->answered'),
    ('answers > tick', 'answers >= tick'),
    ('late += answers < ', 'late += answers + 1 < '),
    (' keep_admitted(link);', ' (void)keep_admitted;'),
    ('identity != link->interface->identity', 'identity == 0'),
    ('iso_loop_rest(loop);', ';')))
def test_the_script_of_a_wire_finds(program, old, new):
    """Defects of core/link/link.c, by tests/core/link/link.c."""
    planted = program('tests/core/link/link.c', 'tests/tap.c', 'port/host/*.c', 'port/unix/console.c', by='clang',
                      planted={'core/link/link.c': (old, new)})
    assert run(planted).finds()
