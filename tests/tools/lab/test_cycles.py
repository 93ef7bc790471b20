"""isochron cycles: what is told of a scene, what does not fit, and what is wrong with what was asked for; the AVR's
table against the cycles that simavr counts; a row of models/cycles.md by turns."""
import re
import shutil

import pytest

from harness.project import ROOT, turn
from lab import build, cycles, machine

MODELS = ROOT / 'models'
PENDULUM, DRIVE = MODELS / 'pendulum.scene', MODELS / 'cart_pole_drive.scene'


@pytest.fixture
def cycles_of(isochron, laboratory):
    """cycles_of(scene, option, ...): the command, with the cells of its file by their names as `cells`."""
    def call(scene, *words):
        of = isochron('cycles', scene, *words)
        path = re.search(r'^numbers +(.*)$', of.printed, re.M)
        assert path, of.errors
        rows = [line.split('\t') for line in (laboratory / path[1]).read_text().splitlines()]
        of.rows = rows
        of.cells = {row[1] if row[0] in ('part', 'kind') else row[0]: row for row in rows}
        return of
    return call


def test_the_parts_are_the_tick_and_the_kinds_the_step(cycles_of):
    of = cycles_of(DRIVE, '--clock', '168MHz')
    assert of.status == 0 and of.printed.endswith('\nfits\n')
    parts = [row for row in of.rows if row[0] == 'part' and row[1] not in ('tick', 'interrupt')]
    for column in 3, 4:
        assert sum(float(row[column]) for row in parts) == float(of.cells['tick'][column]) > 0
    kinds = [row for row in of.rows if row[0] == 'kind']
    assert sum(float(row[4]) for row in kinds) == float(of.cells['step'][4])
    assert sum(float(row[5]) for row in kinds) == pytest.approx(100, abs=0.1)
    assert 'dearest of a run with a change of the first tunable' in of.printed and int(of.cells['checks'][2]) > 50


def test_stack_and_instructions_are_those_of_other_commands(cycles_of, isochron):
    of = cycles_of(DRIVE)
    stack = isochron('stack', DRIVE, '--target', 'cortex-m4f')
    assert stack.said['stack_of_step'] == of.cells['stack'][2]
    run = isochron('run', DRIVE, '--target', 'cortex-m4f', '--seconds', '0.01')
    # With a reading of the clock.
    assert 0 <= int(run.said['instructions_per_step']) - int(of.cells['step'][2]) <= 10


def test_half_the_clock_is_twice_the_load_and_a_slow_one_does_not_fit(cycles_of):
    load = [float(cycles_of(DRIVE, '--clock', clock).cells['load_percent'][2]) for clock in ('168MHz', '84MHz')]
    assert load[1] == pytest.approx(2 * load[0], rel=1e-3)
    slow = cycles_of(DRIVE, '--clock', '2MHz')
    assert slow.status == 1 and slow.printed.endswith('\ndoes not fit: the tick is longer than the step\n')


def test_the_m7_has_a_bound(cycles_of):
    step = cycles_of(DRIVE, '--target', 'cortex-m7').cells['step']
    assert float(step[3]) >= int(step[2]) / 2 and float(step[4]) > 1.5 * float(step[3])


def test_the_small_multiplier_takes_longer(cycles_of):
    fast, small = (float(cycles_of(PENDULUM, '--target', 'cortex-m0', *core).cells['step'][4])
                   for core in ((), ('--core', 'cortex-m0-small')))
    assert small > fast


def test_a_tick_with_a_step_that_is_made_again_is_the_dearest(cycles_of, laboratory):
    text = re.sub('^method.*', '', PENDULUM.read_text(), flags=re.M)
    (laboratory / 'again.scene').write_text(text + 'method abm4\nchecked yes\n')
    assert 'dearest of a run with every second step made again' in cycles_of('again.scene').printed


def test_of_adams_all_sub_steps_are_counted_though_none_but_the_first_is_needed(cycles_of, laboratory):
    counts = []
    for n in 1, 3, 4:
        statements = f'method adams; tolerance 1; substeps {n}'
        (laboratory / 'adams.scene').write_text(re.sub('^method.*', statements, PENDULUM.read_text(), flags=re.M))
        counts.append(float(cycles_of('adams.scene').cells['step'][4]))
    one, three, four = counts
    assert three == four > 2.5 * one


@pytest.mark.parametrize('problem, words', (
    ('--clock 168 is no clock; it could be 168MHz', ['--clock', '168']),
    ('--clock -1MHz is no clock', ['--clock=-1MHz']),
    ('--clock 1ms is no clock', ['--clock', '1ms']),
    ('--board nano is unknown; of --target cortex-m4f it can be: stm32f405', ['--board', 'nano']),
    ('--core cortex-m3 is no table of --target cortex-m4f; it can be: cortex-m4f', ['--core', 'cortex-m3']),
    ('no table for --target rv32imac: the cycles of a RISC-V core', ['--target', 'rv32imac']),
    ('no table for --target cortex-m33: of the Cortex-M33 no published', ['--target', 'cortex-m33']),
    ('no table for --target host', ['--target', 'host'])))
def test_wrong(isochron, problem, words):
    of = isochron('cycles', PENDULUM, *words)
    assert of.status == 1 and problem in of.errors and len(of.errors.splitlines()) == 1


def test_without_a_scene_options_have_no_effect(isochron):
    of = isochron('cycles', '--target', 'cortex-m3')
    assert of.status == 1 and '--target has no effect without a scene' in of.errors


def apart(plant):
    """By which part of the simulator's cycles the table's differ at most, of a part of the tick; and the cycles of the
    step. Both leave interrupts out."""
    tick = cycles.dearest(plant, 'atmega1284p', 2)
    off = [abs(tick.parts[name][2] - of) / of for name, of in tick.simulated.items() if name in tick.parts and of]
    return max(off), tick.simulated['step']


@pytest.mark.parametrize('model', ('pendulum', 'cart_pole_drive', 'dc_motor_bench'))
def test_the_avr_takes_what_simavr_counts(laboratory, model):
    off, step = apart(build.plant(MODELS / f'{model}.scene', target='atmega1284p'))
    assert off <= 1e-3 and step > 10000


def test_found_a_product_of_three_cycles(laboratory, tmp_path, monkeypatch):
    shutil.copytree(machine.CYCLES / 'cores', tmp_path / 'cores')
    monkeypatch.setattr(machine, 'CYCLES', tmp_path)
    path = machine.path_of('atmega1284p')
    path.write_text(re.sub(r'^(mul.*)\| 2 ', r'\1| 3 ', path.read_text(), flags=re.M))
    assert apart(build.plant(PENDULUM, target='atmega1284p'))[0] > 1e-3


def written():
    """The rows of models/cycles.md."""
    text = re.search(r'<!-- isochron cycles -->\n(.*?)<!-- end', (MODELS / 'cycles.md').read_text(), re.S)[1]
    return [[cell.strip() for cell in line.split('|')[1:-1]] for line in text.splitlines() if line.startswith('|')]


def test_the_table_has_all_models_as_they_are(isochron):
    """On the Cortex-M4F and one other core."""
    head, _, *rows = written()
    assert [row[0] for row in rows] == sorted(path.stem for path in MODELS.glob('*.scene'))
    now = turn(3 * len(rows))
    if now is None:
        assert isochron('cycles').rows == written()
        return
    model, other = now % len(rows), now // len(rows)
    cores = ['cortex-m4f', ('cortex-m3', 'cortex-m0', 'atmega1284p')[other]]
    known = {'cortex-m3': (5, 8), 'cortex-m0': (8, 11), 'atmega1284p': (11, 13)}[cores[1]]
    wanted = [cell if i < 5 or known[0] <= i < known[1] else '.' for i, cell in enumerate(rows[model])]
    of = isochron('cycles', TURN=f'{model}/{len(rows)}', CORES=' '.join(cores))
    assert of.rows[0] == head and of.rows[2:] == [wanted], of.errors
