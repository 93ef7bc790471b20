"""The plant in the process of a controller in C, by its library, with the words of the link: the same hash and the same
snapshots as over a wire, at ten times its speed at least. And snapshots that take the state of a controller along."""
import contextlib
import os
import re
import resource
import subprocess

import pytest
from link import INPUT, cart, controller_of, is_refused

from harness.programs import LINKED, client_of, controlled, plant_at, run
from lab import python

TICKS = 8200


@pytest.fixture(scope='module')
def made(isoc, program, tmp_path_factory):
    """The cart with its `program`, and controllers in C."""
    folder = tmp_path_factory.mktemp('cart')
    made = isoc(cart(folder, INPUT), '--link')
    made.program = program(made, *LINKED, by='clang')
    made.controllers = {name: controller_of(program, name, made) for name in ('controller', 'commands', 'kept')}
    return made


@pytest.fixture
def inside(laboratory, tmp_path):
    """inside(scene): the address of its plant in a process."""
    def of(scene):
        module, = python.package(scene, quiet=True, out=tmp_path / 'package').absolute().glob('*_plant')
        return f'plant:{module / "plant.so"}'

    return of


@contextlib.contextmanager
def spent():
    """The processor time of programs that have ended here, in a list."""
    def now():
        of = resource.getrusage(resource.RUSAGE_CHILDREN)
        return of.ru_utime + of.ru_stime

    before, seconds = now(), []
    yield seconds
    seconds.append(now() - before)


def test_the_hash_is_that_of_the_wire_at_ten_times_its_speed(made, inside, tmp_path):
    command = [made.controllers['controller'], TICKS]
    with spent() as by_wire, plant_at(made.program) as wire:
        done = controlled(wire.socket, command)
    address = inside(cart(tmp_path, INPUT))
    with spent() as in_process:
        alone = run(*command, ISOCHRON_LINK=address)
    assert done.status == alone.status == 0 and alone.printed == done.printed and 'hash' in done.printed
    print(f'{by_wire[0]:.3f} s over the wire, {in_process[0]:.3f} s in process')
    assert by_wire[0] > 10 * in_process[0]


def test_all_commands_and_snapshots_of_either_side(made, inside, proves, tmp_path):
    """A record that was taken in the process goes on over the wire, and the other way round."""
    address, commands = inside(cart(tmp_path, INPUT)), made.controllers['commands']
    first = run(commands, 'tick', tmp_path / 'record', 500, ISOCHRON_LINK=address)
    with plant_at(made.program) as wire:
        assert controlled(wire.socket, [commands, 'from', tmp_path / 'record', 500]).printed == first.printed != ''
    with plant_at(made.program) as wire:
        assert controlled(wire.socket, [commands, 'tick', tmp_path / 'other', 500]).printed == first.printed
    assert (tmp_path / 'other').read_bytes() == (tmp_path / 'record').read_bytes()
    proves(run(commands, 'all', tmp_path / 'other', ISOCHRON_LINK=address))


@pytest.mark.parametrize('other, why', (('scene', 'another plant, method, step or type of numbers'),
                                        ('file', 'the library of the plant'), ('nothing', 'the library of the plant')))
def test_another_library_is_refused(made, inside, tmp_path, other, why):
    address = inside(cart(tmp_path, INPUT.replace('20', '21'))) if other == 'scene' else f'plant:{tmp_path}/library.so'
    if other == 'file':
        (tmp_path / 'library.so').write_text('no library')
    done = run(made.controllers['kept'], tmp_path / 'record', 10, 'left', ISOCHRON_LINK=address)
    assert done.status == 1 and why in done.errors


def test_a_snapshot_takes_the_state_of_the_controller_along(made, inside, tmp_path):
    """Control: without it the way back is another one."""
    kept, record = made.controllers['kept'], tmp_path / 'record'
    address = inside(cart(tmp_path, INPUT))
    once, again = run(kept, record, 300, 'kept', ISOCHRON_LINK=address).printed.split()
    with plant_at(made.program) as wire:
        assert controlled(wire.socket, [kept, record, 300, 'from']).printed.split() == [once] == [again]
    with plant_at(made.program) as wire:
        assert controlled(wire.socket, [kept, tmp_path / 'plain', 300, 'left']).printed.split()[1] != once
    whole = record.read_bytes()
    for damaged, why in ((whole[:-9] + bytes([whole[-9] ^ 1]) + whole[-8:], 'the state of the controller is damaged'),
                         ((tmp_path / 'plain').read_bytes(), 'has no state of a controller'), (whole[:5], 'no state'),
                         (whole[:60] + bytes([whole[60] ^ 1]) + whole[61:], 'damaged')):
        record.write_bytes(damaged)
        done = run(kept, record, 300, 'from', ISOCHRON_LINK=address)
        assert done.status == 1 and why in done.errors


def test_and_from_python(made):
    client, state = client_of(made.folder), {'sum': 0}

    def go(link, tick):
        while link.tick < tick:
            state['sum'] += link.tick
            link.exchange(force=1e-6 * state['sum'])
        return link.state().hash

    with plant_at(made.program) as wire, client.Link(wire.address) as link:
        plain = (link.start('lockstep'), link.snapshot())[1]
        link.keep(lambda: state['sum'].to_bytes(4, 'big'), lambda own: state.update(sum=int.from_bytes(own, 'big')))
        go(link, 50)
        record = link.snapshot()
        end = go(link, 100)
        link.restore(record)
        link.run()
        assert state['sum'] == sum(range(50)) and go(link, 100) == end
        for damaged in (plain, record[:-9] + bytes([record[-9] ^ 1]) + record[-8:], b''):
            assert is_refused(client, 'no state of a controller, or a damaged one', link.restore, damaged)
        assert link.state().hash == end and state['sum'] == sum(range(100))


def test_over_udp_a_frame_is_a_datagram(made, tmp_path):
    """The controllers in C and in Python; another sender takes the place of the first by a start."""
    plant = subprocess.Popen([made.program], env={**os.environ, 'ISOCHRON_CONTROLLER': 'udp:0'}, stderr=subprocess.PIPE, text=True)
    try:
        address = 'udp:' + re.search(r'udp:(127.0.0.1:\d+)', plant.stderr.readline())[1]
        first = run(made.controllers['controller'], 1000, ISOCHRON_LINK=address)
        with plant_at(made.program) as wire:
            assert controlled(wire.socket, [made.controllers['controller'], 1000]).printed == first.printed != ''
        client = client_of(made.folder)
        with client.Link(address) as link:
            y = link.start('lockstep', 20)
            while y:
                y = link.exchange(force=0.5)
            assert link.end['ticks'] == 20 and link.end['link_damaged'] == 0
    finally:
        plant.kill()
        plant.wait()
        plant.stderr.close()
