"""The monitor at a plant of the host: its table, a tunable that is set, a record against the trace of the same run, its
replay, and what it says of mistakes. Nothing here is of a length of time: the run lasts until it is ended, whoever looks on
does until so many ticks are done, and whoever waits waits for an event, or for the time that a test has."""
import os
import re
import subprocess
import types

import pytest
from plants import CART, PATIENCE, waiting

from harness.programs import path_of, run
from harness.project import ROOT

MONITOR = ROOT / 'build/monitor'


class Watched:
    """A plant with its A2L, and the monitor at its address."""

    def __init__(self, a2l, at):
        self.a2l, self.at = a2l, at

    def __call__(self, *words):
        done = run(MONITOR, self.a2l, self.at, *words, '--patience', PATIENCE)
        assert done.status == 0, done.errors
        return done.printed

    def does(self, *commands, ticks=None):
        return self(*(word for command in commands for word in ('--do', command)), *(['--ticks', ticks] if ticks else []))

    def tick(self):
        return int(re.search(r'(?:^| )tick +(\d+)', self('--once'), re.M)[1])


def refuses(said, *words):
    """The monitor ends with status 1, and says this and nothing else."""
    done = run(MONITOR, *words)
    assert done.status == 1 and said in done.errors and done.printed == '' and len(done.errors.splitlines()) == 1, done.errors


@pytest.fixture(scope='module')
def built(isochron, tmp_path_factory):
    work = tmp_path_factory.mktemp('work')
    of = isochron('a2l', CART, '--xcp', 'open', cwd=work)
    assert of.status == 0, of.errors
    return types.SimpleNamespace(a2l=work / of.said['a2l'], program=work / of.said['program'])


@pytest.fixture(scope='module')
def run_of_it(built, tmp_path_factory):
    """What a whole run of the plant shows, step by step: each test below looks at a part."""
    folder = tmp_path_factory.mktemp('monitor')
    seen = types.SimpleNamespace(folder=folder, a2l=built.a2l, trace=folder / 'trace.csv', record=folder / 'record.csv')
    command = [ROOT / 'build/trace', '-o', folder, '--']
    with waiting_for(built.program, folder, command) as at:
        watched = seen.watched = Watched(built.a2l, at)
        seen.before = watched('--once')
        seen.set = watched.does('set reading_active = 1', 'set p.rod_mass = 0.3')
        mistakes(watched, folder)
        controller = subprocess.Popen(
            ['python3', '-B', ROOT / 'tests/core/xcp/masters/paced_master.py', built.program.parent, folder / 'stop'],
            env={**os.environ, 'ISOCHRON_LINK': f'unix:{folder}/controller'}, stdin=subprocess.DEVNULL)
        try:
            seen.table = watched('--seconds', 1, '--ticks', 400, '--record', seen.record)
            commands(watched, folder)
        finally:
            (folder / 'stop').touch()
            controller.wait()
    return seen


def waiting_for(program, folder, command):
    """Without an end: it ends with its controller, and is not killed before its table is whole."""
    return waiting(program, folder, command=command, words=[10**15], waits=True)


def mistakes(watched, folder):
    for said, command in (('p.rod_mass must be from 0.05 to 1 kg', 'set rod_mass = 2'),
                          ('p.rod_mass must be from 0.05 to 1 kg', 'set rod_mass = nan'),
                          ('x.rail is no tunable and no fault', 'set x.rail = 1'), ('there is no rod_mas', 'set rod_mas = 1'),
                          ('expected set NAME = VALUE', 'set rod_mass 1'), ("'go' is no command", 'go'),
                          ('expected step or step N', 'step -')):
        refuses(said, watched.a2l, watched.at, '--do', command, '--patience', PATIENCE)
    refuses('No such file', watched.a2l, watched.at, '--record', folder / 'absent/record', '--patience', PATIENCE)
    other = path_of(re.sub('EPK "[0-9a-f]*"', 'EPK "0"', watched.a2l.read_text()), folder, 'other.a2l')
    refuses('the A2L is of 0: another program', other, watched.at, '--patience', PATIENCE)


def commands(watched, folder):
    """Pause, steps and snapshots: to one and on again for 20 ticks, without a wire to the inputs, which stay as the
    controller has set them; its controller goes along."""
    taken, again = folder / 'taken.bin', folder / 'again.bin'
    watched.does('pause')
    first = watched.tick()
    assert first > 0 and re.search('^t .* s  rests$', watched('--once'), re.M) and watched.tick() == first
    watched.does('step', ticks=1)
    assert watched.tick() == first + 1
    watched.does('step 20', ticks=20)
    second = watched.tick()
    assert second == first + 21
    watched.does(f'snapshot {taken}')
    assert taken.read_bytes()[:4] == b'ISOS'
    watched.does('step 20', ticks=20)
    assert watched.tick() == second + 20
    assert re.search('^t .* s  rests$', watched.does(f'restore {taken}'), re.M) and watched.tick() == second
    watched.does(f'snapshot {again}')
    assert again.read_bytes() == taken.read_bytes()     # the hash among them
    watched.does('step 20', ticks=20)
    assert watched.tick() == second + 20
    record = taken.read_bytes()
    (folder / 'damaged.bin').write_bytes(record[:80] + b'\xaaU' + record[82:])
    (folder / 'short.bin').write_bytes(record[:80])
    for said, command in (('the snapshot is damaged', f'restore {folder}/damaged.bin'),
                          ('the snapshot is not whole', f'restore {folder}/short.bin'),
                          ('this is no snapshot', f'restore {watched.a2l}'), ('No such file', f'restore {folder}/absent.bin'),
                          ('No such file', f'snapshot {folder}/absent/taken.bin')):
        refuses(said, watched.a2l, watched.at, '--do', command, '--patience', PATIENCE)
    assert watched.tick() == second + 20
    assert 'rests' not in watched.does('run', ticks=10)


def test_a_table_has_names_values_units_and_statistics_before_a_run(run_of_it):
    for line in ('^p.rod_mass +0.2 kg ', '^x.hinge_speed .* rad/s ', r'execution_max +\d'):
        assert re.search(line, run_of_it.before, re.M), line


def test_a_tunable_and_a_fault_are_set(run_of_it):
    assert re.search('^p.rod_mass +0.3 kg ', run_of_it.set, re.M) and re.search('^p.reading_active +1 1 ', run_of_it.set, re.M)


def test_the_table_has_curves_of_the_run_from_their_least_to_their_most(run_of_it):
    curve = re.search('^y.pole .*rad *(.*)$', run_of_it.table, re.M)[1].strip()
    assert len(curve) >= 9 and '▁' in curve and '█' in curve


def same(record, trace):
    """Whether the columns of outputs of a record are lines of the trace, one for each tick, without a gap; 400 at least."""
    lines = {line: number for number, line in enumerate(trace)}
    places = [lines.get(','.join(line.split(',')[:8])) for line in record]
    return places[0] == 0 and None not in places and len(places) > 400 and all(
        later == earlier + 1 for earlier, later in zip(places[1:], places[2:]))


def test_a_record_is_a_part_of_the_trace_tick_by_tick(run_of_it):
    """Behind the outputs it has the inputs. Controls: a tick that is missing, a value that is another."""
    record, trace = (path.read_text().splitlines() for path in (run_of_it.record, run_of_it.trace))
    assert same(record, trace) and re.fullmatch('t,cart_position,.*,force,push,reading_held', record[0])
    assert not same(record[:99] + record[100:], trace)
    cells = record[99].split(',')
    cells[3] = str(float(cells[3]) + 0.001)
    assert not same([*record[:99], ','.join(cells), *record[100:]], trace)


def test_a_record_and_a_trace_are_shown_again_with_units_and_curves(run_of_it):
    table = run(MONITOR, run_of_it.a2l, '--replay', run_of_it.record).printed
    last = float(run_of_it.record.read_text().splitlines()[-1].split(',')[3])
    assert re.search(r'^y\.pole +(\S+)', table, re.M)[1] == f'{last:.6g}'
    assert re.search('^u.force .* N  *[▁█]', table, re.M) and not re.search(r'^p\.', table, re.M)
    assert re.search('^y.energy .* J ', run(MONITOR, run_of_it.a2l, '--replay', run_of_it.trace, '--once').printed, re.M)


def test_what_it_is_asked_wrongly(run_of_it, tmp_path):
    a2l, at = run_of_it.a2l, run_of_it.watched.at
    refuses('Connection refused', a2l, at)
    refuses('is no address', a2l, 5555)
    refuses('No such file', tmp_path / 'absent.a2l', at)
    text = a2l.read_text().replace('FLOAT32_IEEE unit_2', 'FLOAT33_IEEE unit_2')
    line = text[:text.index('FLOAT33')].count('\n') + 1
    refuses(f"bad.a2l:{line}: 'FLOAT33_IEEE'", path_of(text, tmp_path, 'bad.a2l'), at)
    refuses('empty.a2l:1: ', path_of('', tmp_path, 'empty.a2l'), at)
    for table, said in (('t,pole\n0,1\n0.1,x\n', '3: expected 2 numbers'), ('t,pole,bole\n', "1: the A2L has no 'bole'"),
                        ('pole\n', '1: a table begins with t')):
        refuses(f'bad.csv:{said}', a2l, '--replay', path_of(table, tmp_path, 'bad.csv'))
    done = run(MONITOR)
    assert done.status == 2 and done.errors.startswith('usage: monitor A2L ADDRESS')
