"""Pins of the host and of the emulated Pico, by one script: what is measured and shown has the same bits on both, and is
right by references that share no code with them."""
# Depends on: core port models tools Makefile
import bisect
import math
import random

import numpy
import pytest

from harness import project

from pico import copied, emulated, package  # noqa: F401

STEP, GRID, COUNT = 1_000_000, 8, 32      # ns: of the scene, of the clocks, of a count of the duty at that step
TARGETS = ('host', 'rp2040')
SCENE = '''step 1 ms
method rk4
body disc {
    mass 1 kg
    inertia (0.1, 0.1, 0.001) kg*m^2
}
joint axle revolute {
    parent ground
    child disc
    axis z
    drive torque
    speed 0 rad/s
}
input torque
input second
output angle = position of axle
output first = torque
output other = second
'''


def row(place, kind, pin, at_1='1.0', **more):
    fields = {'place': place, 'kind': f'PINS_{kind}', 'pin': pin, 'at_0': 'R(0.0)', 'at_1': f'R({at_1})', **more}
    return '{' + ', '.join(f'.{name} = {value}' for name, value in fields.items()) + '}'


class Bench:
    """Runs of a scene with a table of pins and the events of a script, on a target."""

    def __init__(self, isochron, folder):
        self.isochron, self.folder = isochron, folder

    def run(self, target, events=(), inputs=(), outputs=(), seconds=0.05, scene=SCENE, good=True):
        table = [f'#define PINS_{name} {", ".join(rows)}' for name, rows in (('INPUTS', inputs), ('OUTPUTS', outputs)) if rows]
        (self.folder / 'pins.h').write_text('\n'.join(table) + '\n')
        (self.folder / 'rotor.scene').write_text(scene)
        record = self.folder / f'{target}.record'
        script = self.folder / f'{target}.script'
        script.write_text(f'record {record}\n' + ''.join(f'{word} {pin} {at}ns{end}\n' for at, pin, word, end in events))
        done = self.isochron('run', 'rotor.scene', '--target', target, '--seconds', seconds, '--script', script, cwd=self.folder,
                             CFLAGS='-include pins.h')
        assert not good or done.status == 0, done.errors
        if good:
            done.trace = numpy.genfromtxt(self.folder / f'build/{target}/float/rotor/trace.csv', delimiter=',', names=True)
            done.record = [line.split() for line in record.read_text().splitlines()]
        return done

    def needs(self, mend, seconds):
        """Whether the last run on the Pico is another in an emulator without a mend of its package."""
        run = [self.folder / 'build/rp2040/float/rotor/program.elf', int(seconds * 1e9), [self.folder / 'rp2040.script']]
        folder = self.folder / mend.split('(')[0]
        return emulated(*run).stdout != emulated(*run, emulator=copied(folder, mend)).stdout


@pytest.fixture
def bench(isochron, tmp_path):
    return Bench(isochron, tmp_path)


def level(at, pin, is_high):
    return at, pin, 'high' if is_high else 'low', ''


def pulses(random_of, pin, end):
    """Changes of a pin with pulses of 1 to 50 kHz, of 0 to 100 %, each kind for 3 ms."""
    at, changes = 10_000, []
    while at < end:
        stop, period = at + 3 * STEP, int(1e9 / 10 ** random_of.uniform(3, math.log10(50e3)))
        part = random_of.choice([0, 1, 0.5, random_of.random(), random_of.random() / 50, 1 - random_of.random() / 50])
        while at < stop:
            width = int(part * period)
            changes += [(at, True)] if width else []
            changes += [(at + width, False)] if width < period else []
            at += period
    kept = []
    for at, is_high in sorted(changes):
        if not kept or kept[-1][1] != is_high:
            kept.append((at, is_high))
    return [level(at, pin, is_high) for at, is_high in kept]


def high_time(events, begin, end):
    """The time for which a pin is high between two times."""
    edges = [(at, word == 'high') for at, _, word, _ in events]
    total, since = 0, None
    for at, is_high in [*edges, (end, False)]:
        at = min(max(at, begin), end)
        if since is not None:
            total += at - since
        since = at if is_high else None
    return total


@pytest.mark.seeds(1)
def test_a_duty_is_right_within_one_count_and_the_same_on_both(bench, seed):
    events = pulses(random.Random(seed), 3, 50 * STEP)
    seen = [(-(-at // GRID) * GRID, pin, word, end) for at, pin, word, end in events]      # at the next count of a clock
    host, pico = (bench.run(target, events, [row(0, 'DUTY', 3)]) for target in TARGETS)
    assert host.said['hash'] == pico.said['hash']

    def worst(of):
        parts = [high_time(of, STEP * k, STEP * (k + 1)) / STEP for k in range(50)]
        return max(abs(a - b) for a, b in zip(pico.trace['first'][1:], parts))
    float_error = 2 ** -24
    assert worst(seen) <= COUNT / STEP + float_error
    assert {0.0, 1.0} <= set(numpy.round(pico.trace['first'], 3)) and len(set(pico.trace['first'])) > 10
    missed = [event for event in seen if event != seen[7]]
    assert worst(missed) > 2 * COUNT / STEP and bench.needs('mendGates(this.mcu);', 0.05)  # the controls


def quadrature(random_of, pin, end, least, most, turns):
    """Changes of two pins: the count goes up and down at random, and never near a tick; and the count at each tick."""
    at, count, way, events, counts = 5_000, 0, 1, [], [0]
    while at < end:
        count += way
        phase = count % 4
        now = (phase in (1, 2), phase in (2, 3))
        before = ((count - way) % 4 in (1, 2), (count - way) % 4 in (2, 3))
        which = 0 if now[0] != before[0] else 1
        events.append(level(at, pin + which, now[which]))
        at += random_of.randint(least, most)
        if at % STEP < 3_000 or at % STEP > STEP - 3_000:
            at = -(-(at - 3_000) // STEP) * STEP + 5_000
        if random_of.random() < turns:
            way = -way
        while len(counts) * STEP < at:
            counts.append(count)
    return events, counts


@pytest.mark.seeds(1)
def test_a_quadrature_is_counted_without_an_error_over_reversals_and_at_the_highest_speed(bench, seed):
    random_of = random.Random(seed)
    slow, counts = quadrature(random_of, 6, 12 * STEP, 712, 20_000, 0.05)
    fast, others = quadrature(random_of, 8, 12 * STEP, 712, 712, 0.002)
    events = sorted([*slow, *fast])
    inputs = [row(0, 'QUADRATURE', 6, at_1='1e-4'), row(1, 'QUADRATURE', 8)]
    host, pico = (bench.run(target, events, inputs, seconds=0.012) for target in TARGETS)
    assert host.said['hash'] == pico.said['hash']
    assert [round(1e4 * value) for value in pico.trace['first']] == counts[:13]
    assert [round(value) for value in pico.trace['other']] == others[:13] and max(map(abs, others)) > 1000
    assert bench.needs('mendMachines(this);', 0.012)
    # The control: of edges that are closer than a round of the decoder some are lost.
    close, counts = quadrature(random_of, 6, 4 * STEP, 300, 300, 0)
    lost = bench.run('rp2040', close, [row(1, 'QUADRATURE', 6)], seconds=0.004)
    assert [round(value) for value in lost.trace['other']] != counts[:5]


TURNING = SCENE.replace('speed 0 rad/s', 'speed 60 rad/s').replace(
    'input torque\n', 'input torque = -6 N*m\n')


def decoded(record, pin, turn):
    """The times at which a recorded quadrature has a new count, with that, by a table of pairs; a pair that cannot be, and an
    index in a wrong place, is an error."""
    up = {(0, 0): (1, 0), (1, 0): (1, 1), (1, 1): (0, 1), (0, 1): (0, 0)}
    state, index, count, found, pending = None, None, None, [], {}
    for word, number, at, *_ in record:
        pending.setdefault(int(at[:-2]), {})[int(number) - pin] = word == 'high'
    levels = [False, False, False]
    for at in sorted(pending):
        for which, is_high in pending[at].items():
            levels[which] = is_high
        new = (int(levels[0]), int(levels[1]))
        if state is None:
            count = 0
        elif new != state:
            assert up[state] == new or up[new] == state, f'two pins at once at {at} ns'
            count += 1 if up[state] == new else -1
            found.append((at, count))
        state, index = new, levels[2]
        assert index == (count % turn == 0), f'the index at {at} ns, count {count}'
    return found


def test_a_position_goes_out_as_edges_at_their_time_and_none_is_lost(bench):
    turn, per_count = 100, numpy.float32('1.5e-3')
    outputs = [row(0, 'QUADRATURE', 10, at_1='1.5e-3', turn=turn)]
    runs = {target: bench.run(target, (), (), outputs, seconds=0.026, scene=TURNING) for target in TARGETS}
    assert runs['host'].said['hash'] == runs['rp2040'].said['hash']
    host, pico = (decoded(runs[target].record, 10, turn) for target in TARGETS)
    behind = {there[0] - here[0] for here, there in zip(host, pico)}
    # So long after its tick the Pico shows it: the same time but for some instructions of the first one.
    assert max(behind) - min(behind) <= 5 * GRID and max(behind) < STEP / 4
    assert len(pico) > 600 and [count for _, count in host][:len(pico)] == [count for _, count in pico]
    record = runs['rp2040'].record                           # the control: without an edge there is a pair that cannot be
    with pytest.raises(AssertionError):
        decoded(record[:40] + record[41:], 10, turn)
    positions = runs['host'].trace['angle'].astype(numpy.float32) / per_count
    turned = int(numpy.argmax(positions))
    assert 5 < turned < 25                                   # a reversal
    times = [at for at, _ in host]
    for k in range(1, 26):
        begin, end = bisect.bisect_left(times, k * STEP), bisect.bisect_left(times, (k + 1) * STEP)
        assert (host[end - 1][1] if end else 0) == math.floor(positions[k])
        for at, count in host[begin:end]:
            passed = count if positions[k] > positions[k - 1] else count + 1
            part = (passed - float(positions[k - 1])) / (float(positions[k]) - float(positions[k - 1]))
            # A slot is 8 ns, and edges are three of them apart at least; the numbers are of 24 bits.
            assert abs(at - k * STEP - part * STEP * 7 / 8) < 3 * GRID + 16 * STEP * 2 ** -24 * abs(positions[k])


def test_of_more_edges_than_a_tick_can_have_the_rest_comes_later(bench):
    outputs = [row(0, 'QUADRATURE', 10, at_1='6e-4', turn=1000)]
    done = bench.run('host', (), (), outputs, seconds=0.012, scene=TURNING)
    found = decoded(done.record, 10, 1000)
    positions = done.trace['angle'].astype(numpy.float32) / numpy.float32('6e-4')
    assert max(numpy.diff(positions)) > 64 and max(
        sum(k * STEP <= at < (k + 1) * STEP for at, _ in found) for k in range(12)) == 64
    assert found[-1][1] == math.floor(positions[-1])


def test_voltages_levels_edges_and_pulses(bench):
    events = [(100_000 * k + 5_000, 26, 'volts', f' {k % 4096}') for k in range(1, 200, 7)]
    events += [level(70_000 * k + 9_000, 7, k % 2) for k in range(1, 260)]
    inputs = [row(0, 'VOLTAGE', 26, at_1='3.3'), row(1, 'EDGES', 7)]
    outputs = [row(1, 'DUTY', 14, at_1='3.3'), row(0, 'LEVEL', 15, at_1='0.004', safe='R(1.0)')]
    events.sort()
    host, pico = (bench.run(target, events, inputs, outputs, seconds=0.02) for target in TARGETS)
    assert host.said['hash'] == pico.said['hash']
    for done in (host, pico):
        for k in range(1, 21):
            code = max((int(end) for at, pin, word, end in events if word == 'volts' and at <= k * STEP), default=0)
            rises = sum(1 for at, pin, word, _ in events if word == 'high' and at <= k * STEP)
            assert done.trace['first'][k] == pytest.approx(3.3 * code / 4095, rel=2 ** -22)
            assert done.trace['other'][k] == rises
    levels = [[(word, int(at[:-2]) // STEP) for word, pin, at, *_ in done.record if pin == '15'] for done in (host, pico)]
    assert levels[0][-2:] == levels[1][-2:] and len(levels[1]) >= 2
    # Pulses of 20 kHz: of the width that the host wrote down as a number of 6250.
    widths = {int(at[:-2]): int(end[0]) for word, pin, at, *end in host.record if word == 'duty'}
    edges = [(word, int(at[:-2])) for word, pin, at, *_ in pico.record if pin == '14']
    rises = [at for word, at in edges if word == 'high']
    assert len(widths) == 21 or len(set(widths.values())) > 5
    assert all(after - before == 50_000 for before, after in zip(rises[-300:], rises[-299:]))
    high = next(at for word, at in edges if word == 'low' and at > rises[-2]) - rises[-2]
    assert high == GRID * [value for at, value in sorted(widths.items()) if at < rises[-2] - 100_000][-1]


def test_when_the_guard_stops_the_plant_outputs_go_to_their_safe_state(bench):
    scene = SCENE.replace('speed 0 rad/s', 'speed 2e6 rad/s')                # 10,000 rad, where the guard stops it, after 5 ms
    outputs = [row(0, 'DUTY', 14, at_1='2e4', safe='R(0.25)'), row(1, 'LEVEL', 15, safe='R(1.0)')]
    for target in TARGETS:
        done = bench.run(target, (), (), outputs, seconds=0.01, scene=scene, good=False)
        assert done.status == 1 and 'guard' in done.printed + done.errors, done.printed + done.errors
        record = [line.split() for line in (bench.folder / f'{target}.record').read_text().splitlines()]
        assert [word for word, pin, *_ in record if pin == '15'][-2:] == ['low', 'high']
        duty = [line for line in record if line[1] == '14']
        if target == 'host':
            assert duty[-1][3] == '1563' != duty[-2][3]


@pytest.mark.parametrize('target, line, text', [
    ('host', 'high 64 1us', 'expected the number of a pin, from 0 to 63'),
    ('host', 'low 3 soon', 'expected a time of at most an hour, such as 300us'),
    ('host', 'volts 26 1us 4096', 'from 0 to 4095'),
    ('host', 'high 3 1us\nlow 3 900ns', 'it stands before the line above in time'),
    ('host', 'high 3 1us more', 'something follows the end of the line'),
    ('rp2040', 'high 30 1us', 'there is no such pin'),
    ('rp2040', 'low 3 soon', 'expected a time such as 300us'),
    ('rp2040', 'high 3 1us\nlow 3 900ns', 'it stands before the line above in time'),
    ('rp2040', 'late 5 300us', 'late is for the host'),
    ('rp2040', 'up 3 1us', 'expected high, low, volts or record'),
])
def test_a_script_that_is_wrong_is_told_by_its_line(bench, target, line, text):
    (bench.folder / 'wrong').write_text(line + '\n')
    (bench.folder / 'rotor.scene').write_text(SCENE)
    done = bench.isochron('run', 'rotor.scene', '--target', target, '--seconds', 0.002, '--script', 'wrong', cwd=bench.folder)
    assert done.status == 1 and f'wrong:{line.count(chr(10)) + 1}: ' in done.errors and text in done.errors, done.errors


@pytest.mark.parametrize('inputs, outputs, text', [
    (['VOLTAGE 25'], [], 'a voltage is measured on GPIO26 to GPIO29'),
    (['DUTY 4'], [], 'a row is on a pin that is not free'),
    (['DUTY 6'], [], 'measured on a pin with an odd number'),
    (['DUTY 7'], ['DUTY 6'], 'two rows are on one PWM slice'),
    (['DUTY 7', 'EDGES 23'], [], 'two rows are on one PWM slice'),
    ([], ['DUTY 6', 'DUTY 22'], 'two rows are on one PWM slice'),
    (['QUADRATURE 6'], ['LEVEL 7'], 'a pin stands in two rows'),
    ([], ['EDGES 7'], 'edges are counted, and not shown'),
    ([], ['QUADRATURE 29'], 'a row is on a pin that is not free'),
    ([], [f'QUADRATURE {pin}' for pin in range(6, 16, 2)], 'more than four quadratures'),
    ([], ['DUTY 6', 'DUTY 7', 'DUTY 8'], None),
])
def test_a_table_that_cannot_be_is_told_at_the_start(bench, inputs, outputs, text):
    ins, outs = ([row(place, *name.split()) for place, name in enumerate(names)] for names in (inputs, outputs))
    done = bench.run('rp2040', (), ins, outs, seconds=0.002, good=False)
    assert done.status == (text is not None)
    assert text is None or 'the table of pins: ' in done.errors and text in done.errors, done.errors


def test_a_table_for_a_port_without_pins_is_told(bench):
    (bench.folder / 'rotor.scene').write_text(SCENE)
    (bench.folder / 'pins.h').write_text(f'#define PINS_INPUTS {row(0, "DUTY", 3)}\n')
    told = bench.isochron('run', 'rotor.scene', '--target', 'cortex-m4f', cwd=bench.folder, CFLAGS='-include pins.h')
    assert told.status == 1 and 'a table of pins is for a port that has pins' in told.errors


def test_the_list_of_targets_says_what_pins_each_has_and_so_does_the_page_of_ports(isochron):
    lines = isochron('targets').printed.splitlines()
    pins = {lines[i - 1].split()[0]: line.split('pins: ')[1].split('; ')[0] for i, line in enumerate(lines) if 'pins: ' in line}
    assert set(pins) == {'host', 'rp2040', 'stm32f407', 'stm32f446'}
    for line in (project.ROOT / 'port/README.md').read_text().splitlines():
        if line.startswith('| `PINS_'):
            kind, where = line.split('|')[1].strip(' `')[5:].lower(), line.split('|')[-2]
            for name, words in pins.items():
                said = [word for word in words.split(', ') if word.split()[0] == kind]
                group = 'stm32f4' if name.startswith('stm32f4') else name
                listed = [part.split(': ')[0].strip() for part in where.split('; ') if group in part or ': all' in part or part.strip() == 'all']
                assert bool(said) == bool(listed), (kind, name)
