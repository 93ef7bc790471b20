"""Inputs that change at every tick, held and smooth: the order of every method, the samples in the plant's memory, what isoc warns
of, the same bits and one count on host and board.

Held: the input is a staircase, and the reference is the exact solution with the staircase of the same ticks. A method without a
history has its order. One with a history is exact to its order for another signal, a continuous one that is h/2 ahead (bdf4: h/2
behind): so its order is one. Smooth: the input is a sample of a continuous signal, with which the reference is the exact solution.
Every method has its order; in the reading `held`, order one, as the staircase is h/2 late."""
import functools
import math
import pathlib
import re
import subprocess

import numpy as np
import pytest
from harness.plants import compiled, replaced
from harness.project import ROOT

from lab import rig

SCENE = pathlib.Path('tests/isoc/plant/inputs/loop.scene').read_text()
HELD = SCENE.replace(' smooth', '')
ORDERS = {'euler': 1, 'heun': 2, 'rk4': 4, 'semi_implicit': 1, 'ab4': 4, 'abm4': 4, 'abm4_pec': 4, 'abm4_pecece': 4, 'bdf4': 4,
          'rosenbrock': 3, 'adams': 4}
HISTORY = {'ab4', 'abm4', 'abm4_pec', 'abm4_pecece', 'bdf4', 'adams'}
CURVED = 'effect square { joint rail; signal pull N; effort on rail = pull * pull / 2 N }\neffect curve square { rail rail; pull force }\n'


def test_all_methods_are_tried():
    rows = re.findall(r'^\| (\w+) \| (?:1 to )?(\d) \|', subprocess.run(['build/isoc', '--methods'], capture_output=True, text=True).stdout, re.M)
    assert {method: int(order) for method, order in rows} == ORDERS


# --- the reference: the cart and its pole by hand ---


def signal(t):
    """At rest at the start to the fourth derivative, as before it, so that the first steps have a past."""
    soft = np.sin(np.pi * t)**4
    return 8 * soft * np.sin(4 * np.pi * t + 1), 1.5 * soft * np.cos(3 * np.pi * t)


def slope(x, force, torque):
    """Place, angle and their rates, also of arrays of states. The pole's centre of mass is 0.4 m up its own axis."""
    _, angle, v, w = x
    c, s, lever = np.cos(angle), np.sin(angle), 0.3 * 0.4
    push = force - 0.5 * v - lever * s * w * w
    turn = torque - 0.02 * w + 9.81 * lever * s
    a, b, d = 1.5, -lever * c, 4e-3 + lever * 0.4
    det = a * d - b * b
    return np.array([v, w, (d * push - b * turn) / det, (a * turn - b * push) / det])


def advanced(x, inputs, t, h):
    """One step of rk4 with the inputs of each stage."""
    def f(y, at):
        return slope(y, *inputs(at))

    k1 = f(x, t)
    k2 = f(x + h / 2 * k1, t + h / 2)
    k3 = f(x + h / 2 * k2, t + h / 2)
    return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + f(x + h * k3, t + h))


START = np.array([0, math.radians(100), 0, 0])


@functools.cache
def exact(stairs=None):
    """The state at 1 s, with the continuous signal or the staircase of so many ticks."""
    steps = 4000
    x, h = START, 1 / steps
    for n in range(steps):
        held = None if stairs is None else signal(n * stairs // steps / stairs)
        x = advanced(x, signal if held is None else lambda t: held, n * h, h)
    return x


def plant_of(plant, scene, method, steps, **of_plant):
    """In so many steps of a second; what is left of the errors of adams is that of the extrapolation over a tick."""
    tolerance = ['--tolerance', '1e-13'] if method == 'adams' else []
    return plant(scene, '--method', method, '--step', f'{10**9 // steps}ns', *tolerance, **of_plant)


def given(steps):
    force, torque = signal(np.arange(steps) / steps)
    return {'force': force, 'torque': torque}


def test_the_reference_has_the_derivative_of_the_plant(plant):
    p = plant(HELD, '--method', 'rk4')
    rows = p.follow(500, {'force': 3.0, 'torque': -0.4}).rows
    wanted = slope(rows['x'].T, 3.0, -0.4).T
    assert np.abs(p.slopes_at(rows, rows['x'])[0] - wanted)[:-1].max() <= 1e-12 * np.abs(wanted).max()


# --- orders ---

# The accepted distance of an observed order from the method's: with C h^p (1 + D h) it is D h / (2 ln 2) with the coarser step.
# Extrapolation has D up to 80 / s.
TOLERANCE = 0.12


def order_of(plant, scene, method, coarsest, is_staircase):
    errors = []
    for steps in (coarsest, 2 * coarsest):
        x = plant_of(plant, scene, method, steps).follow(steps, given(steps)).rows['x'][-1]
        errors.append(np.linalg.norm(x - exact(steps if is_staircase else None)))
    return math.log2(errors[0] / errors[1])


@pytest.mark.parametrize('method', [method for method in ORDERS if method != 'adams'])
def test_held_a_method_without_a_history_has_its_order_and_another_order_one(plant, method):
    order = 1 if method in HISTORY else ORDERS[method]
    coarsest = 1000 if order == 1 else 125
    assert abs(order_of(plant, HELD, method, coarsest, True) - order) <= TOLERANCE


@pytest.mark.parametrize('method', ORDERS)
def test_smooth_every_method_has_its_order(plant, method):
    coarsest = 1000 if ORDERS[method] == 1 or method == 'abm4_pec' else 500
    assert abs(order_of(plant, SCENE, method, coarsest, False) - ORDERS[method]) <= TOLERANCE


def test_held_rk4_is_of_order_one_for_the_continuous_signal(plant):
    assert abs(order_of(plant, HELD, 'rk4', 500, False) - 1) <= TOLERANCE


def test_what_is_not_affine_in_an_input_takes_rosenbrock_a_rate_of_one_order_more(plant, isoc):
    """isoc sees that; taken as affine, the order is lost."""
    def curved_order(change=None):
        errors = []
        for steps in (500, 1000):
            rows = plant_of(plant, SCENE + CURVED, 'rosenbrock', steps, change=change).follow(steps, given(steps)).rows
            errors.append(np.linalg.norm(rows['x'][-1] - curved))
        return math.log2(errors[0] / errors[1])

    x, h = START, 1 / 4000
    for n in range(4000):
        x = advanced(x, lambda t: (signal(t)[0] + signal(t)[0]**2 / 2, signal(t)[1]), n * h, h)
    curved = x
    assert abs(curved_order() - 3) <= TOLERANCE
    assert abs(curved_order(lambda text: replaced(r'^.*curved = true.*$', '', text)) - 3) > TOLERANCE
    assert 'curved' not in isoc(SCENE, '--method', 'rosenbrock').file('plant.c')


@pytest.mark.parametrize('method', ORDERS)
def test_the_local_error_is_that_of_the_step_and_isoc_warns_where_it_is_not(plant, method):
    """The largest of a step from a quarter of a second on, over its state from before."""
    steps = 500
    p = plant_of(plant, SCENE + 'checked yes\n', method, steps)
    rows = p.follow(steps, given(steps)).rows
    x, h = rows['x'][:-1].T, 1 / steps / 16
    t = np.arange(steps) / steps
    for n in range(16):
        x = advanced(x, signal, t + n * h, h)
    late = t > 0.25
    true = np.abs(rows['x'][1:] - x.T)[late].max()
    told = rows['local_error'][1:][late].max()
    tells = 0.8 * true < told < 1.25 * true
    assert tells == (p.made.errors == ''), (told, true, p.made.errors)


# --- samples ---


def test_samples_stand_in_the_memory_and_a_jump_forgets_them(plant):
    """Bits, so that no tolerance hides a sample: held, smooth, and smooth with a jump of 1."""
    jump = SCENE.replace('force smooth', 'force smooth jump 1 N').replace('torque smooth', 'torque smooth jump 1 N*m')
    ticks = 40
    constant = {'force': 5.0, 'torque': -2.0}
    leap = {name: np.where(np.arange(ticks) < ticks // 2, value, -value) for name, value in constant.items()}
    wave = {'force': np.sin(0.05 * np.arange(ticks)), 'torque': np.cos(0.03 * np.arange(ticks))}
    for method in ('rk4', 'rosenbrock'):
        held, smooth, jumping = (plant(scene, '--method', method) for scene in (HELD, SCENE, jump))

        def end(p, of):
            return p.follow(ticks, of).rows['x'][-1].tobytes()

        assert end(held, constant) == end(smooth, constant), 'a first sample has no past'
        assert end(held, leap) == end(jumping, leap) != end(smooth, leap), 'a constant after a jump'
        assert end(held, wave) != end(smooth, wave) == end(jumping, wave), 'changes below the jump are no jump'
        values, which = smooth._inputs(ticks, wave)
        smooth.start()
        smooth.go(20, given=values[:20], which=which)
        kept = smooth.now.copy()
        smooth.go(3, given=smooth._inputs(3, constant)[0], which=which, first=20)
        smooth.now[:] = kept
        smooth.go(20, given=values[20:], which=which, first=20)
        assert smooth.now['x'].tobytes() == end(smooth, wave), 'a snapshot has the samples'


BY_HAND = '''#define ISO_HAS_SMOOTH_INPUTS
#include "core/runtime/handwritten.h"

#include <math.h>

ISO_PLANT_MEMORY(1, 1, 0, 1);

static const real start[1] = {R(0.0)};
static const bool smooth[1] = {true};

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)x, (void)p;
    dx[0] = u[0];
}

static void output(real *restrict const y, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p)
{
    (void)u, (void)p;
    y[0] = x[0];
}

static void drive(void *const instance, const uint64_t tick)
{
    plant_memory *const memory = instance;
    memory->u[0] = (real)pow(sin((double)tick * (double)ISO_STEP_SIZE), 4.0);
}

static const iso_equations equations = {.derivative = derivative, .held = 1, .inputs = 1, .smooth = smooth};

ISO_PLANT(1, 1, 0, 1, .name = "hand", .output_names = "x", .drive = drive);
'''


def test_a_plant_by_hand_can_have_smooth_inputs():
    """x' = u, u = sin(t)^4: with rk4 half the step divides the error by 16, to a tenth of that."""
    errors = []
    for step in (0.01, 0.005):
        library = compiled('tcc', {'plant.c': BY_HAND}, ROOT / 'tools/lab/rig.c', '-shared', '-DISO_REAL_DOUBLE', f'-DISO_STEP={step}',
                           '-lm', kind='.so')
        x = rig.Plant(library).run(round(2 / step))['x'][-1, 0]
        errors.append(abs(x - (0.375 * 2 - math.sin(4) / 4 + math.sin(8) / 32)))
    assert 14.4 < errors[0] / errors[1] < 17.6


# --- what isoc warns of ---

CHECKED = SCENE + 'checked yes\n'
WARNINGS = [(method, HELD, '') for method in ('euler', 'heun', 'rk4', 'semi_implicit', 'rosenbrock')] + [
    (method, scene, message) for method in ('ab4', 'abm4', 'abm4_pec', 'abm4_pecece') for scene, message in (
        (HELD, f"'force' is held, and {method} has a history: .* order one; take rk4, or 'input force smooth'"), (SCENE, ''))] + [
    ('bdf4', HELD, 'order one; take rosenbrock'), ('adams', HELD, 'order two; take rk4'),
    ('bdf4', CHECKED, "without that of the extrapolated input 'force'; take rosenbrock"),
    ('abm4_pec', CHECKED, "without that of the extrapolated input 'force'; take abm4")] + [
    (method, CHECKED, '') for method in ('rk4', 'ab4', 'abm4', 'abm4_pecece', 'rosenbrock')]


@pytest.mark.parametrize('method, scene, message', WARNINGS)
def test_isoc_warns_where_a_method_loses_its_order(isoc, method, scene, message):
    made = isoc(scene, '--method', method)
    assert made.status == 0
    assert re.search(r'scene:\d+:7: warning: .*' + message, made.errors) if message else made.errors == ''


GUST = 'effect wind gust { mean 1 m/s; sigma 1 m/s; length 10 m; speed 2 m/s }'


@pytest.mark.parametrize('line, column, message', [
    (f'{GUST}; effect drift drag {{ on cart; area 1 m^2; wind_x wind.value }}', 8,
     "the noise of the effect 'wind' changes at every tick .* ab4 is of order one; take rk4"),
    ('effect push shove { along rail; by 1 N * noise(3) }', 42, 'the noise changes at every tick'),
    (f'{GUST}; output wind = wind.value', 0, '')])
def test_isoc_warns_of_noise_on_which_the_motion_depends(isoc, line, column, message):
    made = isoc(f'effect shove {{ joint along; signal by N; effort on along = by }}\n{line}\n{SCENE}', '--method', 'ab4')
    assert made.status == 0
    assert re.search(f'scene:2:{column}: warning: {message}', made.errors) if message else made.errors == ''


def test_held_is_what_an_input_is_by_itself(isoc):
    assert isoc(SCENE.replace(' smooth\n', ' held\n'), '--method', 'rk4').file('plant.c').replace(' held ', ' ') == \
        isoc(HELD, '--method', 'rk4').file('plant.c').replace(' held ', ' ')


# --- on the board ---


@pytest.mark.parametrize('method', ['rk4', 'abm4', 'bdf4', 'rosenbrock', 'adams'])
def test_samples_have_the_bits_of_the_host_on_the_board_and_one_count(isochron, tmp_path, method):
    waves = SCENE.replace('input force smooth', 'input force smooth = 8 N * sin(5 Hz)') \
        .replace('input torque smooth', 'input torque = 1 N*m * sin(2 Hz)')
    (tmp_path / 'waves.scene').write_text(waves)
    host, board = (isochron('run', tmp_path / 'waves.scene', '--method', method, '--seconds', '1', '--target', target).said
                   for target in ('host', 'cortex-m4f'))
    assert host['hash'] == board['hash']
    assert 'instructions_per_step' in board
