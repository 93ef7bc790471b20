"""isochron link and isochron hil: a plant and a controller in processes of their own. The plant has the hash that it has
without a wire, the table has the inputs, and whatever goes wrong is told and leaves no process."""
import csv
import os
import pathlib
import re
import subprocess
import time

import numpy as np
import pytest

from harness.programs import hash_of, path_of, run
from harness.project import ROOT
from lab import build, hil

SCENE = ROOT / 'models/hil/cart_pole.scene'
CONTROLLER = (ROOT / 'models/hil/controller.c').read_text()
# What hil does, for 1.2 s: the fault is not in them.
SECONDS, TICKS = 1.2, 1200


@pytest.fixture(scope='module')
def of_host(isochron):
    """hil on the host: what it printed, its folder, and its table."""
    of = isochron('hil', '--seconds', SECONDS, '--target', 'host')
    assert of.status == 0, of.errors
    of.folder = pathlib.Path(of.said['trace']).parent
    of.folder = build.ROOT / 'build/tests/commands' / os.environ.get('PYTEST_XDIST_WORKER', 'alone') / of.folder
    with open(of.folder / 'trace.csv') as file:
        of.table = list(csv.reader(file))
    return of


@pytest.fixture
def controller(program, of_host):
    """controller(text): the program of one in C."""
    def make(text, folder):
        flags = ['-D_POSIX_C_SOURCE=200809L', '-I', of_host.folder / 'linked']
        return program(path_of(text, folder, 'controller.c'), by='clang', flags=flags, name='controlling')

    return make


@pytest.fixture
def link(isochron, of_host):
    """link(word, ...): isochron link of the same plant, with the controller of hil unless another is named."""
    def call(*words, **environment):
        own = [] if '--controller' in words else ['--controller', of_host.folder / 'controller']
        return isochron('link', SCENE, *([] if '--seconds' in words else ['--seconds', SECONDS]), *own, *words, **environment)

    return call


def test_hil_stands_and_tells_of_its_exchanges(of_host):
    exchanges = r'exchanges 1200, median [0-9.e-]+ ms, of which the controller [0-9.e-]+ ms, missed 0'
    assert 'stood:' in of_host.said and re.fullmatch(exchanges, of_host.printed.splitlines()[-4])
    # The longest exchange has the controller's longest part in it, but for that of the last tick, which nothing follows.
    whole, part = (float(of_host.said[f'{word}_max'].split()[0]) for word in ('exchange', 'controller'))
    assert 0 < part <= whole


def test_the_table_has_the_input_behind_the_outputs_and_is_drawn(of_host):
    units = (of_host.folder / 'units.csv').read_text().splitlines()
    assert ','.join(of_host.table[0]) == 't,counts,place,pole,cart,current,stop,volts'
    assert len(of_host.table) == 1 + TICKS + 1 and units[-1] == 's,1,m,rad,m,A,N,V'
    assert all((of_host.folder / f'trace.{picture}').stat().st_size > 0 for picture in ('svg', 'png'))


def test_the_inputs_of_the_table_given_to_the_plant_without_a_wire_have_the_same_hash(of_host, plant):
    """Row k has the inputs of the step from k to k + 1. Control: an input that differs."""
    volts = np.array([float(row[-1]) for row in of_host.table[1:TICKS + 1]], np.float32)
    alone = plant(SCENE, real='float')

    def replayed(volts):
        alone.start()
        rows = []
        for tick, alone.now['u'][0, 0] in enumerate(volts):
            alone.go(1, first=tick)
            rows.append(alone.now['x'][0].copy())
        return hash_of(np.array(rows))

    assert replayed(volts) == of_host.said['hash']
    volts[599] += 0.001
    assert replayed(volts) != of_host.said['hash']


def test_on_the_board_over_its_serial_line_the_hash_is_that_of_the_host(isochron, of_host):
    of = isochron('hil', '--seconds', SECONDS)
    assert of.status == 0 and of.said['hash'] == of_host.said['hash'] and int(of.said['instructions_per_step']) > 0
    assert of.said['exchanges'].startswith('1200, ') and of.said['exchanges'].endswith(' missed 0') and 'stood:' in of.said


def test_link_has_the_same_hash_and_in_real_time_too(link, of_host, laboratory):
    assert link().said['hash'] == of_host.said['hash']
    assert link('--target', 'posix', '--keep', 'posix').said['hash'] == of_host.said['hash']
    assert (laboratory / 'build/runs/posix/trace.csv').stat().st_size > 0


def test_in_a_free_run_each_tick_had_an_input_that_was_new_or_missed_it(link):
    """How many come in time is the system's."""
    of = link('--target', 'posix', '--mode', 'free')
    assert of.said['ticks'] == '1200' and int(of.said['link_inputs']) + int(of.said['exchanges'].split()[-1]) >= 1200


ENDLESS_C = '''#include "cart_pole_link.h"
int main(int argc, char **argv)
{
    static cart_pole_link plant;
    bool good = cart_pole_open(&plant, NULL) && cart_pole_start(&plant, argc > 2 ? ISO_CLIENT_FREE : ISO_CLIENT_LOCKSTEP, 0);
    while (good && plant.client.tick < (uint64_t)atoi(argv[1])) {
        good = cart_pole_exchange(&plant);
    }
    return !good || (argc == 2 && !cart_pole_stop(&plant));
}
'''
ENDLESS_PYTHON = '''import sys
import cart_pole_link as plant

with plant.Link() as link:
    link.start("free" if len(sys.argv) > 2 else "lockstep", 0)
    while link.tick < int(sys.argv[1]):
        link.exchange()
    if len(sys.argv) == 2:
        link.stop()
'''


@pytest.mark.parametrize('language', ('C', 'Python'))
def test_a_run_without_an_end_goes_on_until_the_controller_ends_it(link, controller, laboratory, tmp_path, language):
    """By `stop`, or by closing its link. Control: a run with an end."""
    python = f'python3 -B {path_of(ENDLESS_PYTHON, tmp_path, "endless.py")}'
    command = controller(ENDLESS_C, tmp_path) if language == 'C' else python
    of = link('--seconds', '0', '--controller', f'{command} 10100')
    assert of.status == 0 and of.said['ticks'] == of.said['link_inputs'] == '10100', of.errors
    assert len((laboratory / of.said['trace']).read_text().splitlines()) == 10102
    of = link('--seconds', '0', '--target', 'posix', '--controller', f'{command} 300 free')
    assert of.status == 0 and int(of.said['ticks']) >= 300, of.errors
    of = link('--seconds', '10', '--controller', f'{command} 10100')
    assert of.status == 1 and of.said['ticks'] == '10000'


def test_without_a_controller_it_prints_the_address_and_waits(of_host, laboratory):
    command = [ROOT / 'tools/isochron', 'link', SCENE, '--seconds', str(SECONDS)]
    with open('errors', 'w+') as errors:
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, stdin=subprocess.DEVNULL, text=True)
        said = 'link: waiting for a controller with ISOCHRON_LINK=(.+)\n'
        while not (found := re.search(said, pathlib.Path('errors').read_text())):
            assert process.poll() is None
            time.sleep(0.02)
        assert run(of_host.folder / 'controller', ISOCHRON_LINK=found[1]).status == 0
        assert f'hash {of_host.said["hash"]}\n' in process.communicate()[0]


def at_100(statement):
    """The controller of hil, which does this at its tick 100."""
    text = '#include <signal.h>\n#include <unistd.h>\n' + CONTROLLER
    assert '    while (good) {\n' in text
    return text.replace('    while (good) {\n', f'    while (good) {{\n if (plant.client.tick == 100) {{ {statement}; }}\n')


def alive(text):
    """The processes with this text in their command."""
    def command(path):
        try:
            return path.read_bytes()
        except OSError:
            return b''

    return [path for path in pathlib.Path('/proc').glob('[0-9]*/cmdline') if text.encode() in command(path)]


@pytest.mark.parametrize('said, status, patience, does', (
    ('the controller ended with status 1 and has exchanged nothing', 1, 600, 'false'),
    ('the controller ended and has exchanged nothing', 1, 600, 'true'),
    ('the controller ended with status 127', 1, 600, './absent'),
    ('the controller has not connected for 1 s', 1, 1, 'sleep 100'),
    ('nothing comes any more: the controller has ended, the plant waits at tick 100', 1, 600, 'raise(SIGKILL)'),
    ('nothing comes any more: plant and controller both wait at tick 100', 1, 3, 'raise(SIGSTOP)'),
    ('', 130, 600, 'kill(getppid(), SIGINT)'), ('', 143, 600, 'kill(getppid(), SIGTERM)'),
    ('link: the plant ended with status 7\n', 1, 600, 'plant')))
def test_told(of_host, controller, tmp_path, said, status, patience, does):
    """What goes wrong at one end; and nothing of it is left."""
    command = f'exec {controller(at_100(does), tmp_path)}' if '(' in does else does
    linked = of_host.folder / 'linked'
    plant = [ROOT / 'build/trace', '-o', tmp_path, '--', linked / 'program', 10**11]
    done = run(ROOT / 'build/link', '-o', tmp_path, '--header', linked / 'cart_pole_link.h', '--patience', patience,
               '--controller', of_host.folder / 'controller' if does == 'plant' else command, '--',
               *(['sh', '-c', 'exit 7'] if does == 'plant' else plant))
    assert done.status == status and said in done.errors
    assert not alive(str(linked / 'program')) and ('(' not in does or not alive(command))


@pytest.mark.parametrize('words, said', (
    ([SCENE, '--mode', 'free', '--target', 'host'], '--mode free needs time that is real'),
    ([ROOT / 'models/oscillator.c', '--controller', 'true'], 'a plant in C has no link')))
def test_refused(isochron, words, said):
    of = isochron('link', *words)
    assert of.status == 1 and said in of.errors


def test_a_controller_of_another_plant_is_refused(link):
    of = link('--step', '2ms')
    assert of.status != 0 and 'link: the controller ended with status 1' in of.errors


def test_a_pole_that_falls_is_told_from_one_that_stands(of_host, tmp_path, capsys):
    """One that is 2.06 deg off at the end, and a cart at its stop."""
    def changed(row, column, value):
        table = [list(cells) for cells in of_host.table]
        table[row][column] = value
        return path_of('\n'.join(map(','.join, table)) + '\n', tmp_path, 'fallen.csv')

    assert hil.stood(of_host.folder / 'trace.csv') == 0
    assert hil.stood(changed(899, 3, '0.036')) == 1 and 'fell: pole within 2.06 deg' in capsys.readouterr().out
    assert hil.stood(changed(99, 4, '-0.4')) == 1
