"""Measurement and calibration by a master that is written from the standard, over a socket of the host and over a serial
line of the board in QEMU; by the addresses of the A2L. With TEST_WHOLE the board is measured for 10 s, else for 1 s."""
import os
import re
import shutil
import subprocess

import pytest
from plants import CART, until, waiting

from harness.programs import path_of, run
from harness.project import ROOT
from lab import a2l as writer
from lab import build

MASTERS = ROOT / 'tests/core/xcp/masters'
BOARD_SECONDS = 10 if os.environ.get('TEST_WHOLE') else 1
MASTER = ['python3', '-B', MASTERS / 'session.py']


@pytest.fixture(scope='module')
def made(isochron, tmp_path_factory):
    """made(target, lock, real, scene): a folder with the plant's program `cart`, its A2L, and its client."""
    kept = {}

    def of(target, lock, real='float', scene=CART):
        if (target, lock) not in kept:
            folder = tmp_path_factory.mktemp(lock)
            work = tmp_path_factory.mktemp('work')
            done = isochron('a2l', scene, '--target', target, '--xcp', lock, '--real', real, cwd=work)
            assert done.status == 0, done.errors
            for file, name in ((done.said['a2l'], 'cart.a2l'), (done.said['program'], 'cart')):
                shutil.copy(work / file, folder / name)
            shutil.copy((work / done.said['program']).parent / 'cart_link.py', folder)
            kept[target, lock] = folder
        return kept[target, lock]

    return of


def session(folder, calibration, kind, seconds):
    return run(*MASTER, folder / 'cart.a2l', folder, f'unix:{folder}/controller', calibration, kind, seconds)


@pytest.mark.parametrize('kind, channel, seconds', (('socket', 'tcp', 10), ('datagram', 'udp', 1)))
def test_the_master_at_the_host(made, proves, kind, channel, seconds):
    folder = made('host', 'open')
    with waiting(folder / 'cart', folder, channel) as port:
        proves(session(folder, port, kind, seconds))


def test_the_master_at_a_plant_with_a_lock_and_policies(made, proves, tmp_path):
    scene = path_of(CART.read_text() + 'grace 10 ticks; publish next_tick; histogram\n', tmp_path, 'cart.scene')
    folder = made('host', 'iso_xcp_example_lock', 'double', scene)
    with waiting(folder / 'cart', folder) as port:
        proves(session(folder, port, 'locked', 0))
    # A scene with policies has their counts in its A2L, another has none of them.
    assert ' statistics.histogram_31 ' in (folder / 'cart.a2l').read_text()
    assert not re.search('statistics.(latency|histogram)', (made('host', 'open') / 'cart.a2l').read_text())


def test_the_master_at_the_board_over_a_serial_line(made, proves):
    folder = made('cortex-m4f', 'open')
    lines = [word for name in ('controller', 'calibration') for word in ('-serial', f'unix:{folder / name},server=on,wait=off')]
    process = subprocess.Popen(['qemu-system-arm', '-M', 'mps2-an386', '-icount', 'shift=10,align=off,sleep=off', '-display', 'none',
                                '-monitor', 'none', *lines, '-semihosting-config', 'enable=on,target=native,arg=plant', '-kernel',
                                folder / 'cart'], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    try:
        until(process, lambda: (folder / 'controller').exists() and (folder / 'calibration').exists())
        proves(session(folder, f'unix:{folder}/calibration', 'serial', BOARD_SECONDS))
    finally:
        process.terminate()
        process.wait()


def test_an_idle_client_gives_way_when_another_waits(made, proves):
    folder = made('host', 'open')
    seconds = re.search(r'IDLE_SECONDS = (\d+)', (ROOT / 'port/unix/channel.c').read_text())[1]
    with waiting(folder / 'cart', folder) as port:
        proves('python3', '-B', MASTERS / 'idle.py', port, seconds)


def test_the_monitor_connects_over_udp_which_the_a2l_has_too(made):
    folder = made('host', 'open')
    assert re.search('begin XCP_ON_UDP_IP.*\n.*0x0100 5555 ADDRESS "127.0.0.1"', (folder / 'cart.a2l').read_text())
    with waiting(folder / 'cart', folder, 'udp') as port:
        table = run(ROOT / 'build/monitor', folder / 'cart.a2l', port, '--once').printed
    assert re.search('^p.rod_mass +0.2 kg ', table, re.M)


@pytest.mark.parametrize('bad', ('ISOCHRON_CONTROLLER=udp:x', 'ISOCHRON_CALIBRATION=udp:x', 'ISOCHRON_CALIBRATION=udp:1.2.3:5'))
def test_an_address_that_is_none_is_refused(made, bad):
    done = run('env', bad, 'timeout', '60', made('host', 'open') / 'cart')
    assert done.status != 0 and re.search(
        f'^{bad}: expected udp:PORT or udp:ADDRESS:PORT', done.errors, re.M)


def test_found_by_the_master(isoc, program, laboratory, tmp_path):
    """A slave with three defects: limits are not looked at, a tick has the time stamp of another, and a stimulus is held too
    long."""
    planted = {'core/xcp/access.c': ('x <= limits->most', 'x <= x'),
               'core/xcp/service.c': ('(uint32_t)loop->tick)', '(uint32_t)loop->tick - (loop->tick == 500))'),
               'core/xcp/stimulation.c': ('age < s->patience', 'age <= s->patience')}
    made = isoc(CART, '--link', '--xcp', 'open')
    sources = build.port('host', kind='calibrated').facts['SOURCES'].split()
    defects = program(made, *sources, by='clang', planted=planted, link=['-no-pie'])
    shutil.copy(made.folder / 'cart_link.py', tmp_path)
    bench = build.plant(CART, kind='calibrated', isoc=['--link', '--xcp', 'open'])
    shutil.copy(defects, bench.program)
    shutil.copy(writer.write(bench), tmp_path / 'cart.a2l')
    with waiting(defects, tmp_path) as port:
        done = session(tmp_path, port, 'socket', 1)
    bench.program.unlink()
    for name in ('one number beyond its limits', 'every tick has its own', '360 ticks with a random stimulation'):
        assert done.finds(name), name


@pytest.mark.parametrize('pattern, by', (
    ('.*ECU_ADDRESS.*\n', ''), ('.*/end GROUP.*\n', ''), ('IEEE unit_1 ', 'IEEE unit_99 '), (r'x\.hinge', 'x.rail'),
    ('0x[0-9A-F]*$', '@memory+0@'), (None, '')))
def test_the_a2l_keeps_to_the_grammar(made, tmp_path, pattern, by):
    """Found: a measurement without an address, a block without an end, a unit that there is not, two of one name, an address
    that was left open."""
    text = (made('host', 'open') / 'cart.a2l').read_text()
    changed = re.sub(pattern, by, text, flags=re.M) if pattern else text
    assert (changed != text) == bool(pattern)
    done = run('python3', '-B', MASTERS / 'a2l.py', path_of(changed, tmp_path, 'bad.a2l'))
    assert (done.status != 0) == bool(pattern)


@pytest.mark.parametrize('options, said', (
    (['--xcp', 'open'], '--xcp is for a plant with a link: add --link to --xcp open'),
    (['--link', '--xcp', 'a-lock'], '--xcp is open, or the name of an iso_xcp_lock in C; not a-lock')))
def test_isoc_refuses(isoc, options, said):
    of = isoc(CART, *options)
    assert of.status == 1 and said in of.errors and not of.folder.exists()
