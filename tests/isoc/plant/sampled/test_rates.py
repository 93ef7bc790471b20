"""Blocks of a rate: their rows are those of an interpreter (paced.py); what is due follows from the number of the row."""
import re

import numpy as np
import pytest
from paced import Rows, Scene

from harness.plants import replaced

ROWS = 50


def check(found, expected):
    scale = 1 + np.abs(expected).max()
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * scale)  # 50 rows of some ten sums in double


@pytest.mark.seeds(20)
def test_rows_are_those_of_the_interpreter(plant, seed):
    scene = Scene(seed)
    print(scene)
    check(plant(str(scene)).outputs(ROWS).rows, Rows(scene, ROWS).rows)


@pytest.mark.seeds(5)
def test_so_are_they_from_another_tick_on(plant, seed):
    """A program that goes on with another tick: the rows that follow are those of their numbers."""
    scene = Scene(seed)
    found = plant(str(scene)).outputs(ROWS, first=2 ** 32 - 20).rows
    check(found[1:], Rows(scene, ROWS, first=2 ** 32 - 20).rows[1:])


# Two rates, of which each reads the memory of the other before it changes.
MUTUAL = '''step 1 ms
body b { mass 1 kg }
joint j prismatic { parent ground; child b; axis x; start 1 m; speed 1 m/s }
effect both {
  every 2 ms {
    memory fast = 1; next fast = fast + slow
  }
  every 3 ms at 1 ms {
    memory slow = 2; next slow = slow + fast
  }
  output fast; output slow
}
effect e both { }
output fast = e.fast; output slow = e.slow
'''
BY_HAND = '1 2, 1 3, 4 3, 4 3, 7 7, 7 7, 14 7, 14 21'


def rows_of(plant, **of_plant):
    return ', '.join(f'{fast:g} {slow:g}' for fast, slow in plant(MUTUAL, **of_plant).outputs(7).rows)


def test_memories_of_two_rates_change_together(plant):
    assert rows_of(plant) == BY_HAND


@pytest.mark.parametrize('pattern, by', [
    (r'memory->in_3 == 1', 'memory->in_3 == 2'),                  # another phase
    (r'memory->coming\[0\] = ', 'memory->u[PLANT_U_E_FAST] = memory->coming[0] = '),    # one after the other
    (r'memory->in_2 < 1', 'memory->in_2 < 2')])                     # another period
def test_another_meaning_is_found(plant, pattern, by):
    assert rows_of(plant, change=lambda text: replaced(pattern, by, text)) != BY_HAND


def test_a_block_of_one_step_is_none(isoc):
    texts = [isoc(MUTUAL.replace('every 2 ms', every).replace('every 3 ms at 1 ms', every)).file('plant.c')
             for every in ('every 1 ms', 'every 1 ms at 0 ms')]
    without = isoc(re.sub(r' *every .* ms \{\n(.*)\n *\}', r'\1', MUTUAL)).file('plant.c')
    assert texts == [without, without]


def test_noise_of_a_block_is_that_of_its_rows(plant):
    """It is white, by the number of the row; and not computed in between."""
    scene = 'step 1 ms\nbody b { mass 1 kg }\njoint j prismatic { parent ground; child b; axis x }\n'
    slow = plant(scene + 'every 3 ms at 2 ms { signal hiss = noise(7) }\noutput hiss = 1 * hiss')
    each = plant(scene + 'output hiss = noise(7)').outputs(20).rows
    rows = [row if row == 0 else (row - 2) // 3 * 3 + 2 if row >= 2 else 0 for row in range(21)]
    np.testing.assert_array_equal(slow.outputs(20).rows, each[rows])
    see = slow.made.file('plant.c').split('static void see(')[1]
    assert re.search(r'if \(tick == 0 \|\| memory->in_3 == 2\) \{\s+see_every_3_at_2', see)


TEN = '''step 1 ms
body b { mass 1 kg }
joint j prismatic { parent ground; child b; axis x; start 1 m; speed 1 m/s }
effect controller {
  signal measured m; value gain N/m; value period s; value phase s
  every period at phase {
    memory sum N = 0 N; next sum = sum - gain * measured * step / 1 s
    output force = sum - gain * measured
  }
}
effect pull { joint along; signal f N; effort on along = f }
output x = position of j
'''


def least_and_most(isochron, tmp_path, periods_and_phases, ticks):
    """Instructions of a tick without its step, and what `isochron cost` says of the dearest."""
    uses = [f'effect c{i} controller {{ measured position of j; gain {i + 1} N/m; period {period} ms; phase {phase} ms }}'
            for i, (period, phase) in enumerate(periods_and_phases)]
    total = ' + '.join(f'c{i}.force' for i in range(len(uses))) or '0 N'
    path = tmp_path / 'ten.scene'
    path.write_text('\n'.join([TEN, *uses, f'effect p pull {{ along j; f {total} }}\n']))
    done = isochron('run', path, '--target', 'cortex-m4f', '--seconds', str(ticks / 1000))
    said = dict(line.split(' ', 1) for line in done.printed.splitlines() if ' ' in line)
    return [int(word) - int(said['instructions_per_step']) for word in said['tick'].split()[:2]], path


@pytest.mark.parametrize('periods_and_phases', [
    [(5, 2)] * 10, [(50, 30 + i) for i in range(10)], [(50 + i, 30) for i in range(10)]])
def test_ten_blocks_that_are_not_due_take_at_most_ten_instructions_each(isochron, tmp_path, periods_and_phases):
    (without, _), _ = least_and_most(isochron, tmp_path, [], 40)
    (least, most), _ = least_and_most(isochron, tmp_path, periods_and_phases, 40)
    print(least - without, most - without)
    assert least - without <= 100 < most - without


def test_the_dearest_tick_that_is_printed_is_the_dearest_seen(isochron, tmp_path):
    """Of 30 rows, and of 300 by the account of the loop, which has another begin and end of a tick than the trace."""
    (least, most), path = least_and_most(isochron, tmp_path, [(5, 2), (3, 1), (2, 0)], 300)
    done = isochron('cost', path, '--target', 'cortex-m4f', '--seconds', '0.05')
    cheapest, dearest, row, mean, rows = map(int, re.search(
        r'ticks (\d+) to (\d+) instructions, the dearest in row (\d+); mean (\d+), (\d+) rows', done.printed).groups())
    assert rows == 30 and row == 22 and f'| dearest, {row} |' in done.printed
    assert cheapest < mean < dearest and dearest - cheapest == most - least


HYDRAULIC = '''step 1 ms
body load { mass 200 kg }
joint rail prismatic { parent ground; child load; axis x; damping 500 N*s/m }
effect pi_control {
  signal wanted m; signal place m; value gain V/m; value reset V/m/s; value most V
  every 5 ms at 2 ms {
    let error = wanted - place
    let free = gain * error + sum
    memory sum V = 0 V
    next sum = clamp(sum + reset * error * step, -most, most)
    output volts = clamp(free, -most, most)
  }
}
effect cylinder {
  joint rod; signal volts V; value area m^2; value supply Pa; value stiffness Pa/m^3
  state across Pa = 0 Pa
  let side = if(volts > 0 V, 1, -1)
  let flow = 1e-8 m^3/s/V/sqrt(Pa) * volts * sqrt(max(supply - side * across, 0 Pa))
  rate across = stiffness * (flow - area * speed of rod - 2e-12 m^3/s/Pa * across)
  effort on rod = area * across
  output across
}
effect hydraulic_axis {
  joint rod; signal wanted m
  part control pi_control { wanted wanted; place position of rod; gain 60 V/m; reset 2 V/m/s; most 10 V }
  part drive cylinder { rod rod; volts control.volts; area 10 cm^2; supply 1e7 Pa; stiffness 1e13 Pa/m^3 }
  output volts = control.volts
}
effect press hydraulic_axis { rod rail; wanted 0.1 m }
output place = position of rail
output volts = press.volts
output across = press.drive.across
'''


def test_a_hydraulic_axis_with_a_controller_of_five_milliseconds(plant, isochron, tmp_path):
    """It comes to its place; the valve's voltage changes in the rows of its controller alone, row 2 first; and on the
    board it has the bits of the host, and one number of instructions for all steps."""
    outputs = plant(HYDRAULIC).outputs(3000)
    assert abs(outputs.place[-1] - 0.1) < 0.005 and outputs.across.max() > 1e5
    changed = np.flatnonzero(np.diff(outputs.volts)) + 1
    assert len(changed) > 100 and set(changed % 5) == {2}
    (tmp_path / 'press.scene').write_text(HYDRAULIC)
    host = isochron('run', tmp_path / 'press.scene', '--seconds', '0.3')
    board = isochron('run', tmp_path / 'press.scene', '--seconds', '0.3', '--target', 'cortex-m4f')
    assert host.said['hash'] == board.said['hash']
    least, mean, most, _ = board.said['execution'].split()
    assert least == most == mean.split('.')[0]
