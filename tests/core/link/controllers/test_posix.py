"""TARGET=posix: the plant of the host in real time. It has the same bits, whatever the system does to its ticks; nothing
is said of how long anything takes."""
import os
import shutil
import sys

import pytest

from harness.programs import run, traced
from harness.project import ROOT
from lab import build

SCENE = ROOT / 'models/double_pendulum.scene'
# Stops the program four times for 0.2 s, from its first bytes on, when it cannot be further ahead than a page.
STALLED = '''import fcntl, os, shutil, signal, subprocess, sys, time
ends = os.pipe()
fcntl.fcntl(ends[1], 1031, 4096)  # F_SETPIPE_SZ
plant = subprocess.Popen([sys.argv[1], "2000000000"], stdout=ends[1])
os.close(ends[1])
stream = open(ends[0], "rb", buffering=0)
sys.stdout.buffer.write(stream.read(2048))
for _ in range(4):
    plant.send_signal(signal.SIGSTOP)
    time.sleep(0.2)
    plant.send_signal(signal.SIGCONT)
    time.sleep(0.05)
shutil.copyfileobj(stream, sys.stdout.buffer)
sys.exit(plant.wait())
'''


@pytest.fixture
def of_host(laboratory):
    return build.plant(SCENE).run('0.3 s')


@pytest.fixture
def posix(laboratory):
    return build.plant(SCENE, target='posix')


def test_the_hash_and_the_trace_are_those_of_the_host(of_host, posix):
    run = posix.run('0.3 s')
    assert run.summary['hash'] == of_host.summary['hash'] and run.trace.read_bytes() == of_host.trace.read_bytes()
    ticks, lost, late, overruns = (int(run.summary[word]) for word in ('ticks', 'lost', 'late', 'overruns'))
    assert ticks == 300 and lost < 300 and late <= 300 and overruns <= late + 1


def test_a_script_is_refused(isochron):
    of = isochron('run', SCENE, '--target', 'posix', '--seconds', '0.3', '--script', 'script')
    assert of.status == 1 and 'script has no effect on posix' in of.errors


def test_ticks_that_the_system_takes_away_are_lost_and_caught_up(of_host, posix, tmp_path):
    """Of each of the four stops at least 199 ticks are due, all but one reported with a later one. Those pass that are due
    while it writes its trace, if it is stopped there."""
    done = traced(tmp_path, sys.executable, '-c', STALLED, posix.program.absolute())
    assert done.said['ticks'] == '2000' and 150 <= int(done.said['lost']) <= int(done.said['late'])
    assert (tmp_path / 'trace.csv').read_text().splitlines()[:302] == of_host.trace.read_text().splitlines()


def test_who_is_allowed_neither_a_priority_nor_to_lock_memory_is_told_and_runs(posix):
    program = shutil.copy(posix.program, '/tmp')      # which every user can read
    script = 'ulimit -l 0; ulimit -r 0 2>/dev/null; exec "$@"'
    humble = 'setpriv --reuid 65534 --clear-groups --bounding-set=-all --inh-caps=-all'.split() if os.getuid() == 0 else []
    done = run('sh', '-c', script, 'sh', *humble, program, 1000000)
    os.unlink(program)
    assert done.status == 0
    assert 'posix: no SCHED_FIFO (' in done.errors and '): other programs can make ticks late\n' in done.errors
    assert 'posix: no mlockall (' in done.errors and '): memory that is paged out can make ticks late\n' in done.errors
