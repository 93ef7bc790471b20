"""The Jacobian of a loop whose closures give way by the penalty of the augmented Lagrangian."""
import pathlib

import numpy as np
import pytest

SCENE = pathlib.Path('tests/core/methods/order/four_bar.scene').read_text().replace(
    'stabilisation baumgarte { alpha 5 Hz; beta 5 Hz }', 'stabilisation lagrangian { omega 5 Hz; penalty 1 kg; iterations 1 }')


@pytest.mark.parametrize('method, order', [('bdf4', 4), ('rosenbrock', 3)])
def test_soft_closures(plant, method, order):
    """A light penalty is a large part of the matrix of the closures. With another Jacobian the error of the two Newton
    iterations of bdf4 outweighs its own: with the sign of the penalty changed the orders are 2.6 and 2.2. 2 s, against rk4 at
    0.25 ms."""
    exact = plant(SCENE, '--method', 'rk4', '--step', '0.25ms').run(8000, every=8000)['x'][-1]
    errors = []
    for step in (4, 2, 1):
        rows = plant(SCENE, '--method', method, '--step', f'{step}ms').run(2000 // step, every=2000 // step)
        errors.append(abs(rows['x'][-1] - exact).max())
    orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    assert all(abs(orders - order) < 0.1), (errors, orders)
