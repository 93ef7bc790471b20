"""`overrun stop` over the link: the tick that overran is in the hash, in the outputs that the controller gets, and in the
table, as it is in a run without a wire; and the port is put into its safe state once in both."""
import types

import pytest

from harness.programs import LINKED, LOOP, client_of, path_of, plant_at, traced
from harness.project import ROOT

PENDULUM = (ROOT / 'tests/core/runtime/overruns/pendulum.scene').read_text() + '\noverrun stop; grace 20 ticks\n'
SECOND = 1000000000


@pytest.fixture(scope='module')
def plants(isoc, program, tmp_path_factory):
    """Its program without a link and with one, on a simulated port that says on the standard error that it is made
    safe."""
    made = isoc(PENDULUM, '--link')
    sim = (ROOT / 'port/host/sim.c').read_text().replace(
        'iso_port_safe(void)\n{', 'iso_port_safe(void)\n{\n(void)fputs("safe\\n", stderr);')
    assert '"safe\\n"' in sim
    sim = path_of(sim, tmp_path_factory.mktemp('sim'), 'sim.c')
    port = [sim, *(f'port/host/{name}.c' for name in ('script', 'pins', 'wires'))]
    rest = [source for source in LINKED if source != 'port/host/*.c'] + port
    alone = [source for source in rest if source in LOOP] + [*port, 'core/application/main.c']
    return types.SimpleNamespace(alone=program(made.folder / 'plant.c', *alone), linked=program(made, *rest),
                                 client=client_of(made.folder))


def ended(folder, done):
    """The hash and the table of a run that the overrun of tick 77 stops."""
    assert done.status != 0 and 'trace: stopped by the overrun of tick 77\n' in done.errors
    assert done.errors.splitlines().count('safe') == 1
    return done.said['hash'], (folder / 'trace.csv').read_text()


def over_link(plants, folder, script):
    """The run, and the controller when it is over."""
    command = [ROOT / 'build/trace', '-o', folder, '--', plants.linked, SECOND, script]
    with plant_at(*command, is_endless=False) as wire, plants.client.Link(wire.address) as link:
        wire.socket.close()
        y = link.start('lockstep', 0)
        while y:
            y = link.exchange()
    return wire.plant, link


def test_the_tick_that_overran_is_the_last_with_a_wire_and_without(plants, tmp_path):
    """Control: another tick."""
    script = path_of('slow 10 2ms\nslow 77 1500us\n', tmp_path, 'script')
    digest, table = ended(tmp_path / 'alone', traced(tmp_path / 'alone', plants.alone, SECOND, script))
    done, link = over_link(plants, tmp_path, script)
    assert ended(tmp_path, done) == (digest, table) and len(table.splitlines()) == 79
    assert (link.tick, link.end['ticks'], f'{link.end["hash"]:016x}') == (77, 77, digest)
    later, _ = over_link(plants, tmp_path, path_of('slow 78 1500us\n', tmp_path, 'script'))
    assert later.said['hash'] != digest and 'tick 78' in later.errors
