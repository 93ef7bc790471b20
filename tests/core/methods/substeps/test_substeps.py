"""Sub-steps of a tick (`substeps 4`): the plant moves as with a quarter of the step, to the bit, where its inputs are
constant; on the board as on the host; and at four times the cost."""
import re

import pytest

from harness.programs import path_of
from harness.project import ROOT

MODELS = ROOT / 'models'
PENDULUM = (MODELS / 'double_pendulum.scene').read_text()
TICKS = 500


def moves(plant, text, method, real, parts=4):
    """The states of a plant with sub-steps behind each tick, and those of one with a quarter of the step."""
    # Functions of time are sampled once a tick: constants in their place.
    text = re.sub('^(input [a-z]*) = .*', r'\1 = 1.5 N', text, flags=re.M)
    parted = plant(f'{text}\nsubsteps {parts}\n', '--step', '1ms', '--method', method, real=real).run(TICKS)
    fine = plant(text, '--step', '0.25ms', '--method', method, real=real).run(4 * TICKS, every=4)
    return parted['x'].tobytes(), fine['x'].tobytes()


@pytest.mark.parametrize('scene, method, real', [
    *((MODELS / 'double_pendulum.scene', method, 'float') for method in 'rk4 semi_implicit ab4 abm4 bdf4 rosenbrock'.split()),
    (MODELS / 'double_pendulum.scene', 'abm4', 'double'),
    *((ROOT / f'{scene}.scene', 'rk4', 'float') for scene in (
        'models/four_bar', 'models/gyroscope', 'models/cart_pole', 'tests/promises/hard/rotor'))])
def test_the_bits_are_those_of_a_quarter_of_the_step(plant, scene, method, real):
    parted, fine = moves(plant, scene.read_text(), method, real)
    assert parted == fine


def test_found_another_number_of_sub_steps(plant):
    parted, fine = moves(plant, PENDULUM, 'rk4', 'float', 2)
    assert parted != fine


def test_on_the_board_four_sub_steps_have_the_bits_of_the_host_and_cost_four_steps(isochron, tmp_path):
    one, four = (path_of(PENDULUM + more, tmp_path, f'{name}.scene') for name, more in (('one', ''), ('four', '\nsubsteps 4\n')))
    host, board, step = (isochron('run', scene, '--target', target, '--seconds', 0.5).said for scene, target in (
        (four, 'host'), (four, 'cortex-m4f'), (one, 'cortex-m4f')))
    of_four, of_one = (int(said['instructions_per_step']) for said in (board, step))
    assert board['hash'] == host['hash'] and abs(of_four - 4 * of_one) < 80
    words = ' '.join((ROOT / 'core/README.md').read_text().split())
    assert f'the double pendulum takes {of_four} instructions for {of_one}.' in words


def test_one_sub_step_is_a_step(isoc):
    assert isoc(PENDULUM + '\nsubsteps 1\n').file('plant.c') == isoc(PENDULUM).file('plant.c')


def test_the_budget_of_adams_is_no_number_of_sub_steps_of_another_method(isoc):
    text = re.sub('^method rk4.*', '', PENDULUM, flags=re.M) + '\nmethod adams\nsubsteps 8\n'
    assert 'part(' not in isoc(text, '--method', 'rk4').file('plant.c')
    assert 'part(' in isoc(PENDULUM + '\nsubsteps 8\n').file('plant.c')
