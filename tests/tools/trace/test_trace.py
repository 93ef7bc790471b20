"""A run that goes wrong is told of: by build/trace, by the simulated tick's script, and by a fault on the board."""
import re
import subprocess

import pytest

from harness.programs import on_board, path_of, run
from harness.project import ROOT
from lab import build

TRACE = ROOT / 'build/trace'


@pytest.fixture
def oscillator(laboratory):
    return build.plant(ROOT / 'models/oscillator.c').program.absolute()


@pytest.fixture
def stream(oscillator, tmp_path):
    """The bytes of a run, in a file."""
    (tmp_path / 'stream').write_bytes(subprocess.run([oscillator, '1000000000'], stdout=subprocess.PIPE, check=True).stdout)
    return tmp_path / 'stream'


@pytest.fixture
def tells(laboratory, tmp_path):
    """tells(text, command ...): build/trace fails on the command, says this, and leaves no table."""
    def of(text, *command):
        table = tmp_path / 'table'
        table.mkdir(exist_ok=True)
        done = run(TRACE, '-o', table, '--', *command)
        assert done.status != 0 and re.search(text, done.errors) and list(table.iterdir()) == [], done.errors

    return of


HEADER = r'isochron 2\nscene x\nmethod rk4\nstep 0.1\nreal float\nperiod_ns 1\nnames a,b\nunits m,m,m\n\n'


@pytest.mark.parametrize('text, command', (
    ('No such file', ['./nowhere']), ('broke off.*status 3', ['sh', '-c', 'exit 3']),
    ('broke off.*signal 9', ['sh', '-c', 'kill -9 $$']), ("not a run.*'hello'", ['echo', 'hello']),
    ('broke off', ['printf', r'isochron 2\nscene x\n']), ("'colour'", ['printf', r'isochron 2\ncolour red\n\n']),
    ('makes no sense', ['printf', HEADER]), ('makes no sense', ['printf', r'isochron 2\nscene x\n\n']),
    ('Bail out! hot', ['printf', r'Bail out! hot\n'])))
def test_told_of_a_command(tells, text, command):
    """One that does not exist, fails, is killed, is no run; a header without a run, with an unknown line, with more units
    than outputs, without a step; a platform that gives up."""
    tells(text, *command)


def test_told_of_a_run_that_is_cut_off_and_of_a_whole_one_that_then_fails(tells, stream):
    for count in (100, 250, 5000):
        tells('broke off', 'head', '-c', count, stream)
    tells('ended with status 4', 'sh', '-c', f"cat '{stream}'; exit 4")


def test_a_run_that_fails_leaves_the_last_table(stream, tmp_path):
    path_of('precious', tmp_path / 'kept', 'trace.csv')
    assert run(TRACE, '-o', tmp_path / 'kept', '--', 'false').status != 0
    assert (tmp_path / 'kept/trace.csv').read_text() == 'precious'
    (tmp_path / 'kept/trace.csv.partial').symlink_to('/dev/full')
    done = run(TRACE, '-o', tmp_path / 'kept', '--', 'cat', stream)
    assert done.status != 0 and 'No space' in done.errors


@pytest.mark.parametrize('words, text', ((['-o', 'nowhere/at/all', '--', 'true'], 'No such file'), ([], 'usage')))
def test_told_what_it_is_asked_wrongly(words, text):
    done = run(TRACE, *words)
    assert done.status != 0 and text in done.errors


def test_instructions_of_interrupts_that_come_during_a_step_are_told(oscillator, tmp_path):
    """Where ticks came late; else not."""
    def said(*script):
        return run(TRACE, '-o', tmp_path, '--clock', 'instructions', '--', oscillator, 1000000000, *script).said

    late = said(path_of('slow 5 20ms\n', tmp_path, 'script'))
    assert late['instructions_per_step'].startswith('0 20000000, up to 20000000 of them of the interrupts')
    assert said()['instructions_per_step'] == '0'


@pytest.mark.parametrize('text, line', (
    ('hurry 5\n', 1), ('# nothing\n\nlate 5\n', 3), ('late 0 1us\n', 1), ('late -1 1us\n', 1), ('late 18446744073709552 1us\n', 1),
    ('late 5 300\n', 1), ('late 5 300 us\n', 1), ('slow 5 3601s\n', 1), ('slow 5 99999999999999999999ns\n', 1),
    ('lose 7 1us\n', 1), ('lose 7\nlose 7\n', 2)))
def test_the_simulated_tick_refuses_a_script_and_names_its_line(oscillator, tmp_path, text, line):
    script = path_of(text, tmp_path, 'script')
    done = run(oscillator, 1000000, script)
    assert done.status != 0 and re.search(f'^{script}:{line}: ', done.errors, re.M)


def test_a_script_that_does_not_exist_and_a_duration_that_is_no_number(oscillator):
    assert re.search('^nowhere: No such', run(oscillator, 1000000, 'nowhere').errors, re.M)
    assert "'1s'" in run(oscillator, '1s').errors


def test_a_reader_slower_than_the_board_loses_nothing_and_costs_the_board_no_time(laboratory):
    bench = build.plant(ROOT / 'models/double_pendulum.scene', target='cortex-m4f')
    environment = {'PROGRAM': str(bench.program.absolute()), 'NANOSECONDS': '10000000000', 'FROM': f'{ROOT}/', 'PATH': '/usr/bin:/bin'}
    fast, slow = (subprocess.run(['sh', '-c', f'{{ {bench.port.exec}; }} {pipe}'], env=environment, stdout=subprocess.PIPE,
                                 stdin=subprocess.DEVNULL, check=True).stdout for pipe in ('', '| { sleep 1 && cat; }'))
    assert fast == slow and len(fast) > 10000


@pytest.mark.parametrize('text, statement', (
    ('^Bail out! fault 0x00008200 at 0x', '*(volatile int *)0x60000000 = 1;'),
    ('^Bail out! fault 0x00010000 at 0x', '__asm__ volatile("udf #0");'),
    ('^Bail out! fault 0x000000.2$', 'for (;;) __asm__ volatile("push {r0-r7}" ::: "memory");')))
def test_the_board_tells_of_a_fault(program, laboratory, tmp_path, text, statement):
    """An address without memory, an undefined instruction, a stack that is too deep."""
    fault = path_of(f'#include "port/port.h"\nint main(void)\n{{\n{statement}\nreturn 0;\n}}\n', tmp_path, 'fault.c')
    done = run(*on_board(program(fault, 'port/mps2/*.c', target='cortex-m4f')))
    assert done.status == 1 and re.search(text, done.printed + done.errors, re.M)
