"""Plants side by side have the bits of plants alone: isoc --lanes with -DISO_LANES, 4 to 32 lanes, by gcc and clang, in float and in double.
Each lane has its own start, inputs that change, also to no number, tunables and faults, restarts of the method, and in some the guard ends
it (run.c)."""
import pathlib
import re
import subprocess
import sys

import pytest
from harness import project
from harness.plants import STRICT, replaced
from harness.project import ROOT

HERE = ROOT / 'tests/isoc/emit/lanes'
# Vectors of any width are compiled for any processor. What gcc says of calling conventions is of functions that it inlines.
FLAGS = ['-std=c11', *(flag for flag in STRICT if flag != '-O2'), '-Wno-psabi', '-I', ROOT]


class Sides:
    """What compare.c says of a plant alone and in lanes; `change` is planted in the lanes."""

    def __init__(self, isoc, folder, scene, method, real, lanes, compiler, ticks, change=None):
        made = isoc(scene, '--method', method, '--real', real, '--lanes')
        assert made.status == 0, made.errors
        text = made.file('plant.c')
        (made.folder / 'lanes.c').write_text(change(text) if change else text)
        double = ['-DISO_REAL_DOUBLE'] * (real == 'double')
        for name, of in (('alone', [f'-DPLANT="{made.folder}/plant.c"']), ('lanes', [f'-DISO_LANES={lanes}', f'-DPLANT="{made.folder}/lanes.c"'])):
            subprocess.run([compiler, *FLAGS, '-O0', *double, *of, '-c', HERE / 'run.c', '-o', folder / f'{name}.o'], check=True)
        subprocess.run(['gcc', *FLAGS, '-O2', HERE / 'compare.c', folder / 'alone.o', folder / 'lanes.o', '-o', folder / 'compare'], check=True)
        done = subprocess.run([folder / 'compare', str(lanes), str(ticks)], capture_output=True, text=True)
        self.are_same, self.printed = done.returncode == 0, done.stdout


def model(name):
    return (ROOT / f'models/{name}.scene').read_text()


def with_path(path):
    """A scene that includes what stands beside it."""
    return ROOT / path


NEAR_HOLD = (ROOT / 'tests/isoc/closure/singular/near_dead.scene').read_text() + '\nstabilisation projection { near hold }\n'
WALL = '''step 1 ms
checked yes
body cart { mass 1 kg }
joint rail prismatic { parent ground; child cart; axis x; speed 1 m/s }
effect wall { joint along; effort on along = -10 kN/m * max(position of along - 0.1 m, 0) }
effect hit wall { along rail }
output place = position of rail
'''
DRIVE, ALL, EVENTS, HOLDS = (with_path(path) for path in ('models/cart_pole_drive.scene', 'tests/isoc/effects/all.scene', 'tests/isoc/events/events.scene',
                                                          'tests/isoc/events/holds.scene'))


@pytest.mark.parametrize('scene, method, real, lanes, compiler, ticks, happens', [
    (DRIVE, 'abm4', 'float', 16, 'gcc', 600, 'restarts [1-9].*stopped [1-9]'),
    (ALL, 'rk4', 'double', 8, 'clang', 400, 'restarts [1-9].*stopped [1-9].*held [1-9]'),
    # The energy that is held near a singular position, after others were stopped.
    (NEAR_HOLD, 'rk4', 'float', 8, 'gcc', 400, 'stopped [1-9].*near [1-9]'),
    (EVENTS, 'rk4', 'float', 16, 'gcc', 600, ''), (EVENTS, 'heun', 'double', 4, 'clang', 300, ''), (HOLDS, 'rk4', 'float', 8, 'gcc', 400, ''),
    # A step that is made again, in the lanes where its error leaps, as the cart meets the wall.
    (WALL, 'ab4', 'double', 8, 'gcc', 400, 'restarts [1-9]')],
    ids=['drive', 'all', 'near hold', 'events', 'events by heun', 'holds', 'wall'])
def test_every_kind_of_thing_that_a_lane_has_for_itself(isoc, tmp_path, scene, method, real, lanes, compiler, ticks, happens):
    sides = Sides(isoc, tmp_path, scene, method, real, lanes, compiler, ticks)
    assert sides.are_same and re.search(happens, sides.printed), sides.printed


# The other models, each with a method; by turns.
MODELS = '''arm6 abm4|arm_drive euler|balancer bdf4|bricard ab4|cart_pole rosenbrock|crane heun|dc_motor_bench abm4_pecece|double_pendulum rk4
four_bar abm4_pec|gyroscope semi_implicit|hopper bdf4|n_four_bar ab4|parallelogram rosenbrock|pendulum semi_implicit|pump heun
quadrotor abm4_pecece|quadrotor_sih rk4|quarter_car abm4|rigid_body euler|slider_crank bdf4|squeezer ab4|top rosenbrock|tree semi_implicit'''
PAIRS = [pair.split() for pair in re.split(r'[|\n]', MODELS)]
TURN = project.turn(10, pathlib.Path(__file__))


@pytest.mark.parametrize('number, name, method', [(n, *pair) for n, pair in enumerate(PAIRS, 1) if TURN is None or n % 10 == TURN],
                         ids=lambda value: str(value))
def test_models_have_the_same_bits(isoc, tmp_path, number, name, method):
    sides = Sides(isoc, tmp_path, with_path(f'models/{name}.scene'), method, 'float' if number % 2 else 'double', 4, 'clang' if number % 3 == 0 else 'gcc', 200)
    assert sides.are_same, sides.printed


def test_a_random_scene_has_the_same_bits(isoc, tmp_path, seed):
    scene = subprocess.run([sys.executable, 'tests/promises/random/write_scene.py', str(seed)], capture_output=True, text=True, check=True).stdout
    sides = Sides(isoc, tmp_path, scene, re.search('^method (.*)', scene, re.M)[1], 'float', 32, 'gcc', 200)
    assert sides.are_same, sides.printed


def test_one_lane_with_another_derivative_and_a_restart_of_all_are_found(isoc, tmp_path):
    def fifth(text):
        begin = text.index('static void derivative_by_sines(')
        return text[:begin] + replaced(r'\A((?:.|\n)*?)(^    dx\[.*DRIVE_CURRENT\] = .*$)', r'\1\2\n    dx[PLANT_X_DRIVE_CURRENT][5] *= 1.000001f;', text[begin:])

    sides = Sides(isoc, tmp_path, DRIVE, 'rk4', 'float', 16, 'gcc', 20, fifth)
    assert not sides.are_same and re.findall('^# lane (\\d+)', sides.printed, re.M) == ['5']

    def of_all(text):
        begin = text.index('static iso_flag discontinuity(')
        return text[:begin] + text[begin:].replace('return found;', 'return iso_mask_where(iso_any(found));', 1)

    assert not Sides(isoc, tmp_path, DRIVE, 'abm4', 'float', 4, 'gcc', 100, of_all).are_same


def test_lanes_in_a_folder_that_compiles_alone(isoc):
    """With flags that say nothing of fused products."""
    folder = isoc(with_path('models/cart_pole.scene'), '--name', 'cart', '--standalone', '--lanes').folder
    subprocess.run('gcc -std=c11 -O2 -Wall -Wextra -Wpedantic -Werror -Wno-psabi -fno-math-errno -DISO_LANES=16 -I. -c cart.c -o cart.o'.split(), cwd=folder, check=True)


@pytest.mark.parametrize('scene, options, message', [
    (model('pendulum'), ['--method', 'adams'], 'each plant with adams'),
    (replaced('^step .*$', r'\g<0>\noverrun degrade { method euler; after 10 ticks }', model('pendulum')), [], 'overrun is for the loop'),
    (ROOT / 'models/cart_pole.scene', ['--link'], 'leave out --lanes')], ids=['adams', 'a ladder', 'a link'])
def test_what_has_no_lanes_is_refused(isoc, scene, options, message):
    made = isoc(scene, '--lanes', *options)
    assert made.refused and message in made.errors


def test_five_lanes_are_refused(isoc):
    made = isoc(with_path('models/pendulum.scene'), '--lanes')
    done = subprocess.run(['gcc', *FLAGS, '-O2', '-DISO_LANES=5', '-fsyntax-only', made.folder / 'plant.c'], capture_output=True, text=True)
    assert done.returncode and 'ISO_LANES is 2, 4, 8' in done.stderr


@pytest.mark.parametrize('name', ['double_pendulum', 'four_bar'])
def test_compiled_without_lanes_both_texts_of_a_plant_are_the_same_to_the_last_byte(isoc, tmp_path, name):
    objects = []
    for options in ([], ['--lanes']):
        made = isoc(with_path(f'models/{name}.scene'), '--method', 'abm4', *options, folder=tmp_path / 'plant')
        subprocess.run(['gcc', *FLAGS, '-O2', '-c', made.folder / 'plant.c', '-o', tmp_path / 'o'], check=True)
        objects.append((tmp_path / 'o').read_bytes())
    assert objects[0] == objects[1]
