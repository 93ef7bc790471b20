"""Tunables and faults that are set at times, `at 2 s set k = 3`: in every row what a look at all statements gives."""
import random

import numpy as np
import pytest

TICKS = 60


def scene_of(statements):
    return '''step 1 ms
tunable a = 1
tunable b = 2 N/m
body body_1 { mass 1 kg }
joint rail prismatic { parent ground; child body_1; axis x; start 0.1 m }
effect pull { joint along; value k N/m; fault jammed; effort on along = -k * (1 + jammed) * position of along; output jammed = jammed * 1 }
effect e pull { along rail; k b }
''' + '\n'.join(f'at {tick} ms set {name} = {value}' for tick, name, value in statements) + '''
output a_now = a
output b_now = b
output jammed = e.jammed
output x = position of rail
'''


def drawn(seed):
    """Statements in no order, some of one tick."""
    r = random.Random(seed)
    ticks = [r.randrange(TICKS) for _ in range(r.randrange(1, 12))]
    names = {'a': lambda: r.randrange(9), 'b': lambda: f'{r.randrange(1, 9)} N/m', 'e.jammed': lambda: r.randrange(2)}
    return [(r.choice(ticks), *(lambda name: (name, names[name]()))(r.choice(list(names)))) for _ in range(r.randrange(1, 40))]


def looked_up(statements, start):
    """Each row by all statements: the latest until then, of one tick the last that is written."""
    rows = []
    for tick in range(TICKS + 1):
        now = dict(start)
        for at, name, value in sorted(statements, key=lambda s: s[0]):
            now[name] = float(str(value).split()[0]) if at <= tick else now[name]
        rows.append(list(now.values()))
    return np.array(rows)


def rows_of(plant, statements, **of_plant):
    return plant(scene_of(statements), **of_plant).outputs(TICKS).rows[:, :3]


@pytest.mark.seeds(8)
def test_in_every_row(plant, seed):
    statements = drawn(seed)
    expected = looked_up(statements, {'a': 1.0, 'b': 2.0, 'e.jammed': 0.0})
    np.testing.assert_array_equal(rows_of(plant, statements), expected)


@pytest.mark.seeds(8)
def test_from_another_tick_on(plant, seed):
    """A program that goes on with another tick than the next: what is set there, from there on, and at the start."""
    statements = drawn(seed)
    first = random.Random(-seed).choice([tick for tick, *_ in statements if tick > 0] or [1])
    kept = [s for s in statements if s[0] == 0 or s[0] >= first]
    expected = looked_up(kept, {'a': 1.0, 'b': 2.0, 'e.jammed': 0.0})[first:]
    found = plant(scene_of(statements)).run(TICKS - first, first=first)['p']
    np.testing.assert_array_equal(found, expected)


def test_a_table_that_begins_late_is_found(plant):
    """The control: a plant that leaves out the first row of its table."""
    statements = [(5, 'a', 3), (9, 'a', 4)]
    late = rows_of(plant, statements, change=lambda text: text.replace('(uint32_t)memory->next_change', '(uint32_t)memory->next_change + 1'))
    assert (late != rows_of(plant, statements)).any()


def test_many_statements_are_compiled_in_the_order_of_time(isoc):
    """2000 statements: a table, and no code for each."""
    statements = [(2000 - i, 'a', i % 7) for i in range(2000)]
    text = isoc(scene_of(statements)).file('plant.c')
    code = text[text.index('static void see('):]
    assert code.count('next_change') == 3 and text.count('PLANT_P_A, ') == 2000
    ticks = [int(line.split('UINT32_C(')[1].split(')')[0]) for line in text.splitlines() if line.startswith('    {UINT32_C(')]
    assert ticks == sorted(ticks)
