"""Statements stand in any order, and none is read across the end of a line where it is complete: pairs of statements give the plant that
they give with a semicolon between them, and in the other order. And names: each word of the language is a name where the grammar is not
ambiguous."""
import random
import re

import pytest

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


def bytes_of(isoc, text):
    """The plant without what comments quote, or what isoc said, without places."""
    made = isoc(text + ('' if re.search(r'(^|[;\n]) *step ', text) else 'step 1 ms\n'))
    if made.status != 0:
        return 'refused: ' + '\n'.join(sorted(re.findall(r'error: .*', made.errors)))
    return ''.join(re.sub(r'\s*/\*.*?\*/', '', made.file(f'plant.{end}')) for end in 'ch')


def is_apart(isoc, a, b):
    """Whether line ends are ends: with a semicolon, and in the other order, it is the same plant."""
    one, other = a[1].replace('@', '1'), b[1].replace('@', '2')
    apart = bytes_of(isoc, f'{BASE}{one}\n{other}\n')
    same = not apart.startswith('refused') and apart == bytes_of(isoc, f'{BASE}{one}; {other}\n')
    # What is numbered in the order of the scene is another plant in another order.
    return same and (a[0] in NUMBERED and b[0] in NUMBERED or apart == bytes_of(isoc, f'{BASE}{other}\n{one}\n'))


def test_the_end_of_a_line_ends_a_statement(isoc, seed):
    """All pairs that end with `at` and with an effect whose operands are called as words of the language, and random ones."""
    ends = [line for line in LINES if line[0] == 'at' or ' words ' in line[1]]
    pick = random.Random(seed)
    pairs = [(a, b) for a in LINES for b in ends[:1] + ends[2:]] + [pick.sample(LINES, 2) for _ in range(30)]
    pairs = [(a, b) for a, b in pairs if not (a[0] == b[0] and (a[0] in ONCE or a[0] == 'at'))]
    assert [pair for pair in pairs if not is_apart(isoc, *pair)] == []


# --- names ---

WORDS = """x y z ground pi time at about rotate quaternion rest along of in to and set like safe after ticks every jump held
    smooth on against from column body joint frame effect signal value state rate memory next output input energy power
    speed position inertia step method start axis length mass spring force file table sin""".split()
BEGUN = 'step 1 ms\nbody bob { mass 1 kg; com (0, -1, 0) m; inertia (1, 1, 1) kg*m^2 }\n'
HINGE = BEGUN + 'joint pivot revolute { parent ground; child bob; axis z; start 1 deg }\noutput angle = position of pivot\n'
SIGNAL = HINGE + 'signal NAME = speed of pivot\noutput fast = 2 * NAME\n'
# What is named, the words that are reserved there, and the scene.
NAMED = {
    'a constant': ('ground pi time at about rotate quaternion', BEGUN + '''constant NAME = 2
body more { mass NAME * 1 kg; com (1, 1, 0) m }
joint pivot revolute { parent ground; child bob; axis z; start NAME * 1 deg }
joint second revolute { parent bob at (NAME, 0, 0) m; child more; axis x; spring NAME * 1 N*m/rad rest NAME * 1 deg }
output angle = position of pivot
output number = NAME * 2'''),
    'a body': ('ground pi time', '''step 1 ms
body NAME { mass 1 kg; com (0, -1, 0) m; inertia (1, 1, 1) kg*m^2 }
joint pivot revolute { parent ground; child NAME at (0, 1, 0) m; axis z }
output tip = position of NAME at (0, 1, 0) m
output across = velocity of NAME along y
output square = dot(velocity of NAME, velocity of NAME in body)'''),
    'a joint': ('ground pi time', BEGUN + '''joint NAME revolute { parent ground; child bob; axis z; start 1 deg }
output angle = position of NAME
output other = 2 * speed of NAME'''),
    'an input': ('ground pi time', HINGE + 'input NAME V smooth = 1 V in 0 V to 2 V\noutput volts = 2 * NAME'),
    'a signal': ('ground pi time', SIGNAL),
    'an operand of an effect': ('pi time substeps', HINGE + '''effect kind { joint j; value NAME = 1; let twice = NAME * 2; effort on j = 1 N*m * twice * NAME }
effect use kind { j pivot
NAME 2 }'''),
}


def shape_of(isoc, scene, word):
    """Of an accepted scene with that name what is neither name nor number nor comment in the plant; else what isoc says."""
    made = isoc(scene.replace('NAME', word) + '\n')
    if made.status != 0:
        return None, made.errors
    return re.sub(r'[^(){};=*+/-]', '', re.sub(r'^(.*?)/\*.*\*/', r'\1', made.file('plant.c'), flags=re.M)), ''


@pytest.mark.parametrize('what', NAMED)
def test_each_word_is_a_name_but_for_those_that_are_reserved(isoc, what):
    """One that is no name is refused as a word of the language; any other gives the plant that another name gives."""
    reserved, scene = NAMED[what]
    neutral, _ = shape_of(isoc, scene, 'neutral')
    assert neutral
    for word in WORDS:
        shape, errors = shape_of(isoc, scene, word)
        if word in reserved.split():
            assert shape is None and f"'{word}' is a word of the language" in errors, word
        else:
            assert shape == neutral, (word, errors)
