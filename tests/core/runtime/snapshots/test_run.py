"""isochron run takes a snapshot at a tick, and goes on from one: the halves of a run end with the hash of the whole, on the
host and from there on the Cortex-M4F and back; the rows are those of the whole; what does not fit is refused, and touches
no file."""
import re
import shutil

import pytest

from harness.programs import path_of, run
from harness.project import ROOT
from lab import build
from lab import run as runs

SCENE = ROOT / 'models/cart_pole.scene'     # an input that is a function of time; by ab4 with a history


@pytest.fixture
def half(isochron, laboratory):
    """half(word, ...): a run of 2 s by ab4, unless the words say otherwise; with its `folder` and its `table`."""
    def call(*words):
        words = [*words, *([] if '--method' in words else ['--method', 'ab4']), *([] if '--seconds' in words else ['--seconds', 2])]
        of = isochron('run', *([] if any(str(word).endswith('.c') for word in words) else [SCENE]), *words)
        if of.status == 0:
            of.table = (laboratory / of.said['trace']).read_text().splitlines()
        return of

    return call


@pytest.fixture
def whole(half, laboratory, tmp_path):
    """The whole run, with a snapshot of tick 765."""
    of = half('--snapshot', 765)
    assert of.status == 0 and of.said['snapshot'] == 'build/host/float/cart_pole/snapshot.bin'
    of.record = shutil.move(laboratory / of.said['snapshot'], tmp_path / '765.bin')
    return of


def test_the_halves_end_with_the_hash_of_the_whole(half, whole, laboratory):
    """From the host to the board and back."""
    board = half('--target', 'cortex-m4f', '--restore', whole.record, '--snapshot', 1234)
    assert (board.said['hash'], board.said['from'], board.said['ticks']) == (whole.said['hash'], '765', str(2000 - 765))
    assert board.table == whole.table[:1] + whole.table[766:]
    back = half('--restore', laboratory / board.said['snapshot'])
    assert (back.said['hash'], back.said['from']) == (whole.said['hash'], '1234') and 'snapshot' not in back.said


def test_a_run_without_a_snapshot_is_the_whole_as_well(half, whole):
    of = half()
    assert of.said['hash'] == whole.said['hash'] and 'from' not in of.said and of.table == whole.table


def test_what_does_not_fit_is_refused_and_touches_no_file(half, whole, laboratory, tmp_path):
    table = laboratory / whole.said['trace']
    damaged = bytearray(whole.record.read_bytes())
    damaged[100] = ord('x')
    (tmp_path / 'damaged.bin').write_bytes(damaged)
    by_heun = half('--method', 'heun', '--snapshot', 765)      # whose memory has the size of that of euler
    shutil.move(laboratory / by_heun.said['snapshot'], tmp_path / 'heun.bin')
    kept = table.read_bytes()
    for problem, record, *words in (
            ('the snapshot is damaged', 'damaged.bin'),
            ('the run ends before the tick of the snapshot', '765.bin', '--seconds', 0.764),
            ('is no snapshot', 'absent.bin'),
            ('does not come by the tick of the snapshot', '765.bin', '--snapshot', 2001),
            ('the snapshot is of another plant', '765.bin', '--method', 'heun'),
            ('--snapshot 1e3 is no TICK', '765.bin', '--snapshot', '1e3'),
            ('they are for scenes', '765.bin', ROOT / 'models/oscillator.c'),
            ('the snapshot is of another plant', 'heun.bin', '--method', 'euler'),
            ('the snapshot is of another plant', 'heun.bin', '--method', 'heun', '--step', '2ms', '--seconds', 4)):
        of = half('--restore', tmp_path / record, *words)
        assert of.status != 0 and problem in of.errors, (problem, of.errors)
        assert table.read_bytes() == kept and not (table.parent / 'snapshot.bin').exists()


def test_identities_are_different_by_method_step_and_numbers(isoc):
    """That of one plant is the same each time."""
    def identity(*options):
        return re.search(r'\.identity = (.*),', isoc(SCENE, '--link', *options).file('interface.c'))[1]

    seen = [identity('--method', method, '--step', step, *(['--tolerance', '1e-6'] if method == 'adams' else []))
            for method in build.methods() for step in ('1ms', '2ms')] + [identity('--real', 'double')]
    assert len(seen) == len(set(seen)) >= 23 and identity() == identity()


def test_snapshot_is_of_run(isochron):
    of = isochron('size', ROOT / 'models/double_pendulum.scene', '--snapshot', 3)
    assert of.status != 0 and '--snapshot has no effect on size' in of.errors


def test_found_a_program_that_leaves_the_history_out_of_the_record(whole, program, isoc, tmp_path):
    """It has another hash; one without the defect has that of the whole."""
    taken = 'memcpy(snapshot + sizeof head, plant->memory, head.memory_bytes);'
    made = isoc(SCENE, '--link', '--method', 'ab4')
    sources = build.port('host', kind='recorded').facts['SOURCES'].split()

    def ended(planted):
        for name, snapshot, restore in (('first', '765', None), ('second', None, tmp_path / 'first/snapshot.bin')):
            words = build.object_of(snapshot=snapshot, restore=restore, scene=str(SCENE))
            request = path_of(runs.request(words), tmp_path / name, 'request.c')
            done = run(ROOT / 'build/trace', '-o', tmp_path / name, '--', program(made, request, *sources, planted=planted), 2 * 10**9)
        return done.said.get('hash')

    assert ended(None) == whole.said['hash']
    assert ended({'core/runtime/snapshot.c': (taken, taken.replace('head.memory_bytes', '16'))}) != whole.said['hash']
