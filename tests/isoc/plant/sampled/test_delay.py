"""A delay in the equations, x'' = -w^2 x(t - tau): each method keeps its order with one of a state; one of a memory is
constant within a step."""
import math
import re

import pytest

from harness.project import ROOT

TAU, W, END_MS = 0.04, 5.0, 1600
OF_STATE = '-25 N/m * delay(position of along, 40 ms)'
OF_MEMORY = '-25 N/m * delay(position of along + none / 25 N * 1 m, 40 ms)'


def delayed(plant, method, step_ms, effort):
    return plant(f'''step {step_ms} ms
method {method}
body b {{ mass 1 kg }}
joint j prismatic {{ parent ground; child b; axis x; start 1 m }}
effect pull {{ joint along; memory none N = 0 N; next none = none; effort on along = {effort} }}
effect p pull {{ along j }}
output x = position of j''')


def solution(t):
    """From x = 1 at rest, where x was 1 before: by steps (Bellman and Cooke 1963, Differential-Difference Equations, ch.
    3) a sum over all k with t > (k - 1) tau of (-w^2)^k (t - (k - 1) tau)^(2 k) / (2 k)!, and 1 for k = 0."""
    last = math.ceil(t / TAU - 1e-9)
    return 1.0 + math.fsum((-W * W) ** k * (t - (k - 1) * TAU) ** (2 * k) / math.factorial(2 * k) for k in range(1, last + 1))


def power_of(plant, method, effort):
    """The power of the step with which the error falls from 10 to 5 ms."""
    coarse, fine = (abs(delayed(plant, method, ms, effort).outputs(END_MS // ms).x[-1] - solution(END_MS / 1000))
                    for ms in (10, 5))
    return math.log2(coarse / fine)


ORDERS = {'euler': 1, 'semi_implicit': 1, 'heun': 2, 'rosenbrock': 3, 'rk4': 4, 'ab4': 4, 'abm4': 4, 'bdf4': 4}


@pytest.mark.parametrize('method', ORDERS)
def test_a_delay_of_a_state_leaves_a_method_its_order(plant, method):
    assert ORDERS[method] - 0.3 <= power_of(plant, method, OF_STATE) <= ORDERS[method] + 0.5


def test_the_reference_has_these_powers(plant):
    text = ' '.join((ROOT / 'tools/isoc/README.md').read_text().split())
    powers = [f'`{method}` {power_of(plant, method, OF_STATE):.2f}' for method in ('rk4', 'rosenbrock', 'heun')]
    assert ', '.join(powers) in text


def test_one_of_a_memory_is_constant_within_a_step_and_isoc_warns(plant):
    """The control of the orders: this is not of order four."""
    assert 0.8 <= power_of(plant, 'rk4', OF_MEMORY) <= 1.6
    warned = delayed(plant, 'rk4', 5, OF_MEMORY).made.errors
    assert re.search('plant.scene:.*constant within a step, and so half a step longer', warned)


def test_one_of_a_state_alone_has_no_warning(plant):
    assert delayed(plant, 'rk4', 5, OF_STATE).made.errors == ''
