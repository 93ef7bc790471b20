"""The account of the loop against one made by other code, with seeded faults of tick and step, beyond tick 2^32 too; and
that of a plant with a link, with some 20 faults in a thousand ticks, of tick, stream, input and snapshot."""
import re

import pytest

from harness.programs import path_of, run
from harness.project import ROOT, turn

HERE = ROOT / 'tests/core/runtime/account'
NEAR = 2**32 - 500000
LOOP_ALONE = ['tests/core/runtime/account/account.c', 'core/runtime/loop.c']
LINKED = ['tests/core/runtime/account/faults.c', *(f'core/{name}.c' for name in (
    'link/frame', 'application/stream', 'runtime/loop', 'runtime/snapshot', 'runtime/control', 'link/link', 'link/command'))]
WATCHED = ['valgrind', '-q', '--error-exitcode=9']
HOSTILE = (HERE / 'hostile.scene').read_text()


def agrees(*command):
    """The program's account is the model's."""
    done = run(*command)
    assert done.status == 0, done.printed + done.errors
    return done.printed


def test_a_million_ticks_and_a_million_beyond_2_to_the_32(program):
    account = program(*LOOP_ALONE, by='gcc', level='-O2')
    agrees(account, 1000000, 1, 0)
    agrees(account, 1000000, 2, NEAR)
    agrees(*WATCHED, account, 20000, 3, 2**32 - 10000)


@pytest.mark.parametrize('old, new', (
    ('return (int64_t)(b - a)', 'return (int32_t)(b - a)'), ('while (behind(loop) == 0)', 'if (behind(loop) == 0)'),
    ('iso_plant_admit(plant);', '(iso_refused){0};'), ('(uint32_t)used > loop->used', 'used == 1'),
    ('= t->end - loop->due', '= (uint32_t)(t->end - loop->due)'), ('outputs_held++', 'outputs_held += 0')))
def test_the_account_of_the_loop_finds(program, old, new):
    """Time in 32 bits, a wake-up taken for a tick, inputs that nothing checks, a margin that is not the least, a stall
    beyond 2^32 counts, outputs that are not counted."""
    assert run(program(*LOOP_ALONE, by='clang', level='-O1', planted={'core/runtime/loop.c': (old, new)}), 100000, 4, 0).status == 1


def test_the_account_of_a_plant_with_a_link(program):
    """10^7 ticks, a fifth of them each time, and 10^5 under valgrind, with more than one fault in a hundred ticks."""
    faults = program(*LINKED, by='gcc', level='-O2')
    now = turn(5)
    ticks, seed = (10000000, 1) if now is None else (2000000, now + 1)
    said = agrees(faults, ticks, seed)
    assert int(re.search(r' faults (\d+) ', said)[1]) >= ticks // 100
    agrees(*WATCHED, faults, 100000, 2)


@pytest.mark.parametrize('path, old, new', (
    ('runtime/loop', 'loop->reported += tick - loop->tick;', ''), ('runtime/loop', 'loop->rested += ticks;', ''),
    ('runtime/snapshot', 'return check ==', 'return bytes > 0 || check =='),
    ('runtime/snapshot', 'memcpy(plant->memory, snapshot + sizeof head, head.memory_bytes)',
     'memcpy(plant->memory, snapshot + sizeof head, 4)'),
    ('link/command', 'number == payload[1]', 'number == payload[1] + 1'), ('link/link', 'link->answered = link->loop->tick;', '')))
def test_the_account_of_a_plant_with_a_link_finds(program, path, old, new):
    """A jump that forgets the ticks to be caught up, ticks at rest that count, a damaged snapshot that is taken, one that
    is taken in part, a command that is done twice, inputs that stay fresh after a restore."""
    assert run(program(*LINKED, by='clang', planted={f'core/{path}.c': (old, new)}), 100000, 3).status == 1


@pytest.mark.parametrize('real', ('float', 'double'))
def test_what_comes_into_a_generated_plant_is_checked(isoc, program, real):
    """One with limits computes with numbers within them what one without computes."""
    limited = isoc(HOSTILE, '--name', 'limited', '--real', real)
    without = isoc(re.sub(' in .*', '', HOSTILE), '--name', 'open', '--real', real)
    agrees(program(limited, without, HERE / 'hostile.c', real=real, by='clang'))


@pytest.mark.parametrize('given', ('weight = 0 kg', 'drag = 1e30 N*s/m'))
def test_a_set_that_is_beyond_the_limits_is_refused(isoc, given):
    of = isoc(HERE / 'hostile.scene', '--set', given)
    assert of.refused and not of.folder.exists()
    assert re.search(r'^--set:1:\d+: error: the default of .* is not within its limits', of.errors, re.M)


@pytest.mark.parametrize('real', ('float', 'double'))
def test_the_simulated_port_and_functions_of_time_go_on_beyond_tick_2_to_the_32(isoc, program, tmp_path, real):
    """Late: the tick behind the lost one, the late one, and 20 behind the stall, which lasts to the end. Lost: of these all
    but the late one. Overruns: the stall, and the 20 behind it."""
    long = program(isoc(HERE / 'long.scene', '--real', real), HERE / 'long.c', 'core/runtime/loop.c', 'port/host/script.c',
                   'port/host/pins.c', 'port/host/wires.c', 'port/unix/console.c', 'core/numbers/self_check.c', real=real, by='clang')
    script = 'lose 4294967297\nlate 4294967302 100us\nslow 4294967306 4295ms\n'
    said = agrees(long, path_of(script, tmp_path, 'script')).splitlines()
    assert 'late 22 lost 21 overruns 21 margin -4294000000 wave 1 climb 1 grain 1' in said
