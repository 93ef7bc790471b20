"""Sub-steps of an effect, `substeps 4` in its use: the orders of the scheme, a closed form, where it is stable and what isoc says of
that, the bits and the cost on the board, and that a scene without it has nothing of it."""
import math
import pathlib
import re

import numpy as np
import pytest
from closed_forms import series
from harness.commands import FOLDER
from harness.plants import replaced
from harness.project import ROOT

VOLTS = 6.0

# --- orders, of a motor whose current has sub-steps ---

R, L, K, J, DRAG, LENGTH = 2.0, 5e-3, 0.05, 2e-5, 1e-5, 0.04
BENT = """
    let torque = constant * (1 + 0.3 * sin(position of shaft))
    let store = inductance * (1 + 0.2 * current^2 / 1 A^2)
    let slows = drag * speed of shaft * (1 + speed of shaft / 1 rad/s)"""
LINEAR = """
    let torque = constant
    let store = inductance
    let slows = drag * speed of shaft"""


def motor(plant, method, step, substeps, of=LINEAR, volts=VOLTS, resistance=R, drag=DRAG, start=0, **of_plant):
    return plant(f'''step {step * 1e9:.0f} ns
method {method}
body rotor {{ mass 1 kg; inertia (1, 1, {J}) kg*m^2 }}
joint shaft revolute {{ parent ground; child rotor; axis z; continuous }}
effect winding {{
    joint shaft; value resistance Ohm; value drag N*m*s/rad
    value inductance = {L} H; value constant = {K} N*m/A
    state current A = {start} A{of}
    rate current = ({volts} V - resistance * current - torque * speed of shaft) / store
    effort on shaft = torque * current - slows
    output current
}}
effect one winding {{ shaft shaft; resistance {resistance} Ohm; drag {drag} N*m*s/rad{f"; substeps {substeps}" if substeps else ""} }}
output current = one.current; output angle = position of shaft; output speed = speed of shaft
''', **of_plant)


def bent_solution(steps):
    """The one whose torque and inductance vary, by 32 small steps of rk4 in each."""
    def slope(x):
        torque, store = K * (1 + 0.3 * math.sin(x[1])), L * (1 + 0.2 * x[0]**2)
        return np.array([(VOLTS - R * x[0] - torque * x[2]) / store, x[2], (torque * x[0] - DRAG * x[2] * (1 + x[2])) / J])

    x, h, rows = np.zeros(3), LENGTH / steps / 32, []
    for n in range(steps * 32):
        a = slope(x)
        b = slope(x + h / 2 * a)
        c = slope(x + h / 2 * b)
        x = x + h / 6 * (a + 2 * b + 2 * c + slope(x + h * c))
        rows += [x] if n % 32 == 31 else []
    return np.array(rows)


def linear_solution(steps):
    a = np.array([[-R / L, 0, -K / L], [0, 0, 1], [K / J, 0, -DRAG / J]])
    return series(a, np.array([VOLTS / L, 0, 0]), np.zeros(3), steps, 30, LENGTH / steps)


@pytest.fixture(scope='module')
def solutions():
    """Of both, at the ends of 640 steps."""
    return {LINEAR: linear_solution(640), BENT: bent_solution(640)}


def order_of(plant, solutions, method, of, substeps, **of_plant):
    """The power of the step with which the largest error of all ticks falls, over 3 A, 1 rad and 120 rad/s; from 320 to 640 steps,
    where rounding is far below it."""
    errors = []
    for steps in (320, 640):
        rows = motor(plant, method, LENGTH / steps, substeps, of, **of_plant).follow(steps).rows['y'][1:]
        errors.append((np.abs(rows - solutions[of][640 // steps - 1::640 // steps]) / [3, 1, 120]).max())
    return math.log2(errors[0] / errors[1])


@pytest.mark.parametrize('method, substeps, least, most', [('euler', 4, 0.9, 1.1), ('heun', 4, 1.8, 2.6), ('rk4', 4, 2.9, 4.1),
                                                           ('rk4', 16, 2.9, 4.1)])
@pytest.mark.parametrize('of', [LINEAR, BENT], ids=['linear', 'bent'])
def test_methods_keep_their_orders(plant, solutions, method, substeps, least, most, of):
    assert least <= order_of(plant, solutions, method, of, substeps) <= most


def test_slow_states_that_move_along_straight_lines_are_found(plant, solutions):
    bent = {'core/methods/multirate.h': lambda text: replaced(r'i < 2 \? R\(0\.0\)', 'i < 4 ? R(0.0)', text)}
    assert order_of(plant, solutions, 'rk4', LINEAR, 4, core=bent) < 2.9


def stated(text):
    return text in ' '.join((ROOT / 'core/README.md').read_text().split())


def test_sub_steps_add_no_energy_to_an_exchange_and_take_none(plant):
    """Without resistance and drag, energy goes between the current and the speed for ever, by a quarter of a rad in a step. After a
    thousand steps the method with sub-steps is as near to 1 as alone or nearer, as core/README.md says."""
    left = {}
    for substeps in (4, 0):
        for method in ('euler', 'heun', 'rk4'):
            y = motor(plant, method, 0.25 * math.sqrt(L * J) / K, substeps, volts=0, resistance=0, drag=0, start=1, real='float').follow(1000).y
            left[method, substeps] = float(y.current[-1])**2 + float(y.speed[-1])**2 * J / L
    for method in ('euler', 'heun', 'rk4'):
        assert abs(left[method, 4] - 1) <= abs(left[method, 0] - 1)
    for substeps, words in ((4, 'of 0.25 rad, of 1'), (0, 'the same without sub-steps')):
        row = ' | '.join(f'{left[method, substeps]:.5g}' for method in ('euler', 'heun', 'rk4'))
        assert stated(f'{words} | {row} |'), row
    assert stated('of a decay within 50 us | 0.6 ms | 0.6 ms | 0.836 ms |')


# --- sub-steps of motors whose currents settle within a twentieth of a step ---

FAST = pathlib.Path('tests/isoc/effects/substeps.scene').read_text()


@pytest.mark.parametrize('real', ['float', 'double'])
def test_currents_of_sub_steps_are_those_of_the_closed_form(plant, real):
    """With x = step / (time in which the rotor runs up) a run-up is followed to x^4. What is left is the first tick, in which the
    current jumps: the sub-steps that lead to the middle of the step know nothing yet of the acceleration, so that the speed
    errs by at most H a, a being the largest acceleration, for a part of the tick. A current that follows that is off by
    constant H a / resistance, at the end of the first tick only; the speed by x H a, for good. The sum of a speed rounds by half
    an epsilon in a tick, and is forgotten in 1 / x ticks; twice that, for what is added. A current follows it, and rounds some
    dozens of times. What is not linear in the current takes its square at four points of the first tick: by a third of it
    wrong. The control is a supply that is a thousandth higher."""
    p, h, ticks, parts, lag = plant(FAST, real=real), 1e-3, 2000, 64, 0.1
    a = np.array([[-2 / 1e-4, -0.05 / 1e-4], [0.05 / 1e-3, 0]])
    fine = np.concatenate([np.zeros((1, 2)), series(a, np.array([VOLTS / 1e-4, 0]), np.zeros(2), ticks * parts, 20, h / parts)])
    heat, warm, exact_warmth = 2 * ((fine[:-1, 0] + fine[1:, 0]) / 2)**2, 0.0, []
    d = h / parts / lag
    for power in heat:
        warm += d * (power - warm) * (1 - d / 2)
        exact_warmth.append(warm)
    current, speed, warmth = fine[parts::parts, 0], fine[parts::parts, 1], exact_warmth[parts - 1::parts]
    y = p.follow(ticks, {'volts': VOLTS}).y
    largest, fastest, x = 3.0, 120.0, h * 0.05**2 / (1e-3 * 2)
    most = 0.05 * largest / 1e-3 * h  # H a
    speed_off = x * most + p.ulp * fastest / x
    later = 0.05 / 2 * speed_off + 64 * p.ulp * largest
    off = np.abs(y.current[1:] - current)
    assert off.max() <= 0.05 / 2 * most + later and off[10:].max() <= later
    assert np.abs(y.speed[1:] - speed).max() <= speed_off
    assert np.abs(y.warmth[1:] - warmth).max() <= h / lag * 2 * largest**2 / 3 + 4 * 2 * largest * later
    assert (y.current == y.twin_current).all() and (y.speed == y.twin_speed).all(), 'two effects apart have the same bits'
    higher = p.follow(ticks, {'volts': VOLTS * 1.001}).y
    assert np.abs(higher.current[1:] - current)[10:].max() > later


@pytest.mark.parametrize('method, substeps, is_stable', [('rk4', 0, False), ('rk4', 6, False), ('rk4', 8, True), ('heun', 16, True),
                                                         ('euler', 16, True)])
def test_isoc_says_which_sub_steps_hold_a_motor(plant, method, substeps, is_stable):
    """50 us in a step of 1 ms: no current above 6 A within half a second, or a warning."""
    p = plant(FAST.replace('; substeps 16', f'; substeps {substeps}' if substeps else ''), '--method', method, real='float')
    current = p.follow(500, {'volts': VOLTS}, whole=False).y.current
    assert (len(current) == 501 and (np.abs(current) < 6).all()) == is_stable
    assert (f"the effect 'drive' is too fast for {method}" not in p.made.errors) == is_stable


def test_a_sub_step_is_held_up_to_its_limit(isoc):
    """2.785 times 50 us; what has no sub-steps is judged by the step."""
    six = FAST.replace('; substeps 16', '; substeps 6')
    assert 'warning' not in isoc(six, '--step', '0.830ms').errors
    assert 'euler 0.6 ms, heun 0.6 ms, rk4 0.836 ms' in isoc(six, '--step', '0.840ms').errors
    told = isoc(FAST + 'effect bearing friction { along shaft; sliding 5 N*m; creep 1 rad/s }\n').errors
    assert "the effect 'bearing' is too fast for rk4 with a step of 1 ms, 16 sub-steps of it for effects: " in told
    assert ' -750' in told and "the effect 'd" not in told and "the effect 't" not in told


def test_a_plant_without_sub_steps_has_nothing_of_them(isoc):
    plain = FAST.replace('; substeps 16', '')
    without = ['--without', 'drive; slow; twin']
    assert isoc(FAST, *without).files() == isoc(plain, *without).files()
    assert not any(word in isoc(plain).file('plant.c') for word in ('multirate', 'fast'))
    assert 'multirate' in isoc(FAST).file('plant.c')


# --- on the board ---


def on_board(isochron, tmp_path, scene, name='plant', target='cortex-m4f'):
    (tmp_path / f'{name}.scene').write_text(scene)
    said = isochron('run', tmp_path / f'{name}.scene', '--target', target, '--seconds', '0.2').said
    return said, int(said.get('instructions_per_step', 0))


def test_the_board_has_the_bits_of_the_host(isochron, tmp_path):
    scene = FAST.replace('input volts V', 'input volts V = 6 V')
    assert on_board(isochron, tmp_path, scene)[0]['hash'] == on_board(isochron, tmp_path, scene, target='host')[0]['hash']


def test_the_motor_alone_costs_less_than_the_whole_plant(isochron, tmp_path):
    """One of the library's models, which has friction, as core/README.md says. Under a ladder each rung has its own step of both
    rates, and one that drops all effects with sub-steps a plain one; the top costs what it does alone, and what a ladder does."""
    bench = pathlib.Path('models/dc_motor_bench.scene').read_text()
    parted = replaced('^    constant 50 mN.m/A', r'\g<0>; substeps 4', bench)
    plain, whole = (on_board(isochron, tmp_path, scene)[1] for scene in (bench, bench + 'substeps 4\n'))
    said, cost = on_board(isochron, tmp_path, parted)
    assert plain < cost < whole * 3 / 4
    assert stated(f'takes {plain} instructions of a step, with 4 sub-steps of the motor {cost}, with 4 of the whole plant {whole}.')
    ladder, of_ladder = on_board(isochron, tmp_path, parted + 'overrun degrade { method heun; drop drive; after 10 ticks }\n', 'ladder')
    assert ladder['hash'] == said['hash'] and of_ladder <= cost + 13
    assert stated(f'and a step {of_ladder - cost} instructions more')
    text = ((FOLDER / ladder['trace']).parent / 'plant.c').read_text()
    assert len(re.findall(r'  iso_multirate_step\(ISO_(?:RK4|HEUN)|  iso_method_step\(ISO_HEUN', text)) == 3
