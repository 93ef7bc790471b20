"""Motors, which are linear: against rk4's own map of a step and against the closed form; what the scene sets at ticks."""
import math
import pathlib

import numpy as np
import pytest
from closed_forms import series

SCENE = pathlib.Path('tests/isoc/effects/motor.scene').read_text()
H, TICKS, VOLTS, RESISTANCE, INDUCTANCE, CONSTANT, DAMPING, INERTIA = 1e-4, 5000, 6.0, 2.0, 5e-3, 0.05, 2e-3, 1e-3


RUNNING = (np.array([[-RESISTANCE / INDUCTANCE, -CONSTANT / INDUCTANCE], [CONSTANT / INERTIA, -DAMPING / INERTIA]]),
           np.array([VOLTS / INDUCTANCE, 0]))
OPEN = np.array([[-1000, 0], [CONSTANT / INERTIA, -DAMPING / INERTIA]]), np.zeros(2)
SIZE = [VOLTS / RESISTANCE, VOLTS / CONSTANT]


def motion(r, rows):
    return np.stack([r.y.current[rows], r.y.speed[rows]], 1).astype(float)


@pytest.mark.parametrize('real', ['float', 'double'])
def test_a_motor_runs_up_as_its_closed_form_says_and_a_fault_opens_its_circuit(plant, real):
    """A tick rounds a dozen numbers of at most twice the size; errors decay with the motor, or add up. |h A| is 0.04 of the
    current; rk4 leaves out 0.04^5 / 120 in each tick of the 5 ms that the circuit remembers. A memory is set once a tick, from
    the memories before; a signal is its formula. The control is a supply that is five per cent higher."""
    p = plant(SCENE, real=real)
    r = p.follow(TICKS + 200, {'volts': VOLTS}, {TICKS: {'drive_open': 1}})
    rounding, truncation, up = 24 * p.ulp * TICKS, 50 * 0.04**5 / 120, slice(1, TICKS + 1)
    assert (np.abs(motion(r, up) - series(*RUNNING, np.zeros(2), TICKS, 4, H)) <= np.multiply(rounding, SIZE)).all()
    exact = series(*RUNNING, np.zeros(2), TICKS, 24, H)
    assert (np.abs(motion(r, up) - exact) <= np.multiply(rounding + truncation, SIZE)).all()
    assert (r.y.ticks[TICKS], r.y.ticks_before[TICKS]) == (5003, 5002)
    heat = RESISTANCE * r.y.current[TICKS]**2
    assert abs(r.y.loss[TICKS] - heat) <= 4 * p.ulp * heat
    opened = series(*OPEN, motion(r, [TICKS])[0], 200, 4, H)
    assert (np.abs(motion(r, slice(TICKS + 1, None)) - opened) <= np.multiply(rounding, SIZE)).all() and abs(r.y.current[-1]) < 1e-6
    higher = motion(p.follow(TICKS, {'volts': VOLTS * 1.05}), slice(1, None))
    assert (np.abs(higher - exact) > np.multiply(rounding + truncation, SIZE)).any()


@pytest.mark.parametrize('real', ['float', 'double'])
def test_the_energy_of_the_rotor_is_what_the_motor_gives_less_the_damping(plant, real):
    """By the rule of the trapezoid: of a power that changes with 2.5 ms it leaves out (h / 2.5 ms)^2 / 12 of what has passed."""
    p = plant(SCENE, real=real)
    y = p.follow(TICKS, {'volts': VOLTS}).y
    power, speed = y.power.astype(float), y.speed.astype(float)
    net = power - DAMPING * speed**2
    passed = H * np.abs(power).sum()
    missing = y.energy[-1] - H * (net[1:] + net[:-1]).sum() / 2
    assert passed > 0.1 and abs(missing) <= ((H / 2.5e-3)**2 / 12 + p.ulp * TICKS) * passed


MOTOR = '''step 0.25 ms
input volts V = 6 V
tunable load = 10 mN*m*s/rad
body rotor { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint shaft revolute { parent ground; child rotor; axis z; damping load }
effect drive dc_motor { shaft shaft; supply volts; resistance 2 Ohm; inductance 20 mH; constant 50 mN*m/A }
output current = drive.current
'''


@pytest.mark.parametrize('method', ['rk4', 'ab4'])
def test_what_the_scene_sets_at_a_tick_is_what_a_program_sets_before_it(plant, method):
    sets = {100: {'drive_open': 1}, 200: {'drive_open': 0}, 300: {'load': 0.02}}
    by_program = plant(MOTOR, '--method', method).follow(400, sets=sets)
    by_scene = plant(MOTOR + 'at 25 ms set drive.open = 1; at 50 ms set drive.open = 0; at 75 ms set load = 20 mN*m*s/rad\n',
                     '--method', method).follow(400)
    assert (by_program.rows['x'] == by_scene.rows['x']).all() and (by_program.rows['p'] == by_scene.rows['p']).all()
    assert len(np.unique(by_scene.rows['p'], axis=0)) == 3


def without_names(made):
    return '\n'.join(line.split('/*')[0] for line in made.file('plant.c').splitlines())


def test_set_is_another_value_in_the_scene(isoc):
    other = isoc(MOTOR.replace('load = 10', 'load = 12'))
    assert without_names(isoc(MOTOR, '--set', 'load = 6 mN*m*s/rad * 2')) == without_names(other)
    assert without_names(isoc(MOTOR)) != without_names(other)
    for fault in ('drive_open', 'drive.open'):
        text = isoc(MOTOR, '--set', f'{fault} = 1').file('plant.c')
        assert 'R(1.0)' in text[text.index('defaults['):].split('}')[0], 'the fault is there from the start'


@pytest.mark.parametrize('setting, message', [
    ('lod = 1', "--set:1:1: error: no constant, tunable or fault is called 'lod' (did you mean 'load'?)"),
    ('drive.open = 2', "--set:1:14: error: 'drive.open' is from 0 to 1"),
    ('drive.opn = 1', "called 'drive.opn' (did you mean 'drive.open'?)")])
def test_a_wrong_set_is_told(isoc, setting, message):
    made = isoc(MOTOR, '--set', setting)
    assert made.refused and message in made.errors and made.errors.startswith('--set:1:')
