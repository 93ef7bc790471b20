"""What the loop takes beside the step, on the Cortex-M4F, by the trace of QEMU: `isochron ticks`; and that core/README.md
and models/README.md say so."""
import functools
import re
import subprocess

import pytest

from harness.project import ROOT

HERE = ROOT / 'tests/promises/ticks'
ONE, SATELLITE = ((HERE / f'{name}.scene').read_text() for name in ('one', 'satellite'))
PENDULUM, BENCH = ((ROOT / f'models/{name}.scene').read_text() for name in ('pendulum', 'dc_motor_bench'))
CORE, MODELS = (' '.join((ROOT / name).read_text().split()) for name in ('core/README.md', 'models/README.md'))
FORCE = 'force f_@ { body bob at (0, -1, 0) m; axis (1, 0, 0); drive v_@ }\n'
LIMITED = 'in -1 N to 1 N\n' + FORCE
# Eight of these beside the scene with one input and two outputs; their states are 16.
EIGHT = {
    'output': 'output more_@ = speed of pivot\n',
    'input': 'input v_@\n' + FORCE,
    'limited': 'input v_@ = 0.5 N ' + LIMITED,
    'corrected': 'input v_@ = 1.5 N * square(1 Hz) ' + LIMITED,
    'tunable': '''tunable length_@ = 1 m
body arm_@ { mass 1 kg; com (0, length_@, 0) }
joint stuck_@ fixed { parent bob; child arm_@ }
''',
    'states': '''body arm_@ { mass 1 kg; com (0, 1, 0) m }
joint other_@ revolute { parent ground; child arm_@; axis z }
''',
}


@pytest.fixture(scope='module')
def of_scene(isochron, tmp_path_factory):
    """of_scene(text, word, ...): what a command of isochron says of this scene, each once: what stands first counts."""
    @functools.cache
    def call(text, *words):
        scene = tmp_path_factory.mktemp('ticks') / 'plant.scene'
        scene.write_text(text.replace('"parts/', f'"{ROOT}/models/parts/'))
        done = isochron(words[0], scene, *words[1:])
        assert done.status == 0, done.errors
        return dict(reversed([line.split(' ', 1) for line in done.printed.splitlines() if ' ' in line]))
    return call


@pytest.fixture(scope='module')
def parts(of_scene):
    """parts(text): instructions of the parts of a tick."""
    return lambda text: {name: int(said.split()[0]) for name, said in of_scene(text, 'ticks').items()
                         if name in 'loop checks interrupt port tick signals'.split()}


@pytest.fixture(scope='module')
def board(of_scene):
    """board(text, ...): the summary of a run of a tenth of a second."""
    return lambda text, *words, target='cortex-m4f': of_scene(text, 'run', '--seconds', '0.1', '--target', target, *words)


@pytest.fixture(scope='module')
def ticks_of(board):
    """ticks_of(text): the least and the most instructions of a tick, with what the port takes."""
    def call(text):
        least, most = board(text)['tick'].split()[:2]
        return int(least), int(most)
    return call


@pytest.fixture(scope='module')
def each(parts):
    """each(kind): what the checks of one take."""
    def call(kind, count=8, beside=ONE):
        more = parts(ONE + ''.join(EIGHT[kind].replace('@', str(i)) for i in range(1, 9)))
        return round((more['checks'] - parts(beside)['checks']) / count + 1e-9)
    return call


def test_one_input_and_two_outputs(parts):
    one = parts(ONE)
    beside = one['loop'] + one['checks']
    assert beside <= 150 and 0 < one['interrupt'] <= 20
    assert one['tick'] == beside + one['port'] <= 220


def test_outputs_are_a_part_of_finish(parts):
    """A pendulum with six outputs, and what they compute."""
    assert parts(ONE)['tick'] < parts(PENDULUM)['tick'] <= 240


def test_functions_of_time_are_equations_of_the_scene(parts):
    arm = parts((ROOT / 'models/arm6.scene').read_text())
    assert arm['tick'] <= 400 and arm['signals'] > 100
    assert 'signals' not in parts(ONE), 'control'


def test_a_satellite(parts):
    one, of = parts(ONE), parts(SATELLITE)
    assert 0 < of['checks'] <= 320
    assert f'With 11 inputs with limits, 13 states and 18 outputs it takes {of["checks"]}.' in CORE
    assert (of['loop'], of['interrupt']) == (one['loop'], one['interrupt'])


def test_the_checks_grow_as_is_said(parts, each):
    said = (f'by {each("states", 16)} instructions for a state, {each("tunable")} for a tunable, {each("output")} for an output, '
            f'{each("input")} for an input, with limits {each("limited")}.')
    assert said in CORE
    assert each('output') > 0, 'control: eight outputs more take longer to check'


def test_an_input_that_is_put_right(each):
    """Nine are, that without limits among them."""
    limited = ONE + ''.join(EIGHT['limited'].replace('@', str(i)) for i in range(1, 9))
    assert 35 <= each('corrected', 9, limited) < 45


def test_policies_cost_a_tick_that_keeps_its_time_what_is_said(ticks_of):
    def least(line, text=PENDULUM):
        return ticks_of(f'{text}\n{line}\n')[0]
    plain = least('')
    assert least('overrun catch_up 3; grace 10 ticks') == plain
    later, histogram = least('publish next_tick') - plain, least('histogram') - plain
    assert (f'With `histogram` a tick takes {histogram} instructions more on the Cortex-M4F; the others cost a tick that keeps its '
            f'time nothing, but for {later} of') in CORE
    ladder = least('overrun degrade { drop bearing; hold; after 9 ticks }', BENCH) - least('overrun degrade { hold; after 9 ticks }', BENCH)
    assert f'A tick of such a ladder takes {ladder} instructions more.' in CORE
    rounding = (least('output angle = 0.01 rad * round(position of pivot / 0.01 rad)') - least('output angle = position of pivot'))
    assert f'A rounding over the whole range of numbers takes {rounding}:' in MODELS


def amiss(said):
    return [int(said[name].split()[0]) for name in ('late', 'lost', 'overruns')]


@pytest.mark.parametrize('step', ['1ms', '50us'])
def test_the_trace_makes_no_tick_late(board, step):
    """Also where the period has room for the tick, and not for both."""
    said = board(PENDULUM, '--step', step)
    assert amiss(said) == [0, 0, 0] and said['instructions_per_step'] == '138'
    least, most = map(float, said['tick'].split()[:2])
    assert least > 300 and most < 550 and float(said['tracing'].split()[0]) > 400


def test_found_a_step_that_is_shorter_than_a_tick(board):
    late, _, overruns = amiss(board(PENDULUM, '--step', '10us'))
    assert late > 0 and overruns > 0


def test_what_is_not_measured_on_the_host_is_not_told(board):
    said = board(PENDULUM, '--step', '1ms', target='host')
    assert said['hash'] and not said.keys() & {'execution', 'margin', 'tick', 'tracing', 'instructions_per_step'}


GYRO = '''effect gyro {
    body on; value spin_bias rad/s; value spin_density rad/s/sqrt(Hz); signal noise_4; signal noise_5; signal noise_6
    let turned = spin of on + spin_bias * (1, 1, 1) + spin_density * sqrt(0.5 / step) * (noise_4, noise_5, noise_6)
    memory turn rad/s = turned; next turn = turned
    output spin_x = dot(turn, (1, 0, 0)); output spin_y = dot(turn, (0, 1, 0)); output spin_z = dot(turn, (0, 0, 1))
}
'''


def unit(kind, *outputs):
    """The satellite with an inertial unit, or a gyro that has nothing else, of which these are shown."""
    lines = [line for line in SATELLITE.splitlines() if not line.startswith('output')]
    lines += [f'output {name} = unit.{name}' for name in ('spin_x', 'spin_y', 'spin_z', *outputs)]
    lines += [f'input n{i} = noise({i})' for i in (1, 2, 3)]
    lines.append(f'effect unit {kind} {{ on bus; spin_bias 1 mrad/s; spin_density 0.01 deg/s/sqrt(Hz); noise_4 n1; noise_5 n2; noise_6 n3 }}')
    return '\n'.join(lines) + '\n' + (GYRO if kind == 'gyro' else '')


def test_what_nothing_reads_costs_nothing(board):
    """Its bits and its tick are those of a gyro alone."""
    gyro, spin, used = board(unit('gyro')), board(unit('imu')), board(unit('imu', 'force_x'))
    assert (spin['hash'], spin['tick']) == (gyro['hash'], gyro['tick']) and used['tick'] != gyro['tick']


TUNABLE = 'tunable k = 1\noutput shown = k\n'


def changes(count, at):
    return f'{ONE}{TUNABLE}repeat i from 1 to {count} {{\n    at {at} set k = i\n}}\n'


def test_statements_that_set_a_tunable_at_times(ticks_of):
    """None of it is due in the run: it costs a tick at most 40 more than one; as a control, 20 in one tick."""
    least, most = ticks_of(f'{ONE}{TUNABLE}at 5 s set k = 2\n')
    of_many, most_of_many = ticks_of(changes(2000, '5 s + i * 1 ms'))
    assert of_many - least <= 40 and most_of_many - most <= 40
    assert ticks_of(changes(20, '50 ms'))[1] - most > 40


def test_a_sample_that_is_not_due_costs_less_than_half_of_one_in_each_tick(ticks_of):
    formula = 'sqrt(1 + position of pivot^2) * sin(position of pivot) + exp(speed of pivot * 1 s / 10)'

    def sampled(period):
        return ticks_of(f'{ONE}signal kept = sample({formula}, every {period})\noutput kept = kept\n')
    (in_each, most_of_each), (fifth, most) = sampled('1 ms'), sampled('5 ms')
    none = ticks_of(f'{ONE}output kept = 1\n')[0]
    assert 2 * (fifth - none) < in_each - none and most - most_of_each <= 40


def test_found_a_program_without_a_loop():
    done = subprocess.run([ROOT / 'build/cycles', 'count', ROOT / 'tools/measure/cycles/cores/cortex-m4f.txt', '/dev/null',
                           'iso_loop_tick_float'], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert done.returncode != 0 and re.search('no function iso_loop_tick_float', done.stderr)
