"""Each quantity of tools/isoc/scene/quantities.h: as an output, in a formula, in the next of a memory, and in an effort, which has it or
is refused with the reason."""
import pathlib
import re

import numpy as np
import pytest

# Kind, formula of one number, unit, what becomes of an effort by it.
ROWS = [line.split('|') for line in '''POSITION|position of pivot|rad|taken
POINT|position of bob at (1, 2, 3) m along x|m|taken
SPEED|speed of pivot|rad/s|taken
ACCELERATION|acceleration of pivot|rad/s^2|loop
VELOCITY|velocity of bob at (1, 2, 3) m in body along y|m/s|taken
TURNS|turns of pivot|1|late
ORIENTATION|orientation of bob along z|1|taken
SPIN|spin of bob in ground along z|rad/s|taken
X_AXIS|x_axis of bob along x|1|taken
Y_AXIS|y_axis of bob along x|1|taken
Z_AXIS|z_axis of slider along z|1|taken
SPECIFIC_FORCE|specific_force of bob at (1, 2, 3) m along y|m/s^2|loop
INERTIA|inertia of pivot|kg*m^2|taken
INERTIA_OF_POINT|inertia of slider along x|kg|taken
FORCE|force of pivot along y|N|loop
MOMENT|moment of rail along z|N*m|loop
EFFORT|effort of rack|N*m|loop
ENERGY|energy|J|late
POWER|power|W|loop
BALANCE|balance|W|loop
EVENT_LOSS|event_loss|J|late
LOCAL_ERROR|local_error|1|late
RESIDUAL|residual|1|late
VIOLATION|violation|1|late
VIOLATION_RATE|violation_rate|1|late
VIOLATION_ACCELERATION|violation_acceleration|1|loop
POWER_OF_EFFECT|power of drag|W|loop
ENERGY_OF_EFFECT|energy of drag|J|loop
LOSS|loss of drag|W|loop
WORK|work of drag|W|loop'''.splitlines()]
COMMON = '''gravity (0, -9.81, 0) m/s^2
step 1 ms
method bdf4
checked yes
body bob { mass 1 kg; com (0, -1, 0) m; inertia (1, 1, 1) g*m^2 }
body slider { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint pivot revolute { parent ground; child bob; axis z; start 10 deg; speed 10 rad/s; continuous }
joint rail prismatic { parent ground; child slider; axis x }
close rack gear { first pivot; second rail; ratio 1 rad/m }
input push smooth = 1 N*m * sin(3 Hz)
effect brake {
    joint along
    signal push N*m
    effort on along = push - 0.1 N*m*s * speed of along
    energy = 0.5 kg*m^2 * (speed of along)^2
    loss = 0.1 N*m*s * (speed of along)^2
    work = push * speed of along
}
effect keeper { signal now; memory kept = 0; next kept = now; output kept }
effect pusher { joint along; signal now; effort on along = 1 N * now }
effect drag brake { along pivot; push push }
output taken = event_loss
'''


def per(unit):
    return '' if unit == '1' else f' / (1 {unit})'


def all_of_them():
    lines = [f'output alone_{kind} = {formula}\noutput once_{kind} = 1 * {formula}\noutput twice_{kind} = 2 * {formula}{per(unit)}\n'
             f'signal of_{kind} = {formula}{per(unit)}\neffect keep_{kind} keeper {{ now of_{kind} }}\noutput kept_{kind} = keep_{kind}.kept\n'
             for kind, formula, unit, _ in ROWS]
    parts = [f'output part_{letter} = 1 * orientation of bob along {letter}\n' for letter in 'wxyz']
    return COMMON + ''.join(lines) + 'output whole = orientation of bob\n' + ''.join(parts)


def wrong_kinds(y):
    """The kinds that are not the same number alone, times one, times two and in a memory; a memory is zero in the first row."""
    found = set()
    for kind, *_ in ROWS:
        alone, once, twice, kept = (y[f'{way}_{kind}'.lower()] for way in ('alone', 'once', 'twice', 'kept'))
        is_near = np.abs(2 * alone - twice) <= 2e-7 * np.abs(alone)
        is_kept = np.abs(alone - kept)[1:] <= 1e-7 * np.abs(alone)[1:]
        if not ((alone == once).all() and is_near.all() and is_kept.all()):
            found.add(kind)
    return found


def test_all_rows_of_the_table_are_tried():
    table = pathlib.Path('tools/isoc/scene/quantities.h').read_text()
    assert sorted(re.findall(r'ROW\(QUANTITY_([A-Z_]*), ', table)) == sorted(kind for kind, *_ in ROWS)


def test_each_quantity_is_the_same_number_alone_in_a_formula_and_in_a_memory(plant):
    """And they are numbers that change. The controls are off by a millionth in one row."""
    y = plant(all_of_them()).follow(1000).y
    assert wrong_kinds(y) == set()
    assert sum((y[f'alone_{kind}'.lower()] != y[f'alone_{kind}'.lower()][0]).any() for kind, *_ in ROWS) >= 23
    assert all((y[f'whole_{letter}'] == y[f'part_{letter}']).all() for letter in 'wxyz'), 'the parts of a quaternion'
    for name in ('alone_ENERGY', 'twice_POWER', 'kept_FORCE', 'once_SPIN'):
        place = y.places[name.lower()]
        right = y.array[98, place]
        y.array[98, place] *= 1.000001
        assert wrong_kinds(y) == {name.split('_', 1)[1]}
        y.array[98, place] = right


@pytest.mark.parametrize('kind, formula, unit, becomes', ROWS, ids=[kind for kind, *_ in ROWS])
def test_an_effort_has_a_quantity_or_is_refused_with_the_reason(isoc, kind, formula, unit, becomes):
    made = isoc(f'{COMMON}signal asked = {formula}{per(unit)}\neffect push_by pusher {{ along rail; now asked }}\noutput shown = position of pivot\n')
    word = formula.split()[0]
    said = {'loop': f"an algebraic loop: 'along' needs the {word}, which depends on it; a memory breaks it",
            'late': f"'{word}' is known after the step: for outputs and the next of memories, not for 'along'"}.get(becomes)
    errors = re.findall(r' error: (.*)', made.errors)
    assert errors == [] and made.status == 0 if said is None else made.refused and len(errors) == 1 and said in errors[0], made.errors
