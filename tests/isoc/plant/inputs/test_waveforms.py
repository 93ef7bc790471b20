"""Test signals, measured ones, and what is kept of signals: to the tick; what they cost on the board; where a method with a history
starts anew; and what isoc says of files."""
import math
import pathlib
import subprocess

import numpy as np
import pytest
from harness.plants import NUMERICS, STRICT
from harness.project import ROOT

SCENE = pathlib.Path('tests/isoc/plant/inputs/waveforms.scene')
ROAD = pathlib.Path('tests/isoc/plant/inputs/road.csv').resolve()
README = ' '.join(pathlib.Path('tools/isoc/README.md').read_text().split())
TICKS = 5000
ROW = np.arange(TICKS)


# --- tick by tick against the same in other words ---


def shifted_bits(order, other, state, count):
    """A shift register in Fibonacci's form, one bit after the other, as -1 and 1."""
    made = []
    for _ in range(count):
        out = state >> order - 1 & 1
        state = (state << 1 | out ^ state >> other - 1 & 1) & (1 << order) - 1
        made.append(2 * out - 1)
    return np.array(made)


def chirp(start, end, ticks, ulp):
    """A phase has a rounding of the growth in a tick, and the angle and its sine one each."""
    h, n = 1e-3, np.minimum(ROW, ticks).astype(np.longdouble)
    turns = n * h * start + n * n / ticks * h * (end - start) / 2 + (ROW - n) * h * end
    return np.sin(2 * np.pi * (turns - np.floor(turns))), 4 * ulp + 4 * math.pi * ROW * np.finfo(float).eps


TIMES = [0.01, 0.0105, 0.0107, 0.05, 0.25, 1.5]


def line(values, ulp):
    """Between the points of the file; exact in these."""
    t = 1e-3 * ROW
    made = np.interp(t, TIMES, values)
    is_point = (np.abs(t[:, None] - TIMES).min(1) < 1e-9) | (t < TIMES[0]) | (t > TIMES[-1])
    return made, np.where(is_point, 0, 4 * ulp * 2 * np.abs(values).max())


def past(values, rows, start=None):
    """What stood so many rows before; before the first one what that has, or a start."""
    return np.concatenate([np.full(rows, values[0] if start is None else start), values[:-rows]])


def expected(y, ulp):
    """Of each output what it should be, and what rounding allows."""
    ramp, wave, turn = (y[name].astype(float) for name in ('ramp', 'wave', 'turn'))
    of_7, of_20 = ROW // 7 * 7, ROW // 20 * 20
    exact = {
        'on': ROW >= 300, 'late': ROW >= 301, 'whole': np.where(ROW % 50 < 25, 1, -1),
        'shifted': np.where((4 * ROW + 25) % 100 < 50, 1, -1), 'odd': np.where((0.007 * ROW + 1e-12) % 1 < 0.5, 1, -1),
        'bits': shifted_bits(11, 9, 7, TICKS), 'held': np.repeat(shifted_bits(7, 6, 5, TICKS // 3 + 1), 3)[:TICKS],
        'past': past(ramp, 1), 'delayed': past(ramp, 5, 7), 'twice': past(ramp, 3), 'taken': np.where(of_7 > 0, ramp[of_7], -1),
        'steps': 1 + ROW, 'held_wave': wave[of_7], 'long_ago': past(wave, 300), 'turned': past(turn, 1, 1),
        'turned_before': past(turn, 20), 'turn_taken': turn[of_20], 'moved': (y.turn - past(y.turn, 1)).astype(float)}
    return {**{name: (of, 0) for name, of in exact.items()}, 'rise': chirp(1, 50, 2000, ulp), 'fall': chirp(400, 3, 3000, ulp),
            'left': line([1.5, 2.5, 0.5, -4, 6, 7.25], ulp), 'right': line([-15, 2, 4, 0.0625, 0.5, -1], ulp),
            'ramp': (ROW, 2 * ulp * ROW), 'turn': (1 + 0.002 * ROW, ROW * ulp * 11),
            'wave': (np.sin(2 * np.pi * 0.003 * ROW), 4 * ulp + ROW * np.finfo(float).eps)}


def wrong(p):
    y = p.follow(TICKS - 1).y
    return {name for name, (of, allowed) in expected(y, p.ulp).items() if not (np.abs(y[name] - of) <= allowed).all()}


@pytest.mark.parametrize('real', ['float', 'double'])
def test_each_signal_is_what_its_words_say_and_a_restart_gives_the_same_again(plant, real):
    p = plant(SCENE, real=real)
    assert set(expected(p.follow(TICKS - 1).y, p.ulp)) == set(p.places['y'])
    assert wrong(p) == set()
    first, again = (p.follow(TICKS - 1).rows[-1].tobytes() for _ in range(2))
    assert first == again
    bits, held = p.follow(TICKS - 1).y.bits, p.follow(TICKS - 1).y.held
    assert (bits[:2047] > 0).sum() == 1024 and (bits[2047:] == bits[:-2047]).all(), 'all states but 0, and then the same again'
    assert (held[:381] > 0).sum() == 3 * 64 and (held[381:] == held[:-381]).all()


@pytest.mark.parametrize('words, other, name', [('step(0.3 s)', 'step(0.301 s)', 'on'), ('prbs(7)', 'prbs(8)', 'bits'),
                                                ('chirp(1 Hz', 'chirp(1.00001 Hz', 'rise'), ('every 20 ms', 'every 21 ms', 'turn_taken'),
                                                ('delay(wave, 300 ms)', 'delay(wave, 301 ms)', 'long_ago'), ('column 3', 'column 2', 'right')])
def test_another_signal_is_found(plant, words, other, name):
    text = SCENE.read_text().replace('"road.csv"', f'"{ROAD}"')
    assert words in text
    assert wrong(plant(text.replace(words, other), real='float')) == {name}


def test_periods_of_ticks_beyond_two_to_the_32(plant):
    """A tick of 64 bits is taken modulo periods of up to 24 bits."""
    p = plant('step 1 ms\ninput a = square(20 Hz)\ninput b = prbs(7)\nbody w { mass 1 kg }\n'
              'joint j prismatic { parent ground; child w; axis x }\noutput a = a; output b = b\n')
    bits = shifted_bits(11, 9, 7, 2047)
    for first in (2**32 - 3, 2**33 + 12345, 2**40 + 7, 2**62 + 11):
        y = p.named(p.run(20, first=first)).y
        tick = [first + k for k in range(1, 21)]
        assert y.a[1:].tolist() == [1 if t % 50 < 25 else -1 for t in tick]
        assert y.b[1:].tolist() == [bits[t % 2047] for t in tick]


# --- on the board ---

COUNT = ROOT / 'tests/isoc/plant/inputs/count.c'


@pytest.fixture(scope='module')
def board(isoc, tmp_path_factory):
    """board(scene): what count.c prints of its plant on the board, by its first word: drive, advance, hash; and its results."""
    place = tmp_path_factory.mktemp('board')
    compiler = ['arm-none-eabi-gcc', '-std=c11', *STRICT, '-I', ROOT, '-mcpu=cortex-m4', '-mthumb', '-mfloat-abi=hard', '-mfpu=fpv4-sp-d16']
    objects = []
    for source in [ROOT / 'tests/tap.c', *(ROOT / 'port/mps2').glob('*.c')]:
        objects.append(place / f'{source.name}.o')
        subprocess.run(compiler + ['-c', source, '-o', objects[-1]], check=True)

    def run(scene):
        made = isoc(scene, '--real', 'float')
        subprocess.run(compiler + [f'-DPLANT="{made.folder}/plant.c"', '-nostartfiles', '--specs=nosys.specs', '-T',
                                   ROOT / 'port/mps2/mps2.ld', COUNT, *objects, '-o', place / 'program'], check=True)
        shown = subprocess.run('qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none '
                               '-serial none -semihosting-config enable=on,target=native -kernel'.split() + [place / 'program'],
                               capture_output=True, text=True).stdout
        counts = dict(line[2:].split(' ', 1) for line in shown.splitlines() if line.startswith('# '))
        return counts, [line for line in shown.splitlines() if line.startswith(('ok', 'not ok'))]

    return run


def test_on_the_board_the_bits_are_those_of_the_host_and_every_tick_takes_the_same(board, isoc, tmp_path):
    counts, results = board(SCENE)
    assert len(results) == 5 and all(line.startswith('ok') for line in results), results
    made = isoc(SCENE, '--real', 'float')
    subprocess.run(['gcc', '-std=c11', '-O0', *NUMERICS, '-I', ROOT, f'-DPLANT="{made.folder}/plant.c"', COUNT, ROOT / 'tests/tap.c',
                    *(ROOT / 'port/host').glob('*.c'), ROOT / 'port/unix/console.c', '-o', tmp_path / 'host'], check=True)
    assert f"# hash {counts['hash']}" in subprocess.run([tmp_path / 'host'], capture_output=True, text=True).stdout


def cost(board, formula='1 N', output='position of rail'):
    """The instructions of a tick outside of the step."""
    counts, _ = board(f'step 1 ms\ninput push N = {formula}\nbody cart {{ mass 1 kg }}\n'
                      f'joint rail prismatic {{ parent ground; child cart; axis x; drive push }}\noutput place = {output}\n')
    return int(counts['drive']) + int(counts['advance'])


@pytest.mark.parametrize('formula, more', [('step(0.3 s)', ''), ('square(20 Hz)', ', of a whole number of steps'),
                                           ('square(7 Hz)', ', of any other'), ('prbs(7)', ''), ('chirp(1 Hz, 50 Hz, 2 s)', '')])
def test_functions_of_time_cost_what_the_reference_says(board, formula, more):
    took = cost(board, f'1 N * {formula}') - cost(board)
    assert f'| `{formula}`{more} | {took} |' in README, took


def test_a_file_costs_what_the_reference_says(board, tmp_path):
    (tmp_path / 'long.csv').write_text(''.join(f'{i / 100},{i % 7}\n' for i in range(1024)))
    few, many = (cost(board, f'1 N * file "{path}"') - cost(board) for path in (ROAD, tmp_path / 'long.csv'))
    assert f'| `file`, of 6 points and of 1024 | {few}, {many} |' in README, (few, many)


def test_a_delay_noise_and_a_rounding_take_little_more_than_by_hand(board):
    assert 2 < cost(board, output='delay(push, 5 ms)') - cost(board) <= 15
    assert 0 < cost(board, '1 N * noise(1)') - cost(board) <= 38
    rounded = cost(board, output='previous(0.01 m * round(position of rail / 0.01 m))')
    assert 0 < rounded - cost(board, output='previous(position of rail)') <= 16


# --- new starts ---


def cart(method, push):
    return f'''step 1 ms
method {method}
input push {push}
body cart {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child cart; axis x; spring 100 N/m; drive push }}
output place = position of rail
'''


def restarts(p):
    """The ticks in which the method starts anew."""
    p.start()
    made = []
    for tick in range(1000):
        before = p.facts.restarts
        p.go(1, first=tick)
        made += [tick] * (p.facts.restarts - before)
    return made


@pytest.mark.parametrize('method', ['ab4', 'bdf4'])
def test_a_method_with_a_history_starts_anew_at_edges_and_only_there(plant, method):
    p = plant(cart(method, '= 1 N * (step(0.3 s) + square(5 Hz) * sin(3 Hz))'))
    assert restarts(p) == list(range(100, 1000, 100))


def test_with_a_jump_given_that_alone_counts_and_rk4_has_no_code_for_edges(plant, isoc):
    assert restarts(plant(cart('ab4', 'jump 10 N = 1 N * step(0.3 s)'))) == []
    assert not any('edge' in text for text in isoc(cart('rk4', '= 1 N * step(0.3 s)')).files().values())


# --- files ---


@pytest.mark.parametrize('text, more, message', [
    ('0,1\n\n1,two\n', '', "bad.csv:3:3: error: expected a number, a value; found 'two'"),
    ('0,1\n1.5.2,2\n', '', "bad.csv:2:1: error: expected a number, the time in s; found '1.5.2'"),
    ('t,x\n0,1\n1, ,2\n', '', "bad.csv:3:4: error: expected a number, a value; found ''"),
    ('1,1\n1,2\n', '', 'bad.csv:2:1: error: the times of a file increase'),
    ('-1,1\n0,2\n', '', 'bad.csv:1:1: error: the times of a file increase'),
    ('0,1\n3\n', '', 'bad.csv:2:1: error: this line has no column 2'),
    ('0;1\n1;  1e-320\n', '', 'bad.csv:2:5: error: the value is 9.99989e-321; '),
    ('# nothing\nt,x\n', '', "bad.csv' has no points"),
    ('0,1\n', ' column 1', 'cart.scene:3:42: error: expected the number of a column, from 2 on'),
    (None, '', "cart.scene:3:25: error: cannot read 'bad.csv': No such file")])
def test_a_bad_file_is_told(isoc, tmp_path, text, more, message):
    if text is not None:
        (tmp_path / 'bad.csv').write_text(text)
    place = tmp_path / 'cart.scene'
    place.write_text(cart('rk4', f'= 1 N * file "bad.csv"{more}'))
    made = isoc(place)
    assert made.refused and message in made.errors


def test_files_lists_a_file_that_is_read():
    shown = subprocess.run(['build/isoc', SCENE, '--files'], capture_output=True, text=True).stdout
    assert 'tests/isoc/plant/inputs/road.csv' in shown.splitlines()
