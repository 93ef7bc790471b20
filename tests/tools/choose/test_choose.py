"""isochron choose: what it takes keeps its bounds in a run of its own, and nothing is cheaper by more than 10 %, by a search
of all ticks and sub-steps; what cannot be; what is asked for wrongly; what it writes into a scene."""
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys

import pytest

from front import parse
from front.commands import BY_NAME
from harness.project import ROOT
from lab import choose, kept, motion, search
from lab.build import Wrong
from lab.machine import machine
from lab.scene import edited

PENDULUM = ROOT / 'models/pendulum.scene'
README = ' '.join((ROOT / 'tools/lab/choose.md').read_text().split())


def options_of(scene, error, *words):
    return parse.options_of(BY_NAME['choose'], [str(scene), '--error', error, *words])


@pytest.fixture
def chosen(laboratory, tmp_path):
    """chosen(scene, error, word, ...): the Choice that was made, and its best Candidate."""
    def make(scene, error, *words):
        options = options_of(scene, error, *words)
        of = choose.Choice(options, machine(options.target), tmp_path)
        return of, of.chosen(options.methods.split())
    return make


@pytest.mark.parametrize('error, load, text', [
    ('1 mm of top', '50%', "'1 mm of top': there is no output top; the scene has: theta rate tip energy"),
    ('1 mm of tip; 1 s of tip', '50%', "'1 s of tip': s is no unit of tip, which is in m"),
    ('mm of tip', '50%', "'mm of tip' is no bound; it could be '1 mm of tip'"),
    ('-1 mm of tip', '50%', "'-1 mm of tip' is no bound: it must be greater than 0"),
    ('1 mn of tip', '50%', "unknown unit 'mn'"),
    ('', '50%', '--error is missing'),
    ('1 mm of tip', 'half', '--load half is no load; it could be 50%')])
def test_refused(isochron, error, load, text):
    of = isochron('choose', PENDULUM, '--error', error, '--load', load, '--seconds', '1', '--methods', 'rk4')
    assert of.status == 1 and text in of.errors and len(of.errors.splitlines()) == 1


def test_refused_inputs(isochron, tmp_path):
    file = tmp_path / 'inputs'
    file.write_text('1 2\n3 4\n')
    for scene, words, text in ((PENDULUM, [], 'has no inputs'), (ROOT / 'models/cart_pole.scene', [], 'no lines of 1 numbers'),
                               (ROOT / 'models/cart_pole.scene', ['--inputs', 'smooth'], 'there is no signal')):
        of = isochron('choose', scene, '--error', '1 J of energy', '--recorded', file, '--methods', 'rk4', *words)
        assert of.status == 1 and text in of.errors


TOLD = '''step 1 ms; method rk4 # method ab4; step
effect hold spring { along rail
    substeps 4 }
overrun degrade { method euler; after 3 ticks }
include "a;b.scene" ; compensated yes
'''


def test_statements_at_the_top_of_a_scene_are_replaced():
    of = edited(TOLD, {'step': '4 ms', 'method': 'heun', 'substeps': '2', 'compensated': None}, must='step')
    assert re.sub(' *\n', '\n', of) == (TOLD.replace('1 ms', '4 ms').replace('method rk4', 'method heun')
                                       .replace(' compensated yes', '') + 'substeps 2\n')


def test_a_step_that_stands_in_no_line_of_the_file_is_not_added():
    assert edited(TOLD.partition('\n')[2], {'step': '4 ms'}, must='step') is None


def test_a_bound_below_what_a_float_holds(isochron, tmp_path):
    scene = tmp_path / 'swing.scene'
    shutil.copy(PENDULUM, scene)
    of = isochron('choose', scene, '--error', '1 nm of tip', '--seconds', '0.1', '--step', '10ms', '--methods', 'rk4', '--write')
    assert of.status == 1 and scene.read_text() == PENDULUM.read_text()
    assert of.printed.splitlines()[-1] == 'none: no method keeps 1 nm of tip within 50 % of the chip'
    assert 'A larger error: --error ' in of.printed and 'Another chip: ' in of.printed


def lacking(rule, monkeypatch, tmp_path):
    """A core whose table lacks a rule; what was measured before is not taken."""
    table = (ROOT / 'tools/measure/cycles/cores/cortex-m4f.txt').read_text()
    path = tmp_path / 'cortex-m4f.txt'
    path.write_text(re.sub(rf'^{rule} .*\n', '', table, flags=re.M))
    assert path.read_text() != table
    monkeypatch.setattr('lab.cycles.path_of', lambda core: path)
    monkeypatch.setattr(kept, 'FOLDER', tmp_path / 'kept')


def test_a_method_without_a_price_is_a_row_that_says_so(laboratory, capfd, monkeypatch, tmp_path):
    lacking('smulbb', monkeypatch, tmp_path)
    status = choose.run(options_of(ROOT / 'models/dc_motor_bench.scene', '10 mA of current', '--seconds', '0.02', '--methods', 'rk4 adams'))
    printed = capfd.readouterr().out
    assert status == 0 and printed.splitlines()[-1].startswith('take: rk4 at ')
    assert re.search('^adams  .* no cycles are known: the table of the Cortex-M4F has no rule for the instruction smulbb$',
                     printed, re.M)


def test_where_no_method_has_a_price_that_is_said(laboratory, capfd, monkeypatch, tmp_path):
    lacking('vadd', monkeypatch, tmp_path)
    status = choose.run(options_of(PENDULUM, '1 mm of tip', '--seconds', '0.1', '--methods', 'rk4 adams'))
    printed = capfd.readouterr().out
    assert len(re.findall(r' no cycles are known: the table of the Cortex-M4F has no rule for the instruction v[a-z]*[.]f32$',
                          printed, re.M)) == 2
    assert status == 1 and printed.splitlines()[-1] == 'none: of no method that keeps 1 mm of tip the cycles are known'


def test_a_chaotic_motion(isochron):
    """The largest exponent of Lyapunov of the double pendulum has a time below a second."""
    of = isochron('choose', ROOT / 'models/double_pendulum.scene', '--error', '1 mm of tip', '--seconds', '20', '--methods', 'rk4',
                  '--clock', '168MHz')
    assert of.status == 0, of.errors
    for text in re.findall(r'^From .*(?:\n.*)?Judged .*|^take: rk4 at .*, compensated: .*', of.printed, re.M):
        assert ' '.join(text.split()) in README, text
    assert ' s on no method in float can keep the bound' in of.printed


def test_asked_again_it_measures_nothing(chosen, monkeypatch):
    words = ROOT / 'models/cart_pole.scene', '10 mm of cart_position', '--seconds', '0.5', '--methods', 'rk4 heun'
    first, best = chosen(*words)
    monkeypatch.setattr(choose, 'dearest', None)
    monkeypatch.setattr('lab.motion.library', None)
    monkeypatch.setattr(choose.Motions, 'bounded', lambda self, asked: vars(self).update(
        {name: getattr(first.motions, name) for name in 'period inputs every reading bounds columns'.split()}) or first.summary)
    again, other = chosen(*words)
    assert list(again.table()) == list(first.table()) and other == best


def test_a_changed_bound_takes_the_motions_that_are_there(chosen, monkeypatch):
    chosen(ROOT / 'models/cart_pole.scene', '10 mm of cart_position', '--seconds', '0.5', '--methods', 'rk4')
    made = []
    monkeypatch.setattr('lab.motion.library', lambda *words, of=motion.library: made.append(words) or of(*words))
    chosen(ROOT / 'models/cart_pole.scene', '11 mm of cart_position', '--seconds', '0.5', '--methods', 'rk4')
    assert len(made) <= 2, made


# Scene or the seed of one, method, what else is asked for, bound.
CASES = [
    ('pendulum', 'heun', '10 mm of tip'), ('pendulum', 'rk4', '1 mm of tip'), ('pendulum', 'ab4', '10 um of tip'),
    (1, 'rk4', '10 mm of tip'), (1, 'ab4', '10 um of tip'), (1, 'heun', '1 um of tip'),
    ('cart_pole', 'adams --step 1ms', '10 mm of cart_position'), ('cart_pole', 'rk4', '1 mm of cart_position; 1 deg of pole'),
    ('cart_pole', 'rosenbrock', '1 um of cart_position'), (2, 'rk4', '10 mm of tip'), (2, 'heun', '1 mm of tip'),
    (2, 'ab4', '10 um of tip'), ('double_pendulum', 'abm4', '10 mm of tip'), ('double_pendulum', 'rk4', '1 mm of tip'),
    ('double_pendulum', 'ab4', '10 um of tip'), (3, 'rk4', '10 mm of tip'), (3, 'abm4_pec', '1 mm of tip'), (3, 'ab4', '10 um of tip'),
    ('top', 'heun', '1 mm of stem'), ('top', 'rk4', '0.1 mm of stem'), ('top', 'rosenbrock', '10 um of stem'),
    (4, 'rk4', '10 mm of tip'), (4, 'heun', '1 mm of tip'), (4, 'ab4', '10 um of tip')]
PARTS = 5


def places(of, method, best, cycles, evaluations):
    """Every fifth (k, n) that can cost less, where one step in the scene's tick takes so many cycles: compensated sums only
    add to it, and each further step has at least the operations of its evaluations. A step of another length takes a
    cycle or two more or less, for which a hundredth is added."""
    motions, found = of.motions, []
    grid = search.Grid(motions, of.longest, 1, 10 ** 9, None)
    if method == 'adams':
        there = [(1, 2 ** i) for i in range(11)] + [(k, 2 ** i) for k in grid.ticks for i in range(7)]
    else:
        there = [(1, 1), *((k, 1) for k in grid.ticks), *((1, n) for n in grid.parts)]
    for k, n in there:
        load = (cycles + (n - 1) * evaluations * of.each) / of.machine.hz / (motions.period * k) * 1e11
        if load < 1.01 * best.load:
            found.append((k, n))
    return [place for i, place in enumerate(found) if i % PARTS == 0 or place == (best.k, best.n)]


@pytest.mark.seeds(2)
def test_nothing_is_cheaper(chosen, tmp_path, seed):
    """One case, which a seed chooses, among all that could cost less."""
    scene, method, bound = random.Random(seed).choice(CASES)
    method, *words = method.split()
    path = tmp_path / 'case.scene'
    if isinstance(scene, int):
        path.write_text(subprocess.run([sys.executable, ROOT / 'tests/tools/choose/write_scene.py', str(scene)], capture_output=True,
                                       text=True, check=True).stdout)
    else:
        shutil.copy(ROOT / f'models/{scene}.scene', path)
    of, best = chosen(path, bound, '--seconds', '1', '--methods', method, *words)
    assert best is not None, [vars(one) for one in of.candidates]
    assert best.ratio <= 1
    names = [f'adams-{tolerance}' for tolerance in search.TOLERANCES] if method == 'adams' else [method]
    evaluations, kept_bounds = 2 if method == 'adams' else of.costs[method][1], []
    for name in names:
        once = of.priced(choose.Candidate(name, False, 1, 1))
        for k, n in places(of, method, best, once.cycles, evaluations):
            for compensated in (False, True) if method != 'adams' else (False,):
                if of.ratio(name, compensated, k, n) <= 1:
                    kept_bounds.append(of.priced(of.candidate(name, compensated, k, n)))
    cheaper = [one for one in kept_bounds if one.load < 0.9 * best.load]
    assert not cheaper, (best, cheaper)
    # What it took is among them, as it costs what it costs.
    assert [one.load for one in kept_bounds if (one.method, one.compensated, one.k, one.n) == (
        best.method, best.compensated, best.k, best.n)] == [best.load]


def test_the_scene_has_the_advice(isochron, isoc, tmp_path):
    scene = tmp_path / 'case.scene'
    shutil.copy(ROOT / 'models/top.scene', scene)
    of = isochron('choose', scene, '--error', '1 mm of stem', '--seconds', '1', '--methods', 'heun', '--write')
    assert of.status == 0 and re.search(r'^It ran as .*: its error is \d+ % of the bound\.$', of.printed, re.M), of.errors
    step, unit = re.search(r'^written into .*: step (\S+) (ms|us);', of.printed, re.M).groups()
    made = isoc(pathlib.Path(scene))
    assert made.summary['method'] == 'heun'
    printed = float(re.search(r'^step (\S+) s$', made.printed, re.M)[1])
    assert abs(printed - float(step) * {'ms': 1e-3, 'us': 1e-6}[unit]) < 1e-12


def test_a_wrong_advice_is_found(chosen, monkeypatch):
    """The run of the advised scene has the error that the search has found; with another one it ends with a message."""
    monkeypatch.setattr(choose.Choice, 'measured', lambda self, best, trace: (1.01 * best.ratio, 1e-4))
    with pytest.raises(Wrong, match='of the bound when it runs, not'):
        chosen(PENDULUM, '1 mm of tip', '--seconds', '1', '--methods', 'heun')


def heeds_interrupts():
    """What a shell begins in the background ignores them, and so do its children."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def test_ended_by_the_user_it_goes_on(isochron, laboratory, tmp_path):
    """Ctrl-C ends it, whatever it does, and leaves nothing that is wrong: the same question has the same answer."""
    def asked(comment):
        scene = tmp_path / 'cart.scene'
        scene.write_text((ROOT / 'models/cart_pole.scene').read_text() + f'# {tmp_path} {comment}\n')
        return ['choose', scene, '--error', '10 mm of cart_position', '--seconds', '0.5', '--methods', 'rk4 heun ab4']

    whole = isochron(*asked('whole')).printed
    with subprocess.Popen([ROOT / 'tools/isochron', *asked('ended')], start_new_session=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, preexec_fn=heeds_interrupts) as process:
        while not process.stderr.readline().startswith('choose: 1 of 3'):
            assert process.poll() is None
        os.killpg(process.pid, signal.SIGINT)
        process.communicate()
    assert process.returncode == 128 + signal.SIGINT
    assert isochron(*asked('ended')).printed == whole
