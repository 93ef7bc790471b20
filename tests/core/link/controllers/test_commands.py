"""Commands over the link: run, rest, reset, snapshot and restore, in lockstep and in a free run, after the guard too. A
snapshot of tick 12345 on the host goes on to the same hash on the host and on the Cortex-M4F."""
import re

import pytest
from link import CONTROLLERS, INPUT, balance, cart, controller_of, is_refused

from harness.programs import LINKED, client_of, controlled, linked_on_board, plant_at

TICK = 12345


@pytest.fixture(scope='module')
def plant(isoc, program, tmp_path_factory):
    """The cart, its `program`, its `controller` in C, and a `record` of tick 12345 with the hash of 1000 ticks later."""
    folder = tmp_path_factory.mktemp('cart')
    made = isoc(cart(folder, INPUT), '--link')
    made.program, made.controller = program(made, *LINKED), controller_of(program, 'commands', made)
    made.record = folder / 'record'
    with plant_at(made.program) as wire:
        made.ended = controlled(wire.socket, [made.controller, 'tick', made.record, TICK]).printed
    assert re.fullmatch(f'tick {TICK + 1000} hash [0-9a-f]{{16}}\n', made.ended)
    return made


def goes_on(plant, command, controller=None, **environment):
    with plant_at(*command, **environment) as wire:
        return controlled(wire.socket, [controller or plant.controller, 'from', plant.record, TICK]).printed


def test_a_snapshot_goes_on_to_the_same_hash(plant, program):
    """Control: another input at one tick."""
    assert goes_on(plant, [plant.program]) == plant.ended
    one = ('LAW(plant.y);', 'LAW(plant.y) + (plant.client.tick == 13000);')
    planted = controller_of(program, 'commands', plant, planted={'tests/core/link/controllers/commands.c': one})
    assert goes_on(plant, [plant.program], planted) not in ('', plant.ended)


def test_and_on_the_board(plant, laboratory, tmp_path):
    command, environment = linked_on_board(cart(tmp_path, INPUT))
    assert goes_on(plant, command, **environment) == plant.ended


def test_in_lockstep_from_c(plant, proves):
    with plant_at(plant.program) as wire:
        proves(controlled(wire.socket, [plant.controller, 'all', plant.record]))


def test_in_lockstep_from_python(plant):
    client = client_of(plant.folder)
    with plant_at(plant.program) as wire, client.Link(wire.address) as link:
        assert link.state().state == 'no run' and is_refused(client, 'no run', link.run, 1)
        y = balance(link, link.start('lockstep'), 10)
        assert link.pause().state == 'rests' and link.run(5).left == 5
        y = balance(link, y, 15)
        assert link.state().state == 'rests' and link.state().tick == 15
        record = link.snapshot()
        assert len(record) == link.state().snapshot_bytes
        link.run()
        y = balance(link, y, 40)
        end = link.state().hash
        y = link.restore(record)
        assert link.tick == 15 and link.run().state == 'runs'
        y = balance(link, y, 40)
        assert link.state().hash == end
        damaged = record[:60] + bytes([record[60] ^ 1]) + record[61:]
        assert is_refused(client, 'damaged', link.restore, damaged) and is_refused(client, 'not whole', link.restore, record[:-1])
        assert link.state().hash == end and link.state().tick == 40
        y = link.reset()
        assert link.tick == 0 and link.run(5).state == 'runs'
        balance(link, y, 5)
        assert link.state().state == 'rests' and link.stop()['ticks'] == 5


def test_in_a_free_run_and_behind_the_guard(isoc, program, proves):
    rotor = isoc(CONTROLLERS / 'rotor.scene', '--link')
    with plant_at(program(rotor, *LINKED)) as wire:
        proves(controlled(wire.socket, [controller_of(program, 'rotor', rotor)]))
