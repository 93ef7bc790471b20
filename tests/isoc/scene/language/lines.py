"""Pairs of statements, each on a line of its own, in both orders, and the same two with a semicolon between them.

lines.py ISOC FOLDER SEED COUNT: prints what differs; the exit status is 1 where something does. All pairs that end with
`at` and with an effect whose operands are called as words of the language, and COUNT random ones.
"""
import itertools
import random
import re
import sys

from isoc import Isoc

FOLDER, SEED, COUNT = sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
isoc = Isoc(sys.argv[1], FOLDER)

BASE = '''body bob { mass 1 kg; com (0, -1, 0) m; inertia (1, 2, 3) kg*m^2 }
joint pivot revolute { parent ground; child bob; axis z; start 90 deg }
body block { mass 2 kg }
joint rail prismatic { parent ground; child block; axis x }
tunable gain = 1 N*m/rad
effect kind { joint j; value k N*m/rad; fault off; memory last = 0; next last = 1 - last; effort on j = -k * position of j * (1 - off); output last }
effect drive kind { j pivot; k gain }
effect words { value at = 1; value in = 2; value of = 3; value every = 4; value along = 5; value rest = 6; value about = 7; output sum = at + in * of - every / along * rest + about }
input push = 1 N*m
output base = push
'''
# What a line is, and the line; @ is the number of the line.
LINES = [
    ('gravity', 'gravity (0, 0, -9.81) m/s^2'), ('step', 'step 2 ms'), ('method', 'method heun'), ('compensated', 'compensated yes'),
    ('checked', 'checked yes'), ('overrun', 'overrun count'), ('grace', 'grace 10 ticks'), ('publish', 'publish next_tick'),
    ('histogram', 'histogram'), ('frame', 'frame f@ { on bob at (0, 0, 1) m rotate 90 deg about x }'), ('frame', 'frame f@ { on bob }'),
    ('spring', 'spring s@ { between ground at (1, 0, @) m and bob; stiffness 5 N/m; length 0.1 m }'), ('constant', 'constant c@ = 2'),
    ('constant', 'constant c@ = gain'), ('constant', 'constant c@ = (1, 2, 3) mm'), ('tunable', 'tunable t@ = 2 kg'),
    ('tunable', 'tunable t@ = 2'), ('tunable', 'tunable t@ = 2 N/m in 1 N/m to 3 N/m'), ('input', 'input pedal@ N = 2 N * sin(3 Hz); output pedal@_too = pedal@'),
    ('input', 'output u@_too = u@; input u@ V'), ('input', 'output u@_too = u@; input u@ V smooth'),
    ('input', 'output u@_too = u@; input u@ V held jump 1 V = 2 V'), ('input', 'output u@_too = u@; input u@ V = 1 V in -1 V to 1 V'),
    ('input', 'output u@_too = u@; input u@ V safe 0 V after 5 ticks'), ('output', 'output o@ = position of pivot'),
    ('output', 'output o@ = position of bob'), ('output', 'output o@ = position of bob at (0, 0, 1) m'), ('output', 'output o@ = velocity of bob along x'),
    ('output', 'output o@ = energy'), ('output', 'output o@ = speed of pivot * 2'), ('output', 'output o@ = gain'), ('output', 'output o@ = 3'),
    ('output', 'output o@ = power of drive'), ('output', 'output o@ = speed of rail every 4 ticks'), ('output', 'output o@ = norm(velocity of bob)'),
    ('signal', 'signal s@ = speed of pivot'), ('signal', 'signal s@ = gain'), ('signal', 'signal s@ = dot(velocity of bob in body, x_axis of bob)'),
    ('effect', 'effect kind@ { body b; let v = velocity of b }'), ('effect', 'effect e@ kind { j pivot; k 2 N*m/rad }'),
    ('at', 'at 2 s set gain = 2 N*m/rad'), ('at', 'at 3 s set drive.off = 1'), ('repeat', 'repeat i from 1 to 2 { constant r@[i] = i }'),
    ('effect', 'effect w@ words { at 1\nin 2\nof 3\nevery 4\nalong 5\nrest 6\nabout 7 }'), ('body', 'body b@ { mass 1 kg }; joint j@ fixed { parent bob; child b@ }'),
    ('joint', 'body b@ { mass 1 kg }; joint j@ prismatic { parent bob; child b@; axis y\nspring 5 N/m\nspeed 1 m/s\nstart 1 mm\ndamping 3 N*s/m }'),
    ('force', 'input f@ = 1 N; force g@ { body bob\ndrive f@\naxis x }'),
    ('stabilisation', 'stabilisation baumgarte'), ('close', 'close m@ distance { parent ground\nchild bob at (0, 0, 0.5) m }'),
]
ONCE = {'gravity', 'step', 'method', 'compensated', 'checked', 'overrun', 'grace', 'publish', 'histogram', 'stabilisation', 'close'}
NUMBERED = {'output', 'tunable', 'input', 'effect', 'body', 'joint', 'spring', 'force', 'signal', 'frame', 'constant', 'repeat', 'at', 'close'}


def bytes_of(text):
    """The plant without what comments quote, or what isoc said, without places."""
    text += '' if re.search(r'(^|[;\n]) *step ', text) else 'step 1 ms\n'
    with open(f'{FOLDER}/plant.scene', 'w') as out:
        out.write(text)
    status, said = isoc(f'{FOLDER}/plant.scene', '-o', FOLDER)
    if status != 0:
        return 'refused: ' + '\n'.join(sorted(re.findall(r'error: .*', said)))
    return ''.join(re.sub(r'\s*/\*.*?\*/', '', open(f'{FOLDER}/plant.{end}').read()) for end in 'ch')


def both(a, b):
    """Whether line ends are ends: with a semicolon, and in the other order, it is the same plant."""
    one, other = a[1].replace('@', '1'), b[1].replace('@', '2')
    apart = bytes_of(f'{BASE}{one}\n{other}\n')
    same = apart == bytes_of(f'{BASE}{one}; {other}\n')
    # What is numbered in the order of the scene is another plant in another order.
    if a[0] not in NUMBERED or b[0] not in NUMBERED:
        same = same and apart == bytes_of(f'{BASE}{other}\n{one}\n')
    elif apart.startswith('refused'):
        same = False
    if not same or apart.startswith('refused'):
        print(f'# {one!r} then {other!r}: {apart[:300] if apart.startswith("refused") else "another plant"}')
    return same and not apart.startswith('refused')


pick = random.Random(SEED)
ends = [line for line in LINES if line[0] == 'at' or ' words ' in line[1]]
pairs = [(a, b) for a in LINES for b in ends[:1] + ends[2:]]
pairs += [pick.sample(LINES, 2) for _ in range(COUNT)]
pairs = [(a, b) for a, b in pairs if not (a[0] == b[0] and (a[0] in ONCE or a[0] == 'at'))]
good = [both(a, b) for a, b in pairs]
print(f'# seed {SEED}: {len(good)} pairs, {good.count(False)} differ')
sys.exit(0 if all(good) else 1)
