"""The order of every method: on a generated plant, on a closed loop and on a hand-written plant; of semi-implicit Euler on
bodies that turn freely too; on closed loops with the stabilisation that a scene has by itself; and what a projection
leaves."""
import re
import shutil

import numpy as np
import pytest

from harness.programs import path_of, run
from harness.project import ROOT

HERE = 'tests/core/methods/order/'
MODELS = ROOT / 'models'
ORDER = [HERE + 'order.c', HERE + 'plant.c']


@pytest.fixture
def generated(isoc):
    """generated(scene, option, ...): the source of its plant, in double."""
    def of(scene, *options, real='double'):
        made = isoc(ROOT / scene, '--real', real, *options)
        assert made.status == 0, made.errors
        return made.folder / 'plant.c'

    return of


@pytest.mark.parametrize('scene, method, problem, words', (
    ('models/double_pendulum.scene', 'bdf4', 'double_pendulum', ()),     # an implicit method has a Jacobian for all
    ('models/double_pendulum.scene', 'rk4', 'double_pendulum', ('sines',)),     # stages that take sines from those of the start
    (HERE + 'four_bar.scene', 'rk4', 'four_bar', ())))
def test_of_every_method_on(generated, of_plant, proves, scene, method, problem, words):
    options = [] if problem == 'four_bar' else ['--method', method]
    proves(of_plant(generated(scene, *options), *ORDER, f'{HERE}{problem}.c'), *words)


def test_on_a_plant_that_is_written_by_hand(of_plant, proves):
    proves(of_plant(MODELS / 'oscillator.c', *ORDER, HERE + 'oscillator.c'))


@pytest.mark.parametrize('name', ('tumble', 'top'))
def test_of_semi_implicit_euler_on_bodies_that_turn_freely(generated, of_plant, proves, name):
    proves(of_plant(generated(f'{HERE}{name}.scene'), HERE + 'turning.c', HERE + 'plant.c'))


@pytest.mark.parametrize('problem', ('double_pendulum', 'oscillator'))
def test_in_float_every_error_is_that_in_double_and_what_rounding_adds(generated, of_plant, problem):
    """Each rounded coefficient of a method drives a state off by up to half an epsilon of all its motion, which is some
    20 m or rad, or per second, in this second. So an order shows as far as that lets it. Control: steps of which nothing is
    carried to the next add half an ulp each."""
    def errors(real, *words):
        plant = MODELS / 'oscillator.c' if problem == 'oscillator' else \
            generated('models/double_pendulum.scene', '--method', 'bdf4', real=real)
        done = run(of_plant(plant, *ORDER, f'{HERE}{problem}.c', real=real), 'errors', *words)
        rows = [line.split('\t') for line in done.printed.splitlines()]
        return [row[:2] for row in rows], np.array([float(row[2]) for row in rows])

    of, exact = errors('double')
    same, near = errors('float')
    limit = 20 * 2.0**-23
    assert same == of and len(of) >= 50 and abs(near - exact).max() <= limit
    if problem == 'double_pendulum':
        assert abs(errors('float', 'plain')[1] - exact).max() > limit


@pytest.mark.parametrize('scene, words', (
    ('models/four_bar', '0.25 12'), (HERE + 'governor', '1 11'), (HERE + 'three_free', '0.25 10'),
    # The crank, its speed, the slider and its speed after 0.5 s, of the motion with one freedom that the energy gives,
    # integrated to 24 digits by two methods; the mechanism is that of the IFToMM library of multibody problems (Haug 1989).
    (HERE + 'spatial', '0.5 13 0 5.58376255330730439827198 1 14.4081608102003757545 2 0.184952629777802628835 '
                       '3 -0.00456029063251560051612')))
def test_every_method_keeps_its_order_on_closed_loops(isoc, settled, proves, scene, words):
    text = re.sub('^stabilisation.*\n', '', (ROOT / f'{scene}.scene').read_text(), flags=re.M)
    made = isoc(text, '--real', 'double', '--method', 'bdf4')
    proves(settled(made.folder / 'plant.c', HERE + 'loops.c'), *words.split())


@pytest.mark.parametrize('stabilisation, least, most', (('projection', 3.9, 4.1), ('lagrangian', 3.9, 4.1), ('baumgarte', 0.0, 3.0)))
def test_rk4_on_the_four_bar_linkage_as_isochron_drift_measures_it(isoc, program, stabilisation, least, most):
    """Control: gains that follow the step."""
    text = (MODELS / 'four_bar.scene').read_text() + f'stabilisation {stabilisation}\n'
    parts = [isoc(text, '--real', 'double', '--name', name, '--step', step)
             for name, step in (('coarse', '1ms'), ('middle', '500us'), ('fine', '250us'))]
    done = run(program(*parts, 'tools/measure/order.c', 'core/numbers/self_check.c', real='double', by='clang'), 0.25)
    assert least < float(done.said['order']) < most


PROJECTED = [*(f'models/{name}' for name in ('four_bar', 'n_four_bar', 'slider_crank', 'squeezer')), HERE + 'governor', HERE + 'spatial']


@pytest.mark.parametrize('scene', [*PROJECTED, 'control'])
def test_after_a_projection_the_closures_hold_to_the_second_order(isoc, settled, proves, tmp_path, scene):
    """Of what the states were off by: the speeds are those that the closures demand where the positions have moved to, also
    where sums of angles turn as one (tools/isoc/dynamics/phasors.c). Control: sines and cosines that turn the wrong way."""
    path = ROOT / f'{"models/n_four_bar" if scene == "control" else scene}.scene'
    text = re.sub('^stabilisation.*\n', '', path.read_text(), flags=re.M)
    plant = isoc(text, '--real', 'double', '--method', 'ab4').folder / 'plant.c'
    if scene != 'control':
        proves(settled(plant, HERE + 'projected.c'))
        return
    turned = re.sub('Projection of the speeds.*?(Closures|\\Z)', lambda part: re.sub(r' \+ (.*) \* ', r' - \1 * ', part[0]),
                    plant.read_text(), flags=re.S)
    shutil.copy(plant.with_suffix('.h'), tmp_path)
    other = path_of(turned, tmp_path, 'plant.c')
    assert run(settled(other, HERE + 'projected.c')).finds('the projection leaves')
