"""A force that jumps in the middle of a run starts the history of a method anew, where its scene says what a jump is, or
where steps are checked and their error tells of it: reported as `restarts`, measured as `restart_execution`, and needed
for the right motion. The plant is a cart of 1 kg on a spring of 100 N/m, pushed with 2 N from 0.501 s on: x = 2 N / k
(1 - cos(w (t - 0.501 s))), w = 10 / s.
"""
import math

import pytest

METHODS = 'ab4', 'abm4', 'abm4_pec', 'abm4_pecece', 'bdf4'
STEP = 'table(0 s: 0 N, 0.5 s: 0 N, 0.5005 s: 2 N)'
# With the history made anew what is left is the method's own: of ab4, the largest, 251/720 (w h)^5 of the amplitude of
# 0.02 m in each of 499 steps, 3.5e-10 m; of bdf4 it is 1/5.
NEAR = 7e-10
# Weights 55, -59, 37, -9 over 24 on a derivative that jumps in between add half a step of impulse too much, h F / 2 m =
# 1e-3 m/s or 1e-4 m in place.
FAR = 5e-5


def cart(jump='', checked=False, force=STEP):
    """What is said of jumps, and whether steps are checked."""
    return f'''step 1 ms
input push {jump} = {force}
body cart {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child cart; axis x; spring 100 N/m; drive push }}
output place = position of rail
{'checked yes' if checked else ''}
'''


@pytest.fixture
def pushed(plant):
    """pushed(method, ...): the restarts of a second of the cart, and how far it ends from the exact place."""
    def call(method, **of_cart):
        of = plant(cart(**of_cart), '--method', method)
        place = of.run(1000, every=1000)['x'][-1, 0]
        return of.facts.restarts, abs(place - 0.02 * (1 - math.cos(10 * 0.499)))
    return call


@pytest.mark.parametrize('method', METHODS)
def test_a_method_starts_anew_where_it_is_told_of_the_jump_or_finds_it(pushed, method):
    for of_cart in dict(jump='jump 0.5 N'), dict(checked=True):
        restarts, off = pushed(method, **of_cart)
        assert restarts == 1 and off <= NEAR, of_cart
    restarts, off = pushed(method)
    assert restarts == 0 and off > FAR, 'control: with a history from before'


def test_what_jumps_by_as_much_in_every_tick_is_no_jump(pushed):
    """The force turns about from tick to tick."""
    assert pushed('ab4', checked=True, force='2 N * sin(500 Hz, 90 deg)')[0] == 0


@pytest.fixture
def run(isochron, tmp_path):
    """run(scene, method, ...): the summary of a second."""
    def call(scene, method, *words):
        (tmp_path / 'cart.scene').write_text(scene)
        done = isochron('run', tmp_path / 'cart.scene', '--method', method, '--seconds', '1', *words)
        assert done.status == 0, done.errors
        return done.said
    return call


@pytest.mark.parametrize('jump, checked, methods, is_measured', [
    ('jump 0.5 N', True, 'rosenbrock rk4', False), ('jump 0.5 N', False, 'ab4 bdf4', True), ('', True, 'abm4 bdf4 ab4', True)],
    ids=['told and checked', 'told', 'found'])
def test_a_restart_has_the_same_bits_on_the_board_and_is_the_dearest_step(run, jump, checked, methods, is_measured):
    """Of the last method: all other steps take one number of instructions."""
    scene = cart(jump, checked)
    for method in methods.split():
        here, there = run(scene, method), run(scene, method, '--target', 'cortex-m4f')
        assert here['hash'] == there['hash'] and there['restarts'] == '1', method
    if is_measured:
        assert int(there['restart_execution'].split()[0]) > int(there['instructions_per_step'])


def test_where_nothing_is_kept_there_is_nothing_to_start_anew(run, isoc):
    """And no code for it."""
    said = run(cart('jump 0.5 N'), 'rk4')
    assert not said.keys() & {'restarts', 'restart_execution'}
    text = 'discontinuity'
    assert text not in isoc(cart('jump 0.5 N'), '--method', 'rk4').file('plant.c')
    assert text in isoc(cart('jump 0.5 N'), '--method', 'ab4').file('plant.c'), 'control'
